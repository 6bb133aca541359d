#pragma once
// Export to the scene description language of POV-Ray 3.7, for other renderings of the same scene
// and to compare ray tracers.

#include "scenefile/asset/load_assets.h"
#include "scenefile/base/diagnostics.h"
#include "scenefile/scene/render_scene.h"

#include <span>
#include <string>
#include <string_view>

namespace scenefile {

/// Which terms of the lighting equation to use; named like the ray tracer's options.
struct PovOptions {
  int bounces = 4;        ///< after the camera ray
  float transparent = 0;  ///< transparentcoeff if the scene gives none
  bool shadows = true;
  bool reflect = true;
  bool refract = true;
  bool texture = true;
  bool texture_filter = false;
  bool lens = false;
  bool path = false;  ///< the scene is as use_face_materials() left it (export/face_materials.h)
};

/// Whether POV-Ray can open the path: its file names are ASCII.
bool pov_opens(std::string_view path);

/// Writes the scene in POV-Ray's language. Meshes are smooth if they have normals. `texture_paths`
/// are the paths of texture_files for POV-Ray; instead of a texture that could not be used, or
/// whose path POV-Ray cannot open, the diffuse color is.
///
/// Groups become `#declare`d unions that instances refer to, so the size of the text is linear in
/// the size of the scene. Geometry, camera, texture coordinates, blend, mirrors, shadows, point and
/// directional lights are exact; anything else is reported. Values are linear: render with
/// `File_Gamma=1.0` to get the same pixels as this project. Codes: export/codes.h.
std::string write_pov(const RenderScene& scene, const Assets& assets,
                      std::span<const std::string> texture_paths, const PovOptions& options,
                      Diagnostics& diagnostics);

}  // namespace scenefile
