#include "scenefile/format/recognize.h"

#include "scenefile/base/ascii.h"
#include "scenefile/base/diagnostics.h"
#include "scenefile/base/suggest.h"
#include "scenefile/base/text.h"
#include "scenefile/format/codes.h"
#include "scenefile/format/scene_text.h"

#include <algorithm>
#include <array>
#include <span>
#include <string>

namespace scenefile {

namespace {

// `scenefile` is the first.
constexpr std::array<std::string_view, 5> scene_elements{"scenefile", "globaldata", "cameradata",
                                                         "lightdata", "transblock"};
constexpr std::array<std::string_view, 3> scene_keys{"globalData", "cameraData", "templateGroups"};
constexpr std::size_t longest_name = 64;  // enough of a name to recognize it

bool is_one_of(std::string_view name, std::span<const std::string_view> words) {
  return std::any_of(words.begin(), words.end(),
                     [&](std::string_view word) { return equal_ignoring_case(name, word); });
}

// The name of the tag that follows a `<`, without a namespace prefix.
std::string_view local_tag_name(std::string_view tag) {
  const std::string_view start = tag.substr(0, longest_name);
  const std::string_view name = start.substr(0, start.find_first_of(" \t\r\n/><"));
  return name.substr(name.rfind(':') + 1);
}

// Whether an element has the name of one that only scenes have, or the first element nearly that of
// a scene.
bool has_element_of_scene(std::string_view text) {
  bool is_first = true;
  for (std::size_t at = 0; (at = text.find('<', at)) != std::string_view::npos;) {
    const std::string_view name = local_tag_name(text.substr(++at));
    const bool is_start = !name.empty() && name[0] != '!' && name[0] != '?';
    if (is_one_of(name, scene_elements) ||
        (is_start && is_first && !nearest_name(name, std::span(scene_elements).first(1)).empty())) {
      return true;
    }
    is_first = is_first && !is_start;
  }
  return false;
}

// The end of the string whose opening quote is at `at`.
std::size_t end_of_string(std::string_view text, std::size_t at) {
  for (++at; at < text.size() && text[at] != '"' && text[at] != '\n'; ++at) {
    at += text[at] == '\\' ? 1 : 0;
  }
  return std::min(at + 1, text.size());
}

// Whether the outermost object has a key that only scenes have, or "groups" and no key that scenes
// do not have. `text` need not be valid JSON; its first brace may be missing.
bool has_key_of_scene(std::string_view text) {
  int depth = 0;
  bool groups = false;
  bool others = false;
  for (std::size_t at = 0; at < text.size(); ++at) {
    const char c = text[at];
    if (c == '"') {
      const std::size_t end = end_of_string(text, at);
      const std::size_t next = text.find_first_not_of(blanks, end);
      if (depth <= 1 && next != std::string_view::npos && text[next] == ':') {
        const std::string_view key = text.substr(at + 1, end - at - 2);
        if (is_one_of(key, scene_keys)) {
          return true;
        }
        const bool is_groups = equal_ignoring_case(key, "groups");
        groups = groups || is_groups;
        others = others || (!is_groups && !equal_ignoring_case(key, "name"));
      }
      at = end - 1;
    } else if (c == '{' || c == '[') {
      ++depth;
    } else if (c == '}' || c == ']') {
      --depth;
    }
  }
  return groups && !others;
}

}  // namespace

bool is_scene_name(std::string_view path) {
  const std::string lower = lower_case(path);
  return lower.ends_with(".xml") || lower.ends_with(".json");
}

bool has_scene_parts(std::string_view text) {
  return has_element_of_scene(text) || has_key_of_scene(text);
}

bool may_be_scene(std::string_view bytes) {
  Diagnostics found;
  std::string storage;
  if (open_text(bytes, storage, found)) {
    return true;
  }
  const Code* const code = found.list().back().code;
  return code != &"xml.root-element"_code && code != &"json.missing-key"_code &&
         code != &"json.wrong-type"_code;
}

}  // namespace scenefile
