#pragma once
// Materials in POV-Ray's language. Internal to export.

#include "scenefile/asset/image.h"
#include "scenefile/base/diagnostics.h"
#include "scenefile/export/write_pov.h"
#include "scenefile/scene/render_scene.h"

#include <span>
#include <string>
#include <string_view>

namespace scenefile {

/// A material, with the settings of the scene and the options that it depends on.
struct PovMaterial {
  const RenderMaterial* material = nullptr;
  RenderGlobal global;
  PovOptions options;
  std::string texture_path;   ///< empty: no visible texture
  std::string texture_kind;   ///< "jpeg"
  bool lost_texture = false;  ///< there would be one, but POV-Ray cannot open it

  bool textured() const { return !texture_path.empty(); }
  bool transparent() const;
};

PovMaterial pov_material(const RenderScene& scene, std::uint32_t index,
                         std::span<const Texture> textures,
                         std::span<const std::string> texture_paths, const PovOptions& options);

/// Reports how POV-Ray renders the material differently, each difference once per scene.
void report_differences(const PovMaterial& m, Diagnostics& diagnostics);

/// `texture { ... }`. `mapping` maps the unit square of the image (u along x, v along y) to the
/// surface of the object; it is a list of pigment modifiers.
std::string pov_texture(const PovMaterial& m, std::string_view mapping);

/// `interior { ... }` if the material is transparent; otherwise empty.
std::string pov_interior(const PovMaterial& m);

}  // namespace scenefile
