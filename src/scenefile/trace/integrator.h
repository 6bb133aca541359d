#pragma once
// Rays followed through mirrors and glass: the color that one camera ray sees.

#include "scenefile/trace/camera_rays.h"
#include "scenefile/trace/path.h"

namespace scenefile {

/// What the camera sees. Of every sample of every picture.
Color trace_sample(const Tracer& tracer, const CameraRays& camera, const CameraSample& sample,
                   RayCounts& counts);

/// What a ray sees, with all that comes of it, in the ray tracing modes.
Color trace_path(const Tracer& tracer, const Path& path, RayCounts& counts);

}  // namespace scenefile
