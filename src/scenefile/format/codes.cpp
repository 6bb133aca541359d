#include "scenefile/format/codes.h"

#include "scenefile/format/config_codes.h"
#include "scenefile/format/json_codes.h"
#include "scenefile/format/write_codes.h"

#include <iterator>
#include <vector>

namespace scenefile {

namespace {

constexpr const Code* xml_codes[] = {&format_empty,
                                     &format_unknown,
                                     &format_encoding,
                                     &format_encoding_assumed,
                                     &xml_syntax,
                                     &xml_comment,
                                     &xml_conflict_marker,
                                     &xml_external_dtd,
                                     &xml_entity,
                                     &xml_nesting_limit,
                                     &xml_attribute_limit,
                                     &xml_length_limit,
                                     &xml_light_limit,
                                     &xml_root_element,
                                     &xml_name_case,
                                     &xml_unknown_element,
                                     &xml_misspelt_element,
                                     &xml_misspelt_transblock,
                                     &xml_misplaced_element,
                                     &xml_ignored_element,
                                     &xml_alias_element,
                                     &xml_duplicate_element,
                                     &xml_second_camera,
                                     &xml_text,
                                     &xml_unknown_attribute,
                                     &xml_misspelt_attribute,
                                     &xml_missing_attribute,
                                     &xml_alias_attribute,
                                     &xml_positional_attributes,
                                     &xml_attribute_order,
                                     &xml_color_alpha,
                                     &xml_number,
                                     &xml_number_range,
                                     &xml_number_underflow,
                                     &xml_empty_number,
                                     &xml_camera_default,
                                     &xml_look_and_focus,
                                     &xml_focus_at_position,
                                     &xml_light_type,
                                     &xml_light_id,
                                     &xml_light_default,
                                     &xml_light_unused,
                                     &xml_object_type,
                                     &xml_unknown_object_type,
                                     &xml_misspelt_shape,
                                     &xml_unknown_shape,
                                     &xml_mesh_files,
                                     &xml_master_name,
                                     &xml_duplicate_name,
                                     &xml_reserved_root,
                                     &xml_no_root,
                                     &xml_master_after_root,
                                     &xml_nested_master,
                                     &xml_instance_children,
                                     &xml_empty_tree,
                                     &xml_object_without_transblock,
                                     &xml_transblock_without_object,
                                     &xml_after_object,
                                     &xml_after_object_used,
                                     &xml_rotate_angle,
                                     &xml_rotate_axis,
                                     &xml_matrix_rows,
                                     &xml_matrix_not_affine,
                                     &xml_texture_blend};

}  // namespace

std::span<const Code* const> format_codes() {
  static const std::vector<const Code*> all = [] {
    std::vector<const Code*> codes(std::begin(xml_codes), std::end(xml_codes));
    codes.insert(codes.end(), json_codes().begin(), json_codes().end());
    codes.insert(codes.end(), write_codes().begin(), write_codes().end());
    codes.insert(codes.end(), config_codes().begin(), config_codes().end());
    return codes;
  }();
  return all;
}

}  // namespace scenefile
