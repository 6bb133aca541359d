#pragma once
// Wavefront OBJ: v, vt, vn and f lines. Polygons are split into triangle fans, negative indices
// count from the end. Source of the format: Wavefront, "Object Files (.obj)", appendix B1.

#include "scenefile/base/diagnostics.h"
#include "scenefile/base/limits.h"
#include "scenefile/base/location.h"
#include "scenefile/geometry/mesh.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace scenefile {

/// What an OBJ file says about the materials of its faces.
struct ObjMaterials {
  std::vector<FileReference> names;        ///< after usemtl, each once; may hold blanks
  std::vector<std::uint32_t> of_triangle;  ///< into names, or mesh_no_index; empty without names
  /// For each mtllib, its names in order of priority; the last may be the whole line, for a name
  /// that holds blanks.
  std::vector<std::vector<FileReference>> libraries;
};

/// Reads the text of an OBJ file; every number and index is validated; findings carry the line and
/// `file_name`. Faces may come before their vertices. Groups, smoothing, lines, points, vertex
/// colors and weights are skipped; curves and unknown keywords too, with a warning. Materials are
/// skipped, or written to `materials`. Triangles without area are left out with a warning; those
/// whose normals do not exist have none, with a warning. Codes: asset/codes.h.
///
/// `triangle_budget` is what remains of limits.mesh_triangles, `byte_budget` of limits.mesh_bytes;
/// both are checked before memory is allocated, and reduced by what was read. After an error
/// the mesh is empty; reading stops after limits.messages_per_code errors. Time and memory are
/// linear in the size of the text.
Mesh read_obj(std::string_view text, const std::string& file_name, const Limits& limits,
              std::uint64_t& triangle_budget, std::uint64_t& byte_budget, Diagnostics& diagnostics,
              ObjMaterials* materials = nullptr);

}  // namespace scenefile
