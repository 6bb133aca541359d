// Reading JSON into a Scene.

#include "scenefile/format/codes.h"
#include "scenefile/format/dialects.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace scenefile {
namespace {

constexpr std::string_view head = R"({
"globalData": {"ambientCoeff": 0.5, "diffuseCoeff": 0.5, "specularCoeff": 0.5},
"cameraData": {"position": [0, 0, 5], "up": [0, 1, 0], "look": [0, 0, -1], "heightAngle": 45},
)";

struct JsonReading {
  Scene scene;
  Diagnostics diagnostics;

  const Node& child(std::size_t i) const { return below(scene.root, i); }
  const Node& below(NodeId parent, std::size_t i) const {
    return scene.nodes[scene.nodes[parent].children.at(i)];
  }
  std::size_t count(const Code& code) const {
    return static_cast<std::size_t>(
        std::count_if(diagnostics.list().begin(), diagnostics.list().end(),
                      [&](const Diagnostic& d) { return d.code == &code; }));
  }
  std::string all_messages() const {
    std::string all;
    for (const Diagnostic& d : diagnostics.list()) {
      all += fmt::format("{}:{} {}\n", d.location.line, d.location.column, d.message);
    }
    return all;
  }
};

JsonReading read(std::string_view text, const ReadOptions& options = {}) {
  JsonReading reading;
  reading.scene = read_json(text, options, reading.diagnostics);
  return reading;
}

// Line numbers of `rest` start at 4.
JsonReading read_with_head(std::string_view rest) {
  return read(std::string(head) + std::string(rest) + "}");
}

JsonReading read_group(std::string_view group) {
  return read_with_head(fmt::format("\"groups\": [\n{}]", group));
}

JsonReading read_primitive(std::string_view primitive) {
  return read_group(fmt::format("{{\"primitives\": [\n{}]}}", primitive));
}

JsonReading read_light(std::string_view light) {
  return read_group(fmt::format("{{\"lights\": [\n{}]}}", light));
}

TEST(JsonReader, GlobalsAndCamera) {
  const JsonReading r = read(R"({
    "name": "kitchen",
    "globalData": {"ambientCoeff": 0.1, "diffuseCoeff": 0.2, "specularCoeff": 0.3,
                   "transparentCoeff": 0.4},
    "cameraData": {"position": [1, 2, 3], "up": [0, 0, 1], "focus": [2, 4, 6],
                   "heightAngle": 30, "aperture": 0.5, "focalLength": 7},
    "groups": []})");
  EXPECT_TRUE(r.diagnostics.list().empty()) << r.all_messages();
  EXPECT_EQ(r.scene.name, "kitchen");
  EXPECT_EQ(r.scene.global.ambient, 0.1f);
  EXPECT_EQ(r.scene.global.diffuse, 0.2f);
  EXPECT_EQ(r.scene.global.specular, 0.3f);
  EXPECT_EQ(r.scene.global.transparent, 0.4f);
  ASSERT_TRUE(r.scene.camera);
  EXPECT_EQ(r.scene.camera->position, glm::vec3(1, 2, 3));
  EXPECT_EQ(r.scene.camera->look, glm::vec3(1, 2, 3));
  EXPECT_EQ(r.scene.camera->up, glm::vec3(0, 0, 1));
  EXPECT_EQ(r.scene.camera->height_angle_deg, 30);
  EXPECT_EQ(r.scene.camera->aperture, 0.5f);
  EXPECT_EQ(r.scene.camera->focal_length, 7);
  EXPECT_EQ(r.scene.camera->location, (Location{5, 5}));
  const Scene& s = r.scene;
  EXPECT_TRUE(std::any_of(s.field_places.begin(), s.field_places.end(), [&](const FieldPlace& p) {
    return p.owner == s.camera->location && p.field == Field::height_angle_deg &&
           p.location == Location{6, 20};
  }));
}

