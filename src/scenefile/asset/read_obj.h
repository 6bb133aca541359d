#pragma once
// Wavefront OBJ: v, vt, vn and f lines. Polygons are split into triangle fans, negative indices
// count from the end. Source of the format: Wavefront, "Object Files (.obj)", appendix B1.

#include "scenefile/base/diagnostics.h"
#include "scenefile/base/limits.h"
#include "scenefile/geometry/mesh.h"

#include <cstdint>
#include <string>
#include <string_view>

namespace scenefile {

/// Reads the text of an OBJ file; every number and index is validated; findings carry the line and
/// `file_name`. Faces may come before their vertices. Materials, groups, smoothing, lines, points,
/// vertex colors and weights are skipped; curves and unknown keywords too, with a warning.
/// Triangles without area are left out with a warning. Codes: asset/codes.h.
///
/// `triangle_budget` is what remains of limits.mesh_triangles, `byte_budget` of limits.mesh_bytes;
/// both are checked before memory is allocated, and reduced by what was read. After an error
/// the mesh is empty; reading stops after limits.messages_per_code errors. Time and memory are
/// linear in the size of the text.
Mesh read_obj(std::string_view text, const std::string& file_name, const Limits& limits,
              std::uint64_t& triangle_budget, std::uint64_t& byte_budget, Diagnostics& diagnostics);

}  // namespace scenefile
