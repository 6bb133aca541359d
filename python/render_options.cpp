#include "render_options.h"

#include "scenefile/base/limits.h"
#include "scenefile/trace/features.h"
#include "scenefile/trace/layers.h"
#include "scenefile/trace/visit_options.h"
#include "values.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <pybind11/stl.h>

#include <array>
#include <limits>

namespace scenefile::python {

namespace {

int number(const char* name, const py::handle& value, int least, int most) {
  const long long n = value.cast<long long>();
  if (n < least || n > most) {
    throw py::value_error(fmt::format("{}: {} is not between {} and {}", name, n, least, most));
  }
  return static_cast<int>(n);
}

void set_size(RenderOptions& options, const py::handle& value) {
  const int most = static_cast<int>(Limits{}.image_side);
  const auto [width, height] = value.cast<std::array<py::object, 2>>();
  options.width = number("size", width, 1, most);
  options.height = number("size", height, 1, most);
}

void set_features(RenderOptions& options, const py::handle& value) {
  const std::string list = joined_words(value);
  if (const std::string_view wrong = parse_features(list, options); !wrong.empty()) {
    throw py::value_error(fmt::format("features: \"{}\" is not one of {}", wrong,
                                      fmt::join(feature_list_words(), ", ")));
  }
}

void set_layers(RenderOptions& options, const py::handle& value) {
  const std::string list = joined_words(value);
  options.layers.clear();
  if (list.empty()) {
    return;
  }
  if (const std::string_view wrong = parse_layers(list, options.layers); !wrong.empty()) {
    throw py::value_error(
        fmt::format("layers: \"{}\" is not one of depth, normal, uv, albedo, object-id, light-1, "
                    "light-2 and so on, shadow, reflection-depth, or is given twice",
                    wrong));
  }
}

void set_crop(RenderOptions& options, const py::handle& value) {
  if (value.is_none()) {
    return;
  }
  const auto [x0, y0, x1, y1] = value.cast<std::array<int, 4>>();
  options.crop = PixelRegion{x0, y0, x1, y1};
}

struct Option {
  const char* name;
  const char* field;
  void (*set)(RenderOptions& options, const py::handle& value);
};

// The profile comes first, because it determines the defaults of the others.
constexpr Option known_options[] = {
    {"profile", "profile", [](RenderOptions& /*options*/, const py::handle& /*value*/) {}},
    {"size", "width", set_size},
    {"mode", "mode",
     [](RenderOptions& o, const py::handle& v) {
       o.mode = from_word<Mode>("mode", v.cast<std::string_view>(), mode_words);
     }},
    {"features", "features", set_features},
    {"samples", "samples",
     [](RenderOptions& o, const py::handle& v) { o.samples = number("samples", v, 1, 1 << 20); }},
    {"min_samples", "min_samples",
     [](RenderOptions& o, const py::handle& v) {
       o.min_samples = number("min_samples", v, 1, 1 << 20);
     }},
    {"max_depth", "max_depth",
     [](RenderOptions& o, const py::handle& v) { o.max_depth = number("max_depth", v, 0, 64); }},
    {"seed", "seed",
     [](RenderOptions& o, const py::handle& v) { o.seed = v.cast<std::uint64_t>(); }},
    {"fresnel", "fresnel",
     [](RenderOptions& o, const py::handle& v) { o.fresnel = v.cast<bool>(); }},
    {"threads", "threads",
     [](RenderOptions& o, const py::handle& v) { o.threads = number("threads", v, 0, 1024); }},
    {"crop", "crop", set_crop},
    {"layers", "layers", set_layers},
    {"denoise", "denoise",
     [](RenderOptions& o, const py::handle& v) { o.denoise = v.cast<bool>(); }},
};

void check_crop(const RenderOptions& options) {
  if (!options.crop) {
    return;
  }
  const PixelRegion& c = *options.crop;
  if (c.x0 < 0 || c.y0 < 0 || c.x0 >= c.x1 || c.y0 >= c.y1 || c.x1 > options.width ||
      c.y1 > options.height) {
    throw py::value_error(
        fmt::format("crop: ({}, {}, {}, {}) is not a region (x0, y0, x1, y1) of a "
                    "picture of {}x{}",
                    c.x0, c.y0, c.x1, c.y1, options.width, options.height));
  }
}

}  // namespace

std::string joined_words(const py::handle& words) {
  if (py::isinstance<py::str>(words)) {
    return words.cast<std::string>();
  }
  std::string list;
  for (const py::handle word : words) {
    if (!list.empty()) {
      list += ',';
    }
    list += word.cast<std::string>();
  }
  return list;
}

RenderOptions render_options(const py::dict& given) {
  Profile profile = Profile::fine;
  if (given.contains("profile")) {
    profile = from_word<Profile>("profile", py::handle(given["profile"]).cast<std::string_view>(),
                                 profile_words);
  }
  RenderOptions options = default_options(profile);
  for (const auto& [key, value] : given) {
    const auto name = key.cast<std::string>();
    const Option* known = nullptr;
    for (const Option& option : known_options) {
      known = option.name == name ? &option : known;
    }
    if (known == nullptr) {
      throw py::type_error(fmt::format("a picture has no option {}", name));
    }
    if (!supports_option(profile, support_of(known->field))) {
      throw py::value_error(
          fmt::format("{} is for the profile fine: leave it out, or profile=\"{}\"", name,
                      profile_word(profile)));
    }
    try {
      known->set(options, value);
    } catch (const py::cast_error&) {
      throw py::type_error(
          fmt::format("{}: invalid value {}", name, py::repr(value).cast<std::string>()));
    }
  }
  check_crop(options);
  return options;
}

}  // namespace scenefile::python