TEST(JsonReader, ListsValuesThatCouldNotBeRead) {
  const JsonReading r = read(R"({
    "globalData": {"ambientCoeff": 0.1, "diffuseCoeff": 0.2, "specularCoeff": "much"},
    "cameraData": {"position": [1, 2], "up": [0, 0, 1], "focus": [2, 4, 6], "heightAngle": 30},
    "groups": [{"primitives": [{"type": "cube", "shininess": [1], "diffuse": [0, 0, 0]}]}]})");
  EXPECT_EQ(r.scene.global.unread, FieldSet{Field::specular});
  EXPECT_EQ(r.scene.camera->unread, (FieldSet{Field::position, Field::look}));
  EXPECT_EQ(r.child(0).primitives.at(0).unread, FieldSet{Field::shininess});
  EXPECT_EQ(r.child(0).primitives.at(0).material.shininess, 0);
  const JsonReading both = read(R"({"globalData": {"ambientCoeff": 0.1, "diffuseCoeff": 0.2,
    "specularCoeff": 0.3}, "cameraData": {"position": [1, 2, 3], "heightAngle": 30,
    "look": [0, 0, 1], "focus": [0, 0, 0]}, "groups": []})");
  EXPECT_EQ(both.scene.global.unread, FieldSet{});
  EXPECT_EQ(both.scene.camera->unread, (FieldSet{Field::up, Field::look}));
}

TEST(JsonReader, AbsentTransparentCoefficientStaysAbsent) {
  EXPECT_FALSE(read_group("").scene.global.transparent);
}

TEST(JsonReader, TransformsHaveAFixedOrder) {
  const JsonReading r = read_group(R"({
    "matrix": [[1, 2, 3, 4], [5, 6, 7, 8], [9, 10, 11, 12], [0, 0, 0, 1]],
    "scale": [2, 3, 4],
    "rotate": [0, 1, 0, 90],
    "translate": [1, 2, 3]})");
  const auto& t = r.child(0).transforms;
  ASSERT_EQ(t.size(), 4u) << r.all_messages();
  EXPECT_EQ(std::get<Translate>(t[0].map).by, glm::vec3(1, 2, 3));
  EXPECT_EQ(std::get<Rotate>(t[1].map), (Rotate{glm::vec3(0, 1, 0), 90}));
  EXPECT_EQ(std::get<Scale>(t[2].map).by, glm::vec3(2, 3, 4));
  const glm::mat4 m = std::get<Matrix>(t[3].map).m();
  EXPECT_EQ(m[3], glm::vec4(4, 8, 12, 1));
  EXPECT_EQ(m[0], glm::vec4(1, 5, 9, 0));
  EXPECT_EQ(t[0].location, (Location{9, 5}));
  EXPECT_EQ(t[3].location, (Location{6, 5}));
  EXPECT_EQ(r.count(json_matrix_with_others), 1u);
}

TEST(JsonReader, PrimitivesWithAllKeys) {
  const JsonReading r = read_primitive(R"({"type": "mesh", "meshFile": "meshes/a.obj",
    "ambient": [0, 0.1, 0.2], "diffuse": [0.3, 0.4, 0.5], "specular": [0.6, 0.7, 0.8],
    "reflective": [0.9, 1, 1.1], "transparent": [1.2, 1.3, 1.4], "shininess": 15, "ior": 1.5,
    "blend": 0.25, "textureFile": "file:a\\b.png", "textureU": 2, "textureV": 3,
    "bumpMapFile": "b.png", "bumpMapU": 4, "bumpMapV": 5})");
  EXPECT_TRUE(r.diagnostics.list().empty()) << r.all_messages();
  ASSERT_EQ(r.child(0).primitives.size(), 1u);
  const Primitive& p = r.child(0).primitives[0];
  EXPECT_EQ(p.shape, Shape::mesh);
  EXPECT_EQ(p.mesh_file, "meshes/a.obj");
  EXPECT_EQ(p.location, (Location{6, 1}));
  const Material& m = p.material;
  EXPECT_EQ(m.ambient, glm::vec3(0, 0.1f, 0.2f));
  EXPECT_EQ(m.diffuse, glm::vec3(0.3f, 0.4f, 0.5f));
  EXPECT_EQ(m.specular, glm::vec3(0.6f, 0.7f, 0.8f));
  EXPECT_EQ(m.reflective, glm::vec3(0.9f, 1, 1.1f));
  EXPECT_EQ(m.transparent, glm::vec3(1.2f, 1.3f, 1.4f));
  EXPECT_EQ(m.shininess, 15);
  EXPECT_EQ(m.ior, 1.5f);
  EXPECT_EQ(m.blend, 0.25f);
  ASSERT_TRUE(m.texture && m.bump_map);
  EXPECT_EQ(*m.texture, (TextureUse{"file:a\\b.png", 2, 3, {}}));
  EXPECT_EQ(*m.bump_map, (TextureUse{"b.png", 4, 5, {}}));
}

