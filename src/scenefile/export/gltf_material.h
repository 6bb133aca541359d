#pragma once
// The materials of a glTF file. Private to the room.

#include "scenefile/base/diagnostics.h"
#include "scenefile/export/baked_textures.h"
#include "scenefile/scene/render_scene.h"

#include <set>
#include <string>
#include <string_view>

namespace scenefile {

/// Writes one material as JSON. `extensions` gets the names of those that it uses.
std::string gltf_material(const RenderMaterial& material, const RenderGlobal& global,
                          float transparent, BakedTextures& textures,
                          std::set<std::string_view>& extensions, Diagnostics& diagnostics);

}  // namespace scenefile
