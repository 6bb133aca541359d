// The readout of a clicked pixel, and what is copied.

#include "io/temp_folder.h"
#include "scenefile/asset/image_file.h"
#include "scenefile/viewer/session.h"
#include "viewer/session_fixture.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <thread>
#include <utility>

namespace scenefile::viewer {

namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using testing_support::TempFolder;

struct PixelTest : ::testing::Test {
  PixelTest() {
    session.setup.load = testing::open_request;
    session.setup.wake = [] {};
    session.setup.trace = default_options(Profile::fine);
    session.setup.explain_pixel = [this](const PixelQuestion& question) {
      ++explained;
      const glm::dvec3 eye = question.drawn.camera.position;
      return fmt::format("terms of {},{} from z {:.3f}, {} lights, beside {}{}{}", question.pixel.x,
                         question.pixel.y, eye.z, question.drawn.lights.size(),
                         question.mine ? int((*question.mine)[0]) : -1,
                         question.suggest ? ", with suggestions" : "",
                         question.realtime ? fmt::format(", parameter 1 is {}",
                                                         question.realtime->tessellation.parameter1)
                                           : "");
    };
    session.setup.find_cause = [this](const CauseQuestion& question,
                                      const std::function<bool()>& /*go_on*/) {
      ++searched;
      return CauseAnswer{
          fmt::format("cause at {}x{} {}", question.options.width, question.options.height,
                      question.realtime ? "realtime" : "traced"),
          nothing_found};
    };
    session.picture = {{0, 0}, {400, 300}};
    session.pixels = {40, 30};
    open_scene(session, path);
    settle();
  }

  void pass(double seconds) { testing::pass(session, time, seconds); }
  void settle() { testing::settle(session, time); }
  void click(double x, double y, bool alt = true) {
    pointer_moved(session, {x, y});
    pointer_pressed(session, 0, {.name = {}, .alt = alt});
    pointer_released(session);
  }
  std::string copied() {
    perform(session, Action::copy);
    return std::exchange(session.copied, {});
  }
  void compare_with_gray() {
    Image gray(80, 60);
    std::fill(gray.rgb.begin(), gray.rgb.end(), 0.5F);
    open_picture(session, folder.write("gray.png",
                                       *encode_image(gray, ImageFormat::png8, Rounding::nearest)));
    while (session.reading.busy()) {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
      tick(session, time);
    }
    ASSERT_TRUE(session.mine.exists());
  }

  std::optional<PixelValue> mine_read() const {
    return session.readout.values[static_cast<std::size_t>(Role::mine)];
  }

