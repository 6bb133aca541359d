#include "scenefile/export/write_gltf.h"

#include "scenefile/asset/image_file.h"
#include "scenefile/export/codes.h"
#include "scenefile/export/phong_pbr.h"
#include "scenefile/export/trs.h"
#include "scenefile/format/read_scene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidjson/document.h>

#include <cstring>
#include <random>

namespace scenefile {
namespace {

using testing::HasSubstr;

struct Written {
  std::string bytes;
  rapidjson::Document json;
  std::string_view buffer;
  Diagnostics diagnostics;
};

std::uint32_t number_at(const std::string& bytes, std::size_t at) {
  std::uint32_t number = 0;
  std::memcpy(&number, bytes.data() + at, 4);
  return number;
}

// Writes a scene as GLB and parses the result.
void write(const std::string& xml, Written& w, Assets assets = {}) {
  const Scene scene = read_scene(xml, {}, w.diagnostics);
  ASSERT_FALSE(w.diagnostics.has_errors());
  w.diagnostics = Diagnostics();
  const Prepared ready = prepare(scene, {});
  assets.textures.resize(ready.scene.texture_files.size());
  assets.meshes.resize(ready.scene.mesh_files.size());
  w.bytes = write_gltf(scene, ready, assets, {.segments = 8}, w.diagnostics);
  ASSERT_GE(w.bytes.size(), 20u);
  EXPECT_EQ(w.bytes.substr(0, 4), "glTF");
  EXPECT_EQ(number_at(w.bytes, 8), w.bytes.size());
  const std::uint32_t json_bytes = number_at(w.bytes, 12);
  ASSERT_LE(20 + json_bytes, w.bytes.size());
  w.json.Parse(w.bytes.data() + 20, json_bytes);
  ASSERT_FALSE(w.json.HasParseError());
  if (20 + json_bytes < w.bytes.size()) {
    w.buffer = std::string_view(w.bytes).substr(28 + json_bytes);
    EXPECT_EQ(number_at(w.bytes, 20 + json_bytes), w.buffer.size());
  }
}

std::string scene_of(const std::string& tree, const std::string& before = "") {
  return "<scenefile><globaldata><ambientcoeff v=\"1\"/><diffusecoeff v=\"1\"/><specularcoeff "
         "v=\"1\"/></globaldata>" +
         before + "<object type=\"tree\" name=\"root\">" + tree + "</object></scenefile>";
}

std::string block(const std::string& inside) {
  return "<transblock>" + inside + "</transblock>";
}

const std::string cube = "<object type=\"primitive\" name=\"cube\"/>";
const std::string light =
    R"(<lightdata><id v="0"/><type v="point"/><position x="0" y="10" z="0"/><color r="1" g=".5" b="0"/><function v1="1" v2="0" v3="0"/></lightdata>)";

bool says(const Written& w, const Code& code) {
  for (const Diagnostic& d : w.diagnostics.list()) {
    if (d.code == &code) {
      return true;
    }
  }
  return false;
}

int count_nodes_with(const Written& w, const char* member) {
  int count = 0;
  for (const auto& node : w.json["nodes"].GetArray()) {
    count += node.HasMember(member) ? 1 : 0;
  }
  return count;
}

TEST(WriteGltf, KeepsTheTreeAndItsNames) {
  Written w;
  write(scene_of(block("<translate x=\"1\" y=\"2\" z=\"3\"/><object type=\"tree\" name=\"arm\">" +
                       block(cube) + block(cube) + "</object>")),
        w);
  EXPECT_EQ(count_nodes_with(w, "mesh"), 2);
  EXPECT_EQ(w.json["meshes"].Size(), 1u) << "equal objects share a mesh";
  bool found = false;
  for (const auto& node : w.json["nodes"].GetArray()) {
    found = found || (node.HasMember("name") && std::string(node["name"].GetString()) == "arm" &&
                      node["children"].Size() == 2);
  }
  EXPECT_TRUE(found);
  EXPECT_TRUE(w.diagnostics.list().empty());
}

TEST(WriteGltf, CopiesTemplatesForEachInstance) {
  Written w;
  const std::string instance = "<object type=\"master\" name=\"t\"/>";
  write(scene_of(block(instance) + block("<translate x=\"2\" y=\"0\" z=\"0\"/>" + instance),
                 "<object type=\"tree\" name=\"t\">" + block(cube) + "</object>"),
        w);
  EXPECT_EQ(count_nodes_with(w, "mesh"), 2);
}

TEST(WriteGltf, DescribesItsBytes) {
  Written w;
  write(scene_of(block("<object type=\"primitive\" name=\"sphere\"/>")), w);
  EXPECT_EQ(w.json["buffers"][0]["byteLength"].GetUint(), w.buffer.size());
  for (const auto& accessor : w.json["accessors"].GetArray()) {
    const auto& view = w.json["bufferViews"][accessor["bufferView"].GetUint()];
    EXPECT_LE(view["byteOffset"].GetUint() + view["byteLength"].GetUint(), w.buffer.size());
    EXPECT_EQ(view["byteOffset"].GetUint() % 4, 0u);
  }
  EXPECT_EQ(w.json["accessors"][0]["min"][1].GetDouble(), -0.5);
  EXPECT_EQ(w.json["accessors"][0]["max"][1].GetDouble(), 0.5);
}

TEST(WriteGltf, ReportsEachApproximationOnce) {
  Written w;
  write(scene_of(block(cube), light + light), w);
  EXPECT_EQ(w.json["extensions"]["KHR_lights_punctual"]["lights"].Size(), 2u);
  EXPECT_EQ(w.diagnostics.list().size(), 1u);
  EXPECT_TRUE(says(w, "export.approximate"_code));
}

TEST(WriteGltf, LightsMatchAtTheCenterOfTheScene) {
  Written w;
  write(scene_of(block(cube), light), w);
  const auto& l = w.json["extensions"]["KHR_lights_punctual"]["lights"][0];
  EXPECT_NEAR(l["intensity"].GetDouble(), 3.14159265 * 100, 1e-3);
  EXPECT_EQ(l["color"][1].GetDouble(), 0.5);
}

TEST(WriteGltf, ReportsWhatIsLost) {
  Written w;
  const std::string camera =
      R"(<cameradata><pos x="0" y="0" z="5"/><look x="0" y="0" z="-1"/><up x="0" y="1" z="0"/><heightangle v="45"/><aperture v=".1"/><focallength v="5"/></cameradata>)";
  write(scene_of(block(cube), camera), w);
  EXPECT_TRUE(says(w, "export.lost"_code));
  EXPECT_NEAR(w.json["cameras"][0]["perspective"]["yfov"].GetDouble(), 0.785398, 1e-5);
}

TEST(WriteGltf, RejectsMoreNodesThanAllowed) {
  Diagnostics diagnostics;
  const Scene scene = read_scene(scene_of(block(cube) + block(cube)), {}, diagnostics);
  EXPECT_EQ(write_gltf(scene, prepare(scene, {}), {}, {.max_nodes = 1}, diagnostics), "");
  EXPECT_TRUE(diagnostics.has_errors());
}

TEST(WriteGltf, ATexturedMeshWithoutCoordinatesGetsThem) {
  Written w;
  Assets assets;
  assets.textures.push_back({1, 1, {255, 0, 0}});
  Mesh& triangle = assets.meshes.emplace_back();
  triangle.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  triangle.triangles = {{0, 1, 2}};
  const std::string mesh = "<object type=\"primitive\" name=\"mesh\" filename=\"a.obj\">";
  const std::string textured = "<blend v=\"1\"/><texture file=\"a.png\" u=\"1\" v=\"1\"/>";
  write(scene_of(block(mesh + "</object>") + block(mesh + textured + "</object>")), w, assets);
  const auto& meshes = w.json["meshes"];
  ASSERT_EQ(meshes.Size(), 2u);
  EXPECT_FALSE(meshes[0]["primitives"][0]["attributes"].HasMember("TEXCOORD_0"));
  EXPECT_TRUE(meshes[1]["primitives"][0]["attributes"].HasMember("TEXCOORD_0"));
}

TEST(WriteGltf, BakesBlendAndEncodesForTheScreen) {
  Written w;
  Assets assets;
  assets.textures.push_back({1, 1, {255, 0, 0}});
  write(scene_of(block("<object type=\"primitive\" name=\"cube\"><diffuse r=\"0\" g=\"0\" "
                       "b=\"0.5\"/><blend v=\"0.5\"/><texture file=\"a.png\" u=\"2\" v=\"3\"/>"
                       "</object>")),
        w, assets);
  ASSERT_EQ(w.json["images"].Size(), 1u);
  const auto& view = w.json["bufferViews"][w.json["images"][0]["bufferView"].GetUint()];
  const Result<Texture> baked =
      decode_image(w.buffer.substr(view["byteOffset"].GetUint(), view["byteLength"].GetUint()));
  // sRGB of 0.5, 0 and 0.25 in 1/255.
  EXPECT_THAT(baked->rgb, testing::ElementsAre(188, 0, 137));
}

TEST(Decompose, ReproducesAnyMap) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> value(-3, 3);
  for (int i = 0; i < 1000; ++i) {
    DAffine map;
    for (int column = 0; column < 3; ++column) {
      map.linear[column] = {value(random), value(random), value(random)};
    }
    map.offset = {value(random), value(random), value(random)};
    const TrsPair pair = decompose(map);
    for (const glm::dvec3& p : {glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0), glm::dvec3(1, 2, -3)}) {
      const glm::dvec3 inner = pair.inner ? *pair.inner * p : p;
      const glm::dvec3 there =
          pair.outer.translation + pair.outer.rotation * (pair.outer.scale * inner);
      EXPECT_LT(glm::distance(there, map.point(p)), 1e-12);
    }
  }
}

