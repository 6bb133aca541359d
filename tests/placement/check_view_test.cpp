#include "scenefile/placement/check_view.h"

#include "scenefile/geometry/tessellate.h"
#include "scenefile/placement/codes.h"
#include "trace/build_scene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <string>
#include <utility>

namespace scenefile::placement_test {
namespace {

using namespace trace_test;

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

Diagnostics judge(const SceneBuilder& b, bool shadows = true, double aspect = 4,
                  bool paths = false) {
  ViewQuestion question;
  question.aspect = aspect;
  question.shadows = shadows;
  question.paths = paths;
  question.place_of = [](std::uint32_t source) { return Location{source + 1, 1}; };
  Diagnostics diagnostics;
  check_view(b.scene, b.assets, question, diagnostics);
  return diagnostics;
}

std::vector<std::string> codes(const Diagnostics& diagnostics) {
  std::vector<std::string> names;
  for (const Diagnostic& d : diagnostics.list()) {
    names.emplace_back(d.code->name);
  }
  return names;
}

bool gives(const Diagnostics& diagnostics, const Code& code) {
  const auto& list = diagnostics.list();
  return std::any_of(list.begin(), list.end(),
                     [&](const Diagnostic& d) { return d.code == &code; });
}

// A sphere in front of the camera, and a directional light.
struct Ball : SceneBuilder {
  std::uint32_t plain = material({});

