#pragma once

#include "trace/build_scene.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <random>

namespace scenefile::trace_test {

/// Random scenes that use every feature, by seed.
class RandomScene {
 public:
  explicit RandomScene(std::uint32_t seed) : random_(seed) {
    scene().groups.clear();
    RenderScene& s = scene();
    s.global = {0.4f, 0.7f, 0.6f, 0.8f};
    texture_ = b.texture(4, 3, {0, 200, 90, 255, 30, 60, 250, 128, 9, 77, 140, 222});
    for (int i = 0; i < 8; ++i) {
      b.material(material());
    }
    mesh_ = b.mesh(tent());
    add_group(4, 0);
    add_group(2, 3);
    add_group(3, 4);
    for (int i = 0; i < 5; ++i) {
      s.lights.push_back(light(static_cast<LightType>(i % 4)));
    }
    b.look({real(-1, 1), real(0, 2), 6}, {0, 0, 0}, 45);
  }

  SceneBuilder b;
  RenderScene& scene() { return b.scene; }

 private:
  float real(double low, double high) {
    return static_cast<float>(std::uniform_real_distribution<double>(low, high)(random_));
  }
  std::uint32_t below(std::uint32_t end) {
    return std::uniform_int_distribution<std::uint32_t>(0, end - 1)(random_);
  }
  glm::vec3 color() { return {real(0, 1), real(0, 1), real(0, 1)}; }
  glm::vec3 point(double reach) {
    return {real(-reach, reach), real(-reach, reach), real(-reach, reach)};
  }

  RenderMaterial material() {
    RenderMaterial m;
    m.ambient = color();
    m.diffuse = color();
    m.specular = color();
    m.shininess = real(-5, 30);
    m.shininess = std::max(m.shininess, 0.0f);
    m.reflective = below(3) == 0 ? color() : glm::vec3(0);
    m.transparent = below(3) == 0 ? color() : glm::vec3(0);
    m.ior = real(0.7, 1.8);
    if (below(2) == 0) {
      m.texture = {texture_, 2, 1.5f};
      m.blend = real(0, 1);
    }
    if (below(4) == 0) {
      m.bump_map = {texture_, 1, 1};
    }
    return m;
  }

  static Mesh tent() {
    Mesh m;
    m.positions = {{-0.5f, 0, 0.5f}, {0.5f, 0, 0.5f}, {0, 0.5f, 0}, {0, 0, -0.5f}};
    m.triangles = {{0, 1, 2}, {1, 3, 2}, {3, 0, 2}};
    m.normals = {{-1, 1, 1}, {1, 1, 1}, {0, 1, 0}, {0, 1, -1}};
    m.triangle_normals = m.triangles;
    m.uvs = {{0, 0}, {1, 0}, {0.5f, 1}, {0.3f, 0.6f}};
    m.triangle_uvs = m.triangles;
    return m;
  }

  Affine place(double reach, double size) {
    return translate(point(reach)) * rotate(real(0, 360), {1, 2, real(-3, 3)}) *
           scale({real(0.2, size), real(0.2, size), real(-size, -0.2)});
  }

  RenderLight light(LightType type) {
    RenderLight l;
    l.type = type;
    l.color = 0.7f * color();
    l.position = point(5);
    l.direction = glm::normalize(-l.position + glm::vec3(0.01f, 0.02f, 0.03f));
    l.attenuation = {1, real(0, 0.1), real(0, 0.05)};
    l.inner_angle = 0.2f;
    l.outer_angle = 0.5f;
    l.half_u = glm::normalize(glm::cross(l.direction, glm::vec3(0.3f, 1, 0.2f)));
    l.half_v = glm::cross(l.direction, l.half_u);
    return l;
  }

  // Adds instances of earlier groups.
  void add_group(int primitives, int instances) {
    RenderGroup g;
    for (int i = 0; i < primitives; ++i) {
      const auto shape = static_cast<Shape>(below(5));
      g.primitives.push_back(b.primitive(shape, place(1.5, 1.6), below(8)));
      g.primitives.back().mesh = shape == Shape::mesh ? mesh_ : no_index;
    }
    for (int i = 0; i < instances; ++i) {
      const auto group = below(static_cast<std::uint32_t>(scene().groups.size()));
      g.instances.push_back(b.instance(group, place(1, 1)));
    }
    scene().groups.push_back(g);
    scene().root = static_cast<std::uint32_t>(scene().groups.size() - 1);
  }

  std::mt19937 random_;
  std::uint32_t texture_ = 0;
  std::uint32_t mesh_ = 0;
};

}  // namespace scenefile::trace_test
