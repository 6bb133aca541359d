#pragma once
// Materials in POV-Ray's language. Private to the room.

#include "scenefile/base/diagnostics.h"
#include "scenefile/export/write_pov.h"
#include "scenefile/scene/render_scene.h"

#include <span>
#include <string>
#include <string_view>

namespace scenefile {

/// A material, and what of the scene and the wishes it depends on.
struct PovMaterial {
  const RenderMaterial* material = nullptr;
  RenderGlobal global;
  PovOptions options;
  std::string texture_path;  ///< empty: no texture shows

  bool textured() const { return !texture_path.empty(); }
  bool transparent() const;
};

PovMaterial pov_material(const RenderScene& scene, std::uint32_t index,
                         std::span<const std::string> texture_paths, const PovOptions& options);

/// Reports what of the material POV-Ray says otherwise, each thing once for a scene.
void report_differences(const PovMaterial& m, Diagnostics& diagnostics);

/// `texture { ... }`. `mapping` takes the unit square of the image, u along x and v along y, to the
/// surface of the object: modifiers of a pigment.
std::string pov_texture(const PovMaterial& m, std::string_view mapping);

/// `interior { ... }` where the material is transparent.
std::string pov_interior(const PovMaterial& m);

}  // namespace scenefile