TEST(JsonReader, PrimitiveDefaults) {
  const JsonReading r = read_primitive(R"({"type": "sphere"})");
  EXPECT_EQ(r.child(0).primitives.at(0).material, Material());
  EXPECT_EQ(r.child(0).primitives.at(0).shape, Shape::sphere);
}

TEST(JsonReader, LightsAreAtTheOriginOfTheirGroup) {
  const JsonReading r = read_group(R"({"translate": [1, 2, 3], "lights": [
    {"type": "point", "name": "lamp", "color": [1, 2, 3], "attenuationCoeff": [0.1, 0.2, 0.3]},
    {"type": "directional", "color": [1, 1, 1], "direction": [1, -1, 0]},
    {"type": "spot", "color": [1, 1, 1], "direction": [0, -1, 0], "penumbra": 5, "angle": 20,
     "attenuationCoeff": [1, 0, 0]},
    {"type": "area", "color": [1, 1, 1], "direction": [0, -1, 0], "width": 2, "height": 3}]})");
  EXPECT_EQ(r.diagnostics.count(Severity::warning), 0u) << r.all_messages();
  const auto& lights = r.child(0).lights;
  ASSERT_EQ(lights.size(), 4u);
  EXPECT_EQ(lights[0].name, "lamp");
  EXPECT_EQ(lights[0].color, glm::vec3(1, 2, 3));
  EXPECT_EQ(lights[0].attenuation, glm::vec3(0.1f, 0.2f, 0.3f));
  EXPECT_EQ(lights[0].position, glm::vec3(0));
  EXPECT_EQ(lights[1].type, LightType::directional);
  EXPECT_EQ(lights[1].direction, glm::vec3(1, -1, 0));
  EXPECT_EQ(lights[2].angle_deg, 20);
  EXPECT_EQ(lights[2].penumbra_deg, 5);
  EXPECT_EQ(lights[3].width, 2);
  EXPECT_EQ(lights[3].height, 3);
}

TEST(JsonReader, LightsWithoutTheirKeys) {
  const JsonReading r =
      read_light(R"({"type": "spot", "color": [1, 1, 1], "direction": [0, -1, 0]})");
  EXPECT_EQ(r.count(json_light_default), 2u) << r.all_messages();
  EXPECT_FALSE(r.child(0).lights.at(0).angle_deg);
  EXPECT_EQ(
      read_light(R"({"type": "point", "attenuationCoeff": [1, 0, 0]})").count(json_missing_key),
      1u);
}

TEST(JsonReader, LightsWithoutATypeArePointLights) {
  const JsonReading r = read_light(R"({"color": [1, 0, 1], "attenuationCoeff": [1, 0, 0]})");
  EXPECT_EQ(r.diagnostics.list().size(), 1u);
  EXPECT_EQ(r.count(json_light_default), 1u);
  EXPECT_EQ(r.child(0).lights.at(0).type, LightType::point);
  EXPECT_EQ(r.child(0).lights.at(0).color, glm::vec3(1, 0, 1));
}

