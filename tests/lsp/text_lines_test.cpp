#include "scenefile/lsp/text_lines.h"

#include <gtest/gtest.h>

#include <string>

namespace scenefile {
namespace {

TEST(TextLines, CountUtf16UnitsAndCharacters) {
  const std::string text = "a\u00e9\U0001F600b\r\nc\rd\n";
  const TextLines lines(text);
  EXPECT_EQ(lines.offset(LspPosition{0, 4}), text.find('b'));  // the emoji has two units
  EXPECT_EQ(lines.offset(Location{1, 4}), text.find('b'));     // and is one character
  EXPECT_EQ(lines.position(text.find('b')).character, 4U);
  EXPECT_EQ(lines.offset(LspPosition{1, 0}), text.find('c'));
  EXPECT_EQ(lines.position(text.find('d')).line, 2U);
  EXPECT_EQ(lines.position(text.size()).line, 3U);
}

TEST(TextLines, PlacesOutsideAreTheNearest) {
  const TextLines lines("ab\ncd");
  EXPECT_EQ(lines.offset(LspPosition{0, 99}), 2U);
  EXPECT_EQ(lines.offset(LspPosition{9, 0}), 5U);
  EXPECT_EQ(lines.offset(Location{9, 1}), 5U);
  EXPECT_EQ(lines.offset(Location{}), 0U);
  EXPECT_EQ(lines.position(99).character, 2U);
}

TEST(TextLines, BrokenUtf8IsACharacterForEachByte) {
  const std::string text =
      "\xff\xfe"
      "x";
  const TextLines lines(text);
  EXPECT_EQ(lines.offset(LspPosition{0, 2}), 2U);
  EXPECT_EQ(lines.position(3).character, 3U);
}

TEST(Utf16Offsets, ConvertBothWays) {
  const std::string text = "a\u00e9\U0001F600b";
  const Utf16Offsets offsets(text);
  EXPECT_EQ(offsets.unit(text.find('b')), 4U);
  EXPECT_EQ(offsets.byte(4), text.find('b'));
  EXPECT_EQ(offsets.byte(2), 3U);  // after the e with its accent, not inside it
  EXPECT_EQ(offsets.unit(2), 1U);
  EXPECT_EQ(offsets.byte(3), text.find('b'));  // between surrogates
  EXPECT_EQ(offsets.unit(99), 5U);
  EXPECT_EQ(offsets.byte(5), text.size());
  EXPECT_EQ(Utf16Offsets("abc").byte(2), 2U);
}

}  // namespace
}  // namespace scenefile
