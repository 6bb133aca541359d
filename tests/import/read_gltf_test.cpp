#include "scenefile/import/read_gltf.h"

#include "scenefile/asset/image_file.h"
#include "scenefile/base/base64.h"
#include "scenefile/export/write_gltf.h"
#include "scenefile/format/read_scene.h"
#include "scenefile/import/codes.h"
#include "scenefile/scene/check.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace scenefile {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;

const std::string globals =
    R"(<globaldata><ambientcoeff v="0.5"/><diffusecoeff v="0.8"/><specularcoeff v="0.5"/><transparentcoeff v="1"/></globaldata>)";
const std::string camera =
    R"(<cameradata><pos x="1" y="2" z="5"/><look x="-0.1" y="-0.3" z="-1"/><up x="0" y="1" z="0"/><heightangle v="50"/></cameradata>)";
const std::string lights =
    R"(<lightdata><id v="0"/><type v="point"/><position x="0" y="10" z="0"/><color r="1" g=".5" b="0.25"/><function v1="1" v2="0.5" v3="0"/></lightdata>)"
    R"(<lightdata><id v="1"/><type v="directional"/><direction x="1" y="-2" z="-1"/><color r="0.5" g=".5" b="0.5"/></lightdata>)"
    R"(<lightdata><id v="2"/><type v="spot"/><position x="3" y="4" z="5"/><direction x="0" y="-1" z="0"/><color r="1" g="1" b="1"/><function v1="1" v2="0" v3="0"/><angle v="30"/><penumbra v="10"/></lightdata>)";

std::string scene_of(const std::string& tree) {
  return "<scenefile>" + globals + camera + lights + "<object type=\"tree\" name=\"root\">" + tree +
         "</object></scenefile>";
}

struct Trip {
  Scene scene;
  Prepared ready;
  ImportedScene back;
  Prepared ready_back;
  Diagnostics diagnostics;
};

void travel(const std::string& xml, bool binary, Trip& trip, Assets assets = {}) {
  Diagnostics ignored;
  trip.scene = read_scene(xml, {}, ignored);
  ASSERT_FALSE(ignored.has_errors());
  trip.ready = prepare(trip.scene, {});
  assets.textures.resize(trip.ready.scene.texture_files.size());
  const std::string bytes =
      write_gltf(trip.scene, trip.ready, assets, {.binary = binary, .segments = 6}, ignored);
  trip.back = read_gltf(bytes, {}, trip.diagnostics);
  check(trip.back.scene, {}, trip.diagnostics);
  ASSERT_FALSE(trip.diagnostics.has_errors())
      << trip.diagnostics.list()[0].message << trip.diagnostics.list()[0].code->name;
  trip.ready_back = prepare(trip.back.scene, {});
}

const std::string shiny =
    R"(<object type="primitive" name="sphere"><diffuse r="0.1" g="0.5" b="1"/><ambient r="0.2" g="0" b="0"/><specular r="0.5" g="0.5" b="0.5"/><shininess v="12"/><reflective r="0.4" g="0.4" b="0.4"/></object>)";

std::string block(const std::string& inside) {
  return "<transblock>" + inside + "</transblock>";
}

class RoundTrip : public testing::TestWithParam<bool> {};
INSTANTIATE_TEST_SUITE_P(BothForms, RoundTrip, testing::Bool());

