// What the comparison of two scenes prints.

#include "scenefile/verbs/compare_scenes.h"

#include "scene/builders.h"
#include "scenefile/format/write_scene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <string_view>

namespace scenefile {
namespace {

using namespace test;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

LoadedScene load(std::string path, std::string text) {
  LoadSettings settings;
  settings.depth = LoadDepth::prepared;
  LoadedScene scene = load_scene(std::move(path), std::move(text), {}, settings);
  EXPECT_TRUE(scene.usable());
  return scene;
}

LoadedScene as(SceneFormat format, const Scene& scene, std::string path) {
  Diagnostics ignored;
  return load(std::move(path), write_scene(scene, format, {}, ignored));
}

std::string text_of(const LoadedScene& a, const LoadedScene& b) {
  const SceneDiff diff = compare_scenes(a, b);
  EXPECT_EQ(diff.same_meaning, diff.differences.empty());
  EXPECT_EQ(diff.same_meaning, diff.text.empty());
  return compare_scenes_text(a, b, diff);
}

// Three boxes, the second in a group, a light, and a template.
Scene boxes() {
  Scene scene = fine_scene();
  scene.nodes[0].lights[0].position = {1, 2, 3};
  add_primitive(scene, 0, {translate(1, 0, 0)}, Shape::cube);
  const NodeId arm = add_group(scene, 0, {rotate({1, 0, 0}, 30), translate(0, 2, 0)});
  scene.nodes[arm].name = "arm";
  add_primitive(scene, arm, {scale(1, 2, 1)}, Shape::cube);
  add_primitive(scene, add_template(scene, "leg"), {}, Shape::cylinder);
  add_instance(scene, 0, "leg");
  add_primitive(scene, 0, {translate(3, 0, 0)}, Shape::cube);
  return scene;
}

template <typename Change>
std::string after(Change change, SceneFormat format = SceneFormat::xml,
                  SceneFormat other = SceneFormat::xml) {
  Scene changed = boxes();
  change(changed);
  return text_of(as(format, boxes(), "a"), as(other, changed, "b"));
}

Material& material(Scene& scene, Shape shape) {
  for (Node& node : scene.nodes) {
    if (!node.primitives.empty() && node.primitives[0].shape == shape) {
      return node.primitives[0].material;
    }
  }
  return scene.nodes.at(0).primitives.at(0).material;
}

TEST(CompareScenes, AValueIsShownWithItsObjectAndPlaces) {
  EXPECT_EQ(after([](Scene& s) {
              material(s, Shape::cylinder).specular = {1, 0, 0};
            }),
            R"(--- a
+++ b
@@ a:16:7 b:16:7 @@ leg/#1: cylinder
   </lightdata>
   <object type="tree" name="leg">
     <transblock>
-      <object type="primitive" name="cylinder"/>
+      <object type="primitive" name="cylinder">
+        <specular r="1" g="0" b="0"/>
+      </object>
     </transblock>
   </object>
   <object type="tree" name="root">
a and b: 1 difference
)");
}

TEST(CompareScenes, AnAddedObjectIsOneDifference) {
  const std::string text = after([](Scene& s) {
    add_primitive(s, 0, {translate(4, 0, 0)}, Shape::cube);
    s.nodes[0].children.insert(s.nodes[0].children.begin() + 1, s.nodes[0].children.back());
    s.nodes[0].children.pop_back();
  });
  EXPECT_THAT(text, HasSubstr(R"(
       <object type="primitive" name="cube"/>
     </transblock>
+    <transblock>
+      <translate x="4" y="0" z="0"/>
+      <object type="primitive" name="cube"/>
+    </transblock>
     <transblock>
       <rotate x="1" y="0" z="0" angle="30"/>
)"));
  EXPECT_THAT(text, HasSubstr("a and b: 1 difference\n"));
}

TEST(CompareScenes, ARemovedLightIsOneDifference) {
  const auto two = [](Scene& s) { s.nodes[0].lights.push_back(s.nodes[0].lights[0]); };
  Scene lit = boxes();
  two(lit);
  const std::string text =
      text_of(as(SceneFormat::xml, lit, "a"), as(SceneFormat::xml, boxes(), "b"));
  EXPECT_THAT(text, AllOf(HasSubstr("\n   </lightdata>\n-  <lightdata>\n"),
                          HasSubstr("-  </lightdata>\n   <object type=\"tree\" name=\"leg\">\n")));
}

TEST(CompareScenes, OrderOfTransforms) {
  const std::string text =
      after([](Scene& s) { std::swap(s.nodes[2].transforms[0], s.nodes[2].transforms[1]); });
  EXPECT_THAT(text, AllOf(HasSubstr("@@ root/arm\n"), HasSubstr(R"(
+      <translate x="0" y="2" z="0"/>
       <rotate x="1" y="0" z="0" angle="30"/>
-      <translate x="0" y="2" z="0"/>
       <object type="tree" name="arm">
)")));
}

TEST(CompareScenes, TwoJsonScenesAreShownAsJson) {
  const std::string text = after([](Scene& s) { material(s, Shape::cylinder).ior = 2; },
                                 SceneFormat::json, SceneFormat::json);
  EXPECT_THAT(text, AllOf(HasSubstr("@@ leg/#1: cylinder\n"),
                          HasSubstr("\n               \"type\": \"cylinder\"\n"
                                    "+              \"ior\": 2\n"
                                    "             }\n"),
                          HasSubstr(": 1 difference\n")));
}

TEST(CompareScenes, OtherFormatsOfOneSceneDoNotDiffer) {
  EXPECT_EQ(after([](Scene&) {}, SceneFormat::xml, SceneFormat::json),
            "a and b: same meaning, written differently\n");
  EXPECT_EQ(after([](Scene&) {}), "a and b: no difference\n");
}

// An id of a light, its name, an added default camera, an idle value, -0: none of them differs.
TEST(CompareScenes, WhatHasNoEffectIsNotShown) {
  const std::string text = after(
      [](Scene& s) {
        s.camera = Camera();
        s.name = "boxes";
        s.nodes[0].lights[0].id = 7;
        s.nodes[0].lights[0].type = LightType::directional;
        s.nodes[0].lights[0].direction = {0, -1, 0};
        s.nodes[0].lights[0].attenuation = {0, 1, 0};
        s.nodes[1].transforms = {translate(1, -0.0f, 0)};
      },
      SceneFormat::xml);
  EXPECT_THAT(text, AllOf(HasSubstr("+    <type v=\"directional\"/>\n"), Not(HasSubstr("-0")),
                          Not(HasSubstr("<id")), Not(HasSubstr("<cameradata>")),
                          Not(HasSubstr("v=\"7\""))));
}

// The same in a group around everything, a matrix for a translation, the light in a group.
Scene regrouped() {
  Scene scene = boxes();
  scene.nodes[0].lights.clear();
  std::vector<NodeId> children = std::exchange(scene.nodes[0].children, {});
  glm::mat4 moved(1);
  moved[3] = {1, 0, 0, 1};
  scene.nodes[children[0]].transforms = {matrix(moved)};
  const NodeId lamp = add_group(scene, 0, {translate(1, 2, 3)});
  scene.nodes[lamp].lights = {point_light({0, 0, 0})};
  for (const NodeId child : children) {
    scene.nodes[add_group(scene, 0)].children = {child};
  }
  return scene;
}

TEST(CompareScenes, GroupsAreNotDifferences) {
  const LoadedScene a = as(SceneFormat::json, boxes(), "a.json");
  Scene scene = regrouped();
  EXPECT_EQ(text_of(a, as(SceneFormat::json, scene, "b.json")),
            "a.json and b.json: same meaning, written differently\n");
  material(scene, Shape::cylinder).diffuse = {1, 0, 0};
  scene.nodes[2].transforms[1] = translate(0, 2.5f, 0);
  const std::string text = text_of(a, as(SceneFormat::json, scene, "b.json"));
  EXPECT_THAT(text, AllOf(HasSubstr("@@ leg: cylinder\n"), HasSubstr("@@ root: cube\n"),
                          HasSubstr("-      <translate x=\"0\" y=\"2\" z=\"0\"/>\n"
                                    "+      <translate x=\"0\" y=\"2.5\" z=\"0\"/>\n"),
                          HasSubstr(": 2 differences\n")))
      << text;
}

// XML has no rotated area lights.
TEST(CompareScenes, ATurnOfAnAreaLightIsShownAsJson) {
  Scene lamp = fine_scene();
  Light light;
  light.type = LightType::area;
  light.direction = {0, -1, 0};
  light.width = 2;
  light.height = 1;
  lamp.nodes[0].lights = {light};
  Scene turned = lamp;
  turned.nodes[0].lights.clear();
  turned.nodes[add_group(turned, 0, {rotate({0, 1, 0}, 30)})].lights = {light};
  const std::string text =
      text_of(as(SceneFormat::xml, lamp, "a.xml"), as(SceneFormat::json, turned, "b.json"));
  EXPECT_THAT(text, HasSubstr("\"rotate\": [0, 1, 0, 30]\n")) << text;
}

TEST(CompareScenes, ScenesOfProgramsHaveNoPlaces) {
  LoadedScene a;
  a.path = "a";
  a.written = boxes();
  LoadedScene b = a;
  b.written.global.ambient = 1;
  EXPECT_THAT(text_of(a, b), HasSubstr("\n@@ @@ global data\n"));
}

TEST(CompareScenes, NotesNoMoreThanAskedFor) {
  Scene many = boxes();
  for (int i = 0; i < 50; ++i) {
    add_primitive(many, 0, {translate(static_cast<float>(i), 0, 0)}, Shape::cone);
  }
  Scene others = many;
  for (Node& node : others.nodes) {
    for (Primitive& primitive : node.primitives) {
      primitive.material.ior = 2;
    }
  }
  const SceneDiff diff =
      compare_scenes(as(SceneFormat::xml, many, "a"), as(SceneFormat::xml, others, "b"), 7);
  EXPECT_EQ(diff.differences.size(), 7u);
  EXPECT_EQ(diff.left_out, 48u);
}

TEST(CompareScenes, ColorsTheLinesThatDiffer) {
  const LoadedScene a = as(SceneFormat::xml, boxes(), "a");
  Scene changed = boxes();
  changed.global.ambient = 0.25f;
  const LoadedScene b = as(SceneFormat::xml, changed, "b");
  const SceneDiff diff = compare_scenes(a, b);
  EXPECT_THAT(compare_scenes_text(a, b, diff, true),
              AllOf(HasSubstr("\n\033[31m-    <ambientcoeff v=\"0.5\"/>\033[0m\n"
                              "\033[32m+    <ambientcoeff v=\"0.25\"/>\033[0m\n"),
                    HasSubstr("\n\033[36m@@ a:2:3 b:2:3 @@ global data\033[0m\n")));
  EXPECT_THAT(compare_scenes_text(a, b, diff), Not(HasSubstr("\033")));
  EXPECT_EQ(difference_text(diff.differences.at(0)),
            "global data\n-<ambientcoeff v=\"0.5\"/>\n+<ambientcoeff v=\"0.25\"/>");
}

}  // namespace
}  // namespace scenefile
