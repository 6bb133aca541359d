#pragma once
// From glTF 2.0 (Khronos Group, glTF 2.0 Specification, 2021) to a scene.

#include "scenefile/base/diagnostics.h"
#include "scenefile/import/imported_scene.h"

#include <string_view>

namespace scenefile {

/// Whether the bytes are a GLB file by their first four.
bool is_glb(std::string_view bytes);

/// Reads GLB, or the JSON of a .gltf file. Nodes become groups with their names and transforms,
/// each list of triangles an OBJ file that all its users share, pictures PNG files with linear
/// values. Materials and lights take the nearest meaning (export/phong_pbr.h), or the format's own
/// values where write_gltf() put them and they still fit. Where there is no camera or light, one is
/// added.
///
/// Every number is checked before it is used; what has no counterpart is reported, each thing once.
/// Time and memory are linear in the size of the file and bounded by the limits. Codes:
/// import/codes.h.
ImportedScene read_gltf(std::string_view bytes, const ImportOptions& options,
                        Diagnostics& diagnostics);

}  // namespace scenefile
