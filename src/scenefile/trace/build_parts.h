#pragma once

#include "scenefile/trace/accelerator.h"
#include "scenefile/trace/parts.h"
#include "scenefile/trace/ray_scenes.h"

namespace scenefile {

/// The parts of a scene, with their structures in `scenes`. The result is complete if scenes.good()
/// and the scene is not too deep.
AcceleratorStatus build_parts(const RenderScene& scene, const Assets& assets, Instances instances,
                              RayScenes& scenes, Parts& parts);

}  // namespace scenefile
