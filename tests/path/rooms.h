#pragma once
// Scenes of meshes with face materials.

#include "scenefile/path/render_path.h"
#include "trace/build_scene.h"

namespace scenefile::path_test {

using trace_test::scale;
using trace_test::SceneBuilder;
using trace_test::translate;

inline FaceMaterial diffuse(const glm::vec3& color, const glm::vec3& emission = glm::vec3(0)) {
  FaceMaterial m;
  m.diffuse = color;
  m.emission = emission;
  return m;
}

inline FaceMaterial glossy(const glm::vec3& color, float shininess) {
  FaceMaterial m;
  m.specular = color;
  m.shininess = shininess;
  return m;
}

inline FaceMaterial mirror(const glm::vec3& color) {
  FaceMaterial m;
  m.specular = color;
  m.illum = 5;
  return m;
}

inline FaceMaterial glass(float ior) {
  FaceMaterial m;
  m.ior = ior;
  m.illum = 7;
  return m;
}

/// A mesh with face materials.
struct Model {
  Mesh mesh;
  MeshMaterials materials;

  std::uint32_t material(const FaceMaterial& m) {
    materials.materials.push_back(m);
    return static_cast<std::uint32_t>(materials.materials.size() - 1);
  }

  /// Adds a parallelogram, whose front is the side of u x v.
  void quad(const glm::vec3& corner, const glm::vec3& u, const glm::vec3& v,
            std::uint32_t material_index) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(), {corner, corner + u, corner + u + v, corner + v});
    mesh.triangles.push_back({first, first + 1, first + 2});
    mesh.triangles.push_back({first, first + 2, first + 3});
    materials.of_triangle.insert(materials.of_triangle.end(), 2, material_index);
  }

  /// Adds the faces of the box from `low` to `high`; their fronts are inside or outside.
  void box(const glm::vec3& low, const glm::vec3& high, bool inside, std::uint32_t material_index) {
    const glm::vec3 size = high - low;
    for (int axis = 0; axis < 3; ++axis) {
      glm::vec3 u(0), v(0), across(0);
      u[(axis + 1) % 3] = size[(axis + 1) % 3];
      v[(axis + 2) % 3] = size[(axis + 2) % 3];
      across[axis] = size[axis];
      // u x v points along the axis.
      inside ? quad(low, u, v, material_index) : quad(low, v, u, material_index);
      inside ? quad(low + across, v, u, material_index) : quad(low + across, u, v, material_index);
    }
  }
};

/// A scene without lights.
struct Room : SceneBuilder {
  void add(const Model& model, const Affine& place = {}) {
    const std::uint32_t index = mesh(model.mesh);
    assets.mesh_materials.resize(assets.meshes.size());
    assets.mesh_materials[index] = model.materials;
    RenderMaterial unused;
    unused.diffuse = glm::vec3(0);
    const std::uint32_t object = material(unused);
    SceneBuilder::add(Shape::mesh, place, object);
    scene.groups.back().primitives.back().mesh = index;
  }
  using SceneBuilder::add;
};

/// A closed box from -1 to 1 whose walls all have this material, seen from inside.
inline Room closed_box(const FaceMaterial& walls) {
  Room room;
  Model model;
  model.box(glm::vec3(-1), glm::vec3(1), true, model.material(walls));
  room.add(model);
  room.look({0.3, 0.2, 0.5}, {-0.4, -0.1, -1}, 70);
  return room;
}

inline RenderOptions path_options(int width, int height, int samples) {
  RenderOptions options;
  options.mode = Mode::path;
  options.width = width;
  options.height = height;
  options.samples = samples;
  options.max_depth = 0;
  return options;
}

inline PathResult draw(const Room& room, const RenderOptions& options) {
  return render_path(room.scene, room.assets, options);
}

/// The mean of all pixels.
inline glm::dvec3 mean_of(const Image& image) {
  glm::dvec3 sum(0);
  for (std::size_t i = 0; i < image.rgb.size(); i += 3) {
    sum += glm::dvec3(image.rgb[i], image.rgb[i + 1], image.rgb[i + 2]);
  }
  return sum / (double(image.rgb.size()) / 3);
}

}  // namespace scenefile::path_test
