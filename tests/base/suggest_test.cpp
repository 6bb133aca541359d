#include "scenefile/base/suggest.h"

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <utility>

namespace scenefile {
namespace {

constexpr std::array<std::string_view, 8> words = {
    "diffuse", "specular", "shininess", "transblock", "position", "angle", "id", "heightangle"};

TEST(Suggest, FindsTheIntendedWord) {
  EXPECT_EQ(nearest_name("difuse", words), "diffuse");
  EXPECT_EQ(nearest_name("shinyness", words), "shininess");
  EXPECT_EQ(nearest_name("tranblock", words), "transblock");
  EXPECT_EQ(nearest_name("postion", words), "position");
  EXPECT_EQ(nearest_name("anlge", words), "angle");
  EXPECT_EQ(nearest_name("HeightAngle", words), "heightangle");
  EXPECT_EQ(nearest_name("heigthangle", words), "heightangle");
  EXPECT_EQ(nearest_name("ID", words), "id");
}

TEST(Suggest, SuggestsNothingIfNothingIsSimilar) {
  EXPECT_EQ(nearest_name("frobnicate", words), "");
  EXPECT_EQ(nearest_name("", words), "");
  EXPECT_EQ(nearest_name("x", words), "");
  EXPECT_EQ(nearest_name(std::string(100000, 'a'), words), "");
}

TEST(Suggest, TheStartOfANameIsNear) {
  constexpr std::string_view keys[] = {"textureFile", "textureU", "cameraData"};
  EXPECT_EQ(nearest_name("texture", keys), "textureFile");
  EXPECT_EQ(nearest_name("Camera", keys), "cameraData");
  EXPECT_EQ(nearest_name("text", keys), "");
}

TEST(Suggest, TheNumberThatWasMeant) {
  const std::pair<std::string_view, std::string_view> slips[] = {
      {"1,5", "1.5"},        {"-0,25", "-0.25"},
      {"1,000.5", "1000.5"}, {"1_000", "1000"},
      {"1'000.5", "1000.5"}, {"0x10", "16"},
      {"-0xff", "-255"},     {"1/2", "0.5"},
      {"-3/4", "-0.75"},     {"50%", "0.5"},
      {"1d5", "100000"},     {"90deg", "90"},
      {"45 degrees", "45"},  {"45\u00B0", "45"},
      {"1.5px", "1.5"},      {"5f", "5"},
      {"1e", "1"},           {"1e+", "1"},
      {"0.`", "0"},          {"0.5;", "0.5"},
      {"\"1\"", "1"},        {"\u22125", "-5"},
      {"\u2011.5", "-0.5"},  {"--5", "-5"},
      {"- 5", "-5"},         {"\u201C2\u201D", "2"},
      {"1.0.", "1"},         {".5f", "0.5"},
      {"1.000,5", "1000.5"}, {"-1,234.5", "-1234.5"},
      {"1.5,", "1.5"}};
  for (const auto& [text, number] : slips) {
    EXPECT_EQ(nearest_number(text), number) << text;
  }
}

TEST(Suggest, NoNumberWhereItWouldBeAGuess) {
  for (const std::string_view text :
       {"",           " ",     "-",       ".",       "NaN",     "inf",     "pi",
        "red",        "1.2.3", "1 2",     "1,2,3",   "0b11",    "0x",      "0xfg",
        "1/0",        "1/2/3", "1.57rad", "#ff0000", "1e999",   "e5",      "\u00BD",
        "5 apples 3", "1,0.5", "1.5,2",   "0.125,5", "12,34.5", "1,2.5,3", ",500.5"}) {
    EXPECT_EQ(nearest_number(text), "") << text;
  }
  EXPECT_EQ(nearest_number(std::string(100000, '1')), "");
}

TEST(Suggest, ANumberWithACommaAfterItsPointMayBeTwo) {
  EXPECT_TRUE(number_correction("1,000.5", "1000.5")->certain);
  EXPECT_TRUE(number_correction("1.5,", "1.5")->certain);
  EXPECT_FALSE(number_correction("1.000,5", "1000.5")->certain);
}

}  // namespace
}  // namespace scenefile
