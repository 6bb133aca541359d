#pragma once
// Shorthand for building render scenes.

#include "scenefile/trace/render.h"

#include <glm/gtc/matrix_transform.hpp>

#include <cmath>
#include <utility>
#include <vector>

namespace scenefile::trace_test {

inline Affine affine(const glm::mat4& m) {
  return {glm::mat3(m), glm::vec3(m[3])};
}

inline Affine translate(const glm::vec3& by) {
  return {glm::mat3(1), by};
}

inline Affine scale(const glm::vec3& by) {
  return {glm::mat3(by.x, 0, 0, 0, by.y, 0, 0, 0, by.z), glm::vec3(0)};
}

inline Affine rotate(float degrees, const glm::vec3& axis) {
  return affine(glm::rotate(glm::mat4(1), glm::radians(degrees), axis));
}

/// A scene with a root group, coefficients of 1, and a camera at the origin that looks along -z.
struct SceneBuilder {
  RenderScene scene;
  Assets assets;

  SceneBuilder() {
    scene.global.ambient = scene.global.diffuse = scene.global.specular = 1;
    scene.global.transparent = 1;
    scene.groups.resize(1);
  }

  std::uint32_t material(const RenderMaterial& m) {
    scene.materials.push_back(m);
    return static_cast<std::uint32_t>(scene.materials.size() - 1);
  }

  /// Emits light: ambient term only.
  std::uint32_t glowing(const glm::vec3& color) {
    RenderMaterial m;
    m.ambient = color;
    m.diffuse = glm::vec3(0);
    return material(m);
  }

  RenderPrimitive primitive(Shape shape, const Affine& place, std::uint32_t material_index) {
    RenderPrimitive p;
    p.shape = shape;
    p.group_from_object = place;
    p.material = material_index;
    p.source = next_source_++;
    return p;
  }

  RenderInstance instance(std::uint32_t group, const Affine& place) {
    RenderInstance i;
    i.group = group;
    i.group_from_instance = place;
    i.source = next_source_++;
    return i;
  }

  /// Adds to the root, which is the last group.
  void add(Shape shape, const Affine& place, std::uint32_t material_index) {
    scene.groups.back().primitives.push_back(primitive(shape, place, material_index));
    scene.root = static_cast<std::uint32_t>(scene.groups.size() - 1);
  }

  RenderLight& light(LightType type, const glm::vec3& where, const glm::vec3& color) {
    RenderLight l;
    l.type = type;
    l.color = color;
    (type == LightType::directional ? l.direction : l.position) = where;
    scene.lights.push_back(l);
    return scene.lights.back();
  }

  std::uint32_t texture(int width, int height, const std::vector<std::uint8_t>& gray) {
    Texture t;
    t.width = width;
    t.height = height;
    for (const std::uint8_t g : gray) {
      t.rgb.push_back(g);
      t.rgb.push_back(g);
      t.rgb.push_back(g);
    }
    assets.textures.push_back(std::move(t));
    scene.texture_files.push_back({"texture", {}});
    return static_cast<std::uint32_t>(assets.textures.size() - 1);
  }

  std::uint32_t mesh(Mesh m) {
    assets.meshes.push_back(std::move(m));
    scene.mesh_files.push_back({"mesh", {}});
    return static_cast<std::uint32_t>(assets.meshes.size() - 1);
  }

  void look(const glm::dvec3& from, const glm::dvec3& at, double fov_degrees = 60) {
    RenderCamera& camera = scene.camera;
    camera.position = from;
    camera.w = glm::normalize(from - at);
    const glm::dvec3 up = std::abs(camera.w.y) > 0.99 ? glm::dvec3(0, 0, -1) : glm::dvec3(0, 1, 0);
    camera.v = glm::normalize(up - glm::dot(up, camera.w) * camera.w);
    camera.u = glm::cross(camera.v, camera.w);
    camera.fov_y = glm::radians(fov_degrees);
  }

  /// The color of the picture's center, from a single ray.
  glm::dvec3 seen(Profile profile = Profile::course, Mode mode = Mode::ray) const {
    RenderOptions options = default_options(profile);
    options.mode = mode;
    return seen(options);
  }
  glm::dvec3 seen(RenderOptions options) const {
    options.width = options.height = 1;
    options.samples = 1;
    options.features.super_sample = false;
    options.threads = 1;
    const Image image = render(scene, assets, options).image;
    return {image.pixel(0, 0)[0], image.pixel(0, 0)[1], image.pixel(0, 0)[2]};
  }

  Image picture(int width, int height, RenderOptions options) const {
    options.width = width;
    options.height = height;
    return render(scene, assets, options).image;
  }

 private:
  std::uint32_t next_source_ = 0;
};

}  // namespace scenefile::trace_test