TEST_P(RoundTrip, ObjectsLightsAndCameraComeBack) {
  Trip trip;
  const std::string sheared =
      R"(<scale x="3" y="1" z="1"/><rotate x="0" y="0" z="1" angle="30"/><translate x="1" y="2" z="3"/>)";
  travel(scene_of(block(sheared + shiny) + block(shiny)), GetParam(), trip);
  EXPECT_TRUE(trip.diagnostics.list().empty()) << "not even for ambient light, written as emission";
  const RenderScene& a = trip.ready.scene;
  const RenderScene& b = trip.ready_back.scene;
  ASSERT_EQ(b.lights.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    const RenderLight& x = a.lights[i];
    const RenderLight& y = b.lights[i];
    EXPECT_EQ(x.type, y.type);
    EXPECT_LT(glm::distance(x.color, y.color), 1e-5f);
    EXPECT_EQ(x.attenuation, y.attenuation);
    if (x.type != LightType::directional) {
      EXPECT_LT(glm::distance(x.position, y.position), 1e-5f);
    }
    if (x.type != LightType::point) {
      EXPECT_LT(glm::distance(x.direction, y.direction), 1e-5f);
    }
    EXPECT_NEAR(x.inner_angle, y.inner_angle, 1e-5f);
    EXPECT_NEAR(x.outer_angle, y.outer_angle, 1e-5f);
  }
  EXPECT_LT(glm::distance(a.camera.position, b.camera.position), 1e-5);
  EXPECT_LT(glm::distance(a.camera.w, b.camera.w), 1e-5);
  EXPECT_LT(glm::distance(a.camera.v, b.camera.v), 1e-5);
  EXPECT_NEAR(a.camera.fov_y, b.camera.fov_y, 1e-6);
  ASSERT_EQ(b.groups[b.root].primitives.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    const DAffine x(a.groups[a.root].primitives[i].group_from_object);
    const DAffine y(b.groups[b.root].primitives[i].group_from_object);
    EXPECT_LT(glm::distance(x.point({1, 2, 3}), y.point({1, 2, 3})), 1e-5);
  }
  EXPECT_EQ(trip.back.files.size(), 1u) << "both spheres share a mesh";
  const RenderMaterial& m = b.materials[b.groups[b.root].primitives[0].material];
  EXPECT_LT(glm::distance(m.diffuse, glm::vec3(0.08f, 0.4f, 0.8f)), 1e-6f);
  EXPECT_LT(glm::distance(m.ambient, glm::vec3(0.1f, 0, 0)), 1e-6f);
  EXPECT_LT(glm::distance(m.specular, glm::vec3(0.25f)), 1e-6f);
  EXPECT_LT(glm::distance(m.reflective, glm::vec3(0.2f)), 1e-6f);
  EXPECT_EQ(m.shininess, 12);
}

TEST_P(RoundTrip, TexturesComeBackInLinearValues) {
  Trip trip;
  Assets assets;
  assets.textures.push_back({2, 1, {255, 0, 100, 17, 200, 90}});
  travel(scene_of(block("<object type=\"primitive\" name=\"cube\"><blend v=\"1\"/><texture "
                        "file=\"a.png\" u=\"1\" v=\"1\"/></object>")),
         GetParam(), trip, assets);
  ASSERT_EQ(trip.back.files.size(), 2u);
  const Texture back = *decode_image(trip.back.files[0].bytes);
  ASSERT_EQ(back.rgb.size(), 6u);
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_NEAR(back.rgb[i], assets.textures[0].rgb[i], 1);
  }
}

// A triangle to modify.
std::string triangle(const std::string& accessor_count = "3", const std::string& more = "") {
  const float corners[] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
  const std::string_view bytes(reinterpret_cast<const char*>(corners), sizeof corners);
  return fmt::format(
      R"({{"asset":{{"version":"2.0"}},"nodes":[{{"mesh":0,"name":"a"}}],)"
      R"("meshes":[{{"primitives":[{{"attributes":{{"POSITION":0}}}}]}}],)"
      R"("accessors":[{{"bufferView":0,"componentType":5126,"count":{},"type":"VEC3"}},)"
      R"({{"bufferView":0,"componentType":5126,"count":3,"type":"VEC2"}}],)"
      R"("bufferViews":[{{"buffer":0,"byteLength":36}}],)"
      R"("buffers":[{{"byteLength":36,"uri":"data:application/octet-stream;base64,{}"}}]{}}})",
      accessor_count, base64(bytes), more);
}

const Code* first_error(const std::string& bytes, const Limits& limits = {}) {
  Diagnostics diagnostics(limits);
  read_gltf(bytes, {.limits = limits}, diagnostics);
  for (const Diagnostic& d : diagnostics.list()) {
    if (d.severity == Severity::error) {
      return d.code;
    }
  }
  return nullptr;
}

