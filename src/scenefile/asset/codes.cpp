#include "scenefile/asset/codes.h"

namespace scenefile {

std::span<const Code* const> asset_codes() {
  static constexpr const Code* codes[] = {&texture_missing,
                                          &texture_undecodable,
                                          &texture_limit,
                                          &mesh_missing,
                                          &mesh_unusable,
                                          &mesh_not_obj,
                                          &mesh_number,
                                          &mesh_index,
                                          &mesh_limit,
                                          &mesh_short_face,
                                          &mesh_degenerate,
                                          &mesh_zero_normal,
                                          &mesh_unknown_keyword,
                                          &mesh_empty,
                                          &mtl_missing,
                                          &mtl_no_material,
                                          &mtl_unknown_material,
                                          &mtl_duplicate,
                                          &mtl_before_newmtl,
                                          &mtl_unknown_keyword,
                                          &mtl_value,
                                          &mtl_range,
                                          &mtl_limit,
                                          &mtl_energy,
                                          &mtl_illum,
                                          &mtl_mirror_ior,
                                          &mtl_opacity,
                                          &mtl_map_option,
                                          &mtl_leading_point};
  return codes;
}

}  // namespace scenefile
