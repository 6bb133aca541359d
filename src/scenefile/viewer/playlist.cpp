#include "scenefile/viewer/playlist.h"

#include "scenefile/format/recognize.h"
#include "scenefile/io/folder.h"

#include <algorithm>

namespace scenefile::viewer {

std::vector<std::string> scenes_in(const std::string& folder) {
  std::vector<std::string> names;
  for (const FolderEntry& entry : entries_of(folder)) {
    if (entry.file && is_scene_name(entry.name)) {
      names.push_back(folder == "." ? entry.name : entry.path);
    }
  }
  std::sort(names.begin(), names.end(), natural_less);
  return names;
}

std::string neighbor_of(const std::string& path, int steps) {
  const std::vector<std::string> scenes = scenes_in(folder_of(path));
  if (scenes.empty()) {
    return {};
  }
  const std::string name = file_name_of(path);
  const auto found = std::find_if(scenes.begin(), scenes.end(), [&](const std::string& scene) {
    return file_name_of(scene) == name;
  });
  const auto count = static_cast<long>(scenes.size());
  const long at = found == scenes.end() ? (steps > 0 ? -1 : 0) : found - scenes.begin();
  return scenes[static_cast<std::size_t>(((at + steps) % count + count) % count)];
}

std::string scene_at(const std::string& path) {
  if (!is_folder(path)) {
    return path;
  }
  const std::vector<std::string> scenes = scenes_in(path);
  return scenes.empty() ? std::string() : scenes.front();
}

}  // namespace scenefile::viewer
