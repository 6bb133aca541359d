#pragma once
// The lights of a glTF file. Internal to export.

#include "scenefile/base/diagnostics.h"
#include "scenefile/geometry/shapes.h"
#include "scenefile/scene/render_scene.h"

#include <string>

namespace scenefile {

/// A light of KHR_lights_punctual as JSON. If its attenuation differs from glTF's, the intensity is
/// chosen to match at the center of `box`, the bounding box of the scene.
std::string gltf_light(const RenderLight& light, const Bounds& box, Diagnostics& diagnostics);

}  // namespace scenefile