TEST(ReadGltf, AddsACameraAndALight) {
  Diagnostics diagnostics;
  const ImportedScene scene = read_gltf(triangle(), {}, diagnostics);
  EXPECT_FALSE(diagnostics.has_errors());
  EXPECT_TRUE(scene.scene.camera);
  EXPECT_EQ(scene.scene.nodes[scene.scene.root].lights.size(), 1u);
  ASSERT_EQ(scene.files.size(), 1u);
  EXPECT_EQ(scene.files[0].name, "model-1.obj");
  EXPECT_THAT(scene.files[0].bytes, HasSubstr("f 1 2 3"));
}

TEST(ReadGltf, RejectsOtherFiles) {
  EXPECT_EQ(first_error(""), &"import.not-a-model"_code);
  EXPECT_EQ(first_error("{}"), &"import.not-a-model"_code);
  EXPECT_EQ(first_error("glTF"), &"import.not-a-model"_code);
  EXPECT_EQ(first_error(std::string("glTF\2\0\0\0\x14\0\0\0\xff\0\0\0JSON", 20)),
            &"import.not-a-model"_code);
  EXPECT_EQ(first_error("{\"asset\":{\"version\":\"1.0\"}}"), &"import.unsupported"_code);
}

TEST(ReadGltf, ChecksEachNumberBeforeItIsUsed) {
  EXPECT_EQ(first_error(triangle()), nullptr);
  for (const char* const count : {"4", "0", "-1", "1.5", "1e30", "\"3\"", "9007199254740992"}) {
    EXPECT_NE(first_error(triangle(count)), nullptr) << count;
  }
}

TEST(ReadGltf, ChecksTheTreeOfNodes) {
  const std::string start = "{\"asset\":{\"version\":\"2.0\"},\"nodes\":";
  EXPECT_EQ(first_error(start + "[{\"children\":[0]}]}"), &"import.value"_code);
  EXPECT_EQ(first_error(start + "[{\"children\":[1]}]}"), &"import.value"_code);
  EXPECT_EQ(first_error(start + "[{\"children\":[2]},{\"children\":[2]},{}]}"),
            &"import.value"_code);
  // A loop that the scene does not contain is not reached.
  EXPECT_EQ(first_error(start + "[{\"children\":[1]},{\"children\":[0]},{}]}"), nullptr);
  EXPECT_EQ(
      first_error(start + "[{\"children\":[1]},{\"children\":[0]}],\"scenes\":[{\"nodes\":[0]}]}"),
      &"import.value"_code);
  EXPECT_EQ(first_error(start + "[{}],\"scenes\":[{\"nodes\":[0]}],\"scene\":0}"), nullptr);
  EXPECT_EQ(first_error(start + "[{}],\"scenes\":[{\"nodes\":[0]}],\"scene\":7}"),
            &"import.value"_code);
}

TEST(ReadGltf, SaysWhatIsWrongWithTransforms) {
  const auto message = [](const std::string& transform) {
    Diagnostics diagnostics;
    read_gltf("{\"asset\":{\"version\":\"2.0\"},\"nodes\":[{" + transform + "}]}", {}, diagnostics);
    return diagnostics.list().empty() ? "" : diagnostics.list()[0].message;
  };
  EXPECT_EQ(message(R"("scale":[1e39,1,1])"), "nodes[0].scale has a number that is too large");
  EXPECT_EQ(message(R"("rotation":[0,0,1])"), "nodes[0].rotation should be 4 numbers");
  EXPECT_EQ(message(R"("scale":[1,"1",1])"), "nodes[0].scale should be 3 numbers");
}

TEST(ReadGltf, EnforcesItsLimits) {
  Limits limits;
  limits.mesh_triangles = 0;
  EXPECT_EQ(first_error(triangle(), limits), &"import.limit"_code);
  limits = {};
  limits.mesh_bytes = 200;
  EXPECT_EQ(first_error(triangle(), limits), &"import.limit"_code);
  limits = {};
  limits.nesting = 3;
  EXPECT_EQ(first_error(triangle(), limits), &"import.limit"_code);
}

