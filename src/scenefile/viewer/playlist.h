#pragma once
// The scenes of a folder, to leaf through.

#include <string>
#include <vector>

namespace scenefile::viewer {

/// The scenes of a folder in the order of people: numbers in names by their value, without regard
/// to case. Whole paths.
std::vector<std::string> scenes_in(const std::string& folder);

/// The neighbor of `path` in its folder, `steps` further (negative: back), around at the ends. A
/// file that is not in its folder any more counts as before the first. Empty: there is no scene.
std::string neighbor_of(const std::string& path, int steps);

/// What dropping or naming a path opens: the path itself, of a folder its first scene, else empty.
std::string scene_at(const std::string& path);

}  // namespace scenefile::viewer
