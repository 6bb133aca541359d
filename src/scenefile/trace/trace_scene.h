#pragma once
// Data shared by all pictures of a scene, built once.

#include "scenefile/asset/load_assets.h"
#include "scenefile/scene/render_scene.h"
#include "scenefile/trace/render.h"

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace scenefile {

class Accelerator;
class MipMap;

struct TraceSceneOptions {
  int threads = 0;              ///< for building; 0: one per processor
  bool instance_names = false;  ///< store the instances around each object (explain.h)
};

/// The acceleration structure and the filtered textures. Copies share them.
///
/// Depends only on the scene's groups, meshes and textures: camera, lights, materials, coefficients
/// and all options may change from picture to picture. It does not refer to the scene, whose groups
/// may be freed after it is built (64 bytes per primitive and more). The assets must outlive it.
/// Thread-safe.
class TraceScene {
 public:
  TraceScene(const RenderScene& scene, const Assets& assets, const TraceSceneOptions& options = {});

  /// `complete`, or the reason for failure: limit_reached or failed.
  RenderStatus status() const;
  /// Wall time of building.
  double build_seconds() const;

  const Assets& assets() const;
  const Accelerator& accelerator() const;
  /// By texture. Computed at the first call.
  const std::vector<MipMap>& mip_maps() const;

 private:
  struct Shared;
  std::shared_ptr<const Shared> shared_;
};

/// The libraries and instruction set used for tracing, for bug reports and benchmarks.
struct TraceBackend {
  std::string embree;      ///< version such as "4.3.3"; empty: unknown; "none": built without
  std::string_view lanes;  ///< instruction set in use, such as "AVX2"
};

TraceBackend trace_backend();

}  // namespace scenefile
