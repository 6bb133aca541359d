#include "scenefile/base/text.h"

#include <gtest/gtest.h>

namespace scenefile {
namespace {

TEST(Text, PlainTextStaysAsItIs) {
  EXPECT_EQ(escaped("caf\u00e9 \u4e2d %s"), "caf\u00e9 \u4e2d %s");
}

TEST(Text, ControlAndInvisibleCharactersAreSpelled) {
  EXPECT_EQ(escaped("a\nb\tc\x1b"), "a\\nb\\tc\\u{1b}");
  EXPECT_EQ(escaped("\u202e\u200b\ufeff\u0085"), "\\u{202e}\\u{200b}\\u{feff}\\u{85}");
}

TEST(Text, BytesThatAreNotUtf8AreSpelled) {
  EXPECT_EQ(escaped("\xff"), "\\xff");
  EXPECT_EQ(escaped("\xc0\xaf"), "\\xc0\\xaf");           // overlong
  EXPECT_EQ(escaped("\xed\xa0\x80"), "\\xed\\xa0\\x80");  // surrogate
  EXPECT_EQ(escaped("\xe4\xb8"), "\\xe4\\xb8");           // truncated
}

TEST(Text, LongTextIsCutByCharacters) {
  EXPECT_EQ(quoted("\u4e2d\u4e2d\u4e2d", 2), "\"\u4e2d\u4e2d...\"");
  EXPECT_EQ(quoted("abc", 3), "\"abc\"");
}

TEST(Text, CountsCharacters) {
  EXPECT_EQ(count_code_points("a\u00e9\u4e2d\U0001f600"), 4u);
  EXPECT_EQ(count_code_points("\xff\xff"), 2u);
  EXPECT_EQ(first_code_point("\U0001f600").value, U'\U0001f600');
  EXPECT_EQ(first_code_point("").bytes, 0u);
}

TEST(Text, ArticlesFitTheirWords) {
  EXPECT_EQ(with_article("point"), "a point");
  EXPECT_EQ(with_article("area"), "an area");
  EXPECT_EQ(with_article("error"), "an error");
}

TEST(Text, WordsOfShellsAreQuotedIfNeeded) {
  EXPECT_EQ(shell_word("a/b-c_1.png"), "a/b-c_1.png");
  EXPECT_EQ(shell_word(""), "''");
  EXPECT_EQ(shell_word("two words"), "'two words'");
  EXPECT_EQ(shell_word("it's $HOME"), "'it'\\''s $HOME'");
}

}  // namespace
}  // namespace scenefile
