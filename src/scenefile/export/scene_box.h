#pragma once
// Private to the room.

#include "scenefile/geometry/mesh.h"
#include "scenefile/scene/render_scene.h"

#include <span>

namespace scenefile {

/// The box around all that is drawn, in world space; of a box in a box where templates are used.
Bounds scene_box(const RenderScene& scene, std::span<const Mesh> meshes);

}  // namespace scenefile
