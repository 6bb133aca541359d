#include "scenefile/trace/render_options.h"

#include "scenefile/trace/layers.h"
#include "scenefile/trace/visit_options.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace scenefile {

namespace {

// Appends `name=value ` for each field that affects pixels, `outer.name=value ` for nested ones.
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
    if constexpr (std::is_arithmetic_v<T>) {
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
  void add(Profile profile) { add(profile_word(profile)); }
  void add(Mode mode) { add(mode_word(mode)); }
  void add(Convention convention) { add(convention_word(convention)); }
  void add(const std::vector<Layer>& layers) {
    std::vector<std::string> names;
    for (const Layer& layer : layers) {
      names.push_back(layer_name(layer));
    }
    const std::string list = fmt::format("{}", fmt::join(names, ","));
    add(list.empty() ? std::string_view("none") : std::string_view(list));
  }
  void add(std::string_view word) { text += fmt::format("{}={} ", prefix_, word); }

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

RenderOptions in_range(RenderOptions options) {
  visit_options(options, [](const OptionField& field, auto& value) {
    if constexpr (std::same_as<decltype(value), int&>) {
      value = std::clamp(value, field.least, field.most);
    }
  });
  options.min_samples = std::min(options.min_samples, options.samples);
  if (options.crop.has_value()) {
    PixelRegion& crop = *options.crop;
    crop.x0 = std::clamp(crop.x0, 0, options.width - 1);
    crop.y0 = std::clamp(crop.y0, 0, options.height - 1);
    crop.x1 = std::clamp(crop.x1, crop.x0 + 1, options.width);
    crop.y1 = std::clamp(crop.y1, crop.y0 + 1, options.height);
  }
  // The maximum ends paths in rooms that absorb nothing.
  options.continuation = std::clamp(options.continuation, 0.0, 0.99);
  options.clamp = std::max(options.clamp, 0.0);
  options.fresnel = options.fresnel && options.profile == Profile::fine;
  return options;
}

Rounding rounding_of(Profile profile) {
  return profile == Profile::course ? Rounding::truncate : Rounding::nearest;
}

OptionField option_field(std::string_view name) {
  OptionField found{name};
  const RenderOptions options;
  visit_options(options, [&](const OptionField& field, const auto&) {
    if (field.name == name) {
      found = field;
    }
  });
  return found;
}

OptionSupport support_of(std::string_view field) {
  return option_field(field).support;
}

std::string picture_key(const RenderOptions& options) {
  PictureKey key;
  visit_options(options, key);
  return key.text;
}

}  // namespace scenefile
