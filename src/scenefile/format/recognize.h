#pragma once
// Which files of a folder are scenes.

#include <string_view>

namespace scenefile {

/// Whether a path ends as those of scenes do: .xml or .json, in any case.
bool is_scene_name(std::string_view path);

/// False for XML and JSON of other programs: XML without any block of a scene (`<scenefile>`,
/// `<globaldata>`, `<cameradata>`, `<lightdata>`), JSON whose outermost object has no key of a
/// scene
/// (`globalData`, `cameraData`, `groups`, `templateGroups`). True for everything else, broken and
/// empty files included: those are for read_scene() to report.
bool may_be_scene(std::string_view bytes);

}  // namespace scenefile
