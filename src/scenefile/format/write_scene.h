#pragma once
// Writes a Scene as a scene file in canonical form: equal scenes give equal texts.

#include "scenefile/base/diagnostics.h"
#include "scenefile/base/limits.h"
#include "scenefile/scene/scene.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace scenefile {

enum class SceneFormat : std::uint8_t { xml, json };

/// Writes the scene so that read_scene() reads it without warnings as a scene with the same
/// meaning. Requires a scene in which check() found no error; for any other scene the text is
/// unspecified.
///
/// What a format cannot represent directly is written another way, each with a note.
///
/// XML: lights are at the top level in world space, once for each instance of their template; each
/// object has a transblock; empty groups are dropped; names of trees are unique; the names of the
/// scene and of lights are dropped.
///
/// JSON: transforms are applied in the order translate, rotate, scale, matrix, so other orders
/// become nested groups; a light is at the origin of its group; an instance has no transforms; a
/// camera is required; ids of lights are dropped.
///
/// A warning means that a part of the meaning is lost; an error means that the text cannot be used.
/// Codes: format/codes.h.
std::string write_scene(const Scene& scene, SceneFormat format, const Limits& limits,
                        Diagnostics& diagnostics);

/// Where a line of a listing comes from.
struct ListedLine {
  std::size_t begin = 0;    ///< in the text
  std::string_view what;    ///< such as "camera", "sphere"; empty for groups
  Location place;           ///< of the object or light in the file
  NodeId node = no_group;   ///< the group, in the form
  std::uint32_t depth = 0;  ///< of nesting

  static constexpr NodeId no_group = 0xffffffffu;
};

/// The text of write_scene() for comparing scenes: without indentation, and without values that
/// have no effect.
struct SceneListing {
  Scene form;  ///< the scene as it is written
  std::string text;
  std::vector<ListedLine> lines;
  bool exact = true;  ///< false: the format cannot express a part of the meaning

  /// Without the comma at the end.
  std::string_view line(std::size_t index) const;
};

/// Empty if the scene cannot be written.
SceneListing list_scene(const Scene& scene, SceneFormat format);

}  // namespace scenefile
