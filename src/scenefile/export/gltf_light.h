#pragma once
// The lights of a glTF file. Private to the room.

#include "scenefile/base/diagnostics.h"
#include "scenefile/geometry/shapes.h"
#include "scenefile/scene/render_scene.h"

#include <string>

namespace scenefile {

/// A light of KHR_lights_punctual as JSON. Where a light that fades, or does not, has to have a
/// strength of its own, it is right in the middle of `box`, what the scene draws.
std::string gltf_light(const RenderLight& light, const Bounds& box, Diagnostics& diagnostics);

}  // namespace scenefile
