#pragma once
// From Wavefront OBJ with its materials to a scene (Wavefront, "Object Files (.obj)" and "Material
// Library (.mtl)").

#include "scenefile/base/diagnostics.h"
#include "scenefile/import/imported_scene.h"

#include <string_view>

namespace scenefile {

/// Reads the text of an OBJ file and fetches its material libraries and pictures. The triangles of
/// each material become one OBJ file and one object. Colors and pictures are taken as they stand,
/// as MTL says nothing of sRGB; Ka 1 1 1, which programs write without meaning it, counts as a
/// tenth of Kd. A camera and a light are added. The mesh is read by read_obj() (asset/read_obj.h),
/// which finds what is wrong with it. Codes: import/codes.h, asset/codes.h.
ImportedScene read_obj_scene(std::string_view text, const ImportOptions& options,
                             Diagnostics& diagnostics);

}  // namespace scenefile
