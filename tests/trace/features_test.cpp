#include "scenefile/trace/features.h"

#include <gtest/gtest.h>

namespace scenefile {
namespace {

constexpr Features none{false, false, false, false, false, false, false};

TEST(Features, WordsSwitchTheirField) {
  Features f;
  EXPECT_EQ(parse_features("shadows,texture-filter", f), "");
  Features expected = none;
  expected.shadows = expected.texture_filter = true;
  EXPECT_EQ(f, expected);
}

TEST(Features, AllAndNone) {
  Features f = none;
  EXPECT_EQ(parse_features("all", f), "");
  EXPECT_EQ(f, Features{});
  EXPECT_EQ(parse_features("none", f), "");
  EXPECT_EQ(f, none);
  f = {};
  EXPECT_EQ(parse_features("", f), "");
  EXPECT_EQ(f, none);
}

TEST(Features, UnknownWordsAreNamed) {
  Features f;
  EXPECT_EQ(parse_features("shadows,reflects", f), "reflects");
  EXPECT_EQ(parse_features("shadows,", f), ",");
}

TEST(Features, SevenWords) {
  Features f = none;
  ASSERT_EQ(feature_words().size(), 7u);
  for (const std::string_view word : feature_words()) {
    ASSERT_NE(find_feature(f, word), nullptr);
    *find_feature(f, word) = true;
  }
  EXPECT_EQ(f, Features{});
}

TEST(Features, ProjectsOfTheCourse) {
  RenderOptions options;
  EXPECT_EQ(parse_features("illuminate", options), "");
  EXPECT_EQ(options.mode, Mode::ray);
  Features expected = none;
  expected.shadows = expected.reflect = expected.texture = true;
  EXPECT_EQ(options.features, expected);
  EXPECT_EQ(parse_features("intersect", options), "");
  EXPECT_EQ(options.mode, Mode::intersect);
  EXPECT_EQ(options.features, none);
  EXPECT_EQ(parse_features("shadows,intersect", options), "intersect");
  for (const std::string_view word : feature_list_words()) {
    EXPECT_EQ(parse_features(word, options), "") << word;
  }
  EXPECT_EQ(feature_list_words().size(), 11u);
}

// A name instead of a list, where there is one, and in any case the same features.
TEST(Features, TheShortestList) {
  for (const std::string_view list : {"all", "none", "illuminate", "shadows", "reflect,texture"}) {
    RenderOptions options;
    EXPECT_EQ(parse_features(list, options), "");
    EXPECT_EQ(feature_list(options.features), list);
  }
  Features all;
  EXPECT_EQ(parse_features("texture,shadows,reflect", all), "");
  EXPECT_EQ(feature_list(all), "illuminate");
}

}  // namespace
}  // namespace scenefile
