#include "scenefile/format/write_codes.h"

namespace scenefile {

namespace {

constexpr const Code* all[] = {
    &write_area_light, &write_character,    &write_camera,      &write_empty_group,
    &write_light_dark, &write_light_id,     &write_light_limit, &write_light_moved,
    &write_light_name, &write_light_turned, &write_matrix_row,  &write_nesting,
    &write_renamed,    &write_scene_name,   &write_nested,
};

}  // namespace

std::span<const Code* const> write_codes() {
  return all;
}

}  // namespace scenefile
