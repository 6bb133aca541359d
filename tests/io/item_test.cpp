#include "scenefile/io/item.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace scenefile {
namespace {

using ::testing::HasSubstr;

const std::string key = "scene=1f samples=16";

std::string sealed() {
  std::string bytes = "{\"key\": \"" + item_text(key) + "\", \"values\": [1, 2, 3]}";
  seal_item(bytes);
  return bytes;
}

TEST(Item, IsReadBack) {
  const std::string bytes = sealed();
  EXPECT_THAT(bytes, HasSubstr(key));
  const Item item = read_item(bytes);
  EXPECT_EQ(item.state, ItemState::intact);
  EXPECT_EQ(item.key, key);
  EXPECT_EQ(item_text("").find_first_of("\"\\\n"), std::string::npos);
}

TEST(Item, EveryChangedOrMissingByteIsFound) {
  const std::string bytes = sealed();
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    std::string changed = bytes;
    changed[i] = static_cast<char>(changed[i] ^ 1);
    EXPECT_NE(read_item(changed).state, ItemState::intact) << i;
    EXPECT_EQ(read_item(changed).key, "");
    EXPECT_NE(read_item(bytes.substr(0, i)).state, ItemState::intact) << i;
  }
  EXPECT_EQ(read_item(bytes + " ").state, ItemState::damaged);
  EXPECT_EQ(read_item(bytes.substr(0, 40)).state, ItemState::damaged);
}

// The CRC of a text in PNG comes after it, and depends on the checksum.
TEST(Item, TheCrcAfterTheTextOfAPngIsNotInTheSum) {
  std::string bytes = "\x89PNG " + item_text(key) + "\1\2\3\4 more";
  seal_item(bytes);
  const std::size_t crc = bytes.find('\1');
  bytes.replace(crc, 4, "\5\6\7\x8");
  EXPECT_EQ(read_item(bytes).state, ItemState::intact);
  bytes[crc + 4] = '_';
  EXPECT_EQ(read_item(bytes).state, ItemState::damaged);
}

TEST(Item, OtherFilesAreNone) {
  for (const char* const text : {"", "notes", "scenefile item", "scene=1f samples=16"}) {
    EXPECT_EQ(read_item(text).state, ItemState::none);
    std::string bytes = text;
    seal_item(bytes);
    EXPECT_EQ(bytes, text);
  }
}

TEST(Item, DifferencesOfKeysAreListed) {
  const auto list = [](std::string_view found, std::string_view wanted) {
    std::string text;
    for (const KeyDifference& d : compare_keys(found, wanted)) {
      text += d.name + ":" + d.found + ":" + d.wanted + " ";
    }
    return text;
  };
  EXPECT_EQ(list(key, key), "");
  EXPECT_EQ(list("scene=1f samples=16", "scene=2 samples=4"), "scene:1f:2 samples:16:4 ");
  EXPECT_EQ(list("a=1 b=2", "b=2 c=3"), "c::3 a:1: ");
  EXPECT_EQ(list("", "a=1"), "a::1 ");
  EXPECT_EQ(list("a=1  b x= =y", "a=1"), ":y: ");
  EXPECT_EQ(list("a=1 a=2", "a=1 a=2"), "");
  EXPECT_EQ(list("b=2 a=1", "a=1 b=2"), "key:b=2 a=1:a=1 b=2 ");
}

}  // namespace
}  // namespace scenefile
