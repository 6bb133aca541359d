#pragma once
// What all paths of a picture share, and the points of surfaces that they reach.

#include "scenefile/path/lamps.h"
#include "scenefile/path/path_record.h"
#include "scenefile/trace/tracer.h"

#include <glm/glm.hpp>

namespace scenefile {

struct PathScene {
  PathScene(const TraceScene& traced, const RenderScene& scene, const RenderOptions& options);

  Tracer tracer;  ///< of mode ray, with all features
  RenderOptions options;
  CameraRays camera;
  Transmission transmission;  ///< for shadow rays to the scene's lights
  Lamps lamps;
  // As in programs with a mistake; see noise/path_truth.h.
  bool uniform_directions = false;  ///< not by the BSDF
  bool always_enters = false;       ///< glass refracts each ray as if it came from outside
  /// Mirrors, or glass, of `.mtl` files are also lit by light samples, with Kd and Ks.
  bool shaded_mirrors = false;
  bool shaded_glass = false;
};

/// `ray`: of unit length. If a lamp shines there, but something else at this place was hit, `hit`
/// becomes one on the lamp.
PathPoint path_point(const PathScene& scene, const Ray& ray, Hit& hit);

}  // namespace scenefile
