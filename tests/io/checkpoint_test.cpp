#include "scenefile/io/checkpoint.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace scenefile {

namespace {

using ::testing::HasSubstr;

constexpr CheckpointKey key{1, 2, 3, 4};
const std::string good = encode_checkpoint(key, "the state of the work");

std::string complaint(std::string_view bytes, const CheckpointKey& wanted = key) {
  std::string state = "old";
  const std::string why = decode_checkpoint(bytes, wanted, state);
  EXPECT_EQ(state.empty(), !why.empty());
  return why;
}

TEST(Checkpoint, RoundTrips) {
  std::string state;
  EXPECT_EQ(decode_checkpoint(good, key, state), "");
  EXPECT_EQ(state, "the state of the work");
}

TEST(Checkpoint, EveryTruncationIsDetected) {
  for (std::size_t length = 0; length < good.size(); ++length) {
    EXPECT_NE(complaint(good.substr(0, length)), "") << length;
  }
  EXPECT_THAT(complaint(""), HasSubstr("empty"));
  EXPECT_THAT(complaint(good.substr(0, 30)), HasSubstr("truncated"));
  EXPECT_THAT(complaint(good + "x"), HasSubstr("longer"));
}

TEST(Checkpoint, EveryDamagedBitIsDetected) {
  for (std::size_t i = 0; i < good.size(); ++i) {
    for (int bit = 0; bit < 8; ++bit) {
      std::string bytes = good;
      bytes[i] = static_cast<char>(bytes[i] ^ (1 << bit));
      EXPECT_NE(complaint(bytes), "") << i;
    }
  }
}

TEST(Checkpoint, DescribesItsKey) {
  EXPECT_THAT(complaint(good, {9, 2, 3, 4}), HasSubstr("another build"));
  EXPECT_THAT(complaint(good, {1, 9, 3, 4}), HasSubstr("another scene"));
  EXPECT_THAT(complaint(good, {1, 2, 9, 4}), HasSubstr("other textures or meshes"));
  EXPECT_THAT(complaint(good, {1, 2, 3, 9}), HasSubstr("other options"));
  EXPECT_THAT(complaint("<scenefile/>"), HasSubstr("not a checkpoint"));
}

}  // namespace

}  // namespace scenefile
