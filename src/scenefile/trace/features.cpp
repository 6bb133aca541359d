#include "scenefile/trace/features.h"

#include "scenefile/trace/visit_options.h"

#include <algorithm>
#include <array>
#include <optional>

namespace scenefile {

namespace {

constexpr Features no_matter;  // only used for the names

constexpr std::size_t feature_count = [] {
  std::size_t count = 0;
  visit_options(no_matter, [&](const OptionField&, bool) { ++count; });
  return count;
}();

constexpr std::array<std::string_view, feature_count> feature_names = [] {
  std::array<std::string_view, feature_count> result;
  std::size_t next = 0;
  visit_options(no_matter, [&](const OptionField& field, bool) { result[next++] = field.name; });
  return result;
}();

// A project of the course.
struct Project {
  std::string_view name;
  std::string_view features;
  std::optional<Mode> mode;
};
constexpr std::array projects{Project{"intersect", "none", Mode::intersect},
                              Project{"illuminate", "shadows,reflect,texture", std::nullopt}};

constexpr auto list_words = [] {
  std::array<std::string_view, feature_count + 2 + projects.size()> result;
  std::size_t next = 0;
  for (const std::string_view word : feature_names) {
    result[next++] = word;
  }
  result[next++] = "all";
  result[next++] = "none";
  for (const Project& project : projects) {
    result[next++] = project.name;
  }
  return result;
}();

Features with_all(bool on) {
  Features features;
  visit_options(features, [&](const OptionField&, bool& feature) { feature = on; });
  return features;
}

}  // namespace

std::span<const std::string_view> feature_words() {
  return feature_names;
}

std::span<const std::string_view> feature_list_words() {
  return list_words;
}

bool* find_feature(Features& features, std::string_view word) {
  bool* found = nullptr;
  visit_options(features, [&](const OptionField& field, bool& feature) {
    if (field.name == word) {
      found = &feature;
    }
  });
  return found;
}

std::string_view parse_features(std::string_view list, Features& features) {
  features = with_all(list == "all");
  if (list.empty() || list == "all" || list == "none") {
    return {};
  }
  while (true) {
    const std::size_t comma = std::min(list.find(','), list.size());
    const std::string_view word = list.substr(0, comma);
    bool* const field = find_feature(features, word);
    if (field == nullptr) {
      return word.empty() ? std::string_view(",") : word;
    }
    *field = true;
    if (comma == list.size()) {
      return {};
    }
    list.remove_prefix(comma + 1);
  }
}

std::string_view parse_features(std::string_view list, RenderOptions& options) {
  for (const Project& project : projects) {
    if (list == project.name) {
      options.mode = project.mode.value_or(options.mode);
      return parse_features(project.features, options.features);
    }
  }
  return parse_features(list, options.features);
}

std::string feature_list(const Features& features) {
  for (const bool on : {true, false}) {
    if (features == with_all(on)) {
      return on ? "all" : "none";
    }
  }
  for (const Project& project : projects) {
    Features named;
    parse_features(project.features, named);
    if (!project.mode && features == named) {
      return std::string(project.name);
    }
  }
  std::string list;
  visit_options(features, [&](const OptionField& field, bool on) {
    if (on) {
      list += list.empty() ? "" : ",";
      list += field.name;
    }
  });
  return list;
}

}  // namespace scenefile
