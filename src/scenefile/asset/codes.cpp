#include "scenefile/asset/codes.h"

namespace scenefile {

std::span<const Code* const> asset_codes() {
  static constexpr const Code* codes[] = {
      &texture_missing,      &texture_undecodable, &texture_limit,   &mesh_missing,
      &mesh_unusable,        &mesh_not_obj,        &mesh_number,     &mesh_index,
      &mesh_limit,           &mesh_short_face,     &mesh_degenerate, &mesh_zero_normal,
      &mesh_unknown_keyword, &mesh_empty};
  return codes;
}

}  // namespace scenefile
