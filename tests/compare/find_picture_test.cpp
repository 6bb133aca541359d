#include "scenefile/compare/find_picture.h"

#include "compare/sample_pictures.h"
#include "scenefile/compare/sheet.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace scenefile::compare_test {
namespace {

void set(Texture& picture, int x, int y, const glm::ivec3& color) {
  for (int c = 0; c < 3; ++c) {
    picture.rgb[3 * (std::size_t(y) * picture.width + x) + c] = static_cast<std::uint8_t>(color[c]);
  }
}

// Shaded balls on black; `zoom` moves the camera away.
Texture balls(int width, int height, double light = 1, double zoom = 1) {
  Texture picture = blank(width, height);
  const double unit = height / 12.0 / zoom;
  for (int k = 0; k < 7; ++k) {
    const glm::dvec2 middle(width / 2.0 + unit * (2 * k - 6),
                            height / 2.0 + unit * (k * k % 5 - 2));
    const double radius = unit * (0.7 + 0.25 * (k % 3));
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        const glm::dvec2 d = (glm::dvec2(x + 0.5, y + 0.5) - middle) / radius;
        const double z = 1 - glm::dot(d, d);
        if (z > 0) {
          const double bright = light * (60 + 150 * std::sqrt(z) * (0.5 - 0.5 * d.x));
          set(picture, x, y, glm::ivec3(bright, bright * (k % 2), 255 - bright));
        }
      }
    }
  }
  return picture;
}

Texture on(Texture under, const Texture& picture, const glm::ivec2& corner) {
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      const std::uint8_t* p = picture.texel(x, y);
      set(under, corner.x + x, corner.y + y, {p[0], p[1], p[2]});
    }
  }
  return under;
}

TEST(FindPicture, InTheFrameOfAWindow) {
  const Texture reference = balls(240, 180);
  const Texture wrong = balls(240, 180, 0.4);
  const Texture screenshot = on(blank(270, 230, {220, 220, 225}), wrong, {11, 40});
  EXPECT_EQ(find_picture(reference, screenshot), (PicturePlace{{11, 40}, {240, 180}}));
  EXPECT_EQ(cut_out(screenshot, {11, 40}, {240, 180}).rgb, wrong.rgb);
}

TEST(FindPicture, AtAnotherSizeInAFrame) {
  const Texture reference = balls(240, 180);
  const Texture screenshot = on(blank(420, 360, {90, 90, 90}), balls(320, 240, 0.6), {30, 70});
  const std::optional<PicturePlace> place = find_picture(reference, screenshot);
  EXPECT_EQ(place, (PicturePlace{{30, 70}, {320, 240}}));
}

TEST(FindPicture, APartThatWasCutOut) {
  const Texture reference = balls(240, 180);
  const Texture part = cut_out(balls(240, 180, 0.5), {9, 13}, {200, 150});
  const std::optional<PicturePlace> place = find_picture(reference, part);
  ASSERT_TRUE(place);
  EXPECT_EQ(place->corner, glm::ivec2(-9, -13));
  EXPECT_EQ(place->size, glm::ivec2(240, 180));
}

TEST(FindPicture, NextToTheReference) {
  const Texture reference = balls(240, 180);
  const Texture wrong = balls(240, 180, 0.5);
  const Texture both =
      on(on(blank(516, 204, {255, 255, 255}), reference, {12, 12}), wrong, {264, 12});
  const std::optional<PicturePlace> place = find_picture(reference, both);
  ASSERT_TRUE(place);
  EXPECT_EQ(picture_next_to(*place, reference, both).value_or(*place),
            (PicturePlace{{264, 12}, {240, 180}}));
}

TEST(FindPicture, OtherSizesAndCamerasAreNoParts) {
  const Texture reference = balls(240, 180);
  EXPECT_FALSE(find_picture(reference, balls(320, 240)));
  EXPECT_FALSE(find_picture(reference, balls(240, 240)));
  EXPECT_FALSE(find_picture(reference, balls(300, 180)));
  EXPECT_FALSE(find_picture(reference, balls(320, 240, 1, 1.3)));  // more of the scene is seen
  EXPECT_FALSE(find_picture(reference, balls(320, 240, 1, 0.75)));
  EXPECT_FALSE(find_picture(reference, blank(320, 200, {30, 60, 90})));
  EXPECT_FALSE(find_picture(blank(240, 180), balls(320, 240)));
}

TEST(FindPicture, OutlinesOfOtherScenes) {
  const Texture reference = balls(240, 180);
  EXPECT_FALSE(have_other_outlines(reference, balls(240, 180, 0.3)));
  EXPECT_TRUE(have_other_outlines(reference, balls(240, 180, 1, 1.5)));
  EXPECT_TRUE(have_other_outlines(reference, mirrored(reference)));
  EXPECT_FALSE(have_other_outlines(reference, blank(240, 180)));  // not enough edges
}

}  // namespace
}  // namespace scenefile::compare_test
