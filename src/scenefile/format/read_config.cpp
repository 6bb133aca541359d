#include "scenefile/format/read_config.h"

#include "scenefile/base/number.h"
#include "scenefile/base/suggest.h"
#include "scenefile/base/text.h"
#include "scenefile/format/codes.h"
#include "scenefile/format/ini.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <utility>
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
struct Feature {  // named by its key
  bool affects_picture = true;
};
using Depth = std::optional<int> CourseConfig::*;
struct Count {
  int CourseConfig::*number;
  int most;
};
using Probability = float CourseConfig::*;

constexpr int max_bounces = 64;

// What it means if a key is not given.
enum class Absence : std::uint8_t { allowed, warning, error };

constexpr std::optional<ConfigKind> any_kind;

struct Key {
  std::string_view name;  // "Section/key"
  std::variant<Path, Size, Switch, Feature, Depth, Count, Probability> field;
  std::optional<ConfigKind> kind = ConfigKind::ray;  // that it belongs to
  Absence absence = Absence::allowed;
};

const std::array keys{
    Key{"IO/scene", Path{&CourseConfig::scene, &CourseConfig::scene_place}, any_kind,
        Absence::error},
    Key{"IO/output", Path{&CourseConfig::output, &CourseConfig::output_place}, any_kind,
        Absence::error},
    Key{"Canvas/width", &CourseConfig::width, ConfigKind::ray, Absence::error},
    Key{"Canvas/height", &CourseConfig::height, ConfigKind::ray, Absence::error},
    Key{"Feature/shadows", Feature{}},
    Key{"Feature/reflect", Feature{}},
    Key{"Feature/refract", Feature{}},
    Key{"Feature/texture", Feature{}},
    Key{"Feature/texture-filter", Feature{}},
    Key{"Feature/super-sample", Feature{}},
    Key{"Feature/depthoffield", Feature{}},
    Key{"Feature/parallel", Feature{false}},
    Key{"Feature/acceleration", Feature{false}},
    Key{"Settings/maximum-recursive-depth", &CourseConfig::maximum_recursive_depth},
    Key{"Settings/only-render-normals", &CourseConfig::only_render_normals},
    Key{"Settings/imageWidth", &CourseConfig::width, ConfigKind::path, Absence::error},
    Key{"Settings/imageHeight", &CourseConfig::height, ConfigKind::path, Absence::error},
    Key{"Settings/samplesPerPixel", Count{&CourseConfig::samples_per_pixel, 65536},
        ConfigKind::path, Absence::warning},
    Key{"Settings/pathContinuationProb", &CourseConfig::path_continuation_prob, ConfigKind::path,
        Absence::warning},
    Key{"Settings/directLightingOnly", &CourseConfig::direct_lighting_only, ConfigKind::path,
        Absence::warning},
    Key{"Settings/numDirectLightingSamples",
        Count{&CourseConfig::num_direct_lighting_samples, 1024}, ConfigKind::path,
        Absence::warning},
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
    diagnostics.report("config.value"_code, entry.value_place,
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

  void set(const IniEntry& entry, const Key& key, const Count& field) const {
    int number = 1;
    if (read_number(entry, key, 0, field.most, number) && number == 0) {
      diagnostics.report("config.zero"_code, entry.value_place,
                         fmt::format("0 for {} counts as 1", shown(key.name)));
    }
    config.*field.number = std::max(number, 1);
  }

  void set(const IniEntry& entry, const Key& key, Probability field) const {
    const ParsedNumber number = parse_number(entry.value);
    if (number.error != NumberError::none || number.value < 0 || number.value > 1) {
      fail(entry, key, "a probability from 0 to 1");
      return;
    }
    config.*field = static_cast<float>(number.value);
  }

  bool read_switch(const IniEntry& entry, const Key& key) const {
    const std::string word = lower_case(entry.value);
    const bool on = word == "true" || word == "1";
    if (!on && word != "false" && word != "0" && !word.empty()) {
      fail(entry, key, "true or false");
    }
    return on;
  }

  void set(const IniEntry& entry, const Key& key, Switch field) const {
    config.*field = read_switch(entry, key);
  }

  void set(const IniEntry& entry, const Key& key, Feature feature) const {
    const std::string_view name = key.name.substr(key.name.find('/') + 1);
    std::erase(config.features, name);
    if (read_switch(entry, key) && feature.affects_picture) {
      config.features.push_back(name);
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
      "config.unknown-key"_code, entry.key_place,
      fmt::format("unknown key {} has no effect{}", shown(name),
                  nearest.empty() ? "" : fmt::format("; did you mean {}?", shown(nearest))),
      correction(name, nearest, known));
}

// Whether a key or section is one of a configuration. Only then do findings show the text.
bool is_of_config(const IniEntry& entry) {
  const std::string name = lower_case(name_of(entry));
  return std::any_of(keys.begin(), keys.end(), [&](const Key& key) {
    const std::string known = lower_case(key.name);
    return name.substr(0, name.find('/')) == known.substr(0, known.find('/'));
  });
}

// An entry and what it sets; null if the key is unknown.
struct KnownEntry {
  IniEntry entry;
  std::string name;
  const Key* key = nullptr;
};

std::vector<KnownEntry> known_entries(std::vector<IniEntry> entries) {
  std::vector<KnownEntry> known;
  for (IniEntry& entry : entries) {
    std::string name = name_of(entry);
    const auto* const key = std::find_if(
        keys.begin(), keys.end(), [&](const Key& k) { return equal_ignoring_case(k.name, name); });
    known.push_back({std::move(entry), std::move(name), key == keys.end() ? nullptr : key});
  }
  return known;
}

// nullopt: no key tells.
std::optional<ConfigKind> kind_of(const std::vector<KnownEntry>& entries) {
  const auto count = [&](ConfigKind kind) {
    return std::count_if(entries.begin(), entries.end(), [&](const KnownEntry& e) {
      return e.key != nullptr && e.key->kind == kind;
    });
  };
  const auto paths = count(ConfigKind::path);
  const auto rays = count(ConfigKind::ray);
  return paths > rays ? ConfigKind::path : rays > 0 ? std::optional(ConfigKind::ray) : std::nullopt;
}

void report_missing(const Key& key, bool damaged, Diagnostics& diagnostics) {
  const std::string text = fmt::format("the configuration is missing {}", shown(key.name));
  if (damaged) {
    return;
  }
  if (key.absence == Absence::warning) {
    diagnostics.report("config.missing-key"_code, Severity::warning, {},
                       fmt::format("{}; it counts as {}", text,
                                   std::holds_alternative<Switch>(key.field)  ? "false"
                                   : std::holds_alternative<Count>(key.field) ? "1"
                                                                              : "0"));
  } else if (key.absence == Absence::error) {
    diagnostics.report("config.missing-key"_code, {}, text);
  }
}

}  // namespace

CourseConfig read_config(std::string_view text, const Limits& limits, Diagnostics& diagnostics,
                         std::optional<ConfigKind> program) {
  CourseConfig config;
  const ConfigReader reader{config, limits, diagnostics};
  Diagnostics found;
  std::vector<IniEntry> read = read_ini(text, found);
  if (std::none_of(read.begin(), read.end(), is_of_config)) {
    diagnostics.report("config.missing-key"_code, {},
                       text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff")
                           ? "the configuration is in UTF-16; save it as UTF-8"
                           : "not a configuration: it has no key in a section [IO], [Canvas], "
                             "[Feature] or [Settings]");
    return config;
  }
  for (const Diagnostic& d : found.list()) {
    diagnostics.add(d);
  }
  const std::vector<KnownEntry> entries = known_entries(std::move(read));
  const std::optional<ConfigKind> kind = kind_of(entries);
  config.kind = kind.value_or(program.value_or(ConfigKind::ray));
  std::array<bool, keys.size()> given{};
  for (const KnownEntry& known : entries) {
    const IniEntry& entry = known.entry;
    const Key* const key = known.key;
    if (key == nullptr) {
      report_unknown(entry, known.name, diagnostics);
      continue;
    }
    if (key->kind.value_or(config.kind) != config.kind) {
      const bool path = config.kind == ConfigKind::path;
      diagnostics.report(
          "config.unknown-key"_code, entry.key_place,
          fmt::format("{} has no effect: it belongs to the {} tracer, and this is a "
                      "configuration of the {} tracer",
                      shown(key->name), path ? "ray" : "path", path ? "path" : "ray"));
      continue;
    }
    if (key->name != known.name) {
      diagnostics.report("config.key-case"_code, entry.key_place,
                         fmt::format("{} is read as {}", shown(known.name), shown(key->name)));
    }
    bool& seen = given[static_cast<std::size_t>(key - keys.data())];
    if (seen) {
      diagnostics.report("config.duplicate-key"_code, entry.key_place,
                         fmt::format("{} is given again; this one counts", shown(key->name)));
    }
    seen = true;
    std::visit([&](const auto& field) { reader.set(entry, *key, field); }, key->field);
  }
  // Keys on lines that could not be read are not reported as missing.
  const bool damaged = diagnostics.has_errors();
  const bool known = kind || program;
  for (std::size_t i = 0; i < keys.size(); ++i) {
    if (!given[i] && (known ? keys[i].kind.value_or(config.kind) == config.kind : !keys[i].kind)) {
      report_missing(keys[i], damaged, diagnostics);
    }
  }
  if (!known && !damaged) {
    diagnostics.report("config.missing-key"_code, {},
                       "the configuration is missing the size of the picture: [Canvas] width and "
                       "height for the ray tracer, [Settings] imageWidth and imageHeight for the "
                       "path tracer");
  }
  return config;
}

}  // namespace scenefile
