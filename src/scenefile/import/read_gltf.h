#pragma once
// Import from glTF 2.0 (Khronos Group, glTF 2.0 Specification, 2021).

#include "scenefile/base/diagnostics.h"
#include "scenefile/import/imported_scene.h"

#include <string_view>

namespace scenefile {

/// Whether the first four bytes are those of a GLB file.
bool is_glb(std::string_view bytes);

/// Reads GLB, or the JSON of a .gltf file. Nodes become groups with their names and transforms.
/// Each list of triangles becomes an OBJ file, shared by all its users; pictures become PNG files
/// with linear values. Materials and lights are converted to the nearest equivalent
/// (export/phong_pbr.h); if write_gltf() stored the format's own values and they still match, those
/// are used. A missing camera or light is added.
///
/// Every number is validated. Anything without an equivalent is reported once. Time and memory are
/// linear in the size of the file, and bounded by the limits. Codes: import/codes.h.
ImportedScene read_gltf(std::string_view bytes, const ImportOptions& options,
                        Diagnostics& diagnostics);

}  // namespace scenefile