TEST(ReadGltf, RejectsRequiredExtensionsThatChangeTheData) {
  EXPECT_EQ(first_error(triangle("3", R"(,"extensionsRequired":["KHR_draco_mesh_compression"])")),
            &"import.unsupported"_code);
  EXPECT_EQ(first_error(triangle("3", R"(,"extensionsRequired":["KHR_materials_ior"])")), nullptr);
  EXPECT_EQ(first_error(triangle("3", R"(,"extensionsRequired":["KHR_materials_unheard_of"])")),
            &"import.unsupported"_code);
}

// The triangle with this material and these attributes more, and what is left out of it.
std::vector<std::string> left_out(const std::string& material, const std::string& attributes = {},
                                  Material* read = nullptr, const std::string& more = {}) {
  std::string model = triangle("3", ",\"materials\":[" + material + "]" + more);
  const std::string from = "{\"POSITION\":0}}";
  model.replace(model.find(from), from.size(),
                "{\"POSITION\":0" + attributes + "},\"material\":0}");
  Diagnostics diagnostics;
  const ImportedScene scene = read_gltf(model, {}, diagnostics);
  EXPECT_FALSE(diagnostics.has_errors());
  if (read != nullptr) {
    *read = scene.scene.nodes.at(1).primitives.at(0).material;
  }
  std::vector<std::string> messages;
  for (const Diagnostic& d : diagnostics.list()) {
    if (d.code == &"import.left-out"_code) {
      messages.push_back(d.message);
    }
  }
  return messages;
}

TEST(ReadGltf, EmissionWithAPictureIsLeftOut) {
  Material read;
  EXPECT_THAT(left_out(R"({"emissiveFactor":[1,1,1],"emissiveTexture":{"index":0}})", {}, &read),
              ElementsAre("pictures of roughness, metal, occlusion and emission are left out"));
  EXPECT_EQ(read.ambient, glm::vec3(0));
  EXPECT_THAT(left_out(R"({"emissiveFactor":[1,1,1]})", {}, &read),
              ElementsAre(HasSubstr("becomes their ambient color")));
  EXPECT_EQ(read.ambient, glm::vec3(1));
}

TEST(ReadGltf, SaysWhatIsLeftOut) {
  EXPECT_THAT(left_out("{}"), ElementsAre());
  EXPECT_THAT(left_out("{}", R"(,"COLOR_0":0)"), ElementsAre("colors of vertices are left out"));
  EXPECT_THAT(left_out(R"({"alphaMode":"MASK"})"), ElementsAre("masks by alpha are left out"));
  EXPECT_THAT(left_out(R"({"alphaMode":"BLEND"})"), ElementsAre());
  const std::string picture = R"("pbrMetallicRoughness":{"baseColorTexture":{"index":0}})";
  EXPECT_THAT(left_out("{" + picture + R"(,"alphaMode":"BLEND"})"),
              Contains("alpha values of pictures are left out"));
  EXPECT_THAT(left_out("{}", {}, nullptr,
                       R"(,"extensionsUsed":["KHR_materials_sheen","KHR_materials_ior",)"
                       R"("KHR_materials_sheen","KHR_materials_volume"])"),
              ElementsAre("what the extension \"KHR_materials_sheen\" adds is left out"));
}

TEST(ReadGltf, OtherWrapModesMatterOutsideOfThePicture) {
  const std::string png = base64(
      *encode_image(to_float(Texture{1, 1, {9, 9, 9}}), ImageFormat::png8, Rounding::nearest));
  const auto wrapped = [&](int mode, float scale) {
    return left_out(
        fmt::format(R"({{"pbrMetallicRoughness":{{"baseColorTexture":{{"index":0,"extensions":{{)"
                    R"("KHR_texture_transform":{{"scale":[{0},{0}]}}}}}}}}}})",
                    scale),
        R"(,"TEXCOORD_0":1)", nullptr,
        fmt::format(R"(,"textures":[{{"source":0,"sampler":0}}],"samplers":[{{"wrapT":{}}}],)"
                    R"("images":[{{"uri":"data:image/png;base64,{}"}}])",
                    mode, png));
  };
  constexpr int repeat = 10497;
  constexpr int clamp = 33071;
  EXPECT_THAT(wrapped(repeat, 2), ElementsAre());
  EXPECT_THAT(wrapped(clamp, 1), ElementsAre());
  EXPECT_THAT(wrapped(clamp, 2),
              ElementsAre("wrap modes of textures other than repeat are left out"));
}

