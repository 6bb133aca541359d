#include "scenefile/edit/text_edit.h"

#include <gtest/gtest.h>

#include <random>
#include <string>

namespace scenefile {
namespace {

TEST(TextEdit, ReplacesInsertsAndRemoves) {
  const Edit edit{{{0, 0, "<"}, {0, 1, "A"}, {2, 1, ""}, {4, 0, "!"}}, {}};
  EXPECT_TRUE(fits(edit, 4));
  EXPECT_EQ(applied("abcd", edit), "<Abd!");
}

TEST(TextEdit, ChangesMustBeInOrderAndInTheText) {
  EXPECT_FALSE(fits({{{2, 1, ""}, {1, 1, ""}}, {}}, 4));
  EXPECT_FALSE(fits({{{1, 2, ""}, {2, 1, ""}}, {}}, 4));
  EXPECT_FALSE(fits({{{3, 2, ""}}, {}}, 4));
  EXPECT_FALSE(fits({{{5, 0, "x"}}, {}}, 4));
  std::vector<TextChange> changes{{2, 1, ""}, {0, 1, "a"}, {0, 0, "b"}};
  sort_changes(changes);
  EXPECT_TRUE(fits({changes, {}}, 4));
  EXPECT_EQ(changes[0].text, "b");
}

TEST(TextEdit, PlacesMoveWithTheirText) {
  const Edit edit{{{1, 2, "xyz"}, {4, 0, "++"}}, {}};  // a bc d | e
  EXPECT_EQ(moved(0, edit), 0U);
  EXPECT_EQ(moved(1, edit), 4U) << "removed";
  EXPECT_EQ(moved(2, edit), 4U);
  EXPECT_EQ(moved(3, edit), 4U);
  EXPECT_EQ(moved(4, edit), 7U) << "after what is inserted";
}

TEST(TextEdit, InverseGivesTheSameBytes) {
  std::mt19937 chance(1);
  const auto upto = [&](std::size_t most) { return chance() % (most + 1); };
  for (int round = 0; round < 5000; ++round) {
    std::string text(upto(20), 'a');
    for (char& letter : text) {
      letter = static_cast<char>('a' + upto(25));
    }
    Edit edit;
    for (std::size_t at = upto(3); at <= text.size(); at += 1 + upto(4)) {
      const std::size_t size = upto(std::min<std::size_t>(3, text.size() - at));
      edit.changes.push_back({static_cast<std::uint32_t>(at), static_cast<std::uint32_t>(size),
                              std::string(upto(3), 'X')});
      at += size;
    }
    ASSERT_TRUE(fits(edit, text.size()));
    const std::string after = applied(text, edit);
    const Edit back = inverse(text, edit);
    ASSERT_TRUE(fits(back, after.size()));
    ASSERT_EQ(applied(after, back), text);
    for (std::uint32_t at = 0; at < text.size(); ++at) {
      const std::uint32_t there = moved(at, edit);
      ASSERT_LE(there, after.size());
    }
  }
}

}  // namespace
}  // namespace scenefile
