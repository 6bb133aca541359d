#pragma once
// The materials of a glTF file. Internal to export.

#include "scenefile/base/diagnostics.h"
#include "scenefile/export/baked_textures.h"
#include "scenefile/scene/render_scene.h"

#include <set>
#include <string>
#include <string_view>

namespace scenefile {

/// Writes a material as JSON. Adds the names of the extensions it uses to `extensions`. `path`: see
/// GltfOptions.
std::string gltf_material(const RenderMaterial& material, const RenderGlobal& global,
                          float transparent, bool path, BakedTextures& textures,
                          std::set<std::string_view>& extensions, Diagnostics& diagnostics);

}  // namespace scenefile
