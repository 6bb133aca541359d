#include "scenefile/viewer/save_view.h"

#include "io/temp_folder.h"
#include "viewer/test_scene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace scenefile::viewer {

namespace {

using ::testing::HasSubstr;
using testing_support::TempFolder;

struct SaveView : ::testing::Test {
  TempFolder folder;
  std::string path = folder.write("a.xml", testing::scene_text);
  Camera camera = *testing::open_file(path).written.camera;
};

TEST_F(SaveView, ChangesTheCameraAndNothingElse) {
  camera.position.y = 2.5F;
  const Result<std::string> saved = save_view(path, testing::scene_text, camera, {});
  ASSERT_EQ(error_text(saved), "");
  std::string wanted = testing::scene_text;
  wanted.replace(wanted.find("y=\"0\" z=\"6\""), 11, "y=\"2.5\" z=\"6\"");
  EXPECT_EQ(folder.read("a.xml"), wanted);
  EXPECT_EQ(*saved, wanted);
  EXPECT_EQ(folder.list().size(), 1U);
}

TEST_F(SaveView, DoesNotChangeAFileThatIsNotShown) {
  folder.write("a.xml", testing::scene_text + "<!-- more -->");
  EXPECT_THAT(error_text(save_view(path, testing::scene_text, camera, {})),
              HasSubstr("has changed"));
  EXPECT_EQ(folder.read("a.xml"), testing::scene_text + "<!-- more -->");
}

TEST_F(SaveView, ScenesWithoutAFile) {
  EXPECT_THAT(error_text(save_view("-", testing::scene_text, camera, {})),
              HasSubstr("standard input"));
  EXPECT_NE(error_text(save_view(folder.path("gone.xml"), testing::scene_text, camera, {})), "");
}

}  // namespace

}  // namespace scenefile::viewer
