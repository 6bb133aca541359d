// The visible part of the picture, and values of pixels.

#include "viewer/session_fixture.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace scenefile::viewer {

namespace {

struct ZoomTest : testing::SessionFixture {
  // Opens a picture of 40 x 30 pixels, where the one at 3, 2 is 64 128 255.
  void open_mine() {
    Image image(40, 30);
    const float values[] = {64.0F / 255, 128.0F / 255, 1};
    std::copy(values, values + 3, image.pixel(3, 2));
    open_picture(session, folder.write("mine.pfm",
                                       *encode_image(image, ImageFormat::pfm, Rounding::nearest)));
    settle();
  }
  glm::dvec2 place_of(const glm::ivec2& pixel) const {
    return (glm::dvec2(pixel) + 0.5) / glm::dvec2(40, 30);
  }
};

TEST_F(ZoomTest, ThePlaceUnderThePointerStays) {
  open_mine();
  pointer_moved(session, {100, 60});
  const glm::dvec2 place = place_in_picture(session, {100, 60});
  wheel_turned(session, 6, true);
  EXPECT_GT(session.zoom, 2);
  const glm::dvec2 now = place_in_picture(session, {100, 60});
  EXPECT_NEAR(now.x, place.x, 1e-9);
  EXPECT_NEAR(now.y, place.y, 1e-9);
  EXPECT_EQ(session.camera, session.home) << "the camera does not move";
  wheel_turned(session, -20);
  EXPECT_EQ(session.zoom, 1) << "and out again";
  EXPECT_EQ(session.zoom_at, glm::dvec2(0.5));
}

TEST_F(ZoomTest, RaysFollowThePicture) {
  open_mine();
  const glm::dvec2 middle = session.picture.at + session.picture.size * 0.5;
  const Ray before = ray_in_window(session, middle + glm::dvec2(30, 12));
  zoom_picture(session, 3, {0.5, 0.5});
  const Ray after = ray_in_window(session, middle + glm::dvec2(90, 36));
  EXPECT_NEAR(glm::distance(before.direction, after.direction), 0, 1e-9);
  const std::optional<glm::dvec2> back =
      point_in_window(session, after.origin + 5.0 * after.direction);
  EXPECT_NEAR(glm::distance(back.value(), middle + glm::dvec2(90, 36)), 0, 1e-6);
}

TEST_F(ZoomTest, DraggingMovesThePictureAndClicksStillSelect) {
  open_mine();
  perform(session, Action::other);  // without the line of the split
  zoom_picture(session, 2, {0.5, 0.5});
  const glm::dvec2 place = place_in_picture(session, {200, 150});
  drag(-40, 0);
  EXPECT_NEAR(place_in_picture(session, {160, 150}).x, place.x, 1e-9);
  EXPECT_EQ(session.camera, session.home);
  perform(session, Action::escape);
  EXPECT_EQ(session.zoom, 1);
  zoom_picture(session, 2, {0.3, 0.5});
  const Box whole = whole_picture(session, session.picture);
  click(whole.at.x + 0.35 * whole.size.x, whole.at.y + 0.5 * whole.size.y);
  EXPECT_EQ(selected(), "sphere");
}

TEST_F(ZoomTest, KeysGoFromPixelToPixel) {
  open_mine();
  session.looked_at = place_of({3, 2});
  for (int i = 0; i < 20; ++i) {
    perform(session, Action::zoom_in);
  }
  const PixelSource source = pixels_of(session, Role::mine);
  EXPECT_GE(pixel_width(session, source), pixels_for_values);
  perform(session, Action::look_right);
  EXPECT_EQ(source.pixel_at(session.looked_at), glm::ivec2(4, 2));
  for (int i = 0; i < 60; ++i) {
    perform(session, Action::look_down);
    const Box whole = whole_picture(session, session.picture);
    EXPECT_TRUE(session.picture.holds(whole.at + session.looked_at * whole.size - 1e-6)) << i;
  }
  EXPECT_EQ(source.pixel_at(session.looked_at), glm::ivec2(4, 29)) << "the last row";
  // Without large pixels, steps are larger, except with the magnifier.
  perform(session, Action::zoom_all);
  session.looked_at = place_of({3, 2});
  perform(session, Action::look_right);
  EXPECT_GT(source.pixel_at(session.looked_at).x, 4);
  perform(session, Action::magnifier);
  session.looked_at = place_of({3, 2});
  perform(session, Action::look_right);
  EXPECT_EQ(source.pixel_at(session.looked_at).x, 4);
}

TEST_F(ZoomTest, ValuesAre8BitOrLinear) {
  open_mine();
  using Texts = std::array<std::string, 3>;
  const PixelSource mine = pixels_of(session, Role::mine);
  EXPECT_EQ(value_texts(session, mine, {3, 2}), (Texts{"64", "128", "255"}));
  perform(session, Action::linear_values);
  EXPECT_EQ(value_texts(session, mine, {3, 2}), (Texts{"0.251", "0.502", "1.000"}));
  // Of the traced picture, values above 1 are known.
  rewrite("<diffusecoeff v=\"1\"/>", "<diffusecoeff v=\"9\"/>");
  const PixelSource ours = pixels_of(session, Role::ours);
  ASSERT_NE(ours.linear, nullptr);
  const auto brightest =
      std::max_element(ours.linear->rgb.begin(), ours.linear->rgb.end()) - ours.linear->rgb.begin();
  EXPECT_GT(ours.linear->rgb[static_cast<std::size_t>(brightest)], 2);
  const int pixel = static_cast<int>(brightest / 3);
  const Texts texts = value_texts(session, ours, {pixel % 40, pixel / 40});
  EXPECT_GT(std::stod(texts[static_cast<std::size_t>(brightest % 3)]), 2);
}

}  // namespace

}  // namespace scenefile::viewer
