#pragma once
// The corners of OBJ faces. Internal to asset.

#include "scenefile/base/result.h"

#include <cstdint>
#include <string>
#include <string_view>

namespace scenefile {

/// One of the lists that a face corner refers to.
struct IndexList {
  std::string_view name;  ///< of one element, for messages
  std::uint64_t in_file = 0;
  std::uint64_t so_far = 0;  ///< before the face; negative numbers count back from here
};

struct CornerLists {
  IndexList positions, uvs, normals;
};

/// Indices from 0; uv and normal may be mesh_no_index.
struct Corner {
  std::uint32_t position, uv, normal;
};

/// Reads v, v/vt, v//vn or v/vt/vn. If only the normal does not exist, the corner has none, and
/// `missing_normal` says why.
Result<Corner> parse_corner(std::string_view word, const CornerLists& lists,
                            std::string& missing_normal);

}  // namespace scenefile