TEST(ReadGltf, PerspectiveCamerasComeFirst) {
  const std::string become = "the orthographic camera becomes a perspective camera of 45 degrees";
  const std::string others = "cameras after the first are left out";
  const std::string orthographic = "orthographic cameras are left out";
  const auto read = [](const std::string& nodes, float& angle) {
    std::string model = triangle("3", R"(,"cameras":[{"type":"orthographic"},)"
                                      R"({"type":"perspective","perspective":{"yfov":0.5}},)"
                                      R"({"type":"perspective","perspective":{"yfov":1}}])");
    const std::string from = R"("name":"a"})";
    model.replace(model.find(from), from.size(), from + nodes);
    Diagnostics diagnostics;
    const ImportedScene scene = read_gltf(model, {}, diagnostics);
    angle = glm::radians(scene.scene.camera.value().height_angle_deg);
    std::vector<std::string> messages;
    for (const Diagnostic& d : diagnostics.list()) {
      if (d.code == &"import.left-out"_code) {
        messages.push_back(d.message);
      }
    }
    return messages;
  };
  float angle = 0;
  EXPECT_THAT(read(R"(,{"camera":0},{"camera":0})", angle), ElementsAre(others, become));
  EXPECT_NEAR(angle, glm::radians(45.0f), 1e-5f);
  for (const std::string nodes :
       {R"(,{"camera":0},{"camera":1})", R"(,{"camera":1},{"camera":0})"}) {
    EXPECT_THAT(read(nodes, angle), ElementsAre(orthographic)) << nodes;
    EXPECT_NEAR(angle, 0.5f, 1e-5f) << nodes;
  }
  EXPECT_THAT(read(R"(,{"camera":1},{"camera":2})", angle), ElementsAre(others));
  EXPECT_NEAR(angle, 0.5f, 1e-5f);
}

TEST(ReadGltf, NamesAreCutBetweenCharacters) {
  const std::string name(199, 'x');
  std::string model = triangle();
  model.replace(model.find("\"a\""), 3, "\"" + name + "\u00e9\u00e9\"");
  Diagnostics diagnostics;
  const ImportedScene scene = read_gltf(model, {}, diagnostics);
  EXPECT_EQ(std::string(scene.scene.nodes.at(1).name.str()), name);
}

TEST(ReadGltf, AChangedMaterialUsesItsNewValues) {
  const std::string extras =
      R"("extras":{"scenefile":{"ambient":[0,0,0],"diffuse":[1,0,0],"specular":[0,0,0],"reflective":[0,0,0],"transparent":[0,0,0],"shininess":7,"ior":1}})";
  const auto diffuse_of = [&](const std::string& base) {
    const std::string model = triangle(
        "3", fmt::format(R"(,"materials":[{{"pbrMetallicRoughness":{{"baseColorFactor":[{},1],)"
                         R"("metallicFactor":0}},"extensions":{{"KHR_materials_specular":)"
                         R"({{"specularFactor":0}}}},{}}}])",
                         base, extras));
    std::string with = model;
    const std::string from = "{\"POSITION\":0}}";
    with.replace(with.find(from), from.size(), "{\"POSITION\":0},\"material\":0}");
    Diagnostics diagnostics;
    const ImportedScene scene = read_gltf(with, {}, diagnostics);
    return scene.scene.nodes.at(1).primitives.at(0).material;
  };
  EXPECT_EQ(diffuse_of("1,0,0").shininess, 7);
  EXPECT_EQ(diffuse_of("0,1,0").shininess, 0);
  EXPECT_EQ(diffuse_of("0,1,0").diffuse, glm::vec3(0, 1, 0));
}

}  // namespace
}  // namespace scenefile
