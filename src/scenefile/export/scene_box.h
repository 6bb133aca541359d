#pragma once
// Internal to export.

#include "scenefile/geometry/mesh.h"
#include "scenefile/scene/render_scene.h"

#include <span>

namespace scenefile {

/// A bounding box of everything drawn, in world space; not tight where templates are used.
Bounds scene_box(const RenderScene& scene, std::span<const Mesh> meshes);

}  // namespace scenefile
