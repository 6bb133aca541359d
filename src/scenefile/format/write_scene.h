#pragma once
// From a Scene to the text of a scene file: clean, canonical, the same for the same scene.

#include "scenefile/base/diagnostics.h"
#include "scenefile/base/limits.h"
#include "scenefile/scene/scene.h"

#include <cstdint>
#include <string>

namespace scenefile {

enum class SceneFormat : std::uint8_t { xml, json };

/// Writes the scene so that read_scene() reads it back, without a warning, as a scene of the same
/// meaning. Expects a scene in which check() found no error; for any other the text is unspecified,
/// but made all the same.
///
/// What a format cannot say as it stands is said another way, each with a note:
/// XML: lights stand at the top, in world space, once for each copy of their template; an object
/// fills a transblock alone; empty groups are left out; names of trees are unique; the name of the
/// scene and those of lights are left out.
/// JSON: transforms come in the order translate, rotate, scale, matrix, so others become groups in
/// groups; a light stands at the origin of its group; an instance has no transforms of its own; a
/// camera is required; ids of lights are left out.
/// A warning says that a part of the meaning is lost; an error, that the text is not usable. Codes:
/// format/write_codes.h.
std::string write_scene(const Scene& scene, SceneFormat format, const Limits& limits,
                        Diagnostics& diagnostics);

}  // namespace scenefile
