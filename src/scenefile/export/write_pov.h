#pragma once
// From a ready scene to the scene description language of POV-Ray 3.7, for other pictures of the
// same scene and to compare ray tracers.

#include "scenefile/base/diagnostics.h"
#include "scenefile/geometry/mesh.h"
#include "scenefile/scene/render_scene.h"

#include <span>
#include <string>

namespace scenefile {

/// What of the lighting equation is wanted. The same words as for the ray tracer.
struct PovOptions {
  int bounces = 4;        ///< after the camera ray
  float transparent = 0;  ///< kt where the scene gives none
  bool shadows = true;
  bool reflect = true;
  bool refract = true;
  bool texture = true;
  bool texture_filter = false;
  bool lens = false;
};

/// Writes the scene in POV-Ray's language. `meshes` are those of RenderScene::mesh_files (smooth
/// where they have normals), `texture_paths` say where POV-Ray finds those of texture_files; an
/// empty one shades with the diffuse color.
///
/// Groups become `#declare`d unions, instances refer to them, so the text follows the scene's size.
/// Geometry, camera, texture coordinates, blend, mirrors, shadows, point and directional lights
/// have an exact counterpart; each other thing is reported. Values are linear: render with
/// `File_Gamma=1.0` to get the pixels of this project's pictures. Codes: export/codes.h.
std::string write_pov(const RenderScene& scene, std::span<const Mesh> meshes,
                      std::span<const std::string> texture_paths, const PovOptions& options,
                      Diagnostics& diagnostics);

}  // namespace scenefile
