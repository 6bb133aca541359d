#pragma once

#include "scenefile/trace/accelerator.h"
#include "scenefile/trace/ray_scenes.h"
#include "scenefile/trace/scene_geometry.h"

namespace scenefile {

/// The geometry of a scene, with its structures in `scenes`. The result is complete if
/// scenes.good() and the scene is not too deep.
AcceleratorStatus build_geometry(const RenderScene& scene, const Assets& assets,
                                 Instances instances, RayScenes& scenes, SceneGeometry& geometry);

}  // namespace scenefile
