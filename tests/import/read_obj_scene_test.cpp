#include "scenefile/import/read_obj_scene.h"

#include "scenefile/asset/image_file.h"
#include "scenefile/export/write_obj.h"
#include "scenefile/format/read_scene.h"
#include "scenefile/import/codes.h"
#include "scenefile/scene/check.h"
#include "scenefile/scene/prepare.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

namespace scenefile {
namespace {

using testing::HasSubstr;

ImportOptions with_files(std::map<std::string, std::string> files) {
  ImportOptions options;
  options.fetch = [files = std::move(files)](const std::string& name) {
    const auto found = files.find(name);
    return found == files.end() ? Result<std::string>(Error{"it is not there"}) : found->second;
  };
  return options;
}

const std::string two_triangles =
    "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nusemtl red\nf 1 2 3\nusemtl glass\nf 1 2 "
    "4\n";

TEST(ReadObjScene, CutsTheMeshUpByMaterial) {
  Diagnostics diagnostics;
  const ImportedScene scene = read_obj_scene(
      two_triangles,
      with_files({{"a.mtl",
                   "newmtl red\nKd 1 0 0\nKs .5 .5 .5\nNs 8\nillum 2\nnewmtl glass\nd 0.25\nTf 1 "
                   "0.5 1\nNi 1.4\nKs .5 .5 .5\nillum 6\n"}}),
      diagnostics);
  EXPECT_FALSE(diagnostics.has_errors());
  ASSERT_EQ(scene.files.size(), 2u);
  EXPECT_THAT(scene.files[0].bytes, HasSubstr("v 0 1 0\nf 1 2 3"));
  EXPECT_THAT(scene.files[1].bytes, HasSubstr("v 0 0 1\nf 1 2 3"));
  ASSERT_EQ(scene.scene.nodes.size(), 3u);
  const Material& red = scene.scene.nodes[1].primitives.at(0).material;
  EXPECT_EQ(red.diffuse, glm::vec3(1, 0, 0));
  EXPECT_EQ(red.specular, glm::vec3(.5f));
  EXPECT_EQ(red.shininess, 8);
  EXPECT_EQ(red.transparent, glm::vec3(0));
  const Material& glass = scene.scene.nodes[2].primitives.at(0).material;
  EXPECT_EQ(glass.transparent, glm::vec3(.75f, .375f, .75f));
  EXPECT_EQ(glass.reflective, glm::vec3(.5f));
  EXPECT_EQ(glass.ior, 1.4f);
  EXPECT_TRUE(scene.scene.camera);
}

Material read_red(const std::string& material, std::vector<std::string>* left_out = nullptr) {
  Diagnostics diagnostics;
  const ImportedScene scene = read_obj_scene(
      two_triangles, with_files({{"a.mtl", "newmtl red\n" + material + "\nnewmtl glass\n"}}),
      diagnostics);
  for (const Diagnostic& d : diagnostics.list()) {
    if (left_out != nullptr && d.code == &"import.left-out"_code) {
      left_out->push_back(d.message);
    }
  }
  return scene.scene.nodes.at(1).primitives.at(0).material;
}

TEST(ReadObjScene, GlassNeedsNoOpacity) {
  for (const std::string illum : {"6", "7", "9"}) {
    const Material m = read_red("Kd 1 0 0\nTf 1 0.5 1\nNi 1.5\nillum " + illum);
    EXPECT_EQ(m.transparent, glm::vec3(1, 0.5f, 1)) << illum;
    EXPECT_EQ(m.ior, 1.5f) << illum;
    EXPECT_EQ(m.diffuse, glm::vec3(1, 0, 0)) << illum;
  }
  EXPECT_EQ(read_red("Tf 1 1 1\nillum 2").transparent, glm::vec3(0));
  EXPECT_EQ(read_red("Ni 1.5\nillum 7").transparent, glm::vec3(0)) << "Tf is 0";
  EXPECT_EQ(read_red("Tf 1 1 1\nd 1\nillum 7").transparent, glm::vec3(0));
}

// Of glass, d is the share of light that it lets through in addition to its own color.
TEST(ReadObjScene, OpacityDimsTheColorOfOtherSurfaces) {
  const std::string material = "Kd 1 0.5 0\nd 0.5\nillum ";
  EXPECT_EQ(read_red(material + "2").diffuse, glm::vec3(.5f, .25f, 0));
  EXPECT_EQ(read_red(material + "2").transparent, glm::vec3(.5f));
  EXPECT_EQ(read_red(material + "9").diffuse, glm::vec3(1, .5f, 0));
}

TEST(ReadObjScene, SaysWhichPicturesAreLeftOut) {
  for (const auto& [map, what] :
       {std::pair{"map_d", "masks by alpha"}, std::pair{"map_opacity", "masks by alpha"},
        std::pair{"bump", "bump and normal maps"}, std::pair{"map_Bump", "bump and normal maps"},
        std::pair{"norm", "bump and normal maps"}, std::pair{"map_Ks", "pictures of highlights"}}) {
    std::vector<std::string> left_out;
    read_red(std::string(map) + " a.png", &left_out);
    EXPECT_THAT(left_out, testing::ElementsAre(std::string(what) + " are left out"));
  }
}

TEST(ReadObjScene, EmissionBecomesAmbientColorAndIsReported) {
  Diagnostics diagnostics;
  const ImportedScene scene = read_obj_scene(
      two_triangles,
      with_files(
          {{"a.mtl", "newmtl red\nKa 1 1 1\nKd 1 0 0\nKe 12 6 3\nnewmtl glass\nKe 1 1 1\n"}}),
      diagnostics);
  EXPECT_EQ(scene.scene.nodes.at(1).primitives.at(0).material.ambient, glm::vec3(12.1f, 6, 3));
  const auto& list = diagnostics.list();
  EXPECT_EQ(std::count_if(list.begin(), list.end(),
                          [](const Diagnostic& d) { return d.code == &"import.left-out"_code; }),
            1);
  ASSERT_FALSE(list.empty());
  EXPECT_THAT(list[0].message, HasSubstr("what materials emit becomes their ambient color"));
}

// The map says where the material emits.
TEST(ReadObjScene, EmissionWithAMapIsLeftOut) {
  Diagnostics diagnostics;
  const ImportedScene scene = read_obj_scene(
      two_triangles,
      with_files(
          {{"a.mtl",
            "newmtl red\nKa .1 0 0\nKe 1 1 1\nmap_Ke glow.png\nnewmtl glass\nmap_Ke b.png\n"}}),
      diagnostics);
  EXPECT_EQ(scene.scene.nodes.at(1).primitives.at(0).material.ambient, glm::vec3(.1f, 0, 0));
  std::vector<std::string> left_out;
  for (const Diagnostic& d : diagnostics.list()) {
    if (d.code == &"import.left-out"_code) {
      left_out.push_back(d.message);
    }
  }
  EXPECT_THAT(left_out, testing::ElementsAre("pictures of emission are left out"));
}

TEST(ReadObjScene, NamesAreCutBetweenCharacters) {
  std::string material(199, 'x');
  std::string text = two_triangles;
  text.replace(text.find("red"), 3, material + "\u00e9\u00e9");
  Diagnostics diagnostics;
  const ImportedScene scene = read_obj_scene(text, {}, diagnostics);
  EXPECT_EQ(std::string(scene.scene.nodes.at(1).name.str()), material);
}

TEST(ReadObjScene, ReadsWithoutItsFiles) {
  Diagnostics diagnostics;
  const ImportedScene scene = read_obj_scene(two_triangles, {}, diagnostics);
  EXPECT_FALSE(diagnostics.has_errors());
  EXPECT_EQ(scene.files.size(), 2u);
  ASSERT_FALSE(diagnostics.list().empty());
  EXPECT_EQ(diagnostics.list()[0].code, &"import.missing-file"_code);
}

TEST(ReadObjScene, RejectsOtherFiles) {
  for (const char* const text : {"", "v 0 0 0\n", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n"}) {
    Diagnostics diagnostics;
    EXPECT_TRUE(read_obj_scene(text, {}, diagnostics).files.empty());
    EXPECT_TRUE(diagnostics.has_errors()) << text;
  }
}

TEST(ReadObjScene, EnforcesTheLimitOfMeshes) {
  Diagnostics diagnostics;
  ImportOptions options;
  options.limits.mesh_bytes = 700;
  read_obj_scene(two_triangles, options, diagnostics);
  ASSERT_TRUE(diagnostics.has_errors());
  EXPECT_EQ(diagnostics.list().back().code, &"import.limit"_code);
}

TEST(ReadObjScene, RoundTrips) {
  Diagnostics diagnostics;
  const Scene scene = read_scene(
      R"(<scenefile><globaldata><ambientcoeff v="1"/><diffusecoeff v="0.5"/><specularcoeff v="1"/><transparentcoeff v="1"/></globaldata><object type="tree" name="root"><transblock><object type="primitive" name="cube"><diffuse r="1" g="0" b="0.5"/><ambient r="0.1" g="0.2" b="0.3"/><specular r="1" g="0.5" b="1"/><shininess v="20"/></object></transblock><transblock><object type="primitive" name="sphere"><blend v="1"/><texture file="a.png" u="1" v="1"/></object></transblock><transblock><object type="primitive" name="cone"><diffuse r="1" g="0" b="0"/><transparent r="0.5" g="0.25" b="0.5"/><ior v="1.5"/></object></transblock></object></scenefile>)",
      {}, diagnostics);
  ASSERT_FALSE(diagnostics.has_errors());
  const Prepared ready = prepare(scene, {});
  Assets assets;
  assets.textures.push_back({1, 1, {200, 100, 50}});
  const ObjScene obj = write_obj(ready.scene, assets, {}, diagnostics);
  diagnostics = Diagnostics();
  const ImportedScene back = read_obj_scene(
      obj.obj, with_files({{"scene.mtl", obj.mtl}, {"scene-1.png", obj.pictures.at(0)}}),
      diagnostics);
  check(back.scene, {}, diagnostics);
  ASSERT_FALSE(diagnostics.has_errors());
  ASSERT_EQ(back.scene.nodes.size(), 4u);
  const Material& glass = back.scene.nodes[3].primitives.at(0).material;
  EXPECT_EQ(glass.diffuse, glm::vec3(.5f, 0, 0));
  EXPECT_EQ(glass.transparent, glm::vec3(.5f, .25f, .5f));
  EXPECT_EQ(glass.ior, 1.5f);
  const Material& m = back.scene.nodes[1].primitives.at(0).material;
  EXPECT_EQ(m.diffuse, glm::vec3(.5f, 0, .25f));
  EXPECT_EQ(m.ambient, glm::vec3(.1f, .2f, .3f));
  EXPECT_EQ(m.specular, glm::vec3(1, .5f, 1));
  EXPECT_EQ(m.shininess, 20);
  const Material& textured = back.scene.nodes[2].primitives.at(0).material;
  ASSERT_TRUE(textured.texture);
  for (const ImportedFile& file : back.files) {
    if (file.name == textured.texture->file) {
      EXPECT_THAT(decode_image(file.bytes)->rgb, testing::ElementsAre(200, 100, 50));
    }
  }
}

}  // namespace
}  // namespace scenefile
