#pragma once
// Bounding boxes of what a scene draws.

#include "scenefile/asset/load_assets.h"
#include "scenefile/geometry/shapes.h"
#include "scenefile/scene/render_scene.h"

#include <vector>

namespace scenefile {

/// The bounding box of everything that the scene draws, in world space: tight for primitives
/// outside of templates, conservative inside them. Empty for a scene that draws nothing.
Bounds scene_bounds(const RenderScene& scene, const Assets& assets);

/// By mesh file; empty if there are no triangles.
std::vector<Bounds> mesh_bounds(const RenderScene& scene, const Assets& assets);

/// By group, in its space, including its instances; `meshes` from mesh_bounds().
std::vector<Bounds> group_bounds(const RenderScene& scene, const std::vector<Bounds>& meshes);

/// The bounding box of a transformed box; an empty one stays empty.
Bounds placed_bounds(const Bounds& box, const DAffine& to_from);

}  // namespace scenefile
