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
#include <concepts>
#include <string>
#include <string_view>
#include <type_traits>

namespace scenefile::python {

namespace {

int number(std::string_view name, const py::handle& value, int least, int most) {
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
        fmt::format("layers: \"{}\" is not one of {} (light-2 and so on), or is given twice", wrong,
                    fmt::join(layer_words, ", ")));
  }
}

void set_crop(RenderOptions& options, const py::handle& value) {
  if (value.is_none()) {
    return;
  }
  const auto [x0, y0, x1, y1] = value.cast<std::array<int, 4>>();
  options.crop = PixelRegion{x0, y0, x1, y1};
}

// Options that are not simply numbers or flags.
struct SpecialOption {
  std::string_view name;
  std::string_view field;
  void (*set)(RenderOptions& options, const py::handle& value);
};
constexpr SpecialOption special_options[] = {
    // Determines the defaults of the others, so it was read before them.
    {"profile", "profile", [](RenderOptions& /*options*/, const py::handle& /*value*/) {}},
    {"size", "width", set_size},
    {"mode", "mode",
     [](RenderOptions& o, const py::handle& v) {
       o.mode = from_word<Mode>("mode", v.cast<std::string_view>(), mode_words);
     }},
    {"features", "features", set_features},
    {"crop", "crop", set_crop},
    {"layers", "layers", set_layers},
    {"continuation", "continuation",
     [](RenderOptions& o, const py::handle& v) {
       o.continuation = real_number("continuation", v, 0.01, 0.99);
     }},
    {"convention", "convention",
     [](RenderOptions& o, const py::handle& v) {
       o.convention =
           from_word<Convention>("convention", v.cast<std::string_view>(), convention_words);
     }},
    {"clamp", "clamp",
     [](RenderOptions& o, const py::handle& v) { o.clamp = real_number("clamp", v, 1e-3, 1e9); }},
};

// Returns whether it is a field for numbers or flags.
bool set_plain(RenderOptions& options, std::string_view name, const py::handle& value) {
  bool found = false;
  visit_options(options, [&](const OptionField& field, auto& member) {
    using T = std::remove_reference_t<decltype(member)>;
    if (field.name != name || name == "width" || name == "height") {
      return;
    }
    if constexpr (std::same_as<T, int>) {
      member = number(name, value, field.least, field.most);
      found = true;
    } else if constexpr (std::is_arithmetic_v<T>) {
      member = value.cast<T>();
      found = true;
    }
  });
  return found;
}

const SpecialOption* special_option(std::string_view name) {
  for (const SpecialOption& option : special_options) {
    if (option.name == name) {
      return &option;
    }
  }
  return nullptr;
}

OptionSupport support_for(std::string_view name) {
  const SpecialOption* const special = special_option(name);
  return support_of(special != nullptr ? special->field : name);
}

void set_option(RenderOptions& options, const std::string& name, const py::handle& value) {
  const SpecialOption* const special = special_option(name);
  if (!supports_option(options.profile, support_for(name))) {
    throw py::value_error(fmt::format("{} is for the profile fine: leave it out, or profile=\"{}\"",
                                      name, profile_word(options.profile)));
  }
  if (special != nullptr) {
    special->set(options, value);
  } else if (!set_plain(options, name, value)) {
    throw py::type_error(fmt::format("a picture has no option {}", name));
  }
}

// Empty if the mode has all given options and layers.
std::string unsupported_in(Mode mode, const RenderOptions& options, const py::dict& given) {
  for (const auto& [key, value] : given) {
    const auto name = key.cast<std::string>();
    if (!supports_option(mode, support_for(name))) {
      return mode == Mode::path
                 ? fmt::format("{} has no effect in mode path: leave it out", name)
                 : fmt::format("{} is for path tracing: leave it out, or add mode=\"path\"", name);
    }
  }
  for (const Layer& layer : options.layers) {
    if (!has_layer(mode, layer.kind)) {
      return mode == Mode::path ? fmt::format("layers: mode path has no {}", layer_name(layer))
                                : fmt::format(
                                      "layers: {} is a layer of path tracing: leave it "
                                      "out, or add mode=\"path\"",
                                      layer_name(layer));
    }
  }
  return {};
}

// Determines the mode, and its defaults.
void finish_mode(RenderOptions& options, const py::dict& given, bool lit_by_faces_only) {
  if (lit_by_faces_only && !given.contains("mode") && options.profile == Profile::fine &&
      unsupported_in(Mode::path, options, given).empty()) {
    options.mode = Mode::path;
  }
  if (const std::string wrong = unsupported_in(options.mode, options, given); !wrong.empty()) {
    throw py::value_error(wrong);
  }
  if (options.mode != Mode::path) {
    return;
  }
  if (options.profile != Profile::fine) {
    throw py::value_error(
        fmt::format("mode: path is for the profile fine: leave it out, or profile=\"{}\"",
                    profile_word(options.profile)));
  }
  options.samples = given.contains("samples") ? options.samples : path_samples;
  options.max_depth = given.contains("max_depth") ? options.max_depth : path_max_depth;
}

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

double real_number(std::string_view name, const py::handle& value, double least, double most) {
  const auto n = value.cast<double>();
  if (!(n >= least && n <= most)) {
    throw py::value_error(fmt::format("{}: {} is not between {} and {}", name, n, least, most));
  }
  return n;
}

bool asks_for_paths(const py::dict& given) {
  return given.contains("mode") && py::isinstance<py::str>(given["mode"]) &&
         py::handle(given["mode"]).cast<std::string_view>() == mode_word(Mode::path);
}

RenderOptions render_options(const py::dict& given, bool lit_by_faces_only) {
  Profile profile = Profile::fine;
  if (given.contains("profile")) {
    profile = from_word<Profile>("profile", py::handle(given["profile"]).cast<std::string_view>(),
                                 profile_words);
  }
  RenderOptions options = default_options(profile);
  for (const auto& [key, value] : given) {
    const auto name = key.cast<std::string>();
    try {
      set_option(options, name, value);
    } catch (const py::cast_error&) {
      throw py::type_error(
          fmt::format("{}: invalid value {}", name, py::repr(value).cast<std::string>()));
    }
  }
  check_crop(options);
  finish_mode(options, given, lit_by_faces_only);
  return options;
}

}  // namespace scenefile::python