  Ball() {
    look({0, 0, 5}, {0, 0, 0}, 40);
    light(LightType::directional, {0, 0, -1}, {1, 1, 1});
  }
  void add_ball(const glm::vec3& at) { add(Shape::sphere, translate(at), plain); }
};

TEST(CheckView, AGoodSceneHasNoFindings) {
  Ball b;
  b.add_ball({0, 0, 0});
  EXPECT_THAT(codes(judge(b)), IsEmpty());
}

TEST(CheckView, AnEmptySceneHasNoFurtherFindings) {
  Ball b;
  EXPECT_THAT(codes(judge(b)), IsEmpty());
}

TEST(CheckView, CameraInsideEachShape) {
  for (const Shape shape : {Shape::cube, Shape::sphere, Shape::cylinder, Shape::cone}) {
    Ball b;
    b.add(shape, scale({30, 30, 30}), b.plain);
    EXPECT_THAT(codes(judge(b)), ElementsAre("camera.inside-object")) << static_cast<int>(shape);
  }
  Ball near_miss;
  near_miss.add(Shape::sphere, scale({9.99f, 9.99f, 9.99f}), near_miss.plain);
  EXPECT_THAT(codes(judge(near_miss)), IsEmpty());
}

TEST(CheckView, CameraInsideACopyOfATemplate) {
  Ball b;
  RenderGroup inner;
  inner.primitives = {b.primitive(Shape::cube, Affine(), b.plain)};
  RenderGroup outer;
  outer.instances = {b.instance(0, translate({9, 0, 5})), b.instance(0, translate({0.4f, 0, 5}))};
  b.scene.groups = {inner, outer};
  b.scene.root = 1;
  const Diagnostics found = judge(b);
  ASSERT_THAT(codes(found), ElementsAre("camera.inside-object"));
  EXPECT_EQ(found.list()[0].message, "the camera is inside the cube of line 1");
}

TEST(CheckView, CameraInsideMeshesThatAreClosedAndFaceOutward) {
  const auto with = [](Mesh mesh) {
    Ball b;
    RenderPrimitive p = b.primitive(Shape::mesh, scale({20, 20, 20}), b.plain);
    p.mesh = b.mesh(std::move(mesh));
    b.scene.groups[0].primitives = {p};
    return codes(judge(b));
  };
  const Mesh sphere = tessellate(Shape::sphere, 12);
  EXPECT_THAT(with(sphere), ElementsAre("camera.inside-object"));
  Mesh open = sphere;
  open.triangles.resize(open.triangles.size() - 10);
  EXPECT_THAT(with(open), IsEmpty());
  Mesh room = sphere;
  for (auto& corners : room.triangles) {
    std::swap(corners[0], corners[1]);
  }
  EXPECT_THAT(with(room), IsEmpty());
}

TEST(CheckView, NothingInViewBehindAndToTheSide) {
  for (const glm::vec3 at :
       {glm::vec3{0, 0, 7}, glm::vec3{0, 6, 0}, glm::vec3{0, -6, 0}, glm::vec3{30, 0, 0}}) {
    Ball b;
    b.add_ball(at);
    EXPECT_THAT(codes(judge(b)), ElementsAre("camera.nothing-in-view")) << at.x << ' ' << at.y;
    b.add_ball({0, 0, -20});
    EXPECT_THAT(codes(judge(b)), IsEmpty());
  }
  Ball wide;
  wide.add_ball({4, 0, 0});
  EXPECT_THAT(codes(judge(wide, true, 1)), ElementsAre("camera.nothing-in-view"));
  EXPECT_THAT(codes(judge(wide, true, 4)), IsEmpty());
}

TEST(CheckView, ALensSeesMore) {
  Ball b;
  b.add_ball({0, 2.6f, 0});
  EXPECT_THAT(codes(judge(b)), ElementsAre("camera.nothing-in-view"));
  b.scene.camera.aperture = 1;
  b.scene.camera.focal_length = 5;
  EXPECT_THAT(codes(judge(b)), IsEmpty());
}

TEST(CheckView, MeshesThatAreNotLoadedLeaveItOpen) {
  Ball b;
  b.add_ball({0, 0, 9});
  b.scene.mesh_files.push_back({"a.obj", {}});
  RenderPrimitive p = b.primitive(Shape::mesh, Affine(), b.plain);
  p.mesh = 0;
  b.scene.groups[0].primitives.push_back(p);
  EXPECT_THAT(codes(judge(b)), IsEmpty());
  b.assets.meshes.resize(1);
  EXPECT_THAT(codes(judge(b)), IsEmpty());
  b.assets.meshes[0] = tessellate(Shape::cube, 3);
  b.scene.groups[0].primitives[1].group_from_object = translate({0, 0, 12});
  EXPECT_THAT(codes(judge(b)), ElementsAre("camera.nothing-in-view"));
}

TEST(CheckView, LightsInsideOpaqueObjects) {
  Ball b;
  b.add_ball({0, 0, 0});
  b.light(LightType::point, {0, 0, 0}, {1, 1, 1});
  const Diagnostics found = judge(b);
  EXPECT_THAT(codes(found), ElementsAre("light.inside-object"));
  EXPECT_EQ(found.count(Severity::note), 1u);
  EXPECT_THAT(codes(judge(b, false)), IsEmpty()) << "without shadows its light gets out";
  b.scene.lights.erase(b.scene.lights.begin());
  EXPECT_THAT(codes(judge(b)), ElementsAre("light.inside-object", "scene.unlit"));
  b.scene.materials[b.plain].transparent = {1, 1, 1};
  EXPECT_THAT(codes(judge(b)), IsEmpty());
  b.scene.global.transparent = 0;
  EXPECT_THAT(codes(judge(b)), ElementsAre("light.inside-object", "scene.unlit"));
}

TEST(CheckView, ALightThatSharesItsRoomWithTheCameraIsFine) {
  Ball b;
  b.add(Shape::cube, scale({50, 50, 50}), b.plain);
  b.add_ball({0, 0, 0});
  b.light(LightType::point, {0, 3, 0}, {1, 1, 1});
  EXPECT_THAT(codes(judge(b)), ElementsAre("camera.inside-object"));
}

TEST(CheckView, SpotsAndAreaLightsThatMiss) {
  Ball b;
  b.add_ball({0, 0, 0});
  RenderLight& spot = b.light(LightType::spot, {0, 3, 0}, {1, 1, 1});
  spot.outer_angle = spot.inner_angle = 0.3f;
  EXPECT_THAT(codes(judge(b)), IsEmpty());
  b.scene.lights[1].direction = {0, 0, 1};
  EXPECT_THAT(codes(judge(b)), ElementsAre("light.misses"));
  b.scene.lights[1].outer_angle = 1.9f;
  EXPECT_THAT(codes(judge(b)), IsEmpty()) << "more than half of space";
  b.scene.lights[1].type = LightType::area;
  b.scene.lights[1].direction = {0, 1, 0};
  EXPECT_THAT(codes(judge(b)), ElementsAre("light.misses"));
  b.scene.lights[1].direction = {0, -1, 0};
  EXPECT_THAT(codes(judge(b)), IsEmpty());
}

TEST(CheckView, MaterialsThatShowNoLight) {
  Ball b;
  b.add_ball({0, 0, 0});
  b.scene.global.diffuse = 0;
  EXPECT_THAT(codes(judge(b)), ElementsAre("scene.unlit"));
  b.scene.materials[b.plain].specular = {1, 1, 1};
  EXPECT_THAT(codes(judge(b)), ElementsAre("scene.unlit")) << "shininess 0 gives no highlight";
  b.scene.materials[b.plain].shininess = 5;
  EXPECT_THAT(codes(judge(b)), IsEmpty());
}

TEST(CheckView, MaterialsOfFacesShowLight) {
  Ball b;
  b.add_ball({0, 0, 0});
  b.scene.global.diffuse = 0;
  FaceMaterial face;
  b.assets.mesh_materials.push_back({{face}, {0}});
  b.assets.mesh_materials[0].materials[0].diffuse = glm::vec3(0);
  EXPECT_THAT(codes(judge(b)), ElementsAre("scene.unlit"));
  b.assets.mesh_materials[0].materials[0].diffuse = glm::vec3(0.5f);
  EXPECT_THAT(codes(judge(b)), IsEmpty());
}

TEST(CheckView, DistinguishesMaterialsFromCoefficientsWithoutLight) {
  Ball b;
  b.add_ball({0, 0, 0});
  b.scene.global.diffuse = 0;
  EXPECT_THAT(judge(b).list().at(0).message, HasSubstr("coefficient of the global data is 0"));
  b.scene.global.diffuse = 0.5f;
  b.scene.materials[b.plain].diffuse = {0, 0, 0};
  EXPECT_THAT(judge(b).list().at(0).message, HasSubstr("no material has"));
}

TEST(CheckView, MaterialsThatReturnMoreLightThanTheyReceiveInModePath) {
  Ball b;
  b.add_ball({0, 0, 0});
  b.add_ball({1, 0, 0});
  RenderMaterial bright;
  bright.diffuse = glm::vec3(0.75f);
  bright.specular = bright.reflective = {0, 0.25f, 0};
  b.add(Shape::cube, translate({-1, 0, 0}), b.material(bright));
  const auto found = [&] { return judge(b, true, 4, true); };
  EXPECT_THAT(codes(found()), IsEmpty()) << "shininess 0 gives no highlight";
  b.scene.materials[1].shininess = 10;
  EXPECT_THAT(codes(judge(b)), IsEmpty());
  ASSERT_THAT(codes(found()), ElementsAre("material.energy"));
  EXPECT_EQ(found().list()[0].location, (Location{3, 1}));
  EXPECT_THAT(found().list()[0].message, HasSubstr("of the cube, each times its coefficient, add "
                                                   "up to 1.25 in a channel"));
  b.scene.global.specular = 0.5f;
  EXPECT_THAT(codes(found()), IsEmpty());
  b.scene.materials[1].transparent = glm::vec3(0.5f);
  EXPECT_THAT(codes(found()), ElementsAre("material.energy"));
  // The share of the texture is unknown.
  b.scene.materials[1].texture.file = b.texture(1, 1, {255});
  b.scene.materials[1].blend = 1;
  EXPECT_THAT(codes(found()), IsEmpty());
}

TEST(CheckView, TexturesOfMeshesWithoutUvs) {
  Ball b;
  RenderMaterial textured;
  textured.texture.file = b.texture(1, 1, {255});
  textured.blend = 1;
  Mesh mesh = tessellate(Shape::sphere, 6);
  mesh.uvs.clear();
  mesh.triangle_uvs.clear();
  const std::uint32_t index = b.mesh(mesh);
  for (const std::uint32_t material : {b.plain, b.material(textured), b.material(textured)}) {
    b.add(Shape::mesh, translate({0, 0, 0}), material);
    b.scene.groups[0].primitives.back().mesh = index;
  }
  const Diagnostics found = judge(b);
  ASSERT_THAT(codes(found), ElementsAre("material.texture-without-uvs"));
  EXPECT_EQ(found.list()[0].location, (Location{2, 1}));
  EXPECT_EQ(
      found.list()[0].message,
      "the mesh \"mesh\" has no texture coordinates (vt), so its texture shows a single color");

  // All faces have materials of their own.
  FaceMaterial face;
  b.assets.mesh_materials = {{{face}, std::vector<std::uint32_t>(mesh.triangles.size(), 0)}};
  EXPECT_THAT(codes(judge(b)), IsEmpty());
  b.assets.mesh_materials[0].materials[0].emission_map = 0;
  EXPECT_THAT(codes(judge(b)), ElementsAre("material.texture-without-uvs"));

  Mesh& loaded = b.assets.meshes[0];
  loaded.uvs = {{0, 0}};
  loaded.triangle_uvs.resize(loaded.triangles.size());
  EXPECT_THAT(codes(judge(b)), IsEmpty());
}

TEST(CheckView, EndsOnTemplateBombs) {
  Ball b;
  b.scene.groups.clear();
  RenderGroup leaf;
  leaf.primitives = {b.primitive(Shape::sphere, translate({0, 0, 9}), b.plain)};
  b.scene.groups.push_back(leaf);
  for (std::uint32_t i = 0; i < 40; ++i) {
    RenderGroup group;
    for (int copy = 0; copy < 10; ++copy) {
      // Its bounding box is in view, but no part of it is.
      group.instances.push_back(b.instance(i, rotate(float(copy) / 100, {0, 0, 1})));
    }
    b.scene.groups.push_back(group);
  }
  b.scene.root = 40;
  EXPECT_LE(codes(judge(b)).size(), 1u);
}

// A small random scene, seen from the origin.
SceneBuilder random_scene() {
  const auto number = [](int low, int high) { return float(*rc::gen::inRange(low, high)) / 10; };
  const auto vector = [&](int reach) {
    const float x = number(-reach, reach);
    const float y = number(-reach, reach);
    return glm::vec3(x, y, number(-reach, reach));
  };
  SceneBuilder b;
  RenderMaterial material;
  material.ambient = {0.3f, 0.3f, 0.3f};
  const std::uint32_t plain = b.material(material);
  const int count = *rc::gen::inRange(1, 5);
  for (int i = 0; i < count; ++i) {
    const Shape shape = *rc::gen::element(Shape::cube, Shape::sphere, Shape::cylinder, Shape::cone);
    const glm::vec3 at = vector(60);
    b.add(shape, translate(at) * scale(glm::vec3(0.2f) + glm::abs(vector(40))), plain);
  }
  const int lights = *rc::gen::inRange(1, 3);
  for (int i = 0; i < lights; ++i) {
    RenderLight& light =
        b.light(*rc::gen::element(LightType::point, LightType::spot), vector(60), {1, 1, 1});
    light.direction = glm::normalize(vector(10) + glm::vec3(0.05f));
    light.inner_angle = light.outer_angle = number(1, 12);
  }
  b.look({0, 0, 0}, {0.3, 0.1, -1}, 70);
  return b;
}

TEST(CheckView, ClaimsAreTrueOfThePicture) {
  EXPECT_TRUE(rc::check("no false claims", [] {
    const SceneBuilder b = random_scene();
    const Diagnostics found = judge(b, true, 2);
    const bool nothing = gives(found, "camera.nothing-in-view"_code);
    const bool unlit = gives(found, "scene.unlit"_code);
    RC_CLASSIFY(nothing, "nothing in view");
    RC_CLASSIFY(unlit, "unlit");
    RC_PRE(nothing || unlit);
    RenderOptions options = default_options(Profile::course);
    const Image image = b.picture(32, 16, options);
    const float seen = *std::max_element(image.rgb.begin(), image.rgb.end());
    if (nothing) {
      RC_ASSERT(seen == 0);
    }
    if (unlit) {
      RC_ASSERT(seen <= 0.3f);
    }
  }));
}

}  // namespace
}  // namespace scenefile::placement_test