TEST(Decompose, NeedsOnePartWhereNothingShears) {
  const glm::dquat turn = glm::angleAxis(0.7, glm::normalize(glm::dvec3(1, 2, 3)));
  const DAffine map(glm::mat3_cast(turn) * glm::dmat3(2, 0, 0, 0, -3, 0, 0, 0, 4), {1, 2, 3});
  const TrsPair pair = decompose(map);
  EXPECT_FALSE(pair.inner);
  EXPECT_NEAR(std::abs(pair.outer.scale.y), 3, 1e-12);
  EXPECT_NEAR(pair.outer.scale.x * pair.outer.scale.y * pair.outer.scale.z, -24, 1e-9);
}

TEST(PhongPbr, HighlightsMirrorsAndGlassComeBack) {
  PhongColors shiny;
  shiny.diffuse = {0.2f, 0.4f, 0.6f};
  shiny.ambient = {0.1f, 0.2f, 0};
  shiny.specular = {0.5f, 0.25f, 0.5f};
  shiny.shininess = 20;
  const PhongColors back = phong_of(pbr_of(shiny));
  EXPECT_NEAR(back.shininess, 20, 1e-3);
  EXPECT_LT(glm::distance(back.specular, shiny.specular), 1e-5f);
  EXPECT_EQ(back.diffuse, shiny.diffuse);
  EXPECT_EQ(back.ambient, shiny.ambient);
  EXPECT_EQ(back.reflective, glm::vec3(0));
  PhongColors mirror;
  mirror.reflective = {0.5f, 0.6f, 0.7f};
  EXPECT_EQ(phong_of(pbr_of(mirror)).reflective, mirror.reflective);
  PhongColors glass;
  glass.diffuse = glm::vec3(0.1f);
  glass.transparent = glm::vec3(0.8f);
  glass.ior = 1.4f;
  const PhongColors clear = phong_of(pbr_of(glass));
  EXPECT_LT(glm::distance(clear.transparent, glass.transparent), 1e-5f);
  EXPECT_LT(glm::distance(clear.diffuse, glass.diffuse), 1e-5f);
  EXPECT_EQ(clear.ior, glass.ior);
}

TEST(PhongPbr, GlassIsSmooth) {
  PhongColors glass;
  glass.diffuse = glm::vec3(0.2f);
  glass.transparent = glm::vec3(0.5f);
  glass.ior = 1.5f;
  EXPECT_EQ(pbr_of(glass).roughness, 0) << "path tracers blur what is seen through rough glass";
  glass.specular = glm::vec3(0.5f);
  glass.shininess = 25;
  EXPECT_EQ(pbr_of(glass).roughness, 0) << "its highlight is lost, not what is seen through it";
  EXPECT_EQ(pbr_of(glass).f0, glm::vec3(0));
  glass.transparent = glm::vec3(0.1f);
  EXPECT_GT(pbr_of(glass).roughness, 0) << "little is seen through it";
  glass.shininess = 0;
  glass.transparent = glm::vec3(0);
  EXPECT_GT(pbr_of(glass).roughness, 0) << "a matte surface has no mirror images";
}

}  // namespace
}  // namespace scenefile
