#pragma once
// All codes of all rooms, and those of the verbs.

#include "scenefile/base/code.h"

#include <span>
#include <string_view>

namespace scenefile {

inline constexpr Code verbs_codes[] = {
    {"render.no-directional-light", Severity::warning, "no light is used in this mode",
     "The course's ray caster (--profile course --mode intersect) only uses directional lights, "
     "and the scene has none: the picture shows ambient light only. With --profile fine, or with "
     "--mode ray, the other lights are used too."},

    {"realtime.light-skipped", Severity::note, "a light that the milestone does not support",
     "The milestone Lights, Camera of the assignment Realtime only has directional lights; Action "
     "also has point lights and spotlights. The assignment's program skips all other lights "
     "silently, and so does --profile realtime."},

    {"realtime.no-light", Severity::warning, "no light is used in this milestone",
     "The scene has lights, but none of a type that the milestone supports: the picture shows "
     "ambient light only. Scenes with point lights and spotlights are drawn with --milestone "
     "action."},

    {"realtime.not-drawn", Severity::note, "features that the assignment Realtime does not draw",
     "The assignment has no textures, reflections, transparency or shadows. --profile course and "
     "--profile fine draw them."},

    {"convert.comments", Severity::note, "comments are not carried over",
     "Only the meaning of the scene is converted, and JSON has no comments at all. To keep "
     "comments, use scenefile format, which only changes white space."},

    {"convert.file-left-behind", Severity::warning, "a texture or mesh is in another folder",
     "Files are looked for in the folder of the scene and in a few folders next to it. The "
     "converted scene is in another folder, from which this file is not found. Copy the file to "
     "the corresponding place, write the output next to the input, or give the old folder with "
     "--asset-root whenever you use the new scene."},

    {"convert.file-renamed", Severity::note, "a texture or mesh has another path in the output",
     "File names are relative to the folder of the scene. The output is in another folder, so the "
     "path is changed to lead to the same file from there."},
};

template <CodeName name>
constexpr const Code& operator""_code() requires(code_index(verbs_codes, name) <
                                                 std::size(verbs_codes)) {
  constexpr std::size_t index = code_index(verbs_codes, name);
  return verbs_codes[index];
}

/// Sorted by name.
std::span<const Code* const> all_codes();
/// Their names, in the same order.
std::span<const std::string_view> code_names();
/// The code with that name, or null.
const Code* find_code(std::string_view name);

/// "note", "warning" or "error".
std::string_view severity_name(Severity severity);

}  // namespace scenefile