  TempFolder folder;
  std::string path = folder.write("a.xml", testing::scene_text);
  std::atomic<int> explained = 0;
  std::atomic<int> searched = 0;
  std::atomic<bool> nothing_found = false;
  Session session;
  double time = 0;
};

TEST_F(PixelTest, AClickReadsItsPixel) {
  click(140, 150);
  ASSERT_TRUE(session.readout.at.has_value());
  EXPECT_EQ(session.readout.pixel, glm::ivec2(14, 15));
  settle();
  EXPECT_THAT(session.readout.terms, HasSubstr("terms of 14,15 from z 6.000, 2 lights, beside -1"));
  EXPECT_EQ(searched, 0) << "there is no picture beside ours";
  click(399.9, 299.9);
  EXPECT_EQ(session.readout.pixel, glm::ivec2(39, 29));
  perform(session, Action::escape);
  EXPECT_FALSE(session.readout.at.has_value());
  EXPECT_EQ(readout_text(session), "");
}

TEST_F(PixelTest, APictureOfAnotherShapeExplainsWhatWasClicked) {
  click(145, 155);
  ASSERT_EQ(session.readout.pixel, glm::ivec2(14, 15));
  const Ray before = ray_in_window(session, {145, 155});
  session.picture.size = {300, 300};  // the panel of the pixel opens
  set_pixels(session, {30, 30});
  settle();
  EXPECT_EQ(session.readout.pixel, glm::ivec2(9, 15));
  EXPECT_THAT(session.readout.terms, HasSubstr("terms of 9,15"));
  const Ray after = ray_in_window(session, *session.readout.at * session.picture.size);
  EXPECT_LT(glm::distance(before.direction, after.direction), 1e-9);
  click(290, 155);
  session.picture.size = {150, 300};
  set_pixels(session, {15, 30});
  EXPECT_FALSE(session.readout.at.has_value());
  EXPECT_TRUE(session.explaining);
  EXPECT_THAT(session.notice->text, HasSubstr("click again"));
}

TEST_F(PixelTest, InRealtimeToo) {
  perform(session, Action::realtime);
  click(145, 155);
  const Ray before = ray_in_window(session, {145, 155});
  session.picture.size = {300, 300};
  set_pixels(session, {30, 30});
  const Ray after = ray_in_window(session, *session.readout.at * session.picture.size);
  EXPECT_LT(glm::distance(before.direction, after.direction), 0.02) << "sizes are rounded";
}

TEST_F(PixelTest, PlainClicksExplainOnlyWhileThePanelIsOpen) {
  click(140, 150, false);
  EXPECT_TRUE(session.selected.has_value());
  EXPECT_FALSE(session.readout.at.has_value());
  perform(session, Action::explain);
  click(260, 150, false);
  EXPECT_EQ(session.readout.pixel, glm::ivec2(26, 15));
  perform(session, Action::explain);
  EXPECT_FALSE(session.readout.at.has_value());
  click(140, 150, false);
  EXPECT_FALSE(session.readout.at.has_value());
}

TEST_F(PixelTest, OnePixelSuggestsOnlyWhatThePicturesDoNotExplain) {
  compare_with_gray();
  click(140, 150);
  settle();
  EXPECT_THAT(session.readout.terms, Not(HasSubstr("suggestions")));
  nothing_found = true;
  perform(session, Action::escape);
  click(260, 150);
  settle();
  EXPECT_EQ(searched, 2);
  EXPECT_THAT(session.readout.terms, HasSubstr("suggestions"));
}

TEST_F(PixelTest, PicturesOfDifferentCamerasAreNotCompared) {
  compare_with_gray();
  click(140, 150);
  EXPECT_EQ(mine_read(), (PixelValue{128, 128, 128}));
  settle();
  EXPECT_TRUE(session.compare_started);
  wheel_turned(session, 3);
  settle();
  EXPECT_FALSE(session.compare_started);
  EXPECT_FALSE(mine_read().has_value());
  EXPECT_THAT(session.readout.terms, HasSubstr("beside -1"));
  perform(session, Action::scene_camera);
  settle();
  EXPECT_TRUE(session.compare_started);
  EXPECT_EQ(mine_read(), (PixelValue{128, 128, 128}));
}

TEST_F(PixelTest, FollowsTheCameraAndHiddenObjects) {
  click(140, 150);
  settle();
  wheel_turned(session, 3);
  EXPECT_EQ(session.readout.terms, "");
  settle();
  EXPECT_THAT(session.readout.terms, Not(HasSubstr("z 6.000")));
  perform(session, Action::next_light);
  settle();
  EXPECT_THAT(session.readout.terms, HasSubstr("1 lights"));
}

TEST_F(PixelTest, MineGivesItsValueAndTheCause) {
  compare_with_gray();
  session.compare = CompareView::off;
  click(200, 150);
  EXPECT_EQ(session.readout.size, glm::ivec2(80, 60));
  EXPECT_EQ(session.readout.pixel, glm::ivec2(40, 30));
  settle();
  EXPECT_THAT(session.readout.terms, HasSubstr("beside 128"));
  EXPECT_EQ(session.cause.answer.text, "cause at 80x60 traced");
  click(100, 150);
  settle();
  EXPECT_EQ(searched, 1) << "the cause does not depend on the pixel";
  EXPECT_EQ(explained, 2);
  perform(session, Action::toggle_shadows);
  EXPECT_THAT(cause_text(session), HasSubstr("looking for the cause"));
  settle();
  EXPECT_EQ(searched, 2);
}

TEST_F(PixelTest, RealtimeComparesTheDrawnPicture) {
  compare_with_gray();
  session.compare = CompareView::off;
  perform(session, Action::realtime);
  click(200, 150);
  settle();
  EXPECT_EQ(searched, 0);
  EXPECT_THAT(cause_text(session), HasSubstr("while the pictures are compared"));
  perform(session, Action::split);
  pass(0.5);
  ASSERT_TRUE(wants_picture(session));
  compare_ours(session, session.mine.decoded->texture);
  settle();
  EXPECT_EQ(session.cause.answer.text, "cause at 80x60 realtime");
}

TEST_F(PixelTest, TermsFollowThePanelOfRealtime) {
  perform(session, Action::realtime);
  click(200, 150);
  settle();
  EXPECT_THAT(session.readout.terms, HasSubstr("parameter 1 is 5"));
  session.realtime_panel.tessellation.parameter1 = 7;
  picture_changed(session);
  settle();
  EXPECT_THAT(session.readout.terms, HasSubstr("parameter 1 is 7"));
  perform(session, Action::realtime);
  settle();
  EXPECT_THAT(session.readout.terms, Not(HasSubstr("parameter")));
}

TEST_F(PixelTest, LinesNameRowsOfTheOutline) {
  const std::vector<OutlineRow>& rows = session.shown->outline.rows;
  const auto label = [&](const std::string& line) {
    const std::optional<std::uint32_t> row = row_named_in(session, line);
    return row ? rows[*row].label : "none";
  };
  const auto line_of = [&](const std::string& name) {
    return std::find_if(
               rows.begin(), rows.end(),
               [&](const OutlineRow& row) { return row.label == name && row.source != no_index; })
        ->location.line;
  };
  EXPECT_EQ(label(fmt::format("│ ├ hits cube root/#2 (line {}) at t = 6.2", line_of("cube"))),
            "cube");
  EXPECT_EQ(label(fmt::format("├ point light (line {}) 0.22", line_of("point light"))),
            "point light");
  EXPECT_EQ(label(fmt::format("hits root/#3 > spike/#1 (line {})", line_of("cone"))), "cone");
  EXPECT_EQ(label("hits cube root/#2 (line 1000)"), "none");
  EXPECT_EQ(label(fmt::format("point light (line {})", line_of("cube"))), "none");
  EXPECT_EQ(label("├ samples 1"), "none");
}

TEST_F(PixelTest, AnotherSceneClosesIt) {
  click(140, 150);
  settle();
  open_scene(session, folder.write("b.xml", testing::scene_text));
  settle();
  EXPECT_FALSE(session.readout.at.has_value());
}

TEST_F(PixelTest, CopiesThePixelTheSelectionOrTheCamera) {
  EXPECT_EQ(copied(), "pos 0 0 6\nlook 0 0 -6\nup 0 1 0\nheightangle 45\n");
  EXPECT_THAT(session.notice->text, HasSubstr("the camera"));
  select(session, session.shown->outline.row_of_source[0]);
  std::string text = copied();
  EXPECT_THAT(text, HasSubstr("sphere " + path + ":"));
  EXPECT_THAT(text, HasSubstr("diffuse 1 0 0\n"));
  click(260, 150);
  settle();
  text = copied();
  EXPECT_THAT(text, HasSubstr("pixel 26,15 of 40x30\n"));
  EXPECT_THAT(text, HasSubstr("terms of 26,15"));
  EXPECT_THAT(session.notice->text, HasSubstr("the pixel"));
}

}  // namespace

}  // namespace scenefile::viewer
