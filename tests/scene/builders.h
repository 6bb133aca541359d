#pragma once
// Shorthand for building scenes in tests.

#include "scenefile/scene/scene.h"

#include <string>
#include <utility>
#include <vector>

namespace scenefile::test {

inline Transform translate(float x, float y, float z) {
  return {Translate{{x, y, z}}, {}};
}
inline Transform scale(float x, float y, float z) {
  return {Scale{{x, y, z}}, {}};
}
inline Transform rotate(glm::vec3 axis, float degrees) {
  return {Rotate{axis, degrees}, {}};
}
inline Transform matrix(const glm::mat4& m) {
  return {Matrix{m}, {}};
}

inline Primitive primitive(Shape shape = Shape::sphere) {
  Primitive p;
  p.shape = shape;
  return p;
}

inline Light point_light(glm::vec3 position = {3, 3, 3}) {
  Light light;
  light.position = position;
  return light;
}

inline NodeId add_group(Scene& scene, NodeId parent, std::vector<Transform> transforms = {}) {
  const NodeId node = add_child(scene, parent);
  scene.nodes[node].transforms = std::move(transforms);
  return node;
}

inline NodeId add_primitive(Scene& scene, NodeId parent, std::vector<Transform> transforms = {},
                            Shape shape = Shape::sphere) {
  const NodeId node = add_group(scene, parent, std::move(transforms));
  scene.nodes[node].primitives.push_back(primitive(shape));
  return node;
}

inline NodeId add_instance(Scene& scene, NodeId parent, std::string of,
                           std::vector<Transform> transforms = {}) {
  const NodeId node = add_group(scene, parent, std::move(transforms));
  scene.nodes[node].instance_of = std::move(of);
  return node;
}

/// A sphere and a light: a scene in which check() finds nothing.
inline Scene fine_scene() {
  Scene scene;
  scene.nodes[0].name = "root";
  scene.nodes[0].primitives.push_back(primitive());
  scene.nodes[0].lights.push_back(point_light());
  return scene;
}

inline std::string numbered(int number) {
  std::string name = "t";
  name += std::to_string(number);
  return name;
}

/// `levels` templates, each with `fan` instances of the previous one; the first contains `leaf`, if
/// set.
inline Scene bomb(int levels, int fan, bool leaf) {
  Scene scene = fine_scene();
  const NodeId first = add_template(scene, "t0");
  if (leaf) {
    add_primitive(scene, first);
  }
  for (int level = 1; level <= levels; ++level) {
    const NodeId holder = add_template(scene, numbered(level));
    for (int copy = 0; copy < fan; ++copy) {
      add_instance(scene, holder, numbered(level - 1), {translate(static_cast<float>(copy), 0, 0)});
    }
  }
  add_instance(scene, scene.root, numbered(levels));
  return scene;
}

}  // namespace scenefile::test
