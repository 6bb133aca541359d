#include "scenefile/viewer/settings.h"

#include "scenefile/base/number.h"
#include "scenefile/io/file.h"
#include "scenefile/io/folder.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <string_view>

namespace scenefile::viewer {

namespace {

/// A setting as a number; booleans are 0 and 1.
struct SettingRow {
  std::string_view name;
  double least;
  double most;
  double (*get)(const Settings&);
  void (*set)(Settings&, double);
};

template <auto member>
constexpr SettingRow row(std::string_view name, double least, double most) {
  return {name, least, most, [](const Settings& s) { return static_cast<double>(s.*member); },
          [](Settings& s, double value) {
            using Member = std::remove_reference_t<decltype(s.*member)>;
            if constexpr (std::is_same_v<Member, bool>) {
              s.*member = value != 0;
            } else {
              s.*member = static_cast<Member>(value);
            }
          }};
}

constexpr std::array setting_rows{
    row<&Settings::window_width>("window_width", 320, 16384),
    row<&Settings::window_height>("window_height", 240, 16384),
    row<&Settings::panel_width>("panel_width", 120, 2000),
    row<&Settings::text_scale>("text_scale", 0.5, 4),
    row<&Settings::outline>("outline", 0, 1),
    row<&Settings::messages>("messages", 0, 1),
    row<&Settings::statistics>("statistics", 0, 1),
    row<&Settings::shadows>("shadows", 0, 1),
    row<&Settings::textures>("textures", 0, 1),
    row<&Settings::axes>("axes", 0, 1),
    row<&Settings::assignment_keys>("assignment_keys", 0, 1),
    row<&Settings::ray_tracing>("ray_tracing", 0, 1),
    row<&Settings::linear_values>("linear_values", 0, 1),
    row<&Settings::samples>("samples", 1, 4096),
};

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view blanks = " \t\r";
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) {
    return {};
  }
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

// Returns false if the line is damaged.
bool parse_line(std::string_view line, Settings& settings) {
  const std::size_t equals = line.find('=');
  if (equals == std::string_view::npos) {
    return false;
  }
  const std::string_view name = trimmed(line.substr(0, equals));
  const auto found = std::find_if(setting_rows.begin(), setting_rows.end(),
                                  [&](const SettingRow& r) { return r.name == name; });
  if (found == setting_rows.end()) {
    return !name.empty();
  }
  const ParsedNumber number = parse_number(line.substr(equals + 1));
  if (number.error != NumberError::none) {
    return false;
  }
  found->set(settings, std::clamp(number.value, found->least, found->most));
  return true;
}

}  // namespace

std::string settings_text(const Settings& settings) {
  std::string text = "# scenefile view\n";
  for (const SettingRow& r : setting_rows) {
    text += fmt::format("{} = {}\n", r.name, number_text(static_cast<float>(r.get(settings))));
  }
  return text;
}

bool parse_settings(const std::string& text, Settings& settings) {
  Settings result = settings;
  std::istringstream lines(text);
  for (std::string written; std::getline(lines, written);) {
    const std::string_view line = trimmed(written);
    if (!line.empty() && line.front() != '#' && !parse_line(line, result)) {
      return false;
    }
  }
  settings = result;
  return true;
}

std::string user_path(const char* xdg, const char* home, std::string_view usual,
                      std::string_view name) {
  if (xdg != nullptr && *xdg == '/') {
    return fmt::format("{}/scenefile/{}", xdg, name);
  }
  if (home == nullptr || *home == '\0') {
    return {};
  }
  return fmt::format("{}/{}/scenefile/{}", home, usual, name);
}

Settings load_settings(const std::string& path, std::string& note) {
  constexpr std::uint64_t most = 1 << 16;
  Settings settings;
  if (path.empty() || !stamp_of(path).exists) {
    return settings;
  }
  const Result<std::string> text = read_file(path, most);
  if (!text) {
    note = "the settings cannot be read: " + text.error().text;
  } else if (!parse_settings(*text, settings)) {
    note = path + " is damaged; the settings are the defaults";
  }
  return settings;
}

std::string save_settings(const std::string& path, const Settings& settings) {
  if (path.empty()) {
    return {};
  }
  if (const Result<void> made = make_folder(folder_of(path)); !made) {
    return made.error().text;
  }
  return error_text(write_file(path, settings_text(settings)));
}

}  // namespace scenefile::viewer
