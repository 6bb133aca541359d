#pragma once
// The scenes of a folder, for browsing.

#include <string>
#include <vector>

namespace scenefile::viewer {

/// Paths of the scenes of a folder in natural order: numbers by value, ignoring case.
std::vector<std::string> scenes_in(const std::string& folder);

/// The scene `steps` after `path` in its folder (negative: before), wrapping around at the ends. If
/// `path` is no longer in its folder, counts from before the first scene. Empty if there are no
/// scenes.
std::string neighbor_of(const std::string& path, int steps);

/// What opening a path shows: the path itself, or the first scene of a folder; otherwise empty.
std::string scene_at(const std::string& path);

}  // namespace scenefile::viewer
