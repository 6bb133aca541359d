#include "scenefile/scene/diff.h"

#include "builders.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <utility>

using namespace scenefile;
using namespace scenefile::test;
using testing::ElementsAre;
using testing::IsEmpty;

namespace {

Scene sample() {
  Scene scene = fine_scene();
  scene.nodes[0].primitives = {primitive(Shape::cube), primitive(Shape::sphere),
                               primitive(Shape::sphere)};
  const NodeId arm = add_group(scene, 0, {translate(1, 0, 0)});
  scene.nodes[arm].name = "arm";
  add_primitive(scene, arm);
  const NodeId lamp = add_template(scene, "lamp");
  add_primitive(scene, lamp, {}, Shape::cone);
  add_instance(scene, 0, "lamp");
  return scene;
}

template <typename Change>
std::vector<std::string> texts(Change change) {
  Scene changed = sample();
  change(changed);
  std::vector<std::string> result;
  for (const SceneDifference& difference : diff(sample(), changed)) {
    result.push_back(difference_text(difference));
  }
  return result;
}

}  // namespace

TEST(Diff, EqualScenesHaveNone) {
  EXPECT_THAT(diff(sample(), sample()), IsEmpty());
  EXPECT_THAT(texts([](Scene& s) { s.nodes[0].location = {4, 4}; }), IsEmpty());
  EXPECT_THAT(texts([](Scene& s) { s.nodes[0].primitives[0].material.ambient.x = -0.0f; }),
              IsEmpty());
}

TEST(Diff, BothZerosAreOneValue) {
  EXPECT_THAT(texts([](Scene& s) {
                s.nodes[0].primitives[0].material.specular = {1, -0.0f, 0};
                s.nodes[1].transforms = {translate(1, -0.0f, 0), rotate({0, 1, 0}, -0.0f)};
              }),
              ElementsAre("root: cube 1: specular: 0 0 0 -> 1 0 0",
                          "root/arm: transforms: translate 1 0 0 -> translate 1 0 0, rotate 0 "
                          "about 0 1 0"));
}

TEST(Diff, NamesValues) {
  EXPECT_THAT(texts([](Scene& s) {
                s.nodes[0].primitives[2].material.diffuse = {1, 0, 0};
              }),
              ElementsAre("root: sphere 2: diffuse: 1 1 1 -> 1 0 0"));
  EXPECT_THAT(texts([](Scene& s) {
                s.nodes[0].lights[0].position = {3, 3, 4};
              }),
              ElementsAre("root: point light 1: position: 3 3 3 -> 3 3 4"));
  EXPECT_THAT(texts([](Scene& s) { s.global.transparent = 0.25f; }),
              ElementsAre("global data: transparentcoeff: none -> 0.25"));
  EXPECT_THAT(texts([](Scene& s) { s.camera = Camera{}; }),
              ElementsAre("camera: not given -> given"));
  EXPECT_THAT(texts([](Scene& s) { s.name = "x"; }), ElementsAre("scene name: \"\" -> \"x\""));
  EXPECT_THAT(texts([](Scene& s) {
                s.nodes[1].transforms.push_back(rotate({0, 1, 0}, 30));
              }),
              ElementsAre("root/arm: transforms: translate 1 0 0 -> translate 1 0 0, rotate 30 "
                          "about 0 1 0"));
}

TEST(Diff, CameraValues) {
  Scene a;
  a.camera = Camera{};
  Scene b = a;
  b.camera->height_angle_deg = 60;
  EXPECT_EQ(difference_text(diff(a, b).at(0)), "camera: heightangle: 45 -> 60");
}

TEST(Diff, AnAddedObjectDoesNotShiftTheRest) {
  EXPECT_THAT(texts([](Scene& s) {
                s.nodes[0].primitives.insert(s.nodes[0].primitives.begin(),
                                             primitive(Shape::cylinder));
              }),
              ElementsAre("root: cylinder 1: only in the second: cylinder"));
  EXPECT_THAT(texts([](Scene& s) {
                const NodeId added = add_primitive(s, 0);
                s.nodes[added].name = "new";
                std::vector<NodeId>& children = s.nodes[0].children;
                std::swap(children.front(), children.back());
                std::swap(children[1], children.back());
              }),
              ElementsAre("root/new: only in the second: a group of 1 primitives, 0 lights and "
                          "0 children"));
}