TEST(JsonReader, NonLightsAreIgnored) {
  const JsonReading r = read_light(R"({"translate": [1, 2, 3], "lights": []})");
  EXPECT_EQ(r.count(json_no_light), 1u);
  EXPECT_TRUE(r.child(0).lights.empty());
}

TEST(JsonReader, KeysWithoutEffectOnLights) {
  EXPECT_EQ(read_light(R"({"type": "directional", "color": [1, 1, 1], "direction": [0, -1, 0],
      "attenuationCoeff": [1, 0, 0], "penumbra": 1, "angle": 1, "width": 1, "height": 1})")
                .count(json_unused_key),
            5u);
}

TEST(JsonReader, GroupsKeepOrderAndNames) {
  const JsonReading r = read_group(R"({"name": "a", "groups": [{"name": "b", "primitives": []},
      {"name": "c", "groups": []}]}, {"name": "d", "lights": []})");
  EXPECT_TRUE(r.diagnostics.list().empty()) << r.all_messages();
  EXPECT_EQ(r.child(0).name, "a");
  EXPECT_EQ(r.child(1).name, "d");
  const NodeId a = r.scene.nodes[r.scene.root].children[0];
  EXPECT_EQ(r.below(a, 0).name, "b");
  EXPECT_EQ(r.below(a, 1).name, "c");
}

TEST(JsonReader, InstancesOfTemplatesDeclaredBefore) {
  const JsonReading r = read_with_head(R"("groups": [{"name": "set"}, {"name": "chair"}],
      "templateGroups": [{"name": "chair", "scale": [2, 2, 2], "primitives": [{"type": "cube"}]},
                         {"name": "set", "groups": [{"name": "chair"}]}])");
  EXPECT_TRUE(r.diagnostics.list().empty()) << r.all_messages();
  ASSERT_EQ(r.scene.templates.size(), 2u);
  const NodeId set = r.scene.templates[1];
  EXPECT_EQ(r.scene.nodes[set].name, "set");
  EXPECT_EQ(r.below(set, 0).instance_of, "chair");
  EXPECT_EQ(r.scene.nodes[r.scene.templates[0]].transforms.size(), 1u);
  EXPECT_EQ(r.child(0).instance_of, "set");
  EXPECT_EQ(r.child(0).name, "");
  EXPECT_EQ(r.child(1).instance_of, "chair");
}

TEST(JsonReader, OtherKeysOfAnInstanceAreIgnored) {
  const JsonReading r = read_with_head(R"("templateGroups": [{"name": "a", "primitives": []}],
      "groups": [{"translate": "anything", "name": "a", "groups": 5}])");
  EXPECT_EQ(r.count(json_instance_keys), 1u);
  EXPECT_EQ(r.diagnostics.list().size(), 1u) << r.all_messages();
  EXPECT_NE(r.all_messages().find("5:19 "), std::string::npos) << r.all_messages();
  EXPECT_NE(r.all_messages().find("translate, groups are ignored"), std::string::npos);
  EXPECT_EQ(r.child(0).instance_of, "a");
  EXPECT_TRUE(r.child(0).transforms.empty());
}

TEST(JsonReader, EmptyGroupNamedLikeALaterTemplateIsMeantAsInstance) {
  const JsonReading r = read_with_head(R"("groups": [], "templateGroups": [
      {"name": "a", "groups": [{"name": "b"}, {"name": "a"}]}, {"name": "b", "primitives": []}])");
  EXPECT_EQ(r.below(r.scene.templates[0], 0).instance_of, "b");
  EXPECT_EQ(r.below(r.scene.templates[0], 1).instance_of, "a");
}

TEST(JsonReader, ATemplateWithAMisspelledKeyForItsNameIsKnown) {
  const JsonReading r = read_with_head(R"("templateGroups": [{"nam": "chair"}],
      "groups": [{"name": "chair"}])");
  EXPECT_EQ(r.count(json_misspelled_key), 1u);
  EXPECT_EQ(r.diagnostics.list().size(), 1u) << r.all_messages();
  EXPECT_EQ(r.child(0).instance_of, "chair");
}

