#include "scenefile/compare/measure.h"

#include "compare/sample_pictures.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace scenefile::compare_test {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST(Measure, EqualPictures) {
  std::vector<float> errors;
  const PictureMeasures m = measure(pattern(20, 10, 0), pattern(20, 10, 0), 8, &errors);
  EXPECT_TRUE(m.comparable);
  EXPECT_EQ(m.ssim, 1);
  EXPECT_EQ(m.flip_mean, 0);
  EXPECT_EQ(errors.size(), 200u);
  EXPECT_THAT(broken_thresholds({}, m), IsEmpty());
}

TEST(Measure, WithoutThresholdsOnlyEqualIsTheSame) {
  const PictureMeasures m = measure(pattern(20, 10, 0), darkened(pattern(20, 10, 0), 1));
  EXPECT_THAT(broken_thresholds({}, m), ElementsAre("the pictures are not equal"));
}

TEST(Measure, EachThresholdIsHeldByItself) {
  const PictureMeasures m = measure(blank(20, 20, {100, 100, 100}), blank(20, 20, {110, 110, 110}));
  EXPECT_THAT(broken_thresholds({.min_psnr_db = 28}, m), IsEmpty());
  EXPECT_THAT(broken_thresholds({.min_psnr_db = 29}, m),
              ElementsAre("PSNR is 28.13 dB, less than 29"));
  EXPECT_THAT(broken_thresholds({.max_mean = 10}, m), IsEmpty());
  EXPECT_THAT(broken_thresholds({.max_mean = 9.5}, m),
              ElementsAre("the mean difference is 10.000/255, more than 9.5"));
  PictureMeasures close = m;
  close.difference.psnr_db = 28.1291;
  EXPECT_THAT(broken_thresholds({.min_psnr_db = 28.13}, close),
              ElementsAre("PSNR is 28.129 dB, less than 28.13"));
  EXPECT_THAT(broken_thresholds({.max_difference = 10}, m), IsEmpty());
  EXPECT_THAT(broken_thresholds({.max_difference = 9}, m),
              ElementsAre("the maximum difference is 10/255, more than 9"));
  EXPECT_THAT(broken_thresholds({.max_share = 1}, m), IsEmpty());
  EXPECT_THAT(broken_thresholds({.max_share = 0.5}, m),
              ElementsAre("100.000 % of the pixels are off, more than 50 %"));
  EXPECT_EQ(broken_thresholds({.min_ssim = 1}, m).size(), 1u);
  EXPECT_EQ(broken_thresholds({.max_flip = 0.01}, m).size(), 1u);
  EXPECT_THAT(broken_thresholds({.max_flip = 0.5}, m), IsEmpty());
}

TEST(Measure, OtherSizes) {
  const PictureMeasures m = measure(blank(4, 4), blank(4, 5));
  EXPECT_FALSE(m.comparable);
  EXPECT_THAT(broken_thresholds({.max_flip = 1}, m), ElementsAre("the size is 4x5, expected 4x4"));
}

}  // namespace
}  // namespace scenefile::compare_test
