#include "scenefile/format/recognize.h"

#include "scenefile/base/diagnostics.h"
#include "scenefile/base/text.h"
#include "scenefile/format/scene_text.h"
#include "scenefile/scene/vocabulary.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string>

namespace scenefile {

namespace {

constexpr std::array<std::string_view, 4> json_keys{"globalData", "cameraData", "groups",
                                                    "templateGroups"};

// Whether the text contains a start tag with that name, with or without a namespace prefix.
bool has_element(std::string_view text, std::string_view name) {
  for (std::size_t at = 0; (at = text.find_first_of("<:", at)) != std::string_view::npos;) {
    ++at;
    if (equal_ignoring_case(text.substr(at, name.size()), name)) {
      return true;
    }
  }
  return false;
}

// The end of the string whose opening quote is at `at`.
std::size_t end_of_string(std::string_view text, std::size_t at) {
  for (++at; at < text.size() && text[at] != '"'; ++at) {
    at += text[at] == '\\' ? 1 : 0;
  }
  return std::min(at + 1, text.size());
}

// `text` need not be valid JSON.
bool has_key_of_scene(std::string_view text) {
  int depth = 0;
  for (std::size_t at = 0; at < text.size(); ++at) {
    const char c = text[at];
    if (c == '"') {
      const std::size_t end = end_of_string(text, at);
      const std::string_view word = text.substr(at + 1, end - at - 2);
      if (depth == 1 && std::any_of(json_keys.begin(), json_keys.end(), [&](std::string_view key) {
            return equal_ignoring_case(word, key);
          })) {
        return true;
      }
      at = end - 1;
    } else if (c == '{' || c == '[') {
      ++depth;
    } else if (c == '}' || c == ']') {
      --depth;
    }
  }
  return false;
}

}  // namespace

bool is_scene_name(std::string_view path) {
  const std::string lower = lower_case(path);
  return lower.ends_with(".xml") || lower.ends_with(".json");
}

bool may_be_scene(std::string_view bytes) {
  Diagnostics ignored;
  std::string storage;
  const std::optional<SceneText> file = open_text(bytes, storage, ignored);
  if (!file) {
    return true;
  }
  switch (file->syntax) {
    case SceneFormat::xml:
      return std::any_of(structure_elements.begin(), structure_elements.begin() + 4,
                         [&](std::string_view block) { return has_element(file->text, block); });
    case SceneFormat::json:
      return has_key_of_scene(file->text);
  }
  return true;
}

}  // namespace scenefile
