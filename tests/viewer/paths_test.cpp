// Mode path in the window.

#include "io/temp_folder.h"
#include "scenefile/path/render_path.h"
#include "scenefile/path/tone.h"
#include "scenefile/viewer/drawing_choices.h"
#include "scenefile/viewer/session.h"
#include "support/load_scene.h"
#include "viewer/test_scene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <thread>

namespace scenefile::viewer {

namespace {

using ::testing::HasSubstr;
using testing_support::TempFolder;

const std::string box_text = R"(<scenefile>
  <cameradata>
    <pos x="0.2" y="0.1" z="2.9"/><focus x="0" y="0" z="0"/><up x="0" y="1" z="0"/><heightangle v="45"/>
  </cameradata>
  <object type="tree" name="root">
    <transblock><object type="primitive" name="mesh" filename="box.obj"/></transblock>
    <transblock>
      <translate x="0.3" y="-0.6" z="0"/><scale x="0.8" y="0.8" z="0.8"/>
      <object type="primitive" name="sphere"><diffuse r="0.2" g="0.3" b="0.8"/></object>
    </transblock>
  </object>
</scenefile>
)";

struct PathsTest : ::testing::Test {
  PathsTest() {
    folder.write("box.mtl", "newmtl lamp\nKe 6 5 4\nnewmtl wall\nKd .7 .6 .5\n");
    folder.write("box.obj",
                 "mtllib box.mtl\nusemtl wall\nv -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1\n"
                 "v -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1\n"
                 "f 1 2 3 4\nf 1 5 6 2\nf 1 4 8 5\nf 2 6 7 3\nusemtl lamp\nf 4 3 7 8\n");
    session.setup.load = [this](const SceneRequest& request) {
      materials_wanted = request.materials;
      OpenedScene opened = testing::open_request(request);
      opened.assets = testing_support::load_files(request.path, opened.ready.scene,
                                                  opened.diagnostics, request.materials);
      return opened;
    };
    session.setup.wake = [] {};
    session.setup.trace = default_options(Profile::fine);
    session.setup.paths = default_options(Profile::fine);
    session.setup.paths.mode = Mode::path;
    session.setup.paths.max_depth = path_max_depth;
    session.setup.paths.samples = 6;
    session.setup.path_noise = 0;
    session.picture = {{0, 0}, {400, 300}};
    session.pixels = {48, 36};
  }

  void open(const std::string& text) { open_scene(session, folder.write("a.xml", text)); }
  template <typename Condition>
  bool until(const Condition& condition) {
    for (int i = 0; i < testing::patience && !condition(); ++i) {
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
      tick(session, time += 0.05);
    }
    return condition();
  }
  bool settle() {
    return until([this] { return session.shown != nullptr && settled(session); });
  }
  // What render writes for the session's scene.
  Texture rendered(int samples, const RenderCamera& camera) const {
    RenderScene scene = session.shown->opened.ready.scene;
    scene.camera = camera;
    RenderOptions options = session.setup.paths;
    options.width = session.pixels.x;
    options.height = session.pixels.y;
    options.samples = samples;
    const Image image = render_path(scene, session.shown->opened.assets, options).image;
    return quantize(tone_mapped(image, Tone::course, 0), Rounding::nearest);
  }

