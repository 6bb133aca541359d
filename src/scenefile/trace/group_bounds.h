#pragma once
// Bounding boxes of meshes and groups, for bounds.h and the accelerator.

#include "scenefile/trace/bounds.h"

#include <vector>

namespace scenefile {

/// By mesh file; empty if there are no triangles.
std::vector<Bounds> mesh_bounds(const RenderScene& scene, const Assets& assets);

/// By group, in its space, including its instances; `meshes` from mesh_bounds().
std::vector<Bounds> group_bounds(const RenderScene& scene, const std::vector<Bounds>& meshes);

/// The bounding box of a transformed box; an empty one stays empty.
Bounds placed_bounds(const Bounds& box, const DAffine& to_from);

}  // namespace scenefile