TEST(Diff, RemovedAndMoved) {
  EXPECT_THAT(texts([](Scene& s) { s.nodes[0].children.pop_back(); }),
              ElementsAre("root/#2: only in the first: an instance of \"lamp\""));
  EXPECT_THAT(texts([](Scene& s) { std::swap(s.nodes[0].children[0], s.nodes[0].children[1]); }),
              ElementsAre("root/arm: place 1 -> place 2"));
}

TEST(Diff, FindsChangesInTemplates) {
  EXPECT_THAT(texts([](Scene& s) {
                s.nodes[s.nodes[s.templates[0]].children[0]].primitives[0].material.shininess = 9;
              }),
              ElementsAre("lamp/#1: cone 1: shininess: 0 -> 9"));
}

TEST(Diff, StopsWhenAsked) {
  Scene a = fine_scene();
  Scene b = fine_scene();
  for (int i = 0; i < 50; ++i) {
    add_primitive(a, 0, {translate(static_cast<float>(i), 0, 0)});
    add_primitive(b, 0, {translate(static_cast<float>(-i), 1, 0)});
  }
  EXPECT_EQ(diff(a, b, 7).size(), 7u);
}

namespace {

// The sample as another author would group it: each object in a separate group, one more group
// around everything, the light at its place, and no unnecessary names.
Scene regrouped() {
  Scene scene = fine_scene();
  scene.nodes[0].name.clear();
  scene.nodes[0].lights.clear();
  scene.nodes[0].primitives.clear();
  const NodeId lit = add_group(scene, 0, {translate(3, 3, 3)});
  scene.nodes[lit].lights = {fine_scene().nodes[0].lights[0]};
  scene.nodes[lit].lights[0].position = {0, 0, 0};
  const NodeId all = add_group(scene, 0, {});
  add_primitive(scene, all, {}, Shape::cube);
  add_primitive(scene, all, {}, Shape::sphere);
  add_primitive(scene, all, {}, Shape::sphere);
  const NodeId arm = add_group(scene, all, {translate(1, 0, 0)});
  add_primitive(scene, add_group(scene, arm, {}));
  const NodeId lamp = add_template(scene, "lamp");
  add_primitive(scene, lamp, {}, Shape::cone);
  add_instance(scene, add_group(scene, all, {}), "lamp");
  return scene;
}

std::vector<std::string> meaning_texts(const Scene& a, const Scene& b) {
  const SceneDiff diff = diff_meaning(a, b);
  EXPECT_EQ(diff.same_meaning, diff.differences.empty());
  std::vector<std::string> result;
  for (const SceneDifference& difference : diff.differences) {
    result.push_back(difference_text(difference));
  }
  return result;
}

template <typename Change>
std::vector<std::string> regrouped_texts(Change change) {
  Scene changed = regrouped();
  change(changed);
  return meaning_texts(sample(), changed);
}

}  // namespace

TEST(DiffMeaning, GroupingIsNotADifference) {
  EXPECT_THAT(regrouped_texts([](Scene&) {}), IsEmpty());
}

