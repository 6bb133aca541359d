#pragma once
// Recognizes scene files among other files.

#include <string_view>

namespace scenefile {

/// Whether the path has the extension of a scene file: .xml or .json, in any case.
bool is_scene_name(std::string_view path);

/// Whether the text has a tag of a scene (`<scenefile>`, `<globaldata>`, `<cameradata>`,
/// `<lightdata>`, `<transblock>`, or a first tag with nearly the name `<scenefile>`), or, if read
/// as JSON, a key `globalData`, `cameraData` or `templateGroups` in its outermost object, or
/// `groups` if the other keys there are only `name`. Ignores case and namespace prefixes. The text
/// need not be well-formed. Findings show nothing of texts without any of these (SECURITY.md).
bool has_scene_parts(std::string_view text);

/// Returns false for XML and JSON of other programs: without has_scene_parts(). Returns true for
/// everything else, including broken and empty files, which read_scene() should report.
bool may_be_scene(std::string_view bytes);

}  // namespace scenefile
