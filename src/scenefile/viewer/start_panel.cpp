#include "scenefile/viewer/start_panel.h"

#include "scenefile/asset/image_file.h"
#include "scenefile/base/text.h"
#include "scenefile/format/recognize.h"
#include "scenefile/io/folder.h"

#include <algorithm>
#include <string_view>
#include <utility>

namespace scenefile::viewer {

std::vector<Choice> list_choices(const std::string& folder) {
  std::vector<Choice> choices;
  for (FolderEntry& entry : entries_of(folder)) {
    if (is_hidden_name(entry.name)) {
      continue;
    }
    if (entry.folder) {
      choices.push_back({ChoiceKind::folder, std::move(entry.name), std::move(entry.path)});
    } else if (is_scene_name(entry.name)) {
      choices.push_back({ChoiceKind::scene, std::move(entry.name), std::move(entry.path)});
    } else if (is_picture_name(entry.name)) {  // reading every file of a folder takes too long
      choices.push_back({ChoiceKind::picture, std::move(entry.name), std::move(entry.path)});
    }
  }
  std::sort(choices.begin(), choices.end(), [](const Choice& a, const Choice& b) {
    return a.kind != b.kind ? a.kind < b.kind : natural_less(a.name, b.name);
  });
  return choices;
}

void go_to_folder(StartPanel& panel, const std::string& folder) {
  panel.folder = absolute_path(folder.empty() ? "." : folder);
  while (panel.folder.size() > 1 && (panel.folder.ends_with('/') || panel.folder.ends_with("/."))) {
    panel.folder.pop_back();
  }
  panel.choices = list_choices(panel.folder);
}

std::string typed_path(const StartPanel& panel, const char* home) {
  const std::string& text = panel.typed;
  if (text.starts_with('/')) {
    return text;
  }
  if (text.starts_with("~/") && home != nullptr) {
    return home + text.substr(1);
  }
  return panel.folder + '/' + text;
}

}  // namespace scenefile::viewer