  TempFolder folder;
  std::atomic<bool> materials_wanted{false};
  Session session;
  double time = 0;
};

TEST_F(PathsTest, TheLastPictureIsThatOfRender) {
  open(box_text);
  ASSERT_TRUE(settle());
  ASSERT_TRUE(traces_paths(session));
  EXPECT_FALSE(session.settings.ray_tracing);
  ASSERT_TRUE(shows_traced(session));
  EXPECT_EQ(session.traced->samples, 6);
  EXPECT_GT(session.traced->noise, 0);
  EXPECT_EQ(session.traced->picture.rgb, rendered(6, session.shown->opened.ready.scene.camera).rgb);
  EXPECT_FALSE(session.trace.busy());
  EXPECT_THAT(mode_text(session), HasSubstr("mode path"));
}

TEST_F(PathsTest, EachPictureIsThatOfRender) {
  session.setup.paths.samples = 40;
  session.pixels = {80, 60};
  open(box_text);
  int seen = 0;
  ASSERT_TRUE(until([&] {
    if (session.traced && session.traced->samples > seen) {
      seen = session.traced->samples;
      EXPECT_EQ(session.traced->picture.rgb, rendered(seen, render_camera(session.camera)).rgb);
    }
    return seen == 40;
  }));
}

TEST_F(PathsTest, FollowTheSizeOfTheWindow) {
  open(box_text);
  ASSERT_TRUE(settle());
  set_pixels(session, {60, 20});
  ASSERT_TRUE(settle());
  EXPECT_EQ(session.traced->picture.width, 60);
  EXPECT_EQ(session.traced->picture.height, 20);
}

TEST_F(PathsTest, StopsAtTheNoise) {
  session.setup.paths.samples = most_path_samples;
  session.setup.path_noise = 0.1;
  open(box_text);
  ASSERT_TRUE(settle());
  EXPECT_LE(session.traced->noise, 0.1);
  EXPECT_LT(session.traced->samples, most_path_samples);
  EXPECT_FALSE(session.trace.busy()) << "uses no processor";
}

TEST_F(PathsTest, PicturesFollowTheMovingCamera) {
  session.setup.paths.samples = 1 << 16;
  session.pixels = {320, 240};
  open(box_text);
  ASSERT_TRUE(until([&] { return session.traced.has_value(); }));
  pointer_moved(session, {200, 150});
  pointer_pressed(session, 0, {});
  // The camera never rests, and yet there are new pictures, and always one.
  std::uint64_t version = session.traced_version;
  int pictures = 0;
  for (int i = 0; i < testing::patience && pictures < 5; ++i) {
    pointer_moved(session, {200.0 + i % 150, 150});
    tick(session, time += 0.01);
    EXPECT_FALSE(at_rest(session));
    ASSERT_TRUE(shows_traced(session));
    EXPECT_FALSE(session.traced->complete);
    pictures += session.traced_version != version ? 1 : 0;
    version = session.traced_version;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  EXPECT_EQ(pictures, 5);
  pointer_released(session);
  session.setup.paths.samples = 3;
  picture_changed(session);
  ASSERT_TRUE(settle());
  EXPECT_EQ(session.traced->picture.rgb, rendered(3, render_camera(session.camera)).rgb);
}

TEST_F(PathsTest, AnotherSceneDoesNotShowTheOldPicture) {
  open(box_text);
  ASSERT_TRUE(settle());
  open_scene(session, folder.write("b.xml", testing::scene_text));
  ASSERT_TRUE(until([&] { return shown_name(session) == "b.xml"; }));
  EXPECT_FALSE(traces_paths(session));
  EXPECT_FALSE(session.traced.has_value());
  EXPECT_FALSE(shows_traced(session));
}

TEST_F(PathsTest, WhatIsHiddenDoesNotShine) {
  open(box_text);
  ASSERT_TRUE(settle());
  const std::vector<RenderGroup>& groups = session.shown->opened.ready.scene.groups;
  for (const RenderGroup& group : groups) {
    for (const RenderPrimitive& primitive : group.primitives) {
      if (primitive.shape == Shape::mesh) {
        session.hidden.insert(primitive.source);
      }
    }
  }
  ASSERT_FALSE(session.hidden.empty());
  picture_changed(session);
  ASSERT_TRUE(settle());
  EXPECT_EQ(
      *std::max_element(session.traced->picture.rgb.begin(), session.traced->picture.rgb.end()), 0);
  perform(session, Action::show_all);
  ASSERT_TRUE(settle());
  EXPECT_EQ(session.traced->picture.rgb, rendered(6, render_camera(session.camera)).rgb);
}

TEST_F(PathsTest, AClickExplainsTheSamplesOfThePicture) {
  PixelQuestion asked;
  session.setup.explain_pixel = [&](const PixelQuestion& question) {
    asked = question;
    return std::string("paths");
  };
  open(box_text);
  ASSERT_TRUE(settle());
  read_pixel(session, glm::dvec2(0.5, 0.5));
  ASSERT_TRUE(settle());
  EXPECT_EQ(asked.options.mode, Mode::path);
  EXPECT_EQ(asked.options.samples, 6);
  EXPECT_EQ(asked.options.width, 48);
  EXPECT_THAT(readout_text(session), HasSubstr("paths"));
}

TEST_F(PathsTest, TheModeIsAChoice) {
  open(box_text);
  ASSERT_TRUE(settle());
  EXPECT_EQ(drawn_as(session), DrawnAs::paths);
  draw_as(session, DrawnAs::fine);
  EXPECT_FALSE(traces_paths(session));
  EXPECT_FALSE(session.traced.has_value());
  EXPECT_EQ(trace_options(session).mode, Mode::ray);
  draw_as(session, DrawnAs::paths);
  EXPECT_TRUE(traces_paths(session));
  perform(session, Action::wireframe);
  EXPECT_FALSE(traces_paths(session));
  EXPECT_FALSE(shows_traced(session));
}

TEST_F(PathsTest, AnySceneCanBePathTraced) {
  open(testing::scene_text);
  ASSERT_TRUE(settle());
  EXPECT_FALSE(traces_paths(session));
  EXPECT_FALSE(materials_wanted);
  draw_as(session, DrawnAs::paths);
  ASSERT_TRUE(settle());
  EXPECT_TRUE(materials_wanted) << "of its meshes, read again";
  EXPECT_EQ(session.traced->picture.rgb, rendered(6, render_camera(session.camera)).rgb);
}

TEST_F(PathsTest, CanBeDestroyedAtAnyTime) {
  const std::string path = folder.write("a.xml", box_text);
  for (int i = 0; i < 20; ++i) {
    Session other;
    other.setup = session.setup;
    other.setup.paths.samples = 1000;
    other.picture = session.picture;
    other.pixels = {200, 150};
    open_scene(other, path);
    for (int step = 0; step < i; ++step) {
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
      tick(other, 0.3 * step);
      wheel_turned(other, 1);
    }
  }
}

}  // namespace

}  // namespace scenefile::viewer
