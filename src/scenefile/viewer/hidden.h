#pragma once
// A ready scene without what the user has switched off.

#include "scenefile/asset/load_assets.h"
#include "scenefile/scene/render_scene.h"
#include "scenefile/viewer/picker.h"

#include <cstdint>
#include <optional>

namespace scenefile::viewer {

/// Without the primitives, instances and lights whose source is hidden; indices of materials,
/// files and groups stay. `only_light`: all other lights go too; an index into scene.lights.
RenderScene without_hidden(const RenderScene& scene, const Hidden& hidden,
                           std::optional<std::uint32_t> only_light = {});

/// The box, in world space, around all copies of the primitives and instances of these sources;
/// conservative where copies are rotated. In time linear in the size of the scene.
Bounds bounds_of(const RenderScene& scene, const Assets& assets,
                 const std::set<std::uint32_t>& sources);

/// The same around one copy of a primitive: that in `instances`, sources from the outermost. Empty
/// where there is none.
Bounds bounds_of_copy(const RenderScene& scene, const Assets& assets, std::uint32_t source,
                      const std::vector<std::uint32_t>& instances);

}  // namespace scenefile::viewer
