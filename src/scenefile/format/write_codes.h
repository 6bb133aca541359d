#pragma once
// What write_scene() has to say.

#include "scenefile/base/diagnostics.h"

namespace scenefile {

inline constexpr Code write_light_moved{
    "write.light-moved", Severity::note, "a light is moved to the top of the file",
    "In XML, lights stand beside the objects and in world space. The transforms of the group that "
    "held the light are applied to it; a light in a template is written once for each copy."};
inline constexpr Code write_light_limit{
    "write.light-limit", Severity::error, "too many lights",
    "In XML, lights in a template are written once for each copy. The limit on how many keeps this "
    "within bounds; it can be raised.",
    CodeKind::limit};
inline constexpr Code write_light_turned{
    "write.light-turned", Severity::warning, "an area light that XML cannot place so",
    "In XML an area light has a direction, a width and a height, and no way to say how it is "
    "turned "
    "about its direction, or skewed. It is written with the same center, direction and sides, but "
    "lies otherwise."};
inline constexpr Code write_light_dark{"write.light-dark", Severity::warning,
                                       "a light that lights nothing",
                                       "It has no direction, or no finite place, and is left out."};
inline constexpr Code write_light_id{
    "write.light-id", Severity::note, "light ids are left out or added",
    "JSON has no ids of lights. XML demands one of each light: those without get the next number "
    "that is free. Ids have no effect on the picture."};
inline constexpr Code write_light_name{"write.light-name", Severity::note,
                                       "a light's name is left out",
                                       "In XML, lights have an id and no name."};
inline constexpr Code write_scene_name{"write.scene-name", Severity::note,
                                       "the scene's name is left out",
                                       "In XML, the scene has no name of its own."};
inline constexpr Code write_area_light{
    "write.area-light", Severity::note, "an area light in JSON",
    "The course's JSON reader knows no area lights and refuses the file."};
inline constexpr Code write_default_camera{
    "write.default-camera", Severity::note, "the default camera is written",
    "JSON demands a camera; the scene has none, which means the default camera."};
inline constexpr Code write_transforms_nested{
    "write.transforms-nested", Severity::note, "transforms become groups in groups",
    "A JSON group has one translate, rotate, scale and matrix each, "
    "applied in a fixed order. Other "
    "orders are said by groups that hold one group each."};
inline constexpr Code write_renamed{
    "write.renamed", Severity::note, "a group gets another name",
    "In JSON, a group with the name of a template stands for that template. In XML, names of trees "
    "are unique, and root is the name of the scene."};
inline constexpr Code write_empty_group{
    "write.empty-group", Severity::note, "an empty group is left out",
    "In XML, a transblock holds an object and a tree is not empty."};
inline constexpr Code write_matrix_row{
    "write.matrix-row", Severity::note, "the last row of a matrix is written as 0 0 0 1",
    "Objects are moved by affine maps, whose last row is 0 0 0 1. Another one has no effect."};
inline constexpr Code write_character{
    "write.character", Severity::warning, "a character that cannot be written",
    "XML cannot hold control characters, and neither format bytes that are not UTF-8. They are "
    "replaced; a file name with such a character will not be found."};
inline constexpr Code write_nesting_limit{
    "write.nesting-limit", Severity::error, "the file would be nested too deeply",
    "Readers limit how deep a file may be nested. What the other format says flat may need several "
    "levels here.",
    CodeKind::limit};

}  // namespace scenefile
