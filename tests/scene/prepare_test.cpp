#include "scenefile/scene/prepare.h"

#include "builders.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace scenefile;
using namespace scenefile::test;

namespace {

RenderScene ready(const Scene& scene) {
  return prepare(scene, Limits{}).scene;
}

const RenderGroup& root_of(const RenderScene& scene) {
  return scene.groups[scene.root];
}

}  // namespace

TEST(Prepare, EmptySceneHasAnEmptyRoot) {
  const RenderScene scene = ready(Scene{});
  ASSERT_EQ(scene.groups.size(), 1u);
  EXPECT_TRUE(root_of(scene).primitives.empty());
  EXPECT_EQ(count_virtual_primitives(scene), 0);
  EXPECT_EQ(instance_nesting(scene), 0u);
}

TEST(Prepare, NestedGroupsFoldIntoOne) {
  Scene scene;
  const NodeId outer = add_group(scene, 0, {translate(1, 0, 0)});
  const NodeId inner = add_group(scene, outer, {scale(2, 2, 2)});
  scene.nodes[inner].name = "named, but no template";
  add_primitive(scene, inner, {translate(0, 1, 0)});
  const RenderScene got = ready(scene);
  ASSERT_EQ(got.groups.size(), 1u);
  ASSERT_EQ(root_of(got).primitives.size(), 1u);
  EXPECT_EQ(root_of(got).primitives[0].group_from_object.point({0, 0, 0}), glm::vec3(1, 2, 0));
  EXPECT_EQ(root_of(got).primitives[0].group_from_object.vector({1, 0, 0}), glm::vec3(2, 0, 0));
}

TEST(Prepare, MirroredAndNonUniformScalesStay) {
  Scene scene;
  add_primitive(scene, 0, {scale(-1, 2, 0.5f)});
  const Affine map = root_of(ready(scene)).primitives.at(0).group_from_object;
  EXPECT_EQ(map.vector({1, 1, 1}), glm::vec3(-1, 2, 0.5));
}

TEST(Prepare, DocumentOrderIsKept) {
  Scene scene;
  scene.nodes[0].primitives = {primitive(Shape::cube)};
  const NodeId group = add_group(scene, 0);
  add_primitive(scene, group, {}, Shape::cone);
  add_primitive(scene, 0, {}, Shape::cylinder);
  const RenderScene got = ready(scene);
  ASSERT_EQ(root_of(got).primitives.size(), 3u);
  EXPECT_EQ(root_of(got).primitives[0].shape, Shape::cube);
  EXPECT_EQ(root_of(got).primitives[1].shape, Shape::cone);
  EXPECT_EQ(root_of(got).primitives[2].shape, Shape::cylinder);
}

TEST(Prepare, TemplatesOfTemplatesStayGroups) {
  Scene scene;
  const NodeId leg = add_template(scene, "leg");
  scene.nodes[leg].transforms = {scale(3, 3, 3)};
  add_primitive(scene, leg);
  const NodeId table = add_template(scene, "table");
  add_instance(scene, table, "leg", {translate(1, 0, 0)});
  add_instance(scene, table, "leg", {translate(-1, 0, 0)});
  add_instance(scene, 0, "table", {scale(2, 2, 2)});
  add_instance(scene, 0, "table", {});
  const RenderScene got = ready(scene);
  ASSERT_EQ(got.groups.size(), 3u);
  EXPECT_EQ(got.root, 2u);
  ASSERT_EQ(got.groups[0].primitives.size(), 1u);
  EXPECT_EQ(got.groups[0].primitives[0].group_from_object.vector({1, 0, 0}), glm::vec3(3, 0, 0));
  ASSERT_EQ(got.groups[1].instances.size(), 2u);
  EXPECT_EQ(got.groups[1].instances[0].group, 0u);
  EXPECT_EQ(got.groups[1].instances[1].group_from_instance.offset, glm::vec3(-1, 0, 0));
  ASSERT_EQ(root_of(got).instances.size(), 2u);
  EXPECT_EQ(root_of(got).instances[0].group, 1u);
  EXPECT_EQ(count_virtual_primitives(got), 4);
  EXPECT_EQ(instance_nesting(got), 2u);
}

