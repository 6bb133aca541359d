#pragma once
// Statistics of a written scene.

#include "scenefile/base/shape_traits.h"
#include "scenefile/scene/scene.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace scenefile {

/// Counts of what a file contains. Each thing counts once, however often it is instantiated, except
/// for the members named "virtual". Unused templates count too.
struct SceneSummary {
  std::size_t nodes = 0;
  std::size_t depth = 0;  ///< maximum nesting of nodes, not through instances; the root alone is 1
  std::size_t transforms = 0;
  std::array<std::size_t, shape_count> primitives{};   ///< by Shape
  std::array<std::size_t, light_type_count> lights{};  ///< by LightType
  std::size_t templates = 0;
  std::size_t instances = 0;
  std::uint32_t instance_nesting = 0;  ///< maximum nesting of instances, from the root
  double virtual_primitives = 0;       ///< from the root, after instancing; may be infinite
  double virtual_lights = 0;
  std::size_t materials = 0;  ///< distinct
  std::size_t textures = 0;   ///< distinct files
  std::size_t meshes = 0;     ///< distinct files

  friend bool operator==(const SceneSummary&, const SceneSummary&) = default;
};

/// Takes time linear in the size of the scene.
SceneSummary summarize(const Scene& scene);

}  // namespace scenefile
