#pragma once
// Export to Wavefront OBJ with materials (Wavefront, "Object Files (.obj)" and "Material Library
// (.mtl)").

#include "scenefile/asset/load_assets.h"
#include "scenefile/base/diagnostics.h"
#include "scenefile/scene/render_scene.h"

#include <cstdint>
#include <string>
#include <vector>

namespace scenefile {

struct ObjOptions {
  std::string stem = "scene";  ///< prefix of the names of the other files; no blanks
  int segments = 64;           ///< per full turn on round sides; see geometry/tessellate.h
  float transparent = 0.5f;    ///< transparentcoeff if the scene gives none
  bool path = false;  ///< the scene is as use_face_materials() left it (export/face_materials.h)
  std::uint64_t max_triangles = 20'000'000;  ///< including all instances of templates
};

/// The files: the scene itself, then STEM.mtl, then pictures STEM-1.png and so on.
struct ObjScene {
  std::string obj;
  std::string mtl;
  std::vector<std::string> pictures;
};

/// Writes all objects in world space, each as a separate group. Materials keep ambient, diffuse,
/// specular and shininess, multiplied by the scene's coefficients. Pictures hold linear values with
/// blend baked in, because MTL does not mention sRGB. Lights and camera are lost; everything that
/// is changed or lost is reported once. Returns empty texts and reports an error if there are too
/// many triangles. Codes: export/codes.h.
ObjScene write_obj(const RenderScene& scene, const Assets& assets, const ObjOptions& options,
                   Diagnostics& diagnostics);

}  // namespace scenefile
