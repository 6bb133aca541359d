#include "app/option_table.h"

#include "app/command.h"
#include "app/limit_table.h"
#include "app/names.h"
#include "scenefile/asset/image_file.h"
#include "scenefile/base/limits.h"
#include "scenefile/base/number.h"
#include "scenefile/base/suggest.h"
#include "scenefile/base/text.h"
#include "scenefile/io/folder.h"
#include "scenefile/trace/bands.h"
#include "scenefile/trace/features.h"
#include "scenefile/trace/layers.h"
#include "scenefile/verbs/codes.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <type_traits>

namespace scenefile::app {

namespace {

// A field of Options: at<&Options::render, &RenderOptions::seed>(options).
template <auto... path>
auto& at(Options& options) {
  return (options.*....*path);
}

// Parses an integer in [min, max]; returns an error text otherwise.
template <typename T>
std::string set_number(const std::string& value, std::type_identity_t<T> min,
                       std::type_identity_t<T> max, T& number) {
  const char* const end = value.data() + value.size();
  T read{};
  const auto [rest, error] = std::from_chars(value.data(), end, read);
  if (error != std::errc() || rest != end || read < min || read > max) {
    return fmt::format("{} is not a whole number from {} to {}", quoted(value), min, max);
  }
  number = read;
  return {};
}

template <typename T>
std::string set_number(const std::string& value, std::type_identity_t<T> min,
                       std::type_identity_t<T> max, std::optional<T>& number) {
  return set_number(value, min, max, number.emplace());
}

template <auto min, auto max, auto... path>
std::string set_whole(Options& options, const std::string& value) {
  return set_number(value, min, max, at<path...>(options));
}

// Parses two integers in [min, max]. `what`: what the value should be, such as "a pixel such as
// 320,240".
std::string set_two(const std::string& value, std::string_view separators, std::string_view what,
                    int min, int max, int& first, int& second) {
  const std::size_t at = value.find_first_of(separators);
  if (at == std::string::npos) {
    return fmt::format("{} is not {}", quoted(value), what);
  }
  std::string wrong = set_number(value.substr(0, at), min, max, first);
  return wrong.empty() ? set_number(value.substr(at + 1), min, max, second) : wrong;
}

// Parses a number in the range of its field.
template <int RenderOptions::*member>
std::string set_field(Options& options, const std::string& value) {
  std::string wrong;
  RenderOptions& render = options.render;
  visit_options(render, [&](const OptionField& field, auto& number) {
    if constexpr (std::same_as<decltype(number), int&>) {
      if (&number == &(render.*member)) {
        wrong = set_number(value, field.least, field.most, number);
      }
    }
  });
  return wrong;
}

// "unknown profile "corse"; did you mean course?", or the list of words.
std::string unknown_word(std::string_view what, std::string_view word,
                         std::span<const std::string_view> known) {
  const std::string nearest = did_you_mean(word, known);
  return fmt::format(
      "unknown {} {}{}", what, quoted(word),
      nearest.empty() ? fmt::format("; known: {}", fmt::join(known, ", ")) : nearest);
}

// The words of an enumeration, in its order, and what they name.
struct WordList {
  std::string_view what;
  std::span<const std::string_view> words;
};
// Those of --profile: the ray tracer's, and the one for OpenGL.
constexpr std::array<std::string_view, 3> profile_choices{profile_words[0], profile_words[1],
                                                          "realtime"};
constexpr std::array<std::string_view, 1> dialect_words{"course"};
constexpr WordList engines{"engine", engine_words};
constexpr WordList filters{"filter", filter_words};
constexpr WordList milestones{"milestone", milestone_words};
constexpr WordList modes{"mode", mode_words};
constexpr WordList conventions{"convention", convention_words};
constexpr WordList tones{"tone", tone_words};
constexpr WordList formats{"format", format_words};
constexpr WordList shells{"shell", shell_words};

// Parses a word of a list to its index; returns an error text otherwise.
std::string find_word(const WordList& list, const std::string& value, std::size_t& index) {
  const auto found = std::find(list.words.begin(), list.words.end(), value);
  index = static_cast<std::size_t>(found - list.words.begin());
  return found == list.words.end() ? unknown_word(list.what, value, list.words) : std::string();
}

template <typename Enum>
void set_enumerator(Enum& field, std::size_t index) {
  field = static_cast<Enum>(index);
}
template <typename Enum>
void set_enumerator(std::optional<Enum>& field, std::size_t index) {
  field = static_cast<Enum>(index);
}

template <const WordList& list, auto... path>
std::string set_word(Options& options, const std::string& value) {
  std::size_t index = 0;
  std::string wrong = find_word(list, value, index);
  set_enumerator(at<path...>(options), index);
  return wrong;
}
template <const WordList& list, auto... path>
constexpr OptionParser word{set_word<list, path...>, list.words};

// Checks the syntax of a list, which must be a single argument. The shell splits a list with
// spaces, such as "shadows, reflect", into the list "shadows," and the argument "reflect".
std::string check_list(const std::string& value, std::string_view example) {
  const bool blank = value.find_first_of(" \t") != std::string::npos;
  if (blank || value.starts_with(',') || value.ends_with(',') ||
      value.find(",,") != std::string::npos) {
    return fmt::format("write the list {} with commas and without spaces, such as {}",
                       quoted(value), example);
  }
  return {};
}

constexpr int max_side = 1 << 20;  // options.load.limits is checked later, when it is complete

std::string set_size(Options& options, const std::string& value) {
  return set_two(value, "xX", "a size such as 1024x768", 1, max_side, options.render.width,
                 options.render.height);
}

std::string set_window(Options& options, const std::string& value) {
  auto& [width, height] = options.window;
  std::string wrong = set_two(value, "xX", "a size such as 1024x768", 1, max_side, width, height);
  return wrong.empty() && (width > 16384 || height > 16384)
             ? fmt::format("{} is larger than 16384x16384", quoted(value))
             : wrong;
}

std::string set_pixel(Options& options, const std::string& value) {
  if (std::string wrong = check_list(value, "320,240"); !wrong.empty()) {
    return wrong;
  }
  PixelPlace& pixel = options.pixel.emplace();
  return set_two(value, ",", "a pixel such as 320,240", 0,
                 static_cast<int>(Limits{}.image_side) - 1, pixel.x, pixel.y);
}

std::string set_profile(Options& options, const std::string& value) {
  std::size_t index = 0;
  std::string wrong = find_word({"profile", profile_choices}, value, index);
  options.realtime = index == profile_words.size();
  options.render = default_options(options.realtime ? Profile::fine : static_cast<Profile>(index));
  return wrong;
}

std::string set_parameters(Options& options, const std::string& value) {
  TessellationParameters& parameters = options.realtime_panel.tessellation;
  return set_two(value, ",", "two parameters such as 5,5", 1, max_tessellation,
                 parameters.parameter1, parameters.parameter2);
}

template <double RealtimeOptions::*depth>
std::string set_depth(Options& options, const std::string& value) {
  constexpr double most = 1e9;
  const ParsedNumber number = parse_number(value);
  options.realtime_panel.*depth = number.value;
  if (number.error != NumberError::none || !(number.value > 0 && number.value <= most)) {
    return fmt::format("{} is not a depth above 0 and up to {:g}", quoted(value), most);
  }
  return {};
}

std::string set_features(Options& options, const std::string& value) {
  if (std::string wrong = check_list(value, "shadows,reflect"); !wrong.empty()) {
    return wrong;
  }
  const std::string_view unknown = parse_features(value, options.render);
  if (unknown.empty()) {
    return {};
  }
  const auto alone = feature_list_words().subspan(feature_words().size());
  return std::find(alone.begin(), alone.end(), unknown) == alone.end()
             ? unknown_word("feature", unknown, feature_list_words())
             : fmt::format("{} cannot be combined with other words", unknown);
}

std::string set_compat(Options& options, const std::string& value) {
  options.load.compat_course = value == dialect_words[0];
  return options.load.compat_course ? "" : unknown_word("dialect", value, dialect_words);
}

std::string set_deny(Options& options, const std::string& value) {
  if (value == "warnings") {
    options.policy.deny_warnings = true;
  } else if (const Code* const code = find_code(value); code != nullptr) {
    options.policy.denied.emplace_back(code->name);
  } else {
    return fmt::format("{} is neither warnings nor a code{}", quoted(value),
                       did_you_mean(value, code_names()));
  }
  return {};
}

std::string set_allow(Options& options, const std::string& value) {
  const Code* const code = find_code(value);
  if (code == nullptr) {
    return fmt::format("unknown code {}{}", quoted(value), did_you_mean(value, code_names()));
  }
  if (code->severity == Severity::error) {
    return fmt::format("{} is an error: a scene that has it cannot be used", value);
  }
  options.policy.allowed.emplace_back(code->name);
  return {};
}

std::string set_limit_option(Options& options, const std::string& value) {
  return set_limit(options.load.limits, value);
}

std::string set_max_memory(Options& options, const std::string& value) {
  return parse_bytes(value, std::uint64_t{16} << 20, std::uint64_t{1} << 50,
                     options.max_memory.emplace());
}

std::string set_timeout(Options& options, const std::string& value) {
  constexpr double most = 1e7;
  const ParsedNumber number = parse_number(value);
  options.timeout = number.value;
  if (number.error != NumberError::none || !(number.value > 0 && number.value <= most)) {
    return fmt::format("{} is not a number of seconds above 0 and up to {:.0f}", quoted(value),
                       most);
  }
  return {};
}

std::string set_layers(Options& options, const std::string& value) {
  if (std::string wrong = check_list(value, "depth,normal"); !wrong.empty()) {
    return wrong;
  }
  const std::string_view wrong = parse_layers(value, options.render.layers);
  if (wrong.empty()) {
    return {};
  }
  const bool known = std::any_of(options.render.layers.begin(), options.render.layers.end(),
                                 [&](const Layer& layer) { return layer_name(layer) == wrong; });
  return known ? fmt::format("{} is in the list twice", wrong)
               : unknown_word("layer", wrong, layer_words);
}

std::string set_crop(Options& options, const std::string& value) {
  if (std::string wrong = check_list(value, "100,50,300,200"); !wrong.empty()) {
    return wrong;
  }
  PixelRegion& crop = options.render.crop.emplace();
  std::string_view rest = value;
  for (int* const side : {&crop.x0, &crop.y0, &crop.x1, &crop.y1}) {
    const std::size_t comma = side == &crop.y1 ? rest.size() : rest.find(',');
    if (comma == std::string_view::npos) {
      return fmt::format("{} is not a region such as 100,50,300,200", quoted(value));
    }
    const std::string number(rest.substr(0, comma));
    if (std::string wrong = set_number(number, 0, 1 << 20, *side); !wrong.empty()) {
      return wrong;
    }
    rest.remove_prefix(std::min(rest.size(), comma + 1));
  }
  return crop.width() > 0 && crop.height() > 0
             ? std::string()
             : fmt::format("{} contains no pixels: x1 and y1 must be larger than x0 and y0",
                           quoted(value));
}

std::string set_part(Options& options, const std::string& value) {
  const std::size_t slash = value.find('/');
  PartPlace& part = options.part.emplace();
  std::string wrong =
      slash == std::string::npos
          ? fmt::format("{} is not a share such as 3/64", quoted(value))
          : set_number(value.substr(slash + 1), std::uint32_t{1}, max_shares, part.count);
  if (wrong.empty()) {
    wrong = set_number(value.substr(0, slash), std::uint32_t{1}, part.count, part.index);
    part.index -= wrong.empty() ? 1 : 0;
  }
  return wrong;
}

std::string set_range(Options& options, const std::string& value) {
  const std::size_t colon = value.find(':');
  if (colon == std::string::npos) {
    return fmt::format("{} is not a range such as 1:48", quoted(value));
  }
  FrameRange& range = options.range.emplace();
  std::string wrong = set_number(value.substr(0, colon), 1, 1000000, range.first);
  return wrong.empty() ? set_number(value.substr(colon + 1), range.first, 1000000, range.last)
                       : wrong;
}

std::string add_asset_root(Options& options, const std::string& value) {
  options.access.roots.push_back(value);
  return is_folder(value) ? std::string()
                          : fmt::format("the folder {} does not exist", quoted(value));
}

template <std::string Options::*name>
std::string set_name(Options& options, const std::string& value) {
  options.*name = value;
  return value.empty() ? "the name is empty" : "";
}

constexpr std::string_view svg_ending = ".svg";
constexpr std::string_view png_ending = ".png";

template <const std::string_view& ending, std::string Options::*name>
std::string set_file(Options& options, const std::string& value) {
  options.*name = value;
  return lower_case(value).ends_with(ending)
             ? ""
             : fmt::format("{} does not end in {}", quoted(value, 400), ending);
}

// Parses a number in [min, max].
std::string read_number(const std::string& value, double min, double max, double& number) {
  const ParsedNumber parsed = parse_number(value);
  number = parsed.value;
  if (parsed.error != NumberError::none || number < min || number > max) {
    return fmt::format("{} is not a number from {:g} to {:g}", quoted(value), min, max);
  }
  return {};
}

template <std::optional<double> Thresholds::*threshold, int max>
std::string set_threshold(Options& options, const std::string& value) {
  return read_number(value, 0, max, (options.thresholds.*threshold).emplace());
}

std::string set_max_share(Options& options, const std::string& value) {
  double& share = options.thresholds.max_share.emplace();
  std::string wrong = read_number(value, 0, 100, share);
  share /= 100;
  return wrong;
}

template <bool on, auto... path>
std::string set_flag(Options& options, const std::string& /*value*/) {
  at<path...>(options) = on;
  return {};
}

constexpr std::array picture_options{
    OptionRow{"--size", "", "WxH", "Size in pixels (default 1024x768).", for_tracing, set_size,
              "width"},
    OptionRow{
        "--crop", "", "X0,Y0,X1,Y1",
        "Draw only the pixels from column X0 and row Y0 up to, but not including, X1 and Y1 (row 0 "
        "at the top), exactly as in the whole picture; the file has the size of the region.",
        for_render | for_frames, set_crop, "crop"},
    OptionRow{"--pixel", "", "X,Y",
              "The pixel to explain; 0,0 is the one at the top left. Required.", for_explain,
              set_pixel},
    OptionRow{"--sample", "", "N",
              "Show sample N of the pixel in full, counted from 0 (default: the one nearest to its "
              "center; with --profile realtime the one with the largest weight).",
              for_explain, set_whole<0, 0x7fffffff, &Options::sample>},
    OptionRow{"--engine", "", "NAME",
              "trace (default): the ray tracer. gl: OpenGL, fast and without a window, but without "
              "reflections, refraction and depth of field.",
              for_render | for_frames, word<engines, &Options::engine>},
    OptionRow{"--profile",
              "",
              "NAME",
              "fine (default): the lighting equation of the course with good sampling. course: the "
              "pixels of the course's ray tracer; implies --compat course. realtime: those of the "
              "course's assignment Realtime, by OpenGL; implies --compat course.",
              for_realtime,
              OptionParser{set_profile, profile_choices},
              "profile",
              {},
              true},
    OptionRow{
        "--mode", "", "NAME",
        "ray (default), intersect (the course's ray caster: no shadows, reflections or textures), "
        "normals (colors are normals), or path (path tracing; the default if the scene has no "
        "lights, but faces of meshes that emit light).",
        for_tracing | for_pictures | for_view, word<modes, &Options::render, &RenderOptions::mode>,
        "mode"},
    OptionRow{
        "--features", "", "LIST",
        "Features to use, separated by commas: shadows, reflect, refract, texture, texture-filter, "
        "super-sample, depthoffield; or all, or none; or a project of the course: intersect (also "
        "sets --mode) or illuminate. Default: all, for course without super-sample.",
        for_tracing | for_convert | for_pictures | for_view, set_features, "features"},
    OptionRow{"--fresnel", "", "",
              "Glass reflects light according to Fresnel's equations, for the profile fine.",
              for_tracing, set_flag<true, &Options::render, &RenderOptions::fresnel>, "fresnel"},
    OptionRow{"--max-depth", "", "N",
              "Maximum number of reflections and refractions in a row (default: fine 16, course 4; "
              "with --mode path 0, which is no maximum).",
              for_tracing | for_convert | for_pictures | for_view,
              set_field<&RenderOptions::max_depth>, "max_depth"},
    OptionRow{"--segments", "", "N",
              "Segments of a full turn of round shapes, for output in glTF and OBJ (default 64).",
              for_convert, set_whole<3, 1024, &Options::segments>},
};

constexpr std::array realtime_options{
    OptionRow{
        "--milestone", "", "NAME",
        "With --profile realtime: lights-camera (default) has only directional lights; action also "
        "has point lights and spotlights, and the frame of its reference pictures.",
        for_realtime, word<milestones, &Options::realtime_panel, &RealtimeOptions::milestone>},
    OptionRow{"--parameters", "", "P1,P2",
              "With --profile realtime: the two parameters of the tessellation (default 5,5).",
              for_realtime, set_parameters},
    OptionRow{"--near", "", "DEPTH",
              "With --profile realtime: the near clipping plane (default 0.1).", for_realtime,
              set_depth<&RealtimeOptions::near>},
    OptionRow{"--far", "", "DEPTH",
              "With --profile realtime: the far clipping plane (default 100).", for_realtime,
              set_depth<&RealtimeOptions::far>},
    OptionRow{"--filter", "", "NAME",
              "With --profile realtime: none (default), invert, grayscale, blur or sharpen.",
              for_realtime, word<filters, &Options::realtime_panel, &RealtimeOptions::filter>},
};

constexpr std::array motion_options{
    OptionRow{"--turntable", "", "N",
              "N frames in which the camera turns once around the scene; the first is the camera "
              "of the file.",
              for_frames, set_whole<1, 100000, &Options::turntable>},
    OptionRow{"--path", "", "FILE",
              "A JSON file with views and their times; the camera moves smoothly through them. "
              "docs/many-machines.md describes it.",
              for_frames, set_name<&Options::path>},
    OptionRow{"--range", "", "A:B", "Only the frames A to B, counted from 1.", for_frames,
              set_range},
    OptionRow{"--fps", "", "N", "Frames per second (default: fps in the --path file, or else 24).",
              for_frames,
              [](Options& o, const std::string& v) {
                return read_number(v, 0.001, 1000, o.fps.emplace());
              }},
};

constexpr std::array quality_options{
    OptionRow{"--samples", "", "N",
              "Maximum number of samples per pixel, for the profile fine (default 16; with "
              "--engine gl 1, 4, 16 or 64, by default 4, or 16 if most objects are a few pixels "
              "wide; with --mode path the number for every pixel, by default 64). In view for mode "
              "path: without it, until the noise is 1 %, at most 4096.",
              for_tracing | for_view, set_field<&RenderOptions::samples>, "samples"},
    OptionRow{"--min-samples", "", "N",
              "Smallest number of samples per pixel, for the profile fine (default 1). If "
              "--samples is the same number, every pixel takes exactly that many.",
              for_tracing, set_field<&RenderOptions::min_samples>, "min_samples"},
    OptionRow{"--seed", "", "N", "Selects the noise pattern, for the profile fine (default 0).",
              for_tracing, set_whole<0, ~std::uint64_t{0}, &Options::render, &RenderOptions::seed>,
              "seed"},
    OptionRow{"--denoise", "", "",
              "Remove the noise of area lights and lenses with few samples, for the profile fine; "
              "with --mode path all noise.",
              for_render | for_frames, set_flag<true, &Options::render, &RenderOptions::denoise>,
              "denoise"},
};

constexpr std::array paths_options{
    OptionRow{
        "--time", "", "SECONDS",
        "With --mode path: take samples until this time is over; --samples then is the maximum. "
        "--samples with the number that was taken gives the same picture. diff, grade, view and "
        "explain "
        "--mine: processor time for the truth of path-traced pictures (default 40).",
        for_render | for_pictures | for_explain | for_view,
        [](Options& o, const std::string& v) { return read_number(v, 0.001, 1e7, o.seconds); }, "",
        path_only},
    OptionRow{"--light-samples", "", "N",
              "With --mode path: points on lamps and area lights for each point of a path (default "
              "1; 0: paths find lamps only by chance).",
              for_tracing | for_view, set_field<&RenderOptions::light_samples>, "light_samples"},
    OptionRow{"--no-mis", "", "",
              "With --mode path: without multiple importance sampling. Diffuse and glossy surfaces "
              "then only use the samples of --light-samples.",
              for_tracing | for_view, set_flag<false, &Options::render, &RenderOptions::mis>,
              "mis"},
    OptionRow{"--direct-only", "", "",
              "With --mode path: only light that comes straight from lamps, also as seen in "
              "mirrors and through glass.",
              for_tracing | for_view | for_diff,
              set_flag<true, &Options::render, &RenderOptions::direct_only>, "direct_only"},
    OptionRow{"--continue", "", "P",
              "With --mode path: the probability that a path continues after each bounce, up to "
              "0.99 (default: after the third bounce, by the light that it can still add).",
              for_tracing | for_view,
              [](Options& o, const std::string& v) {
                return read_number(v, 0.01, 0.99, o.render.continuation);
              },
              "continuation"},
    OptionRow{"--convention", "", "NAME",
              "With --mode path: physics (default), or course: as the published pictures of the "
              "course, in which light of lamps falls off with the distance instead of its square, "
              "and materials with a bright Ks have no Kd.",
              for_tracing | for_view | for_pictures,
              word<conventions, &Options::render, &RenderOptions::convention>, "convention"},
    OptionRow{
        "--clamp", "", "N",
        "With --mode path: the maximum of indirect light in a sample. Removes bright specks, and "
        "some light.",
        for_tracing | for_view,
        [](Options& o, const std::string& v) { return read_number(v, 1e-3, 1e9, o.render.clamp); },
        "clamp"},
    OptionRow{"--tone", "", "NAME",
              "With --mode path, for PNG files: course (default: Reinhard's curve, white is the "
              "brightest pixel, gamma 2) or none. EXR and PFM files are always linear.",
              for_render | for_frames, word<tones, &Options::tone>, "", path_only},
    OptionRow{"--exposure", "", "STOPS",
              "With --mode path, for PNG files: 1 makes the picture twice as bright before tone "
              "mapping, -1 half as bright (default 0).",
              for_render | for_frames,
              [](Options& o, const std::string& v) { return read_number(v, -64, 64, o.exposure); },
              "", path_only},
};

constexpr std::array layers_options{
    OptionRow{"--aov", "", "LIST",
              "Layers in addition to the picture, separated by commas: depth, normal, uv, albedo, "
              "object-id, light-1 (light-2, ...), shadow, reflection-depth; with --mode path "
              "normal, albedo, direct, bounce-0 (bounce-1, ...), specular, variance, samples. Into "
              "the same .exr, or for x.png into x.depth.png and so on.",
              for_render | for_frames, OptionParser{set_layers, layer_words}, "layers"},
};

constexpr std::array comparison_options{
    OptionRow{"--references", "", "DIR",
              "The folder of the reference pictures; with --mode path, of the course's "
              "configurations. Required.",
              for_grade, set_name<&Options::references>},
    OptionRow{"--scenes", "", "DIR",
              "The scenes of the pictures, by the same names (default: with the references).",
              for_grade, set_name<&Options::scenes>},
    OptionRow{"--map", "", "FILE",
              "For pictures with other names than their references: a file with one line for each, "
              "the submitted name, a comma, and the name of the reference.",
              for_grade, set_name<&Options::name_map>},
    OptionRow{
        "--scene", "", "SCENE",
        "The scene of the pictures: look for the mistake that turns the first one into the second.",
        for_diff, set_name<&Options::scene>},
    OptionRow{"--reference", "", "PICTURE",
              "The right picture of the scene, as the course gives it: ours is drawn like it.",
              for_view, set_name<&Options::reference>},
    OptionRow{"--reference",
              "",
              "PICTURE",
              "The correct picture, next to --mine: look for the mistake in the whole picture, as "
              "diff does, and show the pixel's terms with it.",
              for_explain,
              set_name<&Options::reference>,
              "",
              {.path = false}},
    OptionRow{"--mine", "", "PICTURE",
              "Your picture of the scene: compare its values with ours or the reference, and find "
              "the mistake in our terms that gives them; explain --mode path compares the pixels "
              "around with the truth.",
              for_explain | for_view, set_name<&Options::mine>},
    OptionRow{"--layer", "", "NAME", "The layer to read of EXR pictures that have several.",
              for_pictures | for_explain | for_view, set_name<&Options::layer>},
    OptionRow{"--min-psnr", "", "DB",
              "Pictures differ below this PSNR. This and the next options apply to pictures. "
              "Without any of them, diff requires equality, and grade judges by the kind of "
              "difference, or by 40 dB if that is not clear.",
              for_pictures, set_threshold<&Thresholds::min_psnr_db, 99>},
    OptionRow{"--max-mean", "", "N", "Pictures differ above this mean difference in 1/255.",
              for_pictures, set_threshold<&Thresholds::max_mean, 255>},
    OptionRow{"--max-difference", "", "N",
              "Pictures differ if any value is off by more than this, in 1/255.", for_pictures,
              set_threshold<&Thresholds::max_difference, 255>},
    OptionRow{"--max-share", "", "PERCENT",
              "Pictures differ when more of the pixels are off by more than --pixel-threshold.",
              for_pictures, set_max_share},
    OptionRow{"--pixel-threshold", "", "N",
              "A pixel is off if a value differs by more than this, in 1/255 (default 8).",
              for_pictures, set_whole<0, 255, &Options::pixel_threshold>},
    OptionRow{"--min-ssim", "", "N", "Pictures differ below this SSIM.", for_pictures,
              set_threshold<&Thresholds::min_ssim, 1>},
    OptionRow{"--max-flip", "", "N", "Pictures differ above this mean FLIP.", for_pictures,
              set_threshold<&Thresholds::max_flip, 1>},
};

constexpr std::array window_options{
    OptionRow{"--window", "", "WxH", "Size of the window (default: the last size).", for_view,
              set_window},
    OptionRow{"--trace", "", "", "Trace rays when the camera rests; the key R toggles it.",
              for_view, set_flag<true, &Options::live_trace>},
    OptionRow{"--screenshot", "", "OUT",
              "Write a picture of the window, a .png, when everything is loaded, and close it.",
              for_view, set_file<png_ending, &Options::screenshot>},
    OptionRow{"--frames", "", "N", "With --screenshot: draw this many frames first (default 1).",
              for_view, set_whole<1, 100000, &Options::frames>},
    OptionRow{"--script", "", "FILE",
              "Run the steps in this file instead of a user's input, then close the window; "
              "docs/viewer.md lists the steps.",
              for_view, set_name<&Options::script>},
};

constexpr std::array input_options{
    OptionRow{
        "--compat", "", "NAME",
        "course: read as the course's programs did where the format says otherwise: every object "
        "of a transblock, transforms after it, the numeric prefix of a malformed number.",
        for_all_readers | for_pictures | for_view, OptionParser{set_compat, dialect_words}},
    OptionRow{"--asset-root", "", "DIR",
              "Look for textures and meshes in this folder too. May be given several times; "
              "docs/assets.md has the rules.",
              for_all_readers | for_pictures | for_view | for_lsp, add_asset_root},
    OptionRow{"--allow-outside", "", "",
              "Open textures and meshes wherever the scene says, not only in its folder, the "
              "folders for images and meshes next to it, and the asset roots.",
              for_all_readers | for_pictures | for_view | for_lsp,
              set_flag<true, &Options::access, &AssetAccess::allow_outside>},
    OptionRow{"--allow-missing", "", "", "Draw the scene without meshes that cannot be used.",
              for_tracing | for_check | for_view,
              set_flag<true, &Options::load, &LoadSettings::allow_missing>},
    OptionRow{"--no-assets", "", "", "Do not open textures and meshes.", for_check,
              set_flag<false, &Options::assets>},
    OptionRow{"--stdio", "", "",
              "Use standard input and output, as always; editors give this option.", for_lsp,
              set_flag<true, &Options::stdio>},
};

constexpr std::array findings_options{
    OptionRow{"--strict", "", "", "Treat spellings that only some programs accept as errors.",
              for_check, set_flag<true, &Options::policy, &FindingPolicy::strict>},
    OptionRow{"--deny", "", "WHAT",
              "warnings: every warning is an error. A code: findings of this code are errors. May "
              "be given several times.",
              for_check, set_deny},
    OptionRow{"--allow", "", "CODE",
              "Do not report findings of this code, denied or not. May be given several times.",
              for_check, set_allow},
    OptionRow{
        "--fix", "", "",
        "Correct the mistakes in the files that have only one possible correction, such as "
        "misspelled names. The findings and the exit status are those of the corrected files.",
        for_check, set_flag<true, &Options::fix>},
    OptionRow{"--dry-run", "", "",
              "Like --fix, but change nothing: print the differences in the unified format.",
              for_check, set_flag<true, &Options::dry_run>},
};

constexpr std::array limits_options{
    OptionRow{"--threads", "", "N",
              "Number of threads (default: one per processor). The picture does not depend on it.",
              for_tracing | for_pictures | for_view,
              [](Options& o, const std::string& v) {
                return set_number(v, 1, option_field("threads").most, o.render.threads);
              },
              "threads"},
    OptionRow{"--limit", "", "NAME=VALUE",
              "Set a limit on what a file may contain; \"scenefile help limits\" lists them. May "
              "be given several times.",
              for_all_readers | for_pictures | for_format | for_view, set_limit_option},
    OptionRow{"--max-memory", "", "BYTES",
              "Use at most this much memory, such as 800M or 4G (default: 80 % of what the system "
              "allows).",
              for_all_readers | for_pictures | for_format | for_view | for_lsp, set_max_memory},
    OptionRow{"--timeout", "", "SECONDS",
              "Stop with exit status 4 after this time, without writing outputs.",
              for_all_readers | for_pictures | for_format | for_view, set_timeout},
};

constexpr std::array output_options{
    OptionRow{"--output", "-o", "OUT",
              "The picture to write: .png, .exr or .pfm; - for a PNG on standard output. For "
              "frames, a pattern such as frame%04d.png.",
              for_render | for_frames, set_name<&Options::output>},
    OptionRow{"--to", "", "FORMAT",
              "xml, json, glb, gltf (glTF 2.0), obj (Wavefront) or pov (POV-Ray 3.7); needed if "
              "the extension of the output is missing or different.",
              for_convert, word<formats, &Options::to>},
    OptionRow{"--store", "", "OUTDIR",
              "Keep the work in this folder, in pieces: bands of the picture, results of students. "
              "The same command continues from the pieces that exist, and writes the result when "
              "all do. Pieces of other work are an error (status 1).",
              for_render | for_grade, set_name<&Options::store>},
    OptionRow{"--part", "", "I/N",
              "With --store: make only share I of N, where I is 1 to N, and write no result. "
              "Several machines can make the shares at the same time.",
              for_render | for_grade, set_part},
    OptionRow{"--missing", "", "N",
              "With --store: make nothing, but print which of N shares are still to make, one per "
              "line. The exit status is 1 if there are any.",
              for_render | for_grade, set_whole<1, max_shares, &Options::missing>},
    OptionRow{
        "--write-scenes", "", "PATTERN",
        "Also write the scene of each frame, such as scene%04d.xml; rendering it gives the frame.",
        for_frames, set_name<&Options::write_scenes>},
    OptionRow{"--video", "", "OUT",
              "Make a video of all frames with ffmpeg, such as turn.mp4, .webm or .gif. Without "
              "-o, the frames are not kept.",
              for_frames, set_name<&Options::video>},
    OptionRow{"--overwrite", "", "",
              "Replace existing files with the names of frames and scenes, such as frames of "
              "another scene or with other options (default: refuse).",
              for_frames, set_flag<true, &Options::overwrite>},
    OptionRow{"--heatmap", "", "OUT", "Write a picture of the differences: a .png.", for_diff,
              set_file<png_ending, &Options::heatmap>},
    OptionRow{"--energy", "", "OUT",
              "Write the light by bounces, of a path-traced picture and of the truth: an .svg.",
              for_diff, set_file<svg_ending, &Options::energy>, "", path_only},
    OptionRow{"--sheet", "", "OUT",
              "Write both pictures, their differences and FLIP side by side: a .png.", for_diff,
              set_file<png_ending, &Options::sheet>},
    OptionRow{
        "--report", "", "OUT",
        "Write an HTML report; for large classes, its pictures are in the folder OUT-pictures.",
        for_grade, set_name<&Options::report>},
    OptionRow{"--pages", "", "OUTDIR", "Write an HTML page for each student into this folder.",
              for_grade, set_name<&Options::pages>},
    OptionRow{"--title", "", "TEXT",
              "The title of the report and the pages (default: the name of the class's folder).",
              for_grade, set_name<&Options::title>},
    OptionRow{"--csv", "", "OUT", "Write the results as CSV, for spreadsheets.", for_grade,
              set_name<&Options::csv>},
    OptionRow{"--csv-students", "", "OUT", "Write the score of each student as CSV.", for_grade,
              set_name<&Options::csv_students>},
    OptionRow{"--junit", "", "OUT", "Write the results as JUnit XML.", for_grade,
              set_name<&Options::junit>},
    OptionRow{"--gradescope", "", "OUT",
              "Write results.json for Gradescope: DIR is one student's, whatever it contains.",
              for_grade, set_name<&Options::gradescope>},
    OptionRow{"--check", "", "",
              "Change nothing; name the files that would be changed. The exit status is then 1.",
              for_format, set_flag<true, &Options::check>},
    OptionRow{"--files", "", "",
              "List textures and meshes with the place where each was found, or why it was not.",
              for_info, set_flag<true, &Options::files>},
    OptionRow{"--tree", "", "", "Show the scene graph.", for_info, set_flag<true, &Options::tree>},
    OptionRow{"--man", "", "", "The manual page of the program, or of the command, for man(1).",
              for_help, set_flag<true, &Options::man>},
    OptionRow{
        "--completion", "", "SHELL",
        "The completion script for bash, zsh or fish: source <(scenefile help --completion bash).",
        for_help, word<shells, &Options::completion>},
    OptionRow{"--json", "", "", "Answer in JSON, for programs.",
              for_all_readers | for_pictures | for_format | for_help | for_version,
              set_flag<true, &Options::json>},
    OptionRow{"--sarif", "", "", "Answer in SARIF 2.1.0, for code hosts and editors.", for_check,
              set_flag<true, &Options::sarif>},
    OptionRow{"--markdown", "", "",
              "Print the page of all codes, docs/diagnostics.md; with causes, that of all causes, "
              "docs/mistakes.md.",
              for_help, set_flag<true, &Options::markdown>},
    OptionRow{"--quiet", "-q", "", "Print only errors.",
              for_tracing | for_check | for_convert | for_pictures | for_format,
              set_flag<true, &Options::quiet>},
    OptionRow{
        "--help", "-h", "", "Print this help.",
        for_all_readers | for_pictures | for_format | for_help | for_version | for_view | for_lsp,
        set_flag<true, &Options::help>},
};

constexpr std::array groups{
    OptionGroup{"Picture", picture_options},       OptionGroup{"Realtime", realtime_options},
    OptionGroup{"Motion", motion_options},         OptionGroup{"Quality", quality_options},
    OptionGroup{"Paths", paths_options},           OptionGroup{"Layers", layers_options},
    OptionGroup{"Comparison", comparison_options}, OptionGroup{"Window", window_options},
    OptionGroup{"Input", input_options},           OptionGroup{"Findings", findings_options},
    OptionGroup{"Limits", limits_options},         OptionGroup{"Output", output_options},
};

}  // namespace

std::span<const OptionGroup> option_groups() {
  return groups;
}

std::vector<const OptionRow*> options_of(const Command& command) {
  std::vector<const OptionRow*> rows;
  for (const OptionGroup& group : groups) {
    for (const OptionRow& row : group.rows) {
      if ((row.commands & command.bit) != 0) {
        rows.push_back(&row);
      }
    }
  }
  return rows;
}

std::span<const std::string_view> words_of(const OptionRow& row) {
  return row.name == "--features" ? feature_words() : row.parser.words;
}

std::string did_you_mean(std::string_view word, std::span<const std::string_view> known) {
  const std::string_view nearest = nearest_name(word, known);
  return nearest.empty() ? std::string() : fmt::format("; did you mean {}?", nearest);
}

}  // namespace scenefile::app
