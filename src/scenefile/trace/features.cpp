#include "scenefile/trace/features.h"

#include <algorithm>
#include <array>

namespace scenefile {

namespace {

struct FeatureWord {
  std::string_view word;
  bool Features::*field;
};

constexpr std::array<FeatureWord, 7> table{{{"shadows", &Features::shadows},
                                            {"reflect", &Features::reflect},
                                            {"refract", &Features::refract},
                                            {"texture", &Features::texture},
                                            {"texture-filter", &Features::texture_filter},
                                            {"super-sample", &Features::super_sample},
                                            {"depthoffield", &Features::depthoffield}}};

constexpr std::array<std::string_view, table.size()> words = [] {
  std::array<std::string_view, table.size()> result;
  std::transform(table.begin(), table.end(), result.begin(),
                 [](const FeatureWord& w) { return w.word; });
  return result;
}();

Features with_all(bool on) {
  Features features;
  for (const FeatureWord& w : table) {
    features.*w.field = on;
  }
  return features;
}

}  // namespace

std::span<const std::string_view> feature_words() {
  return words;
}

bool* find_feature(Features& features, std::string_view word) {
  const auto found = std::find_if(table.begin(), table.end(),
                                  [&](const FeatureWord& w) { return w.word == word; });
  return found == table.end() ? nullptr : &(features.*found->field);
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

}  // namespace scenefile