TEST(Prepare, OrderOfDeclarationDoesNotMatter) {
  const auto make = [](bool swapped) {
    Scene scene;
    for (const std::string name : {swapped ? "b" : "a", swapped ? "a" : "b"}) {
      add_primitive(scene, add_template(scene, name), {}, name == "a" ? Shape::cube : Shape::cone);
    }
    add_instance(scene, 0, "a");
    add_instance(scene, 0, "b");
    return scene;
  };
  EXPECT_TRUE(same_meaning(make(false), make(true)));
}

TEST(Prepare, LeavesOutInvisibleObjects) {
  Scene scene;
  add_template(scene, "empty");
  add_instance(scene, add_template(scene, "holds empty"), "empty");
  add_primitive(scene, add_template(scene, "unused"));
  add_primitive(scene, add_template(scene, "flattened"));
  scene.nodes[add_template(scene, "unnamed mesh")].primitives = {primitive(Shape::mesh)};
  add_instance(scene, 0, "holds empty");
  add_instance(scene, 0, "empty");
  add_instance(scene, 0, "flattened", {scale(1, 0, 1)});
  add_instance(scene, 0, "unnamed mesh");
  add_instance(scene, 0, "nobody");
  add_primitive(scene, 0, {scale(0, 0, 0)});
  EXPECT_EQ(ready(scene), ready(Scene{}));
}

TEST(Prepare, ContentsOfAnInstanceNodeDoNotCount) {
  Scene scene;
  add_primitive(scene, add_template(scene, "t"));
  const NodeId instance = add_instance(scene, 0, "t");
  Scene more = scene;
  more.nodes[instance].primitives = {primitive(Shape::cube)};
  more.nodes[instance].lights = {point_light()};
  add_primitive(more, instance);
  EXPECT_TRUE(same_meaning(scene, more));
}

TEST(Prepare, AScaleThatIsUndoneInsideIsDrawn) {
  Scene scene;
  const NodeId huge = add_group(scene, 0, {scale(1e20f, 1e20f, 1e20f), scale(1e20f, 1e20f, 1e20f)});
  add_primitive(scene, huge, {scale(1e-20f, 1e-20f, 1e-20f), scale(1e-20f, 1e-20f, 1e-20f)});
  EXPECT_EQ(root_of(ready(scene)).primitives.size(), 1u);
}

TEST(Prepare, MaterialsAndFilesAreNumberedOnce) {
  Scene scene;
  Primitive red = primitive();
  red.material.diffuse = {1, 0, 0};
  red.material.texture = TextureUse{"a.png", 1, 1, {4, 2}};
  Primitive mesh = primitive(Shape::mesh);
  mesh.mesh_file = "m.obj";
  mesh.location = {9, 1};
  scene.nodes[0].primitives = {primitive(), red, primitive(), red, mesh, mesh};
  red.material.texture->repeat_u = 2;
  red.material.bump_map = TextureUse{"b.png", 1, 1, {}};
  scene.nodes[0].primitives.push_back(red);
  scene.field_places.push_back({{9, 1}, Field::mesh_file, {9, 40}});
  const RenderScene got = ready(scene);
  EXPECT_EQ(got.materials.size(), 3u);
  const std::vector<RenderPrimitive>& p = root_of(got).primitives;
  EXPECT_EQ(p[0].material, p[2].material);
  EXPECT_EQ(p[1].material, p[3].material);
  EXPECT_NE(p[1].material, p[6].material);
  ASSERT_EQ(got.texture_files.size(), 2u);
  EXPECT_EQ(got.texture_files[0].name, "a.png");
  EXPECT_EQ(got.texture_files[0].location, (Location{4, 2}));
  EXPECT_EQ(got.materials[p[6].material].bump_map.file, 1u);
  ASSERT_EQ(got.mesh_files.size(), 1u);
  EXPECT_EQ(got.mesh_files[0].location, (Location{9, 40}));
  EXPECT_EQ(p[4].mesh, 0u);
  EXPECT_EQ(p[0].mesh, no_index);
}

