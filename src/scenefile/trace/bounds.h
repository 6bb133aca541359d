#pragma once

#include "scenefile/asset/load_assets.h"
#include "scenefile/geometry/shapes.h"
#include "scenefile/scene/render_scene.h"

namespace scenefile {

/// The bounding box of everything that the scene draws, in world space: tight for primitives
/// outside of templates, conservative inside them. Empty for a scene that draws nothing.
Bounds scene_bounds(const RenderScene& scene, const Assets& assets);

}  // namespace scenefile
