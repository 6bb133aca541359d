#include "scenefile/export/write_obj.h"

#include "scenefile/asset/image_file.h"
#include "scenefile/asset/read_obj.h"
#include "scenefile/export/codes.h"
#include "trace/build_scene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace scenefile {
namespace {

using testing::HasSubstr;
using trace_test::SceneBuilder;

Mesh read_back(const std::string& obj) {
  const Limits limits;
  std::uint64_t triangles = limits.mesh_triangles;
  std::uint64_t bytes = limits.mesh_bytes;
  Diagnostics diagnostics;
  Mesh mesh = read_obj(obj, "scene.obj", limits, triangles, bytes, diagnostics);
  EXPECT_TRUE(diagnostics.list().empty());
  return mesh;
}

TEST(WriteObj, IsReadBackByOurReader) {
  SceneBuilder scene;
  for (const Shape shape : {Shape::cube, Shape::cone, Shape::cylinder, Shape::sphere}) {
    scene.add(shape, trace_test::translate({2 * float(shape), 0, 0}), scene.material({}));
  }
  Diagnostics diagnostics;
  const ObjScene obj = write_obj(scene.scene, scene.assets, {.segments = 8}, diagnostics);
  const Mesh mesh = read_back(obj.obj);
  EXPECT_GT(mesh.triangles.size(), 100u);
  const Bounds box = bounds(mesh);
  EXPECT_LT(glm::distance(box.min, glm::dvec3(-.5)), 1e-6);
  EXPECT_LT(glm::distance(box.max, glm::dvec3(6.5, .5, .5)), 1e-6);
  EXPECT_THAT(obj.obj, HasSubstr("mtllib scene.mtl\n"));
}

TEST(WriteObj, MirroredMeshesKeepTheirFacesOutward) {
  SceneBuilder scene;
  scene.add(Shape::cube, trace_test::scale({-1, 1, 2}), scene.material({}));
  Diagnostics diagnostics;
  const Mesh mesh = read_back(write_obj(scene.scene, scene.assets, {}, diagnostics).obj);
  ASSERT_EQ(mesh.triangles.size(), 12u);
  for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
    const glm::dvec3 flat = surface_at(mesh, i, .3, .3, false).normal;
    const glm::dvec3 smooth = surface_at(mesh, i, .3, .3, true).normal;
    EXPECT_GT(glm::dot(flat, smooth), 0.999);
    EXPECT_GT(glm::dot(flat, glm::dvec3(mesh.positions[mesh.triangles[i][0]])), 0);
  }
}

TEST(WriteObj, CopiesTemplates) {
  SceneBuilder scene;
  scene.scene.groups[0].primitives = {scene.primitive(Shape::cube, {}, scene.material({}))};
  scene.scene.groups.emplace_back();
  scene.scene.groups[1].instances = {scene.instance(0, trace_test::translate({5, 0, 0})),
                                     scene.instance(0, {})};
  scene.scene.root = 1;
  Diagnostics diagnostics;
  EXPECT_EQ(read_back(write_obj(scene.scene, {}, {}, diagnostics).obj).triangles.size(), 24u);
  diagnostics = Diagnostics();
  EXPECT_EQ(write_obj(scene.scene, {}, {.max_triangles = 23}, diagnostics).obj, "");
  ASSERT_TRUE(diagnostics.has_errors());
  EXPECT_EQ(diagnostics.list().back().code, &"export.size-limit"_code);
}

TEST(WriteObj, KeepsPhongMaterialsAndReportsTheRestOnce) {
  SceneBuilder scene;
  scene.scene.global.diffuse = 0.5f;
  RenderMaterial m;
  m.ambient = {0.25f, 0, 0};
  m.diffuse = {1, 0.5f, 0};
  m.specular = {0, 0, 1};
  m.shininess = 12.5f;
  m.transparent = glm::vec3(0.25f);
  m.ior = 1.5f;
  scene.add(Shape::cube, {}, scene.material(m));
  scene.add(Shape::sphere, {}, scene.material(m));
  Diagnostics diagnostics;
  const ObjScene obj = write_obj(scene.scene, scene.assets, {}, diagnostics);
  for (const char* const part :
       {"newmtl m1\n", "newmtl m2\n", "Ka 0.25 0 0\n", "Kd 0.5 0.25 0\n", "Ks 0 0 1\n", "Ns 12.5\n",
        "Tf 1 1 1\n", "d 0.75\n", "Ni 1.5\n", "illum 9\n"}) {
    EXPECT_THAT(obj.mtl, HasSubstr(part));
  }
  ASSERT_EQ(diagnostics.list().size(), 1u);
  EXPECT_EQ(diagnostics.list()[0].code, &"export.lost"_code);
}

TEST(WriteObj, TexturesAreLinearWithBlendBakedIn) {
  SceneBuilder scene;
  RenderMaterial m;
  m.diffuse = {0, 0, 1};
  m.blend = 0.5f;
  m.texture.file = scene.texture(1, 1, {255});
  scene.add(Shape::cube, {}, scene.material(m));
  Diagnostics diagnostics;
  const ObjScene obj = write_obj(scene.scene, scene.assets, {}, diagnostics);
  EXPECT_THAT(obj.mtl, HasSubstr("map_Kd scene-1.png\n"));
  ASSERT_EQ(obj.pictures.size(), 1u);
  EXPECT_THAT(decode_image(obj.pictures[0])->rgb, testing::ElementsAre(128, 128, 255));
}

}  // namespace
}  // namespace scenefile
