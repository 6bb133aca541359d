#pragma once
// A written scene in figures.

#include "scenefile/scene/scene.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace scenefile {

/// What a file holds, each thing counted once however often it is instantiated, except where it
/// says "virtual". Whether the scene uses a template does not matter to the counts.
struct SceneSummary {
  std::size_t nodes = 0;
  std::size_t depth = 0;  ///< nodes inside each other at most, not through instances; root alone: 1
  std::size_t transforms = 0;
  std::array<std::size_t, 5> primitives{};  ///< by Shape
  std::array<std::size_t, 4> lights{};      ///< by LightType
  std::size_t templates = 0;
  std::size_t instances = 0;
  std::uint32_t instance_nesting = 0;  ///< instances inside each other at most, from the root
  double virtual_primitives = 0;       ///< from the root, instances replaced; may be infinite
  double virtual_lights = 0;
  std::size_t materials = 0;  ///< different ones
  std::size_t textures = 0;   ///< different files
  std::size_t meshes = 0;     ///< different files

  friend bool operator==(const SceneSummary&, const SceneSummary&) = default;
};

/// In time linear in the size of the scene.
SceneSummary summarize(const Scene& scene);

}  // namespace scenefile
