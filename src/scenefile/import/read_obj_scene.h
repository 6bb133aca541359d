#pragma once
// Import from Wavefront OBJ with materials (Wavefront, "Object Files (.obj)" and "Material Library
// (.mtl)").

#include "scenefile/base/diagnostics.h"
#include "scenefile/import/imported_scene.h"

#include <string_view>

namespace scenefile {

/// Reads the text of an OBJ file and fetches its material libraries and pictures. The triangles of
/// each material become one OBJ file and one object. Colors and pictures are used unchanged,
/// because MTL does not mention sRGB. Ka 1 1 1, which programs often write by default, counts as a
/// tenth of Kd. A camera and a light are added. Errors in the mesh are reported by read_obj()
/// (asset/read_obj.h). Codes: import/codes.h, asset/codes.h.
ImportedScene read_obj_scene(std::string_view text, const ImportOptions& options,
                             Diagnostics& diagnostics);

}  // namespace scenefile
