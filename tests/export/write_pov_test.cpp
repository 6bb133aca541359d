#include "scenefile/export/write_pov.h"

#include "scenefile/export/codes.h"
#include "trace/build_scene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace scenefile {
namespace {

using testing::HasSubstr;
using testing::Not;
using trace_test::SceneBuilder;

struct WrittenPov {
  std::string text;
  Diagnostics diagnostics;
};

WrittenPov write(const SceneBuilder& scene, const PovOptions& options = {}) {
  WrittenPov w;
  const std::vector<std::string> paths(scene.scene.texture_files.size(), "image.png");
  w.text = write_pov(scene.scene, scene.assets, paths, options, w.diagnostics);
  return w;
}

bool says(const WrittenPov& w, const Code& code) {
  for (const Diagnostic& d : w.diagnostics.list()) {
    if (d.code == &code) {
      return true;
    }
  }
  return false;
}

TEST(WritePov, DoesNotReportExactConversions) {
  SceneBuilder scene;
  RenderMaterial m;
  m.specular = glm::vec3(.5f);
  m.shininess = 10;
  scene.add(Shape::cube, {}, scene.material(m));
  scene.light(LightType::point, {1, 2, 3}, glm::vec3(1));
  const WrittenPov w = write(scene);
  EXPECT_TRUE(w.diagnostics.list().empty());
  EXPECT_THAT(w.text, HasSubstr("light_source { <1, 2, 3> rgb <1, 1, 1> }"));
}

TEST(WritePov, ReportsApproximations) {
  SceneBuilder scene;
  RenderMaterial m;
  m.specular = {1, 0, 0};
  m.shininess = 10;
  scene.add(Shape::cube, {}, scene.material(m));
  EXPECT_TRUE(says(write(scene), "pov.approximate"_code));
}

TEST(WritePov, ReportsEachKindOncePerScene) {
  SceneBuilder scene;
  scene.add(Shape::cube, {}, scene.material({}));
  for (int i = 0; i < 3; ++i) {
    scene.light(LightType::point, {1, 2, 3}, glm::vec3(1)).attenuation = {1, 0, 1};
  }
  EXPECT_EQ(write(scene).diagnostics.list().size(), 1u);
}

TEST(WritePov, ReportsWhatIsLost) {
  SceneBuilder scene;
  RenderMaterial m;
  m.bump_map.file = scene.texture(1, 1, {0});
  scene.add(Shape::cube, {}, scene.material(m));
  EXPECT_TRUE(says(write(scene), "pov.lost"_code));
}

TEST(WritePov, LeavesOutTexturesThatCannotBeUsed) {
  SceneBuilder scene;
  RenderMaterial m;
  m.texture.file = scene.texture(1, 1, {0});
  m.blend = 1;
  scene.add(Shape::cube, {}, scene.material(m));
  EXPECT_THAT(write(scene).text, HasSubstr("image_map"));
  scene.assets.textures[0] = {};
  EXPECT_THAT(write(scene).text, Not(HasSubstr("image_map")));
}

TEST(WritePov, LeavesOutTexturesThatPovRayCannotOpen) {
  SceneBuilder scene;
  RenderMaterial m;
  m.texture.file = scene.texture(1, 1, {0});
  m.blend = 1;
  scene.add(Shape::cube, {}, scene.material(m));
  scene.add(Shape::cone, {}, scene.material(m));
  WrittenPov w;
  const std::vector<std::string> paths = {"/home/jos\u00e9/a.png"};
  w.text = write_pov(scene.scene, scene.assets, paths, {}, w.diagnostics);
  EXPECT_THAT(w.text, Not(HasSubstr("image_map")));
  ASSERT_EQ(w.diagnostics.list().size(), 1u);
  EXPECT_EQ(w.diagnostics.list()[0].code, &"pov.lost"_code);
  EXPECT_THAT(w.diagnostics.list()[0].message, HasSubstr("ASCII"));
}

TEST(WritePov, SaysThatPovRayScramblesInterlacedGifFiles) {
  SceneBuilder scene;
  RenderMaterial m;
  m.texture.file = scene.texture(1, 1, {0});
  m.blend = 1;
  scene.add(Shape::cube, {}, scene.material(m));
  for (const bool gif : {false, true}) {
    scene.assets.textures[0].format = gif ? "GIF" : "PNG";
    EXPECT_EQ(says(write(scene), "pov.approximate"_code), gif);
  }
}

TEST(WritePov, WritesAGroupOnceHoweverOftenItIsUsed) {
  SceneBuilder scene;
  RenderScene& s = scene.scene;
  s.groups[0].primitives = {scene.primitive(Shape::sphere, {}, scene.material({}))};
  for (std::uint32_t level = 1; level <= 30; ++level) {
    s.groups.emplace_back();
    s.groups.back().instances.assign(10, scene.instance(level - 1, {}));
  }
  s.root = 30;
  EXPECT_LT(write(scene).text.size(), 20000u);
}

TEST(WritePov, LeavesOutGroupsWithNothingInThem) {
  SceneBuilder scene;
  scene.scene.groups.emplace_back();
  scene.scene.groups[1].instances = {scene.instance(0, {})};
  scene.scene.root = 1;
  EXPECT_THAT(write(scene).text, Not(HasSubstr("union")));
}

TEST(WritePov, NamesTheFormatOfTexturesWhateverTheirExtension) {
  SceneBuilder scene;
  RenderMaterial m;
  m.texture.file = scene.texture(1, 1, {0});
  m.blend = 1;
  scene.add(Shape::cube, {}, scene.material(m));
  Diagnostics diagnostics;
  const std::vector<std::string> paths = {"a\"b\\c.png"};
  scene.assets.textures[0].format = "JPEG";
  EXPECT_THAT(write_pov(scene.scene, scene.assets, paths, {}, diagnostics),
              HasSubstr("jpeg \"a\\\"b\\\\c.png\""))
      << "the path is escaped";
}

}  // namespace
}  // namespace scenefile
