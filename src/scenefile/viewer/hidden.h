#pragma once
// A render scene without hidden objects.

#include "scenefile/asset/load_assets.h"
#include "scenefile/scene/render_scene.h"
#include "scenefile/viewer/picker.h"

#include <cstdint>
#include <optional>

namespace scenefile::viewer {

/// The scene without primitives, instances and lights whose source is hidden; indices of materials,
/// files and groups do not change. `only_light`, an index into scene.lights, hides all other
/// lights.
RenderScene without_hidden(const RenderScene& scene, const Hidden& hidden,
                           std::optional<std::uint32_t> only_light = {});

/// The bounding box, in world space, of all instances of the primitives and instances with these
/// sources; conservative if instances are rotated. Takes time linear in the size of the scene.
Bounds bounds_of(const RenderScene& scene, const Assets& assets,
                 const std::set<std::uint32_t>& sources);

/// Same for a single instance of a primitive, given by the sources in `instances`, outermost first.
/// Empty if it does not exist.
Bounds bounds_of_copy(const RenderScene& scene, const Assets& assets, std::uint32_t source,
                      const std::vector<std::uint32_t>& instances);

}  // namespace scenefile::viewer
