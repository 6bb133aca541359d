#include "scenefile/base/number.h"

#include <gtest/gtest.h>

#include <clocale>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <random>
#include <string>

namespace scenefile {
namespace {

TEST(Number, AcceptsCommonNotations) {
  const std::pair<const char*, double> cases[] = {
      {"1", 1},
      {"-2.5", -2.5},
      {"+3", 3},
      {".5", 0.5},
      {"5.", 5},
      {"1e3", 1000},
      {"1E-2", 0.01},
      {"  7\t\n", 7},
      {"0", 0},
      {"-0.0", 0},
      {"1e+2", 100},
      {"00012", 12},
      {"3.4e38", 3.4e38},
      {"1e-400", 0},
      {"0.000000000000000000000000000000000000000000000000001", 1e-51}};
  for (const auto& [text, value] : cases) {
    const ParsedNumber n = parse_number(text);
    EXPECT_EQ(n.error, NumberError::none) << text;
    EXPECT_DOUBLE_EQ(n.value, value) << text;
  }
}

TEST(Number, RejectsOtherThanDecimalNumbers) {
  for (const char* text :
       {"nan", "inf", "-inf", "nan(1)", "0x10", "0x1p3", "1,5", "1 2", "--1", "1e",
        "1e+", "one", "1f",   "1%",     "..7",  ".",     "+",   "-",   "1;",  "\xd9\xa1"}) {
    EXPECT_EQ(parse_number(text).error, NumberError::malformed) << text;
  }
}

TEST(Number, PrefixOfAMalformedNumber) {
  EXPECT_EQ(parse_number("1'").value, 1);
  EXPECT_EQ(parse_number(" 0.`").value, 0);
  EXPECT_EQ(parse_number(" 2.5x").value, 2.5);
  EXPECT_EQ(parse_number(" 2.5x").used, 4u);
  EXPECT_EQ(parse_number("1e+").value, 1);
  EXPECT_EQ(parse_number("..7").used, 0u);
}

TEST(Number, EmptyAndBlank) {
  EXPECT_EQ(parse_number("").error, NumberError::empty);
  EXPECT_EQ(parse_number(" \t").error, NumberError::empty);
}

TEST(Number, WhatIsWrittenOfTheLargestFloatReadsBack) {
  const float largest = std::numeric_limits<float>::max();
  for (const float value : {largest, -largest}) {
    const ParsedNumber number = parse_number(number_text(value));
    EXPECT_EQ(number.error, NumberError::none);
    EXPECT_EQ(static_cast<float>(number.value), value);
  }
  EXPECT_EQ(parse_number("3.4028236e38").error, NumberError::out_of_range);
}

TEST(Number, BeyondFloatIsOutOfRange) {
  for (const char* text :
       {"1e39", "-1e39", "1e400", "-1e400", "123456789e400", "0.00000001e5000"}) {
    EXPECT_EQ(parse_number(text).error, NumberError::out_of_range) << text;
  }
  EXPECT_EQ(parse_number("1" + std::string(400, '0')).error, NumberError::out_of_range);
  EXPECT_EQ(parse_number("0e400").error, NumberError::none);
  EXPECT_EQ(parse_number("0." + std::string(400, '0') + "1").value, 0);
}

TEST(Number, IgnoresTheLocale) {
  const char* old = std::setlocale(LC_ALL, "de_DE.UTF-8");
  EXPECT_EQ(parse_number("1.5").value, 1.5);
  EXPECT_EQ(number_text(1.5f), "1.5");
  if (old != nullptr) {
    std::setlocale(LC_ALL, "C");
  }
}

TEST(Number, ShortAndLongNumbersAreTheNearestDouble) {
  std::mt19937_64 random(7);
  for (int i = 0; i < 200000; ++i) {
    const int digits = 1 + static_cast<int>(random() % 18);
    std::string text = random() % 2 == 0 ? "-" : "";
    const int point = static_cast<int>(random() % static_cast<std::uint64_t>(2 * digits + 1));
    for (int d = 0; d < digits; ++d) {
      text += d == point ? "." : "";
      text += static_cast<char>('0' + random() % 10);
    }
    const ParsedNumber n = parse_number(text);
    ASSERT_EQ(n.error, NumberError::none) << text;
    ASSERT_EQ(n.used, text.size()) << text;
    ASSERT_EQ(n.value, std::strtod(text.c_str(), nullptr)) << text;
  }
}

TEST(Number, TextReadsBackAsTheSameFloat) {
  std::mt19937 random(1);
  for (int i = 0; i < 20000; ++i) {
    const auto bits = static_cast<std::uint32_t>(random());
    float value = 0;
    std::memcpy(&value, &bits, sizeof value);
    if (std::isfinite(value)) {
      EXPECT_EQ(static_cast<float>(parse_number(number_text(value)).value), value);
    }
  }
}

}  // namespace
}  // namespace scenefile