TEST(DiffMeaning, NamesOneChangeBetweenScenesWithDifferentGroups) {
  EXPECT_THAT(regrouped_texts([](Scene& s) {
                s.nodes[5].primitives[0].material.diffuse = {1, 0, 0};
              }),
              ElementsAre("root: sphere 2: diffuse: 1 1 1 -> 1 0 0"));
  EXPECT_THAT(regrouped_texts([](Scene& s) { s.nodes[6].transforms = {translate(1, 2, 0)}; }),
              ElementsAre("root: sphere 3: transforms: translate 1 0 0 -> translate 1 2 0"));
  EXPECT_THAT(regrouped_texts([](Scene& s) { s.nodes[1].transforms = {translate(3, 3, 4)}; }),
              ElementsAre("point light 1: position: 3 3 3 -> 3 3 4"));
  EXPECT_THAT(regrouped_texts([](Scene& s) { s.camera.emplace().height_angle_deg = 60; }),
              ElementsAre("camera: heightangle: 45 -> 60"));
  EXPECT_THAT(regrouped_texts([](Scene& s) {
                s.nodes[s.nodes[s.templates[0]].children[0]].primitives[0].material.shininess = 9;
              }),
              ElementsAre("lamp: cone 1: shininess: 0 -> 9"));
  EXPECT_THAT(regrouped_texts([](Scene& s) { s.nodes[3].primitives.clear(); }),
              ElementsAre("root: cube 1: only in the first: cube"));
}

namespace {

// An area light of 2 by 1 in a separate group, shining along `direction`.
Scene area_light(std::vector<Transform> place, glm::vec3 direction = {-1, -2, -0.5f}) {
  Scene scene = fine_scene();
  scene.nodes[0].lights.clear();
  const NodeId lamp = add_group(scene, 0, std::move(place));
  Light light;
  light.type = LightType::area;
  light.position = {0, 0, 0};
  light.direction = direction;
  light.width = 2;
  light.height = 1;
  scene.nodes[lamp].lights = {light};
  return scene;
}

// The same light at the root, with the given size.
Scene lit_at_root(float width, float height, glm::vec3 direction = {-1, -2, -0.5f}) {
  Scene scene = area_light({}, direction);
  scene.nodes[0].lights = scene.nodes[1].lights;
  scene.nodes[1].lights.clear();
  scene.nodes[0].lights[0].width = width;
  scene.nodes[0].lights[0].height = height;
  return scene;
}

}  // namespace

TEST(DiffMeaning, AreaLightsAreComparedAsTheyAreInTheWorld) {
  const Scene a = area_light({scale(1.1f, 1.1f, 1.1f)});
  EXPECT_THAT(meaning_texts(a, lit_at_root(2.2f, 1.1f)), IsEmpty());
  EXPECT_THAT(meaning_texts(a, lit_at_root(2.3f, 1.1f)),
              ElementsAre("area light 1: width: 2.2 -> 2.3"));
}

TEST(DiffMeaning, NamesATurnOfAnAreaLight) {
  const glm::vec3 down(0, -1, 0);
  const Scene turned = area_light({rotate({0, 1, 0}, 30)}, down);
  EXPECT_THAT(meaning_texts(turned, lit_at_root(2, 1, down)),
              ElementsAre("area light 1: turned: width along 0.866 0 -0.5, height along -0.5 0 "
                          "-0.866 -> no"));
  // Half a turn does not change the rectangle.
  EXPECT_THAT(meaning_texts(area_light({rotate({0, 1, 0}, 180)}, down), lit_at_root(2, 1, down)),
              IsEmpty());
}

// Scenes built in memory have no file places to tell lights apart.
TEST(DiffMeaning, LightsOfOneGroupNeedNoPlacesInAFile) {
  const auto two_spots = [](float second_angle, bool grouped) {
    Scene scene = fine_scene();
    Light spot;
    spot.type = LightType::spot;
    spot.direction = {0, -1, 0};
    spot.angle_deg = 10.0f;
    scene.nodes[0].lights = {spot, spot};
    scene.nodes[0].lights[1].angle_deg = second_angle;
    if (grouped) {
      const NodeId group = add_group(scene, 0);
      scene.nodes[group].lights = std::move(scene.nodes[0].lights);
      scene.nodes[0].lights.clear();
    }
    return scene;
  };
  EXPECT_THAT(meaning_texts(two_spots(20, false), two_spots(20, true)), IsEmpty());
  EXPECT_THAT(meaning_texts(two_spots(20, false), two_spots(30, true)),
              ElementsAre("spotlight 2: angle: 20 -> 30"));
}