TEST(JsonReader, UnknownTemplateSuggestsANearOne) {
  const JsonReading r = read_with_head(R"("templateGroups": [{"name": "chair", "primitives": []}],
      "groups": [{"name": "chiar"}])");
  EXPECT_NE(r.all_messages().find("did you mean \"chair\"?"), std::string::npos);
  EXPECT_EQ(r.child(0).name, "chiar");
}

TEST(JsonReader, ExtensionsAreNamedAndSkipped) {
  const JsonReading r = read_primitive(
      R"({"type": "cube", "velocity": {"deep": [1, {"x": 2}]}}, {"type": "movingCube"})");
  EXPECT_FALSE(r.diagnostics.has_errors()) << r.all_messages();
  EXPECT_EQ(r.count(json_unknown_key), 1u);
  EXPECT_EQ(r.count(json_unknown_primitive_type), 1u);
  EXPECT_EQ(r.child(0).primitives.size(), 1u);
}

TEST(JsonReader, MisspelledTypesAreErrors) {
  for (const char* type : {"Cube", "sphre", "cub", "two words", "a\\nb", ""}) {
    const JsonReading r = read_primitive(fmt::format("{{\"type\": \"{}\"}}", type));
    EXPECT_TRUE(r.diagnostics.has_errors()) << type;
  }
  EXPECT_NE(read_primitive(R"({"type": "Cube"})").all_messages().find("did you mean \"cube\"?"),
            std::string::npos);
}

TEST(JsonReader, MisspelledKeysAreSuggested) {
  const JsonReading r = read_primitive(R"({"type": "cube", "Diffuse": [1, 0, 0]})");
  EXPECT_NE(r.all_messages().find("6:18 unknown key \"Diffuse\" in a primitive; did you mean "
                                  "\"diffuse\"?"),
            std::string::npos)
      << r.all_messages();
  EXPECT_EQ(r.count(json_misspelled_key), 1u);
  EXPECT_TRUE(r.diagnostics.has_errors());
}

TEST(JsonReader, AKeyNextToASimilarOneIsAnExtension) {
  const JsonReading r =
      read_primitive(R"({"type": "cube", "diffuse2": [1, 1, 1], "diffuse": [1, 0, 0]})");
  EXPECT_EQ(r.count(json_unknown_key), 1u);
  EXPECT_FALSE(r.diagnostics.has_errors());
}

TEST(JsonReader, KeysOfOtherProgramsAreTranslated) {
  const std::pair<JsonReading, const char*> cases[] = {
      {read_primitive(R"({"type": "cube", "color": [1, 0, 0]})"), "did you mean \"diffuse\"?"},
      {read_primitive(R"({"type": "cube", "scale": [1, 2, 1]})"), "transforms belong to the group"},
      {read_primitive(R"({"type": "box"})"), "did you mean \"cube\"?"},
      {read_primitive(R"({"type": "spot"})"), "lights belong in the list \"lights\""},
      {read_light(R"({"type": "point", "color": [1, 1, 1], "attenuationCoeff": [1, 0, 0],
                      "position": [0, 1, 0]})"),
       "give the group a \"translate\""},
      {read_with_head(R"("groups": [], "lights": [])"), "put it into a group of \"groups\""},
      {read_group(R"({"templateGroups": []})"), "next to \"groups\""}};
  for (const auto& [r, hint] : cases) {
    EXPECT_EQ(r.diagnostics.list().size(), 1u) << r.all_messages();
    EXPECT_FALSE(r.diagnostics.has_errors()) << r.all_messages();
    EXPECT_NE(r.all_messages().find(hint), std::string::npos) << r.all_messages();
  }
  const JsonReading light =
      read_light(R"({"type": "sun", "color": [1, 1, 1], "direction": [0, 1, 0]})");
  EXPECT_NE(light.all_messages().find("did you mean \"directional\"?"), std::string::npos);
  EXPECT_TRUE(light.diagnostics.has_errors());
}

