#include "scenefile/trace/render_options.h"

#include "scenefile/trace/visit_options.h"

#include <fmt/format.h>

namespace scenefile {

namespace {

// Appends `name=value ` for each field that changes pixels, of nested structs `outer.name=value `.
class PictureKey {
 public:
  template <typename T>
  void operator()(const OptionField& field, const T& value) {
    if (!field.changes_pixels) {
      return;
    }
    const std::size_t length = prefix_.size();
    prefix_ += field.name;
    add(value);
    prefix_.resize(length);
  }

  std::string text;

 private:
  template <typename T>
  void add(const T& value) {
    if constexpr (std::is_enum_v<T>) {
      text += fmt::format("{}={} ", prefix_, static_cast<int>(value));
    } else if constexpr (std::is_arithmetic_v<T>) {
      text += fmt::format("{}={} ", prefix_, value);
    } else {
      prefix_ += '.';
      visit_options(value, *this);
    }
  }
  template <typename T>
  void add(const std::optional<T>& value) {
    if (value.has_value()) {
      add(*value);
    } else {
      text += fmt::format("{}=none ", prefix_);
    }
  }
  template <typename T>
  void add(const std::vector<T>& values) {
    text += fmt::format("{}={} ", prefix_, values.size());
    for (const T& value : values) {
      add(value);
    }
  }

  std::string prefix_;
};

}  // namespace

RenderOptions default_options(Profile profile) {
  RenderOptions options;
  options.profile = profile;
  if (profile == Profile::course) {
    options.features.super_sample = false;
    options.max_depth = 4;
  }
  return options;
}

Rounding rounding_of(Profile profile) {
  return profile == Profile::course ? Rounding::truncate : Rounding::nearest;
}

KnownTo who_knows(std::string_view name) {
  KnownTo known;
  const RenderOptions options;
  visit_options(options, [&](const OptionField& field, const auto&) {
    if (field.name == name) {
      known = field.known;
    }
  });
  return known;
}

std::string picture_key(const RenderOptions& options) {
  PictureKey key;
  visit_options(options, key);
  return key.text;
}

}  // namespace scenefile
