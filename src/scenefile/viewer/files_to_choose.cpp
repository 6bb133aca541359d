#include "scenefile/viewer/files_to_choose.h"

#include "scenefile/asset/image_file.h"
#include "scenefile/io/folder.h"

#include <algorithm>

namespace scenefile::viewer {

namespace {

constexpr std::size_t most = 500;

bool is_useful(const std::string& name, FileUse use) {
  if (use == FileUse::image) {
    return is_texture_name(name);
  }
  return name.ends_with(".obj") || name.ends_with(".OBJ");
}

void add_files(const std::string& folder, const std::string& prefix, bool inner, FileUse use,
               std::vector<std::string>& files) {
  for (const FolderEntry& entry : entries_of(folder)) {
    if (is_hidden_name(entry.name) || files.size() >= most) {
      continue;
    }
    if (!entry.folder && is_useful(entry.name, use)) {
      files.push_back(prefix + entry.name);
    } else if (entry.folder && inner) {
      add_files(entry.path, entry.name + "/", false, use, files);
    }
  }
}

}  // namespace

std::vector<std::string> files_to_choose(const std::string& scene, FileUse use) {
  std::vector<std::string> files;
  add_files(folder_of(scene), "", true, use, files);
  std::sort(files.begin(), files.end(), natural_less);
  return files;
}

}  // namespace scenefile::viewer
