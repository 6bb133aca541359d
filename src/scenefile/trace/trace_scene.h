#pragma once
// What all pictures of one scene share: built once, kept as long as pictures of it are wanted.

#include "scenefile/asset/load_assets.h"
#include "scenefile/scene/render_scene.h"
#include "scenefile/trace/render.h"

#include <memory>
#include <vector>

namespace scenefile {

class Accelerator;
class Pyramid;

struct TraceSceneOptions {
  int threads = 0;              ///< to build with; 0: one a processor
  bool instance_names = false;  ///< remember which instances a part comes from (explain.h)
};

/// The structure in which rays find what they hit, and the filtered textures. Copies share them.
///
/// It depends on the groups of the scene and on the meshes and textures alone: camera, lights,
/// materials, coefficients and all options may change from picture to picture. It does not refer to
/// the scene, whose groups may be given back once it is built (64 bytes a primitive and more); the
/// assets must outlive it. Safe to use from several threads.
class TraceScene {
 public:
  TraceScene(const RenderScene& scene, const Assets& assets, const TraceSceneOptions& options = {});

  /// `complete`, or why no picture can be made: limit_reached or failed.
  RenderStatus status() const;
  /// Wall time that building took.
  double build_seconds() const;

  const Assets& assets() const;
  const Accelerator& accelerator() const;
  /// By texture. Made when they are asked for first.
  const std::vector<Pyramid>& pyramids() const;

 private:
  struct Shared;
  std::shared_ptr<const Shared> shared_;
};

}  // namespace scenefile
