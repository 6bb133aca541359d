#pragma once
// Boxes of meshes and groups, for bounds.h and the accelerator.

#include "scenefile/trace/bounds.h"

#include <vector>

namespace scenefile {

/// By mesh file; empty where there are no triangles.
std::vector<Bounds> mesh_bounds(const RenderScene& scene, const Assets& assets);

/// By group, in its own space, with all that stands in it; `meshes` as of mesh_bounds().
std::vector<Bounds> group_bounds(const RenderScene& scene, const std::vector<Bounds>& meshes);

/// The box around a transformed box; an empty one stays empty.
Bounds placed_bounds(const Bounds& box, const DAffine& to_from);

}  // namespace scenefile
