#pragma once
// A session with a scene from a file, without a window.

#include "io/temp_folder.h"
#include "scenefile/asset/image_file.h"
#include "scenefile/viewer/session.h"
#include "viewer/test_scene.h"

#include <gtest/gtest.h>

#include <chrono>
#include <string>
#include <thread>

namespace scenefile::viewer::testing {

// Advances simulated time, faster than real time.
inline void pass(Session& session, double& time, double seconds) {
  for (double end = time + seconds; time < end; time += 0.05) {
    tick(session, time);
  }
}
inline void settle(Session& session, double& time) {
  pass(session, time, 0.8);
  for (int i = 0; i < patience && !settled(session); ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    pass(session, time, 0.05);
  }
  EXPECT_TRUE(settled(session));
}

struct SessionFixture : ::testing::Test {
  SessionFixture() {
    session.setup.load = testing::open_request;
    session.setup.wake = [] {};
    session.setup.trace = default_options(Profile::fine);
    session.settings.samples = 1;
    session.picture = {{0, 0}, {400, 300}};
    session.pixels = {40, 30};
    open_scene(session, path);
    settle();
  }

  void pass(double seconds) { testing::pass(session, time, seconds); }
  void settle() { testing::settle(session, time); }
  // Nothing draws the pictures that a comparison waits for.
  void settle_files() {
    pass(0.8);
    for (int i = 0; i < testing::patience && (session.loading.busy() || session.reading.busy());
         ++i) {
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
      pass(0.05);
    }
  }
  void rewrite(const std::string& from, const std::string& to) {
    std::string text = folder.read("a.xml");
    ASSERT_NE(text.find(from), std::string::npos) << from;
    folder.write("a.xml", text.replace(text.find(from), from.size(), to));
    settle();
  }
  void click(double x, double y) {
    pointer_moved(session, {x, y});
    pointer_pressed(session, 0, {});
    pointer_released(session);
  }
  void drag(double x, double y, const KeyPress& with = {}, int button = 0) {
    pointer_moved(session, {200, 150});
    pointer_pressed(session, button, with);
    pointer_moved(session, {200 + x, 150 + y});
    pointer_released(session);
  }
  std::string selected() const {
    return session.selected ? session.shown->outline.rows[*session.selected].label : "";
  }
  std::string write_picture(const std::string& name, int width, int height) {
    return folder.write(name,
                        *encode_image(Image(width, height), ImageFormat::png8, Rounding::nearest));
  }
  const RenderScene& scene() const { return session.shown->opened.ready.scene; }

  testing_support::TempFolder folder;
  std::string path = folder.write("a.xml", testing::scene_text);
  Session session;
  double time = 0;
};

}  // namespace scenefile::viewer::testing
