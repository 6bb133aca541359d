#pragma once
// Random scenes in which check() finds no error, using every feature of Scene.

#include "scenefile/scene/scene.h"

#include <fmt/format.h>

#include <random>
#include <string>
#include <vector>

namespace scenefile::testing {

class RandomScene {
 public:
  /// `size` limits templates, nodes, lights and so on. `moved_area_lights`: allows transforms of
  /// area lights that XML cannot represent.
  RandomScene(unsigned seed, int size, bool moved_area_lights)
      : random_(seed), size_(size), moved_area_lights_(moved_area_lights) {}

  Scene make() {
    scene_.name = one_in(2) ? "" : name();
    scene_.global = {number(), number(), number(), {}, {}};
    if (one_in(2)) {
      scene_.global.transparent = number();
    }
    if (!one_in(3)) {
      make_camera();
    }
    const int templates = below(size_ + 1);
    for (int t = 0; t < templates; ++t) {
      const bool root = t == 0 && one_in(4);
      const NodeId head = add_template(scene_, root ? "root" : fmt::format("{}{}", word(), t));
      templates_ = t;
      fill_tree(head);
    }
    templates_ = templates;
    fill_tree(scene_.root);
    return std::move(scene_);
  }

 private:
  int below(int n) { return static_cast<int>(random_() % static_cast<unsigned>(n)); }
  bool one_in(int n) { return below(n) == 0; }

  float number() {
    switch (below(6)) {
      case 0:
        return static_cast<float>(below(7) - 3);
      case 1:
        return static_cast<float>(below(2001) - 1000) / 10;
      case 2:
        return std::uniform_real_distribution<float>(-1e-3f, 1e-3f)(random_);
      default:
        return std::uniform_real_distribution<float>(-10, 10)(random_);
    }
  }
  float positive() { return std::abs(number()) + 0.25f; }
  // On both sides of 1, so that deeply nested scales neither underflow nor overflow.
  float factor() { return std::uniform_real_distribution<float>(0.3f, 2.0f)(random_); }
  glm::vec3 vector() { return {number(), number(), number()}; }
  glm::vec3 direction() {
    const glm::vec3 v = vector();
    return v == glm::vec3(0) ? glm::vec3(0, 1, 0) : v;
  }

  std::string word() {
    static const char* words[] = {"leg",
                                  "arm",
                                  "a<b>&\"c\"",
                                  "two words",
                                  " blank ",
                                  "\xc3\xa4\xe2\x82\xac",
                                  "line\nbreak\ttab\r",
                                  "back\\slash",
                                  "'",
                                  "\xf0\x9f\x98\x80",
                                  "-"};
    return words[below(std::size(words))];
  }
  std::string name() { return one_in(4) ? "root" : one_in(3) ? word() + "0" : word(); }

  void make_camera() {
    Camera& camera = scene_.camera.emplace();
    camera.position = vector();
    camera.look = direction();
    camera.up =
        camera.look == glm::vec3(0, camera.look.y, 0) ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0);
    camera.height_angle_deg = 1 + static_cast<float>(below(170));
    camera.aperture = one_in(2) ? 0 : positive();
    camera.focal_length = one_in(2) ? 0 : positive();
  }

  void fill_tree(NodeId head) {
    std::vector<NodeId> open = {head};
    std::vector<NodeId> all = {head};
    for (int i = below(2 * size_ + 2); i > 0; --i) {
      const NodeId node =
          add_child(scene_, open[static_cast<std::size_t>(below(int(open.size())))]);
      all.push_back(node);
      if (templates_ > 0 && one_in(3)) {
        const auto target = static_cast<std::size_t>(below(templates_));
        scene_.nodes[node].instance_of = scene_.nodes[scene_.templates[target]].name;
      } else {
        open.push_back(node);
      }
    }
    for (const NodeId node : open) {
      fill_contents(node);
    }
    for (const NodeId node : all) {
      fill_place(node, node == head);
    }
  }

  void fill_contents(NodeId node) {
    const auto several = [&] { return one_in(2) ? 0 : below(3); };
    for (int i = several(); i > 0; --i) {
      scene_.nodes[node].primitives.push_back(primitive());
    }
    for (int i = one_in(2) ? several() : 0; i > 0; --i) {
      scene_.nodes[node].lights.push_back(light());
    }
  }

  void fill_place(NodeId node, bool head) {
    if (!head && one_in(2)) {
      scene_.nodes[node].name = name();
    }
    for (int i = one_in(2) ? below(2) : below(7); i > 0; --i) {
      scene_.nodes[node].transforms.push_back(transform());
    }
  }

  Transform transform() {
    switch (below(4)) {
      case 0:
        return {Translate{vector()}, {}};
      case 1:
        return {
            Rotate{direction(), one_in(2) ? 90.0f * static_cast<float>(below(9) - 4) : number()},
            {}};
      case 2:
        return {Scale{{factor(), -factor(), factor()}}, {}};
      default: {
        glm::mat4 m(1);
        for (int i = 0; i < 4; ++i) {
          m[i] += glm::vec4(number(), number(), number(), 0) / 200.0f;
        }
        m[3] = glm::vec4(vector(), 1);
        if (one_in(4)) {
          m[below(4)][3] = number();
        }
        return {Matrix{m}, {}};
      }
    }
  }

  Light light() {
    Light light;
    light.type = static_cast<LightType>(below(moved_area_lights_ ? 4 : 3));
    light.color = vector();
    light.position = one_in(2) ? glm::vec3(0) : vector();
    light.direction = direction();
    light.attenuation = {positive(), one_in(2) ? 0 : positive(), 0};
    if (light.type == LightType::spot) {
      light.angle_deg = one_in(3) ? std::nullopt : std::optional(positive());
      light.penumbra_deg = positive();
    }
    if (light.type == LightType::area) {
      light.width = positive();
      light.height = positive();
    }
    if (one_in(2)) {
      light.id = below(12) - 2;
    }
    light.name = one_in(3) ? name() : "";
    return light;
  }

  Primitive primitive() {
    Primitive p;
    p.shape = static_cast<Shape>(below(5));
    if (p.shape == Shape::mesh) {
      p.mesh_file = word() + ".obj";
    }
    Material& m = p.material;
    for (glm::vec3* color : {&m.ambient, &m.diffuse, &m.specular, &m.reflective, &m.transparent}) {
      if (one_in(2)) {
        *color = vector();
      }
    }
    for (float* value : {&m.shininess, &m.ior, &m.blend}) {
      if (one_in(2)) {
        *value = number();
      }
    }
    if (one_in(3)) {
      m.texture = TextureUse{word() + ".png", number(), number(), {}};
    }
    if (one_in(4)) {
      m.bump_map = TextureUse{word() + ".png", number(), number(), {}};
    }
    return p;
  }

  std::mt19937 random_;
  int size_;
  bool moved_area_lights_;
  int templates_ = 0;  // templates that can be used so far
  Scene scene_;
};

}  // namespace scenefile::testing
