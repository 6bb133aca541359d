#include "scenefile/base/hash.h"

#include <gtest/gtest.h>

#include <string>

namespace scenefile {

namespace {

std::uint64_t hash_of(std::initializer_list<std::string_view> texts) {
  Hash hash;
  for (const std::string_view text : texts) {
    hash.add(text);
  }
  return hash.value();
}

TEST(Hash, DependsOnEveryBit) {
  const std::string text = "nineteen characters";
  for (std::size_t i = 0; i < text.size(); ++i) {
    for (int bit = 0; bit < 8; ++bit) {
      std::string other = text;
      other[i] = static_cast<char>(other[i] ^ (1 << bit));
      EXPECT_NE(hash_of({text}), hash_of({other}));
    }
  }
}

TEST(Hash, DependsOnWhereTextsEndAndOnTheirOrder) {
  EXPECT_NE(hash_of({"ab", "c"}), hash_of({"a", "bc"}));
  EXPECT_NE(hash_of({"abc"}), hash_of({"abc", ""}));
  EXPECT_NE(hash_of({"a", "b"}), hash_of({"b", "a"}));
  EXPECT_NE(hash_of({std::string_view("a\0", 2)}), hash_of({"a"}));
}

TEST(Hash, IsTheSameInEveryBuild) {
  EXPECT_EQ(hash_of({"a", "b"}), hash_of({"a", "b"}));
}

}  // namespace

}  // namespace scenefile
