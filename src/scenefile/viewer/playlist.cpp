#include "scenefile/viewer/playlist.h"

#include "scenefile/base/text.h"
#include "scenefile/io/folder.h"

#include <algorithm>
#include <string_view>

namespace scenefile::viewer {

namespace {

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

// The digits at the start without leading zeros; takes them away.
std::string_view take_digits(std::string_view& text) {
  const std::size_t end = std::min(text.find_first_not_of("0123456789"), text.size());
  std::string_view digits = text.substr(0, end);
  text.remove_prefix(end);
  digits.remove_prefix(std::min(digits.find_first_not_of('0'), digits.size()));
  return digits;
}

bool comes_before(const std::string& first, const std::string& second) {
  const std::string a_text = lower_case(first);
  const std::string b_text = lower_case(second);
  std::string_view a = a_text;
  std::string_view b = b_text;
  while (!a.empty() && !b.empty()) {
    if (is_digit(a.front()) && is_digit(b.front())) {
      const std::string_view x = take_digits(a);
      const std::string_view y = take_digits(b);
      if (x != y) {
        return x.size() != y.size() ? x.size() < y.size() : x < y;
      }
    } else if (a.front() != b.front()) {
      return a.front() < b.front();
    } else {
      a.remove_prefix(1);
      b.remove_prefix(1);
    }
  }
  return a.empty() != b.empty() ? a.empty() : first < second;
}

}  // namespace

bool is_scene_name(const std::string& name) {
  const std::string lower = lower_case(name);
  return lower.ends_with(".xml") || lower.ends_with(".json");
}

std::vector<std::string> scenes_in(const std::string& folder) {
  std::vector<std::string> names = files_in(folder);
  names.erase(std::remove_if(names.begin(), names.end(),
                             [](const std::string& name) { return !is_scene_name(name); }),
              names.end());
  std::sort(names.begin(), names.end(), comes_before);
  const std::string prefix = folder.ends_with('/') ? folder : folder + "/";
  for (std::string& name : names) {
    name.insert(0, folder == "." ? "" : prefix);
  }
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
