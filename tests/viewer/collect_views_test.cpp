#include "scenefile/viewer/collect_views.h"

#include "io/temp_folder.h"
#include "scenefile/format/read_cameras.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

namespace scenefile::viewer {

namespace {

using ::testing::HasSubstr;
using testing_support::TempFolder;

struct CollectViews : ::testing::Test {
  TempFolder folder;
  std::string path = folder.path("a-views.json");
  Limits limits;

  static Camera camera_at(float x) {
    Camera camera;
    camera.position.x = x;
    camera.height_angle_deg = 33.3F;
    return camera;
  }
  CameraPath read() const { return *read_cameras(folder.read("a-views.json"), Camera{}, limits); }
};

TEST_F(CollectViews, RoundTrip) {
  for (const int i : {1, 2, 3}) {
    const Result<std::size_t> views =
        change_views(path, camera_at(0.1F * static_cast<float>(i)), {}, limits);
    ASSERT_EQ(error_text(views), "");
    EXPECT_EQ(*views, static_cast<std::size_t>(i));
  }
  const CameraPath found = read();
  ASSERT_EQ(found.views.size(), 3U);
  for (const int i : {0, 1, 2}) {
    const CameraView& view = found.views[static_cast<std::size_t>(i)];
    EXPECT_EQ(view.time, i);
    EXPECT_EQ(view.camera, camera_at(0.1F * static_cast<float>(i + 1)));
  }
}

TEST_F(CollectViews, KeepsTheUsersText) {
  folder.write("a-views.json", R"({"fps": 12, "views": [{"time": 4.5, "position": [1, 2, 3],
      "focus": [0, 0.5, 0], "aperture": 0.25, "focalLength": 2}]})");
  const CameraPath before = read();
  EXPECT_EQ(*change_views(path, camera_at(9), {}, limits), 2U);
  const CameraPath after = read();
  EXPECT_EQ(after.fps, 12);
  EXPECT_EQ(after.views[0].camera, before.views[0].camera);
  EXPECT_EQ(after.views[0].focus, before.views[0].focus);
  EXPECT_EQ(after.views[1].time, 5.5);
  EXPECT_FALSE(after.views[1].focus.has_value());
}

TEST_F(CollectViews, WhatTheFirstViewLeavesOutIsTheScenes) {
  folder.write("a-views.json", R"({"views": [{"time": 0, "position": [3, 2.2, 4]}]})");
  Camera scene = camera_at(7);
  scene.look = {0, -1, 0};
  EXPECT_EQ(*change_views(path, camera_at(9), scene, limits), 2U);
  scene.position = {3, 2.2, 4};
  EXPECT_EQ(read().views[0].camera, scene);
}

TEST_F(CollectViews, RemovesTheLastView) {
  ASSERT_TRUE(change_views(path, camera_at(1), {}, limits));
  const std::string one = folder.read("a-views.json");
  ASSERT_TRUE(change_views(path, camera_at(2), {}, limits));
  EXPECT_EQ(*change_views(path, {}, {}, limits), 1U);
  EXPECT_EQ(folder.read("a-views.json"), one);
  EXPECT_EQ(error_text(change_views(path, {}, {}, limits)), "");
  EXPECT_FALSE(std::filesystem::exists(path));
  EXPECT_EQ(error_text(change_views(path, {}, {}, limits)), "there are no views");
}

TEST_F(CollectViews, NeverChangesOtherFiles) {
  folder.write("a-views.json", "my notes");
  EXPECT_THAT(error_text(change_views(path, camera_at(1), {}, limits)),
              HasSubstr("a-views.json:1:1"));
  EXPECT_NE(error_text(change_views(path, {}, {}, limits)), "");
  EXPECT_EQ(folder.read("a-views.json"), "my notes");
  EXPECT_NE(error_text(change_views(folder.path("no/such.json"), camera_at(1), {}, limits)), "");
}

TEST(ViewsFile, IsNamedAfterTheScene) {
  EXPECT_EQ(views_file("some/chess.xml"),
            (std::filesystem::current_path() / "chess-views.json").string());
  EXPECT_THAT(views_file("-"), HasSubstr("/scene-views.json"));
}

}  // namespace

}  // namespace scenefile::viewer
