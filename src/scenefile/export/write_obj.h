#pragma once
// From a ready scene to Wavefront OBJ with its materials (Wavefront, "Object Files (.obj)" and
// "Material Library (.mtl)").

#include "scenefile/asset/load_assets.h"
#include "scenefile/base/diagnostics.h"
#include "scenefile/scene/render_scene.h"

#include <cstdint>
#include <string>
#include <vector>

namespace scenefile {

struct ObjOptions {
  std::string stem = "scene";  ///< the names of the other files begin with it; no blanks
  int segments = 64;           ///< of a full turn of round sides; see geometry/tessellate.h
  float transparent = 0.5f;    ///< kt where the scene gives none
  std::uint64_t most_triangles = 20'000'000;  ///< with all copies of templates
};

/// The files: the scene itself, then STEM.mtl, then pictures STEM-1.png, ...
struct ObjScene {
  std::string obj;
  std::string mtl;
  std::vector<std::string> pictures;
};

/// Writes all objects in world space, each as a group of its own. Materials keep ambient, diffuse,
/// specular and shininess as they are, with the scene's coefficients multiplied in; pictures hold
/// linear values with blend baked, as MTL says nothing of sRGB. Lights and camera are lost; each
/// thing that is not said as it stands is reported once. Returns empty texts and reports an error
/// when there are too many triangles. Codes: export/codes.h.
ObjScene write_obj(const RenderScene& scene, const Assets& assets, const ObjOptions& options,
                   Diagnostics& diagnostics);

}  // namespace scenefile