TEST(JsonReader, ExistingKeysAreNotSuggested) {
  const JsonReading r =
      read_primitive(R"({"type": "cube", "color": [1, 0, 0], "diffuse": [1, 0, 0]})");
  EXPECT_EQ(r.all_messages(), "6:18 unknown key \"color\" in a primitive is ignored\n");
}

TEST(JsonReader, TemplatesMayFollowTheGroups) {
  const JsonReading r = read_with_head(R"("groups": [{"name": "a"}],
      "templateGroups": [{"name": "a", "primitives": [{"type": "cube"}]}])");
  EXPECT_EQ(r.all_messages(), "");
  EXPECT_EQ(r.child(0).instance_of, "a");
}

TEST(JsonReader, WrongTypesNameKeyExpectationAndFinding) {
  const std::pair<const char*, const char*> cases[] = {
      {R"({"primitives": {}})", "\"primitives\" must be an array of primitives, found an object"},
      {R"({"primitives": [7]})", "a primitive must be an object, found the number 7"},
      {R"({"lights": [null]})", "a light must be an object, found null"},
      {R"({"groups": ["x"]})", "must be an object, found the string \"x\""},
      {R"({"name": 5})", "\"name\" must be a string, found the number 5"},
      {R"({"translate": "1 2 3"})", "\"translate\" must be an array of 3 numbers (x, y, z), found"},
      {R"({"scale": [1, "2", 3]})", "found the string \"2\" in it; write 2"},
      {R"({"scale": [1, "2px", 3]})", "found the string \"2px\" in it; write 2"},
      {R"({"scale": [1, [2], 3]})", "found an array of 1 number in it"},
      {R"({"scale": [1]})", "found 1 number"},
      {R"({"rotate": [0, 1, 0]})", "axis x, y, z and degrees), found 3 numbers"},
      {R"({"matrix": [1, 2]})", "\"matrix\" must be 4 rows, each an array of 4 numbers, found"},
      {R"({"matrix": [[1,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,true]]})", "must be 4 rows"},
      {R"({"matrix": {"a": 1}})", "must be 4 rows"},
  };
  for (const auto& [group, message] : cases) {
    const JsonReading r = read_group(group);
    EXPECT_TRUE(r.diagnostics.has_errors()) << group;
    EXPECT_NE(r.all_messages().find(message), std::string::npos) << r.all_messages();
  }
}

TEST(JsonReader, VectorsOfTheFourDimensionalFork) {
  for (const char* group : {R"({"translate": [1, 2, 3, 4]})", R"({"scale": [1, 2, 3, 4]})",
                            R"({"rotate": [0, 0, 0, 0, 0, 0, 90]})"}) {
    EXPECT_EQ(read_group(group).count(json_four_dimensional), 1u) << group;
  }
  EXPECT_EQ(read_primitive(R"({"type": "cube", "diffuse": [1, 1, 1, 1]})").count(json_wrong_length),
            1u);
}

TEST(JsonReader, RepeatsOfTheWrongTypeAreOne) {
  const JsonReading r =
      read_primitive(R"({"type": "cube", "textureFile": "a.png", "textureU": "2", "textureV": 3})");
  EXPECT_FALSE(r.diagnostics.has_errors());
  EXPECT_EQ(r.diagnostics.count(Severity::warning), 1u);
  EXPECT_EQ(r.child(0).primitives.at(0).material.texture->repeat_u, 1);
  EXPECT_EQ(r.child(0).primitives.at(0).material.texture->repeat_v, 3);
}

TEST(JsonReader, DuplicateKeysTheLastCounts) {
  const JsonReading r = read_group(R"({"scale": [1, 1, 1],
    "scale": [2, 2, 2]})");
  EXPECT_EQ(r.all_messages(),
            "6:5 \"scale\" occurs twice in a group, first at line 5; the last one "
            "counts\n");
  EXPECT_EQ(std::get<Scale>(r.child(0).transforms.at(0).map).by, glm::vec3(2));
}

