#include "scenefile/viewer/actions.h"

#include <algorithm>
#include <array>

namespace scenefile::viewer {

const ActionRow& row_of(Action action) {
  const auto rows = actions();
  return *std::find_if(rows.begin(), rows.end(),
                       [&](const ActionRow& row) { return row.action == action; });
}

std::string key_text(const KeyPress& key) {
  std::string text(key.control ? "Ctrl+" : "");
  text.append(key.shift ? "Shift+" : "").append(key.name);
  return text;
}

KeyPress parse_key(std::string_view text) {
  KeyPress key;
  const auto take = [&](std::string_view prefix, bool& flag) {
    // "Ctrl++" means the key +.
    if (text.size() > prefix.size() && text.starts_with(prefix)) {
      flag = true;
      text.remove_prefix(prefix.size());
    }
  };
  take("Ctrl+", key.control);
  take("Shift+", key.shift);
  key.name = text;
  return key;
}

bool is_flying_key(const KeyPress& key) {
  constexpr std::array<std::string_view, 6> keys{"W", "A", "S", "D", "Q", "E"};
  return !key.control && std::find(keys.begin(), keys.end(), key.name) != keys.end();
}

bool is_assignment_key(const KeyPress& key) {
  constexpr std::array<std::string_view, 6> keys{"W", "A", "S", "D", "Space", "Control"};
  return std::find(keys.begin(), keys.end(), key.name) != keys.end();
}

const ActionRow* action_of(const KeyPress& key) {
  const auto rows = actions();
  const std::string text = key.name == "?" ? "F1" : key_text(key);
  const auto found =
      std::find_if(rows.begin(), rows.end(), [&](const ActionRow& row) { return row.key == text; });
  return found == rows.end() ? nullptr : &*found;
}

}  // namespace scenefile::viewer
