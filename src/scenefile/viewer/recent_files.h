#pragma once
// The recently opened scenes, kept between runs.

#include <string>
#include <vector>

namespace scenefile::viewer {

/// The maximum number of paths in the list.
inline constexpr std::size_t max_recent_files = 12;

/// Absolute paths, the last opened first. Empty if the file does not exist, or is damaged: one line
/// that is not an absolute path, or more lines than are kept. A file that is too long is damaged.
std::vector<std::string> load_recent_files(const std::string& path);

/// Puts `scene`, an absolute path, in front, and saves the list. The file is replaced atomically,
/// even if it is damaged. Nothing is saved if `path` is empty, or if the scene's path has a line
/// break. Returns why the file cannot be written; empty on success.
std::string add_recent_file(const std::string& path, const std::string& scene);

}  // namespace scenefile::viewer
