#pragma once
// Boxes of meshes and groups, for bounds.h and the accelerator.

#include "scenefile/trace/bounds.h"

#include <vector>

namespace scenefile {

/// By mesh file; empty where there are no triangles.
std::vector<Bounds> mesh_bounds(const RenderScene& scene, const Assets& assets);

/// The box around a transformed box; an empty one stays empty.
Bounds placed_bounds(const Bounds& box, const DAffine& to_from);

}  // namespace scenefile
