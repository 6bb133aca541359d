#pragma once
// The values of a scene file, as numbers that can be varied. Internal to grade.

#include "scenefile/scene/prepare.h"
#include "scenefile/scene/scene.h"
#include "scenefile/scene/value_kind.h"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace scenefile {

/// What a value changes, which decides how it is estimated.
enum class ValueEffect : std::uint8_t {
  colors,   ///< of lights and of the whole scene
  light,    ///< where light falls
  surface,  ///< colors of objects
  camera,
  shapes,  ///< where objects are
};

/// One value of a scene file, or two that are edited together.
struct SceneValue {
  ValueEffect effect = ValueEffect::colors;
  std::string name;             ///< "the position of light 2 (point)"
  Location location;            ///< in the file
  std::vector<double> numbers;  ///< as written
  /// Changes its numbers in a copy of the scene.
  std::function<void(Scene&, const std::vector<double>&)> set;
  NumberRange range = {};  ///< of each number
  bool direction = false;  ///< the length of the three numbers has no effect
};

/// The values of the globals, the camera and the first lights.
std::vector<SceneValue> values_of_view(const Scene& scene, const Prepared& prepared);
/// The values of a primitive's material.
std::vector<SceneValue> values_of_material(const Scene& scene, const Source& primitive);
/// The transforms of a node.
std::vector<SceneValue> values_of_transforms(const Scene& scene, NodeId node);

}  // namespace scenefile