TEST(Prepare, MaterialValuesAreMadeSafe) {
  Scene scene;
  Primitive p = primitive();
  p.material.shininess = -3;
  p.material.ior = -1.5f;
  p.material.blend = 7;
  p.material.texture = TextureUse{"a.png", 1e30f, -1e30f, {}};
  scene.nodes[0].primitives = {p};
  const RenderMaterial m = ready(scene).materials.at(0);
  EXPECT_EQ(m.shininess, 0);
  EXPECT_EQ(m.ior, 1);
  EXPECT_EQ(m.blend, 1);
  EXPECT_EQ(m.texture.repeat_u, 1e4f);
  EXPECT_EQ(m.texture.repeat_v, -1e4f);
  scene.nodes[0].primitives[0].material = Material{};
  EXPECT_EQ(ready(scene).materials.at(0), RenderMaterial{});
  EXPECT_EQ(ready(scene).materials.at(0).ior, 1);
}

TEST(Prepare, BothZerosAreOneMaterial) {
  Scene scene;
  Primitive a = primitive();
  a.material.ambient = {0.0f, 0, 0};
  Primitive b = primitive();
  b.material.ambient = {-0.0f, 0, 0};
  scene.nodes[0].primitives = {a, b};
  EXPECT_EQ(ready(scene).materials.size(), 1u);
}

TEST(Prepare, SourcesLeadBack) {
  Scene scene;
  const NodeId node = add_primitive(scene, 0);
  scene.nodes[node].primitives[0].location = {5, 6};
  scene.nodes[0].lights = {point_light()};
  scene.nodes[0].lights[0].location = {2, 3};
  const Prepared got = prepare(scene, Limits{});
  const Source& object = got.sources.at(root_of(got.scene).primitives[0].source);
  EXPECT_EQ(object.node, node);
  EXPECT_EQ(place_of(scene, object), (Location{5, 6}));
  EXPECT_EQ(place_of(scene, got.sources.at(got.scene.lights.at(0).source)), (Location{2, 3}));
}

TEST(Prepare, GlobalsPassThrough) {
  Scene scene;
  scene.global = Global{0.1f, 0.2f, 0.3f, 0.4f, {}};
  EXPECT_EQ(ready(scene).global, (RenderGlobal{0.1f, 0.2f, 0.3f, 0.4f}));
}

TEST(Prepare, TemplateBombsStayAsSmallAsTheirFile) {
  const RenderScene got = ready(bomb(40, 10, true));
  EXPECT_EQ(got.groups.size(), 42u);
  EXPECT_NEAR(count_virtual_primitives(got) / 1e40, 1, 1e-9);
  EXPECT_EQ(instance_nesting(got), 41u);
}

TEST(Prepare, VirtualPrimitivesSaturate) {
  const RenderScene got = ready(bomb(400, 10, true));
  EXPECT_EQ(count_virtual_primitives(got), std::numeric_limits<double>::infinity());
}

TEST(Prepare, EmptyTemplateBombsVanish) {
  EXPECT_EQ(ready(bomb(60, 2, false)), ready(fine_scene()));
}

TEST(Prepare, IsSafeOnLoops) {
  Scene scene = fine_scene();
  const NodeId a = add_template(scene, "a");
  const NodeId b = add_template(scene, "b");
  add_primitive(scene, a);
  add_instance(scene, a, "b");
  add_instance(scene, a, "a");
  add_instance(scene, b, "a");
  scene.nodes[b].lights = {point_light()};
  add_instance(scene, 0, "a");
  const RenderScene got = ready(scene);
  EXPECT_GE(count_virtual_primitives(got), 1);
  for (std::size_t g = 0; g < got.groups.size(); ++g) {
    for (const RenderInstance& instance : got.groups[g].instances) {
      EXPECT_LT(instance.group, g);
    }
  }
}

TEST(Prepare, IsSafeOnBadIndices) {
  Scene scene = fine_scene();
  scene.nodes[0].children = {7, 0, 0};
  scene.templates = {9, 0};
  EXPECT_EQ(root_of(ready(scene)).primitives.size(), 1u);
  scene.root = 12;
  EXPECT_EQ(ready(scene).groups.size(), 1u);
}
