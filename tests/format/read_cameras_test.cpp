#include "scenefile/format/read_cameras.h"

#include <gtest/gtest.h>

#include <string>

namespace scenefile {
namespace {

TEST(ReadCameras, ReadsFilesWithAByteOrderMark) {
  const std::string text = "\xEF\xBB\xBF{\"views\": [{\"heightAngle\": 30}]}";
  const Result<CameraPath> path = read_cameras(text, {}, {});
  ASSERT_TRUE(path) << path.error().text;
  EXPECT_EQ(path->views.at(0).camera.height_angle_deg, 30);
  const Result<CameraPath> wrong = read_cameras("\xEF\xBB\xBF{\"view\": []}", {}, {});
  ASSERT_FALSE(wrong);
  EXPECT_EQ(wrong.error().text.substr(0, 4), "1:1:") << wrong.error().text;
}

}  // namespace
}  // namespace scenefile
