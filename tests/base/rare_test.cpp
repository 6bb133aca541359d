#include "scenefile/base/rare.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>

namespace scenefile {
namespace {

TEST(Rare, IsEmptyOrHasAValue) {
  Rare<std::string> none;
  EXPECT_FALSE(none);
  EXPECT_FALSE(none.has_value());
  const Rare<std::string> some(std::string("a"));
  ASSERT_TRUE(some.has_value());
  EXPECT_EQ(*some, "a");
  EXPECT_EQ(some->size(), 1u);
  EXPECT_EQ(none.emplace("b"), "b");
  EXPECT_EQ(*none, "b");
}

TEST(Rare, CopiesTheValue) {
  const Rare<std::string> first(std::string("a"));
  Rare<std::string> second = first;
  *second += "b";
  EXPECT_EQ(*first, "a");
  second = first;
  EXPECT_EQ(*second, "a");
  second = Rare<std::string>();
  EXPECT_FALSE(second);
}

TEST(Rare, MovesTheValue) {
  Rare<std::string> first(std::string("a"));
  const std::string* const place = &*first;
  const Rare<std::string> second = std::move(first);
  EXPECT_EQ(&*second, place);
}

TEST(Rare, ComparesTheValues) {
  const Rare<int> none;
  EXPECT_EQ(none, Rare<int>());
  EXPECT_EQ(Rare<int>(1), 1);
  EXPECT_NE(Rare<int>(1), Rare<int>(2));
  EXPECT_NE(Rare<int>(0), none);
  EXPECT_NE(none, Rare<int>(0));
}

TEST(RareText, IsEmptyOrAText) {
  const RareText none;
  EXPECT_TRUE(none.empty());
  EXPECT_EQ(none, "");
  EXPECT_EQ(none, RareText(std::string()));
  EXPECT_EQ(none.size(), 0u);
  EXPECT_EQ(sizeof none, sizeof(void*));

  RareText text("ab");
  EXPECT_EQ(text, "ab");
  EXPECT_EQ(text, std::string("ab"));
  EXPECT_EQ(std::string_view(text), "ab");
  EXPECT_NE(text, none);
  const RareText copy = text;
  text.clear();
  EXPECT_TRUE(text.empty());
  EXPECT_EQ(copy.str(), "ab");
}

}  // namespace
}  // namespace scenefile
