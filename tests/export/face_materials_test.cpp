#include "scenefile/export/face_materials.h"

#include "scenefile/asset/image_file.h"
#include "scenefile/export/codes.h"
#include "scenefile/export/write_obj.h"
#include "scenefile/export/write_pov.h"
#include "trace/build_scene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace scenefile {
namespace {

using testing::HasSubstr;
using testing::Not;
using trace_test::SceneBuilder;

// Two walls and a lamp of one mesh, which also has a triangle with the material of its object.
struct PathExport : testing::Test {
  PathExport() {
    Mesh mesh;
    for (int i = 0; i < 12; ++i) {
      mesh.positions.emplace_back(float(i), 0, float(i % 3));
    }
    mesh.triangles = {{0, 1, 2}, {3, 4, 5}, {6, 7, 8}, {9, 10, 11}};
    scene.assets.meshes.push_back(mesh);
    MeshMaterials faces;
    faces.of_triangle = {1, 0, mesh_no_index, 1};
    faces.materials.resize(2);
    faces.materials[0].emission = {17, 12, 4};
    faces.materials[0].diffuse = glm::vec3(0.5f);
    faces.materials[1].diffuse = glm::vec3(0.25f);
    faces.materials[1].specular = glm::vec3(0.5f);
    faces.materials[1].shininess = 8;
    scene.assets.mesh_materials.push_back(faces);
    scene.scene.global = {0.3f, 0.5f, 0.25f, {}};
    RenderMaterial own;
    own.ambient = own.diffuse = glm::vec3(0.8f);
    own.transparent = glm::vec3(0.4f);
    own.ior = 3;
    scene.add(Shape::mesh, {}, scene.material(own));
    scene.scene.groups[scene.scene.root].primitives[0].mesh = 0;
  }

  void use(bool maps = true) {
    use_face_materials(scene.scene, scene.assets, 0.5f, maps, diagnostics);
  }

  SceneBuilder scene;
  Diagnostics diagnostics;
};

TEST_F(PathExport, AMeshForEachMaterial) {
  use();
  const auto& primitives = scene.scene.groups[scene.scene.root].primitives;
  ASSERT_EQ(primitives.size(), 3u);
  const Mesh& walls = scene.assets.meshes[primitives[1].mesh];
  EXPECT_EQ(walls.triangles.size(), 2u);
  EXPECT_EQ(walls.positions.size(), 6u);
  EXPECT_EQ(walls.positions[walls.triangles[1][2]], glm::vec3(11, 0, 2));
  EXPECT_EQ(scene.scene.materials[primitives[0].material].ambient, glm::vec3(17, 12, 4));
  EXPECT_EQ(scene.scene.materials[primitives[1].material].specular, glm::vec3(0.5f));
  const RenderMaterial& own = scene.scene.materials[primitives[2].material];
  EXPECT_EQ(own.ambient, glm::vec3(0)) << "path tracing has no ambient light";
  EXPECT_EQ(own.diffuse, glm::vec3(0.4f));
  EXPECT_EQ(own.transparent, glm::vec3(0.2f));
  EXPECT_EQ(own.reflective, glm::vec3(0.05f)) << "a quarter, by Fresnel's equations";
  EXPECT_EQ(scene.scene.global.diffuse, 1);
  EXPECT_TRUE(diagnostics.list().empty());
}

TEST_F(PathExport, AnObjectWhoseTextureIsMissingKeepsItsColor) {
  RenderMaterial& own = scene.scene.materials[0];
  own.texture = {0, 1, 1};
  own.blend = 1;
  scene.assets.textures.emplace_back();
  use();
  EXPECT_EQ(scene.scene.materials[0].diffuse, glm::vec3(0.4f));
}

TEST_F(PathExport, ObjHasTheFaceMaterials) {
  scene.assets.mesh_materials[0].materials[1].illum = 5;
  use();
  const ObjScene obj = write_obj(scene.scene, scene.assets, {.path = true}, diagnostics);
  EXPECT_THAT(obj.mtl, HasSubstr("Ke 17 12 4\nKd 0.5 0.5 0.5\n"));
  EXPECT_THAT(obj.mtl, HasSubstr("Kd 0 0 0\nKs 0.5 0.5 0.5\nNs 0\nillum 5\n")) << "a mirror";
  EXPECT_THAT(obj.mtl, HasSubstr("Ni 3\nillum 7\n")) << "glass";
  EXPECT_THAT(obj.mtl, Not(HasSubstr("Ka")));
}

TEST_F(PathExport, PovRayDrawsTheLightOfFaces) {
  use(false);
  const std::string pov = write_pov(scene.scene, scene.assets, {}, {.path = true}, diagnostics);
  EXPECT_THAT(pov, HasSubstr("radiosity"));
  EXPECT_THAT(pov, HasSubstr("emission rgb <34, 24, 8>")) << "of a pigment of 0.5";
  EXPECT_THAT(pov, HasSubstr("phong 2.5 phong_size 8")) << "5 times the share of the lobe";
}

TEST_F(PathExport, TexturesThatAreLeftOutAreReported) {
  scene.assets.mesh_materials[0].materials[1].diffuse_map = 0;
  use(false);
  ASSERT_EQ(diagnostics.list().size(), 1u);
  EXPECT_EQ(diagnostics.list()[0].code, &"export.lost"_code);
  EXPECT_EQ(diagnostics.list()[0].message, "textures of face materials are left out");
}

TEST_F(PathExport, TexturesOfFacesAreUsed) {
  scene.assets.mesh_materials[0].materials[1].diffuse_map = 0;
  use();
  const auto& primitives = scene.scene.groups[scene.scene.root].primitives;
  const RenderMaterial& walls = scene.scene.materials[primitives[1].material];
  EXPECT_EQ(walls.texture.file, 0u);
  EXPECT_EQ(walls.blend, 1);
  EXPECT_TRUE(diagnostics.list().empty());
  scene.assets.textures.push_back({1, 1, {200, 100, 0}});
  const ObjScene obj = write_obj(scene.scene, scene.assets, {.path = true}, diagnostics);
  EXPECT_THAT(decode_image(obj.pictures.at(0))->rgb, testing::ElementsAre(50, 25, 0));
}

}  // namespace
}  // namespace scenefile
