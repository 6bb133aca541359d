#include "scenefile/base/suggest.h"

#include <gtest/gtest.h>

#include <array>
#include <string>

namespace scenefile {
namespace {

constexpr std::array<std::string_view, 8> words = {
    "diffuse", "specular", "shininess", "transblock", "position", "angle", "id", "heightangle"};

TEST(Suggest, FindsWhatWasMeant) {
  EXPECT_EQ(nearest_name("difuse", words), "diffuse");
  EXPECT_EQ(nearest_name("shinyness", words), "shininess");
  EXPECT_EQ(nearest_name("tranblock", words), "transblock");
  EXPECT_EQ(nearest_name("postion", words), "position");
  EXPECT_EQ(nearest_name("anlge", words), "angle");
  EXPECT_EQ(nearest_name("HeightAngle", words), "heightangle");
  EXPECT_EQ(nearest_name("heigthangle", words), "heightangle");
  EXPECT_EQ(nearest_name("ID", words), "id");
}

TEST(Suggest, SaysNothingWhenNothingIsNear) {
  EXPECT_EQ(nearest_name("frobnicate", words), "");
  EXPECT_EQ(nearest_name("", words), "");
  EXPECT_EQ(nearest_name("x", words), "");
  EXPECT_EQ(nearest_name(std::string(100000, 'a'), words), "");
}

TEST(Suggest, TheStartOfANameIsNear) {
  constexpr std::string_view keys[] = {"textureFile", "textureU", "cameraData"};
  EXPECT_EQ(nearest_name("texture", keys), "textureFile");
  EXPECT_EQ(nearest_name("Camera", keys), "cameraData");
  EXPECT_EQ(nearest_name("text", keys), "");
}

}  // namespace
}  // namespace scenefile
