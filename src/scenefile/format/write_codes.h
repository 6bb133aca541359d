#pragma once
// Findings of write_scene().

#include "scenefile/base/diagnostics.h"

namespace scenefile {

inline constexpr Code write_light_moved{
    "write.light-moved", Severity::note, "a light is moved to the top level of the file",
    "In XML, lights are at the top level and in world space. The transforms of the group that held "
    "the light are applied to it; a light in a template is written once for each instance."};
inline constexpr Code write_light_limit{"write.light-limit", Severity::error, "too many lights",
                                        "In XML, lights in a template are written once for each "
                                        "instance. The limit bounds how many; it can be raised.",
                                        CodeKind::limit};
inline constexpr Code write_light_turned{
    "write.light-turned", Severity::warning, "an area light that XML cannot express",
    "In XML, an area light has a direction, a width and a height; it cannot be rotated about its "
    "direction, or sheared. It is written with the same center, direction and size, but without "
    "that rotation."};
inline constexpr Code write_light_dark{
    "write.light-dark", Severity::warning, "a light that lights nothing",
    "It has no direction, or no finite position, and is dropped."};
inline constexpr Code write_light_id{
    "write.light-id", Severity::note, "light ids are dropped or added",
    "JSON lights have no ids. XML requires one for each light: those without get the next free "
    "number. Ids have no effect on the picture."};
inline constexpr Code write_light_name{"write.light-name", Severity::note,
                                       "a light's name is dropped",
                                       "XML lights have an id but no name."};
inline constexpr Code write_scene_name{"write.scene-name", Severity::note,
                                       "the scene's name is dropped",
                                       "In XML, a scene has no name."};
inline constexpr Code write_area_light{
    "write.area-light", Severity::note, "an area light in JSON",
    "The course's JSON reader does not support area lights and rejects the file."};
inline constexpr Code write_default_camera{
    "write.default-camera", Severity::note, "the default camera is written",
    "JSON requires a camera; the scene has none, so the default camera is written."};
inline constexpr Code write_transforms_nested{
    "write.transforms-nested", Severity::note, "transforms become groups in groups",
    "A JSON group has one translate, rotate, scale and matrix each, "
    "applied in a fixed order. Other "
    "orders are said by groups that hold one group each."};
inline constexpr Code write_renamed{
    "write.renamed", Severity::note, "a group is renamed",
    "In JSON, a group with a template's name is an instance of that template. In XML, names of "
    "trees are unique, and root is the name of the scene."};
inline constexpr Code write_empty_group{
    "write.empty-group", Severity::note, "an empty group is dropped",
    "In XML, a transblock holds an object, and a tree is not empty."};
inline constexpr Code write_matrix_row{
    "write.matrix-row", Severity::note, "the last row of a matrix is written as 0 0 0 1",
    "Transforms are affine; their last row is 0 0 0 1. Other values have no effect."};
inline constexpr Code write_character{
    "write.character", Severity::warning, "a character that cannot be written",
    "XML cannot contain control characters, and neither format can contain bytes that are not "
    "UTF-8. They are replaced; a file with such a character in its name will not be found."};
inline constexpr Code write_nesting_limit{"write.nesting-limit", Severity::error,
                                          "the file would be nested too deeply",
                                          "Readers limit how deeply a file may be nested. What the "
                                          "other format writes flat may need several levels here.",
                                          CodeKind::limit};

}  // namespace scenefile
