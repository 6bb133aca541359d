#pragma once
// The scalar tracer: recursive ray tracing, one ray after the other. The reference for wavefronts,
// which must agree with it to the last bit.

#include "scenefile/trace/adaptive_sampler.h"
#include "scenefile/trace/camera_rays.h"
#include "scenefile/trace/path.h"
#include "trace/recorder.h"

namespace scenefile {

/// The color of a camera sample.
Color trace_sample(const Tracer& tracer, const CameraRays& camera, const CameraSample& sample,
                   ScalarCounts& counts);

/// A pixel of the course profile: a sample at its center, the adaptive cell, or the lens samples.
Color course_pixel(const Tracer& tracer, const CameraRays& camera, int x, int y,
                   ScalarCounts& counts);

/// Takes pattern samples of a pixel of the fine profile, round by round, until it has enough.
void take_samples(const Tracer& tracer, const CameraRays& camera, const AdaptiveSampler& sampler,
                  int x, int y, std::uint16_t refinement, PixelSamples& samples,
                  ScalarCounts& counts);

}  // namespace scenefile
