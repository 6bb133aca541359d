#include "scenefile/export/face_materials.h"

#include "scenefile/export/codes.h"
#include "scenefile/export/phong_pbr.h"
#include "scenefile/export/report_once.h"

#include <array>
#include <cstdint>
#include <map>
#include <unordered_map>
#include <utility>
#include <vector>

namespace scenefile {

namespace {

// A list of a mesh with only what some of its triangles use, whose indices count from 0 anew.
template <typename Value>
class Compacted {
 public:
  explicit Compacted(const std::vector<Value>& from) : from_(from) {}

  std::array<std::uint32_t, 3> add(std::array<std::uint32_t, 3> corners) {
    for (std::uint32_t& corner : corners) {
      if (corner != mesh_no_index) {
        const auto [at, is_new] =
            numbers_.try_emplace(corner, static_cast<std::uint32_t>(values.size()));
        if (is_new) {
          values.push_back(from_[corner]);
        }
        corner = at->second;
      }
    }
    return corners;
  }

  std::vector<Value> values;

 private:
  const std::vector<Value>& from_;
  std::unordered_map<std::uint32_t, std::uint32_t> numbers_;
};

Mesh part_of(const Mesh& mesh, const std::vector<std::uint32_t>& triangles) {
  Mesh part;
  Compacted positions(mesh.positions);
  Compacted normals(mesh.normals);
  Compacted uvs(mesh.uvs);
  for (const std::uint32_t t : triangles) {
    part.triangles.push_back(positions.add(mesh.triangles[t]));
    if (!mesh.triangle_normals.empty()) {
      part.triangle_normals.push_back(normals.add(mesh.triangle_normals[t]));
    }
    if (!mesh.triangle_uvs.empty()) {
      part.triangle_uvs.push_back(uvs.add(mesh.triangle_uvs[t]));
    }
  }
  part.positions = std::move(positions.values);
  part.normals = std::move(normals.values);
  part.uvs = std::move(uvs.values);
  return part;
}

RenderMaterial material_of(const FaceMaterial& face, bool maps, Diagnostics& diagnostics) {
  RenderMaterial material;
  material.ambient = face.emission;
  material.diffuse = glm::vec3(0);
  material.shininess = face.shininess;
  material.ior = face.ior;
  bool left_out = face.emission_map != no_map;
  if (face.illum == illum_glass) {
    material.transparent = glm::vec3(1);
    material.reflective = glm::vec3(f0_of(face.ior));
  } else if (face.illum == illum_mirror) {
    material.reflective = face.specular;
    left_out = left_out || face.specular_map != no_map;
  } else {
    material.diffuse = face.diffuse;
    material.specular = face.specular;
    left_out = left_out || face.specular_map != no_map || (face.diffuse_map != no_map && !maps);
    if (face.diffuse_map != no_map && maps) {
      material.texture = {face.diffuse_map, 1, 1};
      material.blend = 1;
    }
  }
  if (left_out) {
    report_once("export.lost"_code,
                maps ? "textures of specular and emitted colors are left out"
                     : "textures of face materials are left out",
                diagnostics);
  }
  return material;
}

// Of the scene's own materials, as path tracing uses them.
void multiply_coefficients(RenderScene& scene, const Assets& assets, float transparent) {
  RenderGlobal& global = scene.global;
  for (RenderMaterial& material : scene.materials) {
    material.ambient = glm::vec3(0);
    // Of a texture of blend 1 the object's own color shows nothing.
    const std::uint32_t file = material.texture.file;
    const bool covered =
        material.blend == 1 && file < assets.textures.size() && !assets.textures[file].empty();
    material.diffuse = covered ? glm::vec3(1) : global.diffuse * material.diffuse;
    material.specular *= global.specular;
    material.reflective *= global.specular;
    material.transparent *= global.transparent.value_or(transparent);
    // Glass also reflects, by Fresnel's equations.
    material.reflective = glm::max(material.reflective, f0_of(material.ior) * material.transparent);
  }
  global.ambient = global.diffuse = global.specular = 1;
  global.transparent = 1;
}

/// What a mesh with face materials becomes. `material`: no_index for the object's own.
struct MeshPart {
  std::uint32_t mesh = 0;
  std::uint32_t material = no_index;
};

}  // namespace

void use_face_materials(RenderScene& scene, Assets& assets, float transparent, bool maps,
                        Diagnostics& diagnostics) {
  multiply_coefficients(scene, assets, transparent);
  std::vector<std::vector<MeshPart>> parts(assets.meshes.size());
  for (std::uint32_t m = 0; m < assets.mesh_materials.size(); ++m) {
    const MeshMaterials& faces = assets.mesh_materials[m];
    std::map<std::uint32_t, std::vector<std::uint32_t>> triangles;
    for (std::uint32_t t = 0; t < faces.of_triangle.size(); ++t) {
      triangles[faces.of_triangle[t]].push_back(t);
    }
    for (const auto& [face, list] : triangles) {
      MeshPart part{static_cast<std::uint32_t>(assets.meshes.size())};
      if (face != mesh_no_index) {
        part.material = static_cast<std::uint32_t>(scene.materials.size());
        scene.materials.push_back(material_of(faces.materials[face], maps, diagnostics));
      }
      Mesh own = part_of(assets.meshes[m], list);
      assets.meshes.push_back(std::move(own));
      parts[m].push_back(part);
    }
    if (!parts[m].empty()) {
      assets.meshes[m] = {};
    }
  }
  for (RenderGroup& group : scene.groups) {
    std::vector<RenderPrimitive> primitives;
    for (const RenderPrimitive& p : group.primitives) {
      if (p.shape != Shape::mesh || parts[p.mesh].empty()) {
        primitives.push_back(p);
        continue;
      }
      for (const MeshPart& part : parts[p.mesh]) {
        primitives.push_back(p);
        primitives.back().mesh = part.mesh;
        primitives.back().material = part.material == no_index ? p.material : part.material;
      }
    }
    group.primitives = std::move(primitives);
  }
  assets.mesh_materials.clear();
}

}  // namespace scenefile
