#pragma once
// Findings about scenes exported for other programs.

#include "scenefile/base/code.h"

namespace scenefile {

inline constexpr Code export_codes[] = {
    {"export.approximate", Severity::note, "glTF or OBJ represents this differently",
     "glTF has physical materials and lights, and OBJ has no mirror colors. The nearest equivalent "
     "is written; docs/convert.md lists which. glTF files also contain the scene's own values, so "
     "that convert can read them back."},
    {"export.lost", Severity::warning, "glTF or OBJ cannot represent this",
     "The file is written without it. Keep the scene file; only it is complete."},
    {"export.size-limit", Severity::error, "the file would be too large",
     "glTF and OBJ files have no instances of groups: each instance of a template is written out, "
     "so nested templates become very large, and a GLB file can have at most 4 GB. Convert a part "
     "of the scene.",
     CodeKind::limit},
    {"pov.approximate", Severity::note, "POV-Ray expresses this differently",
     "The lighting equations differ: POV-Ray has one highlight strength for all colors, lets the "
     "ambient light of a textured object take the color of the texture, attenuates lights by a "
     "single power of the distance, and dims the surface of glass. The pictures are similar, not "
     "equal."},
    {"pov.lost", Severity::warning, "POV-Ray cannot express this",
     "The scene is written without it."},
};

template <CodeName name>
constexpr const Code& operator""_code() requires(code_index(export_codes, name) <
                                                 std::size(export_codes)) {
  constexpr std::size_t index = code_index(export_codes, name);
  return export_codes[index];
}

}  // namespace scenefile
