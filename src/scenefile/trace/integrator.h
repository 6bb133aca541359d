#pragma once
// Rays followed through mirrors and glass: the color that one camera ray sees.

#include "scenefile/trace/shade.h"

namespace scenefile {

/// What a camera ray sees, in the mode and profile of the tracer. `direction` of unit length.
Color trace_camera_ray(const Tracer& tracer, const Ray& ray, const RayCone& cone,
                       const SampleKey& key, RayCounts& counts);

}  // namespace scenefile
