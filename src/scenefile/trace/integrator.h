#pragma once
// Recursive ray tracing: the color seen by a camera ray.

#include "scenefile/trace/camera_rays.h"
#include "scenefile/trace/path.h"

namespace scenefile {

/// The color of a camera sample; used for every sample of every picture.
Color trace_sample(const Tracer& tracer, const CameraRays& camera, const CameraSample& sample,
                   RayCounts& counts);

/// The color of a ray, including reflections and refractions, in the ray tracing modes.
Color trace_path(const Tracer& tracer, const Path& path, RayCounts& counts);

}  // namespace scenefile