TEST(JsonReader, EscapesInKeysAndStrings) {
  const JsonReading r = read_group(R"({"\u006eame": "a\u00e9\n\ud83d\ude00\/", "primitives": []})");
  EXPECT_TRUE(r.diagnostics.list().empty()) << r.all_messages();
  EXPECT_EQ(r.child(0).name, "a\xc3\xa9\n\xf0\x9f\x98\x80/");
}

TEST(JsonReader, CompatCourseReadsNumbersWithoutADigit) {
  const std::string text =
      std::string(head) + R"("groups": [{"name": "1. \".5", "translate": [.5, -.25, 2.],
    "scale": [1.,1.,.5], "rotate": [0, 1, 0, 1.5], "lights": 7}]})";
  EXPECT_EQ(read(text).count(json_number), 5u) << "two are alike";
  ReadOptions options;
  options.compat_course = true;
  const JsonReading r = read(text, options);
  EXPECT_EQ(r.count(json_number), 6u) << r.all_messages();
  EXPECT_EQ(r.diagnostics.count(Severity::warning), 6u);
  EXPECT_NE(r.all_messages().find("4:46 a number with \".5\" is not JSON"), std::string::npos)
      << r.all_messages();
  EXPECT_NE(r.all_messages().find("5:52 \"lights\" must be an array of lights, found the number 7"),
            std::string::npos)
      << r.all_messages();
  const Node& node = r.child(0);
  EXPECT_EQ(node.name, "1. \".5");
  EXPECT_EQ(std::get<Translate>(node.transforms.at(0).map).by, glm::vec3(0.5f, -0.25f, 2));
  EXPECT_EQ(std::get<Scale>(node.transforms.at(2).map).by, glm::vec3(1, 1, 0.5f));
}

TEST(JsonReader, CompatCourseExcusesNothingElse) {
  ReadOptions options;
  options.compat_course = true;
  for (const char* number : {"+1", "01", "NaN", "0x1", ".", "-.", "1e"}) {
    EXPECT_TRUE(read(fmt::format("{{\"a\": {}}}", number), options).diagnostics.has_errors())
        << number;
  }
  const JsonReading r = read("{\"a\": .5, \"b\": 1.,}", options);
  EXPECT_NE(r.all_messages().find("1:18 comma before the closing }"), std::string::npos)
      << r.all_messages();
}

TEST(JsonReader, RequiredKeys) {
  EXPECT_EQ(read("{}").count(json_missing_key), 2u);
  EXPECT_EQ(read(R"({"globalData": {}, "cameraData": {}, "groups": []})").count(json_missing_key),
            7u);
}

TEST(JsonReader, TopLevelMustBeAnObject) {
  EXPECT_EQ(read("[]").all_messages(),
            "1:1 a scene must be an object, found an array of 0 values\n");
}

TEST(JsonReader, KeysAreBounded) {
  std::string keys;
  for (int i = 0; i < 300; ++i) {
    keys += fmt::format("\"k{}\": {},", i, i);
  }
  const JsonReading r = read_group("{" + keys + "\"primitives\": []}");
  EXPECT_EQ(r.count(json_limit), 1u);
  EXPECT_EQ(r.count(json_unknown_key), 100u);
}

TEST(JsonReader, DeepGroupsNeedNoStack) {
  ReadOptions options;
  options.limits.nesting = 1'000'000;
  std::string text(head);
  const int depth = 100'000;
  for (int i = 0; i < depth; ++i) {
    text += "\"groups\": [{";
  }
  text += "\"primitives\": [{\"type\": \"cube\"}]";
  for (int i = 0; i < depth; ++i) {
    text += "}]";
  }
  const JsonReading r = read(text + "}", options);
  EXPECT_FALSE(r.diagnostics.has_errors()) << r.all_messages();
  EXPECT_EQ(r.scene.nodes.size(), static_cast<std::size_t>(depth) + 1);
}

}  // namespace
}  // namespace scenefile
