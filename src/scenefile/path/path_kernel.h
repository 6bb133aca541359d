#pragma once
// Follows one path from the camera.

#include "scenefile/path/path_scene.h"

#include <cstdint>

namespace scenefile {

/// An estimate of the light that arrives at a pixel; its mean over all samples is the picture.
/// Adds the rays to `counts`. `record`: if not null, set to all that was computed.
Color path_light(const PathScene& scene, int x, int y, std::uint32_t sample, RayCounts& counts,
                 PathRecord* record = nullptr);

}  // namespace scenefile
