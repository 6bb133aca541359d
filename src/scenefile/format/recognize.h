#pragma once
// Recognizes scene files among the files of a folder.

#include <string_view>

namespace scenefile {

/// Whether the path has the extension of a scene file: .xml or .json, in any case.
bool is_scene_name(std::string_view path);

/// Returns false for XML and JSON of other programs: XML without any block of a scene
/// (`<scenefile>`, `<globaldata>`, `<cameradata>`, `<lightdata>`), and JSON whose outermost object
/// has no key of a scene (`globalData`, `cameraData`, `groups`, `templateGroups`). Returns true for
/// everything else, including broken and empty files, which read_scene() should report.
bool may_be_scene(std::string_view bytes);

}  // namespace scenefile
