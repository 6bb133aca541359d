#pragma once
// What all paths of a picture share, and the points of surfaces that they reach.

#include "scenefile/path/lamps.h"
#include "scenefile/path/path_record.h"
#include "scenefile/trace/tracer.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <map>
#include <utility>

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
  /// By mesh and triangle: the triangle at the same place that faces the other way and emits light.
  /// Rays hit only the last of such faces, but a lamp may be made of two.
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> other_faces;
};

/// `ray`: of unit length.
PathPoint path_point(const PathScene& scene, const Ray& ray, const Hit& hit);

}  // namespace scenefile
