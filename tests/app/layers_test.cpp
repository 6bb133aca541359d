#include "app/run_program.h"
#include "scenefile/asset/image_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace scenefile {
namespace {

using namespace testing_support;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

struct RenderLayers : ProgramFolder {
  RenderLayers() { scene = folder.write("scene.xml", good_scene); }

  ProgramRun render(std::vector<std::string> more, const std::string& output = "out.png") const {
    std::vector<std::string> words{"render", scene, "-o", folder.path(output), "--size", "32x24"};
    words.insert(words.end(), more.begin(), more.end());
    return run_program(words);
  }

  Texture picture(const std::string& name) const { return *decode_image(folder.read(name)); }

  std::string scene;
};

TEST_F(RenderLayers, AreSeparatePngFiles) {
  EXPECT_EQ(render({"--aov", "normal,object-id,light-1"}).status, 0);
  EXPECT_THAT(folder.list(), ElementsAre("out.light-1.png", "out.normal.png", "out.object-id.png",
                                         "out.png", "scene.xml"));
  EXPECT_GT(picture("out.normal.png").texel(16, 12)[2], 240);
}

TEST_F(RenderLayers, AreInTheSameExr) {
  EXPECT_EQ(render({"--aov", "depth,shadow"}, "out.exr").status, 0);
  EXPECT_THAT(folder.list(), ElementsAre("out.exr", "scene.xml"));
  const std::string bytes = folder.read("out.exr");
  EXPECT_THAT(bytes, HasSubstr("depth.Z"));
  EXPECT_THAT(bytes, HasSubstr("shadow.Y"));
}

TEST_F(RenderLayers, ObjectsAreListedForPrograms) {
  const rapidjson::Document answer =
      parse_json(render({"--aov", "object-id", "--crop", "1,2,3,4", "--json"}).out);
  ASSERT_EQ(answer["objects"].Size(), 1U);
  EXPECT_EQ(answer["objects"][0]["line"].GetInt(), 14);
  EXPECT_EQ(answer["crop"][3].GetInt(), 4);
  EXPECT_STREQ(answer["layers"][0].GetString(), "object-id");
}

TEST_F(RenderLayers, ACropHasItsOwnSize) {
  render({});
  const Texture whole = picture("out.png");
  EXPECT_THAT(render({"--crop", "10,5,20,12"}).err, HasSubstr("10x7"));
  const Texture part = picture("out.png");
  ASSERT_EQ(part.width, 10);
  ASSERT_EQ(part.height, 7);
  for (int x = 0; x < 10; ++x) {
    EXPECT_EQ(part.texel(x, 3)[0], whole.texel(x + 10, 8)[0]);
  }
}

TEST_F(RenderLayers, DenoiseRemovesNoise) {
  EXPECT_EQ(render({"--denoise", "--samples", "8"}).status, 0);
}

TEST_F(RenderLayers, InvalidOptionsAreUsageErrors) {
  const struct {
    std::vector<std::string> words;
    const char* says;
  } cases[] = {
      {{"--aov", "normals"}, "did you mean normal?"},
      {{"--aov", "depth,depth"}, "is in the list twice"},
      {{"--aov", "light-2"}, "the scene has no light-2, but 1 light"},
      {{"--crop", "1,2,3"}, "is not a region such as"},
      {{"--crop", "1,2,3,4,5"}, "is not a whole number"},
      {{"--crop", "5,5,5,9"}, "contains no pixels"},
      {{"--crop", "0,0,33,24"}, "extends outside of the picture of 32x24"},
      {{"--denoise", "--profile", "course"}, "--denoise is for the profile fine"},
  };
  for (const auto& c : cases) {
    const ProgramRun run = render(c.words);
    EXPECT_EQ(run.status, 2) << c.says;
    EXPECT_THAT(run.err, HasSubstr(c.says));
  }
  EXPECT_THAT(render({"--aov", "uv"}, "out.pfm").err, HasSubstr("needs an output that ends in"));
  EXPECT_THAT(folder.list(), ElementsAre("scene.xml"));
}

}  // namespace
}  // namespace scenefile
