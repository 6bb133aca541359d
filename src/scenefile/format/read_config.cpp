#include "scenefile/format/read_config.h"

#include "scenefile/base/suggest.h"
#include "scenefile/base/text.h"
#include "scenefile/format/codes.h"
#include "scenefile/format/ini.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <variant>
#include <vector>

namespace scenefile {

namespace {

struct Path {
  std::string CourseConfig::*text;
  Location CourseConfig::*place;
};
using Size = int CourseConfig::*;
using Switch = bool CourseConfig::*;
using Depth = std::optional<int> CourseConfig::*;

constexpr int max_bounces = 64;

struct Key {
  std::string_view name;  // "Section/key"
  std::variant<Path, Size, Switch, Depth> field;
  bool required = false;
};

const std::array keys{
    Key{"IO/scene", Path{&CourseConfig::scene, &CourseConfig::scene_place}, true},
    Key{"IO/output", Path{&CourseConfig::output, &CourseConfig::output_place}, true},
    Key{"Canvas/width", &CourseConfig::width, true},
    Key{"Canvas/height", &CourseConfig::height, true},
    Key{"Feature/shadows", &CourseConfig::shadows},
    Key{"Feature/reflect", &CourseConfig::reflect},
    Key{"Feature/refract", &CourseConfig::refract},
    Key{"Feature/texture", &CourseConfig::texture},
    Key{"Feature/texture-filter", &CourseConfig::texture_filter},
    Key{"Feature/super-sample", &CourseConfig::super_sample},
    Key{"Feature/depthoffield", &CourseConfig::depthoffield},
    Key{"Feature/parallel", &CourseConfig::parallel},
    Key{"Feature/acceleration", &CourseConfig::acceleration},
    Key{"Settings/maximum-recursive-depth", &CourseConfig::maximum_recursive_depth},
    Key{"Settings/only-render-normals", &CourseConfig::only_render_normals},
};

// A key for messages: "[IO] scene".
std::string shown(std::string_view name) {
  const std::size_t slash = name.find('/');
  return slash == std::string_view::npos
             ? escaped(name, 40)
             : fmt::format("[{}] {}", escaped(name.substr(0, slash), 40),
                           escaped(name.substr(slash + 1), 40));
}

// As in QSettings, keys before any section may name their section themselves, and General is the
// unnamed section.
std::string name_of(const IniEntry& entry) {
  return entry.section.empty() || lower_case(entry.section) == "general"
             ? entry.key
             : entry.section + "/" + entry.key;
}

struct ConfigReader {
  CourseConfig& config;
  const Limits& limits;
  Diagnostics& diagnostics;

  void fail(const IniEntry& entry, const Key& key, std::string_view expected) const {
    diagnostics.report(config_value, entry.value_place,
                       fmt::format("found {} for {}, expected {}", quoted(entry.value),
                                   shown(key.name), expected));
  }

  bool read_number(const IniEntry& entry, const Key& key, int least, int most, int& number) const {
    const char* const end = entry.value.data() + entry.value.size();
    int read = 0;
    const auto [rest, error] = std::from_chars(entry.value.data(), end, read);
    if (error != std::errc() || rest != end || read < least || read > most) {
      fail(entry, key, fmt::format("a whole number from {} to {}", least, most));
      return false;
    }
    number = read;
    return true;
  }

  void set(const IniEntry& entry, const Key& key, const Path& field) const {
    if (entry.value.empty() || entry.value.size() > limits.name_bytes ||
        entry.value.find('\0') != std::string::npos) {
      fail(entry, key, "a path");
    }
    config.*field.text = entry.value;
    config.*field.place = entry.value_place;
  }

  void set(const IniEntry& entry, const Key& key, Size field) const {
    read_number(entry, key, 1, static_cast<int>(limits.image_side), config.*field);
  }

  void set(const IniEntry& entry, const Key& key, Depth field) const {
    int number = 0;
    if (read_number(entry, key, 0, max_bounces, number)) {
      config.*field = number;
    }
  }

  void set(const IniEntry& entry, const Key& key, Switch field) const {
    const std::string word = lower_case(entry.value);
    config.*field = word == "true" || word == "1";
    if (!(config.*field) && word != "false" && word != "0" && !word.empty()) {
      fail(entry, key, "true or false");
    }
  }
};

void report_unknown(const IniEntry& entry, const std::string& name, Diagnostics& diagnostics) {
  std::vector<std::string_view> known;
  for (const Key& key : keys) {
    known.push_back(key.name);
  }
  const std::string_view nearest = nearest_name(name, known);
  diagnostics.report(
      config_unknown_key, entry.key_place,
      fmt::format("unknown key {} has no effect{}", shown(name),
                  nearest.empty() ? "" : fmt::format("; did you mean {}?", shown(nearest))));
}

// Whether a key or section is one of a configuration. Only then do findings show the text.
bool is_of_config(const IniEntry& entry) {
  const std::string name = lower_case(name_of(entry));
  return std::any_of(keys.begin(), keys.end(), [&](const Key& key) {
    const std::string known = lower_case(key.name);
    return name.substr(0, name.find('/')) == known.substr(0, known.find('/'));
  });
}

}  // namespace

CourseConfig read_config(std::string_view text, const Limits& limits, Diagnostics& diagnostics) {
  CourseConfig config;
  const ConfigReader reader{config, limits, diagnostics};
  std::array<bool, keys.size()> given{};
  Diagnostics found;
  const std::vector<IniEntry> entries = read_ini(text, found);
  if (std::none_of(entries.begin(), entries.end(), is_of_config)) {
    diagnostics.report(config_missing_key, {},
                       "not a configuration: it has no key in a section [IO], [Canvas], [Feature] "
                       "or [Settings]");
    return config;
  }
  for (const Diagnostic& d : found.list()) {
    diagnostics.add(d);
  }
  for (const IniEntry& entry : entries) {
    const std::string name = name_of(entry);
    const auto key = std::find_if(keys.begin(), keys.end(), [&](const Key& k) {
      return lower_case(k.name) == lower_case(name);
    });
    if (key == keys.end()) {
      report_unknown(entry, name, diagnostics);
      continue;
    }
    if (key->name != name) {
      diagnostics.report(config_key_case, entry.key_place,
                         fmt::format("{} is read as {}", shown(name), shown(key->name)));
    }
    bool& seen = given[static_cast<std::size_t>(key - keys.begin())];
    if (seen) {
      diagnostics.report(config_duplicate_key, entry.key_place,
                         fmt::format("{} is given again; this one counts", shown(key->name)));
    }
    seen = true;
    std::visit([&](const auto& field) { reader.set(entry, *key, field); }, key->field);
  }
  // Keys on lines that could not be read are not reported as missing.
  const bool damaged = diagnostics.has_errors();
  for (std::size_t i = 0; i < keys.size(); ++i) {
    if (keys[i].required && !given[i] && !damaged) {
      diagnostics.report(config_missing_key, {},
                         fmt::format("the configuration is missing {}", shown(keys[i].name)));
    }
  }
  return config;
}

}  // namespace scenefile
