#include "scenefile/format/json_codes.h"

namespace scenefile {

namespace {

constexpr const Code* all[] = {
    &json_after_end,       &json_area_light,     &json_comment,
    &json_conflict_marker, &json_duplicate_key,  &json_four_dimensional,
    &json_instance_keys,   &json_light_default,  &json_limit,
    &json_look_and_focus,  &json_matrix_order,   &json_missing_key,
    &json_misspelt_key,    &json_no_groups,      &json_no_light,
    &json_number,          &json_number_range,   &json_number_underflow,
    &json_string,          &json_syntax,         &json_template_order,
    &json_trailing_comma,  &json_truncated,      &json_unknown_key,
    &json_light_type,      &json_primitive_type, &json_unknown_template,
    &json_unused_key,      &json_length,         &json_type,
};

}  // namespace

std::span<const Code* const> json_codes() {
  return all;
}

}  // namespace scenefile
