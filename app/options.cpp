#include "app/options.h"

#include "app/command.h"
#include "app/course_program.h"
#include "app/named_files.h"
#include "app/names.h"
#include "app/option_table.h"
#include "app/realtime.h"
#include "scenefile/asset/image_file.h"
#include "scenefile/base/text.h"
#include "scenefile/format/recognize.h"
#include "scenefile/io/file.h"
#include "scenefile/trace/layers.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <vector>

namespace scenefile::app {

namespace {

// CLI11 uses the form "-o,--output".
std::string names_of(const OptionRow& row) {
  return row.letter.empty() ? std::string(row.name) : fmt::format("{},{}", row.letter, row.name);
}

void add_option(CLI::App& parser, const OptionRow& row, Options& options) {
  if (row.value.empty()) {
    parser
        .add_flag_callback(names_of(row),
                           [&row, &options] {
                             options.given.push_back({&row, {}});
                           })
        ->disable_flag_override();
    return;
  }
  parser
      .add_option_function<std::vector<std::string>>(
          names_of(row),
          [&row, &options](const std::vector<std::string>& values) {
            for (const std::string& value : values) {
              options.given.push_back({&row, value});
            }
          })
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
      ->allow_extra_args(false);
}

bool has_option(const Command& command, std::string_view name) {
  const std::vector<const OptionRow*> rows = options_of(command);
  return std::any_of(rows.begin(), rows.end(),
                     [&](const OptionRow* row) { return row->name == name; });
}

void set_up(CLI::App& parser, const Command& command, Options& options) {
  parser.set_help_flag();
  parser.allow_extras();
  parser.add_option("arguments", options.arguments);
  for (const OptionRow* row : options_of(command)) {
    add_option(parser, *row, options);
  }
}

std::string needs_value(const OptionRow& row) {
  return row.value.empty() ? fmt::format("{} takes no value", row.name)
                           : fmt::format("{0} needs a value: {0} {1}", row.name, row.value);
}

// Whether an option is where the value should be: "-o --size 320x240". "-" alone is standard input
// or output.
bool is_missing(const OptionRow& row, std::string_view value) {
  return names_file(row) && value.size() > 1 && value.starts_with('-');
}

// Parses the given options, first those that affect the defaults of others.
std::string set_given(Options& options) {
  std::stable_partition(options.given.begin(), options.given.end(),
                        [](const GivenOption& given) { return given.row->sets_defaults; });
  for (const auto& [row, value] : options.given) {
    if (is_missing(*row, value)) {
      return fmt::format("{}; a file {} is ./{}", needs_value(*row), quoted(value, 400),
                         escaped(value, 400));
    }
    if (const std::string wrong = row->parser.set(options, value); !wrong.empty()) {
      return fmt::format("{}: {}", row->name, wrong);
    }
  }
  return {};
}

std::string unknown_option(const Command& command, const std::string& word) {
  std::vector<std::string_view> known;
  for (const OptionRow* row : options_of(command)) {
    known.push_back(row->name);
  }
  const std::string name = word.substr(0, word.find('='));
  return fmt::format("{} has no option {}{}", command.name, escaped(name),
                     did_you_mean(name, known));
}

std::string missing_value(const Command& command, std::string_view words) {
  // CLI11: "--size: 1 required TEXT missing", "json was given a disallowed flag override".
  const std::string_view name = words.substr(0, words.find_first_of(": "));
  for (const OptionRow* row : options_of(command)) {
    if (row->name == name || row->name.substr(2) == name) {
      return needs_value(*row);
    }
  }
  return std::string(words);
}

std::string check_output(std::string_view command, const std::string& output) {
  if (output.empty()) {
    return fmt::format("{} needs an output: -o OUT.png", command);
  }
  if (output == "-" || output.starts_with("/dev/") || image_format_of(output)) {
    return {};
  }
  if (const std::string extension = lower_case_extension(output);
      extension == ".jpg" || extension == ".jpeg") {
    return fmt::format(
        "cannot write {}: the name must end in {}; JPEG changes colors, so pictures could not be "
        "compared",
        quoted(output, 400), image_extensions);
  }
  return fmt::format("cannot write {}: the name must end in {}", quoted(output, 400),
                     image_extensions);
}

std::string check_pixel(const Options& options) {
  if (!options.pixel.has_value()) {
    return "explain needs a pixel: --pixel X,Y";
  }
  if (!options.reference.empty() && (options.mine.empty() || was_given(options, "--size"))) {
    return options.mine.empty() ? "--reference needs your picture: --mine PICTURE"
                                : "--size: with --reference, the pictures determine the size";
  }
  const auto [x, y] = *options.pixel;
  // With --mine, the picture determines the size, but it has not been read yet.
  return !options.mine.empty() || (x < options.render.width && y < options.render.height)
             ? std::string()
             : fmt::format("--pixel: {},{} is not in the picture: 0,0 to {},{}", x, y,
                           options.render.width - 1, options.render.height - 1);
}

std::string check_count(const Command& command, const std::vector<std::string>& arguments) {
  const auto [fewest, most] = command.count;
  if (arguments.size() < fewest) {
    return fmt::format("{} needs {}: scenefile {} {}", command.name,
                       fewest == 1 ? (command.bit == for_grade ? "a folder" : "a scene")
                                   : fmt::format("{} names", fewest),
                       command.name, command.arguments);
  }
  if (arguments.size() > most) {
    const std::string& extra = arguments[most];
    const bool picture = image_format_of(extra).has_value();
    std::string_view hint;
    if (picture && command.bit == for_render) {
      hint = "; the picture to write goes after -o";
    } else if (picture && command.bit == for_explain) {
      hint = "; your picture goes after --mine";
    } else if (command.bit == for_diff && is_scene_name(extra)) {
      hint = "; the scene of two pictures goes after --scene";
    }
    return fmt::format("{} takes {}; unexpected {}{}", command.name,
                       most == 0   ? "no arguments"
                       : most == 1 ? "one argument"
                                   : fmt::format("{} arguments", most),
                       quoted(extra, 400), hint);
  }
  return {};
}

// The format, from --to or from the extension of the output.
std::string choose_format(Options& options) {
  const std::string& output = options.arguments[1];
  if (!options.to.has_value()) {
    const std::string extension = lower_case_extension(output);
    const auto found =
        std::find_if(format_words.begin(), format_words.end(),
                     [&](std::string_view word) { return extension == fmt::format(".{}", word); });
    if (found == format_words.end()) {
      return fmt::format("the name {} does not imply a format; end it in one of .{}, or give --to",
                         quoted(output, 400), fmt::join(format_words, ", ."));
    }
    options.to = static_cast<ConvertTo>(found - format_words.begin());
  }
  if (options.to != ConvertTo::pov &&
      (was_given(options, "--features") || was_given(options, "--max-depth"))) {
    return "--features and --max-depth are for POV-Ray files; scene files do not contain them";
  }
  return {};
}

OptionSupport support_for(const OptionRow& row) {
  return row.field.empty() ? row.support : support_of(row.field);
}

std::vector<std::string_view> layers_of(Mode mode) {
  std::vector<std::string_view> words;
  for (std::size_t i = 0; i < layer_words.size(); ++i) {
    if (has_layer(mode, static_cast<LayerKind>(i))) {
      words.push_back(layer_words[i]);
    }
  }
  return words;
}

// Checks that each option has an effect with the selected engine, profile and mode.
std::string check_support(const Options& options) {
  if (options.render.mode == Mode::path) {
    if (options.engine != Engine::trace) {
      return fmt::format("--mode path is for the ray tracer: leave it out, or {}",
                         options.realtime ? "--profile realtime" : "--engine gl");
    }
    if (options.render.profile != Profile::fine) {
      return fmt::format("--mode path is for the profile fine: leave it out, or --profile {}",
                         profile_word(options.render.profile));
    }
  }
  for (const auto& [row, value] : options.given) {
    const OptionSupport support = support_for(*row);
    if (!supports_option(options.engine, support)) {
      return fmt::format("{} is for the ray tracer: leave it out, or {}", row->name,
                         options.realtime ? "--profile realtime" : "--engine gl");
    }
    if (!supports_option(options.render.profile, support)) {
      return fmt::format("{} is for the profile fine: leave it out, or --profile {}", row->name,
                         profile_word(options.render.profile));
    }
    if (!supports_option(options.render.mode, support)) {
      return options.render.mode == Mode::path
                 ? fmt::format("{} has no effect on paths: leave it out, or {}", row->name,
                               path_option(options))
                 : fmt::format("{} is for path tracing: leave it out, or --mode {}", row->name,
                               mode_word(options.render.mode));
    }
  }
  for (const Layer& layer : options.render.layers) {
    if (!has_layer(options.render.mode, layer.kind)) {
      return options.render.mode == Mode::path
                 ? fmt::format("--aov: mode path has no layer {}; it has {}", layer_name(layer),
                               fmt::join(layers_of(Mode::path), ", "))
                 : fmt::format("--aov: {} is a layer of path tracing: leave it out, or --mode {}",
                               layer_name(layer), mode_word(options.render.mode));
    }
  }
  const int samples = options.render.samples;
  if (options.render.min_samples > samples) {
    return fmt::format("--min-samples {0}: more than the {1} of --samples; add --samples {0}",
                       options.render.min_samples, samples);
  }
  return options.engine == Engine::trace || !was_given(options, "--samples") || samples == 1 ||
                 samples == 4 || samples == 16 || samples == 64
             ? std::string()
             : fmt::format("--samples: OpenGL takes 1, 4, 16 or 64 samples per pixel, not {}",
                           samples);
}

// Checks of view that need more than one option.
std::string check_window(const Options& options) {
  if (options.arguments.size() > 1 && !options.mine.empty()) {
    return "name both pictures by their roles: --reference A.png --mine B.png";
  }
  return options.frames != 1 && options.screenshot.empty() ? "--frames requires --screenshot FILE"
                                                           : std::string();
}

std::string check_crop(const Options& options) {
  if (const std::optional<PixelRegion>& crop = options.render.crop;
      crop.has_value() && (crop->x1 > options.render.width || crop->y1 > options.render.height)) {
    return fmt::format("--crop: {},{},{},{} extends outside of the picture of {}x{}", crop->x0,
                       crop->y0, crop->x1, crop->y1, options.render.width, options.render.height);
  }
  return {};
}

// Checks shared by render and frames.
std::string check_picture(const Options& options, std::string_view command) {
  if (std::string wrong = check_crop(options); !wrong.empty()) {
    return wrong;
  }
  const std::optional<ImageFormat> format = image_format_of(options.output);
  const bool holds_layers = format && layer_storage(*format) != LayerStorage::none;
  if (!options.render.layers.empty() && !holds_layers && !options.output.empty()) {
    return "--aov needs an output that ends in .exr (all layers in one file) or .png (a file for "
           "each)";
  }
  return options.any_extension ? std::string() : check_output(command, options.output);
}

// Whether the work ends before the result.
bool works_on_share(const Options& options) {
  return options.part.has_value() || options.missing.has_value();
}

// Checks the options for a store.
std::string check_store(const Options& options) {
  if (works_on_share(options) && options.store.empty()) {
    return fmt::format("{} needs the folder of the work: --store DIR",
                       options.part ? "--part" : "--missing");
  }
  return options.part && options.missing
             ? "--part makes a share, --missing lists shares: choose one"
             : "";
}

// Checks of render that need more than one option.
std::string check_render(const Options& options) {
  if (std::string wrong = check_store(options); !wrong.empty()) {
    return wrong;
  }
  if (!options.store.empty() && options.engine != Engine::trace) {
    return fmt::format("--store is for the ray tracer: leave it out, or {}",
                       options.realtime ? "--profile realtime" : "--engine gl");
  }
  if (!options.store.empty() && options.seconds > 0) {
    return "--store cannot be combined with --time, which takes other samples each time";
  }
  // The picture is not written.
  if (works_on_share(options) && options.output.empty()) {
    return check_crop(options);
  }
  return check_picture(options, "render");
}

// Checks a name pattern for numbers, such as "f%04d.png".
std::string check_pattern(const std::string& pattern) {
  const std::size_t begin = pattern.find('%');
  const std::size_t end = pattern.find_first_not_of("0123456789", begin + 1);
  const bool good = begin != std::string::npos && end != std::string::npos && pattern[end] == 'd' &&
                    end - begin <= 3 && (end == begin + 1 || pattern[begin + 1] == '0') &&
                    pattern.find('%', end) == std::string::npos;
  return good ? std::string()
              : fmt::format("{} needs one place for the number, such as frame%04d.png",
                            quoted(pattern, 400));
}

// Checks of frames that need more than one option.
std::string check_frames(const Options& options) {
  if (options.turntable.has_value() == !options.path.empty()) {
    return "frames needs either --turntable N or --path FILE";
  }
  if (options.output.empty() && options.write_scenes.empty() && options.video.empty()) {
    return "frames needs an output: -o frame%04d.png";
  }
  if (options.output.empty() && !options.video.empty() && options.range) {
    return "--video needs all frames: leave out --range, or keep the frames with -o frame%04d.png";
  }
  if (options.output.empty() && !options.render.layers.empty()) {
    return "--aov needs the frames: -o frame%04d.exr";
  }
  for (const std::string& pattern : {options.output, options.write_scenes}) {
    if (std::string wrong = pattern.empty() ? "" : check_pattern(pattern); !wrong.empty()) {
      return wrong;
    }
  }
  if (const std::string extension = lower_case_extension(options.write_scenes);
      !options.write_scenes.empty() && extension != ".xml" && extension != ".json") {
    return fmt::format("--write-scenes: the name {} must end in .xml or .json",
                       quoted(options.write_scenes, 400));
  }
  return options.output.empty() ? std::string() : check_picture(options, "frames");
}

// Checks of grade that need more than one option.
std::string check_grade(const Options& options) {
  if (options.references.empty()) {
    return "grade needs the reference pictures: --references DIR";
  }
  for (const std::string_view name :
       {"--report", "--pages", "--title", "--csv", "--csv-students", "--junit", "--gradescope"}) {
    if (works_on_share(options) && was_given(options, name)) {
      return fmt::format("{} is for the whole class: leave it out, or {}", name,
                         options.part ? "--part" : "--missing");
    }
  }
  return check_store(options);
}

// Whether standard output is for a file, not for an answer.
bool writes_to_stdout(const Command& command, const Options& options) {
  switch (command.bit) {
    case for_render:
      return is_standard_output(options.output);
    case for_convert:
      return is_standard_output(options.arguments[1]);
    case for_check:
    case for_format:
      return (command.bit == for_format ? !options.check : options.fix && !options.dry_run) &&
             std::any_of(options.arguments.begin(), options.arguments.end(), is_standard_output);
    default:
      return false;
  }
}

// Checks that need more than one option.
std::string check_together(const Command& command, Options& options) {
  if (std::string wrong = check_count(command, options.arguments); !wrong.empty()) {
    return wrong;
  }
  if ((options.json || options.sarif) && writes_to_stdout(command, options)) {
    return fmt::format("the {} and --{} cannot both go to standard output",
                       command.bit == for_render ? "picture" : "file",
                       options.json ? "json" : "sarif");
  }
  if (command.bit == for_convert) {
    return choose_format(options);
  }
  if (command.bit == for_grade) {
    if (std::string wrong = check_grade(options); !wrong.empty()) {
      return wrong;
    }
  }
  if (command.bit == for_explain) {
    if (std::string wrong = check_pixel(options); !wrong.empty()) {
      return wrong;
    }
  }
  if (!options.title.empty() && options.report.empty() && options.pages.empty()) {
    return "--title is for --report and --pages";
  }
  if (std::string wrong = check_support(options); !wrong.empty()) {
    return wrong;
  }
  if (options.json && options.sarif) {
    return "--json and --sarif are two output formats: choose one";
  }
  if (const int most = static_cast<int>(options.load.limits.image_side);
      has_option(command, "--size") &&
      (options.render.width > most || options.render.height > most)) {
    return fmt::format("--size: {}x{}{} is more than the limit of {} pixels per side",
                       options.render.width, options.render.height,
                       was_given(options, "--size") ? "" : ", the default,", most);
  }
  return command.bit == for_render   ? check_render(options)
         : command.bit == for_frames ? check_frames(options)
         : command.bit == for_view   ? check_window(options)
                                     : std::string();
}

}  // namespace

std::string parse_options(const Command& command, std::span<const char* const> words,
                          Options& options, const Configured& configured) {
  std::vector<std::string> all;
  // pathContinuationProb = 0 of a configuration became --max-depth 1, which --continue replaces.
  const bool continues = std::any_of(words.begin(), words.end(), [](std::string_view word) {
    return word.starts_with("--continue");
  });
  for (const std::string& word : configured.words) {
    if (has_option(command, word.substr(0, word.find('='))) &&
        !(continues && configured.kind == ConfigKind::path && word.starts_with("--max-depth"))) {
      all.push_back(word);
    }
  }
  all.insert(all.end(), words.begin(), words.end());
  CLI::App parser;
  set_up(parser, command, options);
  try {
    parser.parse(std::vector<std::string>(all.rbegin(), all.rend()));
  } catch (const CLI::ArgumentMismatch& error) {
    return missing_value(command, error.what());
  } catch (const CLI::ParseError& error) {
    return escaped(error.what());
  }
  // CLI11 returns the "--" that ends the options as one of the unknown words.
  for (const std::string& unknown : parser.remaining()) {
    if (unknown != "--") {
      return unknown_option(command, unknown);
    }
  }
  if (std::string wrong = set_given(options); !wrong.empty() || options.help) {
    return wrong;
  }
  if (!configured.scene.empty()) {
    options.arguments = {configured.scene};
    if (options.output.empty()) {
      options.output = configured_output(command, configured);
      options.any_extension = !options.output.empty();
    }
  }
  if (std::string wrong = check_realtime_options(options); !wrong.empty()) {
    return wrong;
  }
  if (options.realtime) {
    options.engine = Engine::gl;
  }
  if (!path_option(options).empty()) {
    set_path_mode(options);
  }
  options.load.compat_course =
      options.load.compat_course || options.render.profile == Profile::course || options.realtime;
  return check_together(command, options);
}

std::string configured_output(const Command& command, const Configured& configured) {
  const bool pattern = configured.output.find('%') != std::string::npos;
  return has_option(command, "--output") && (pattern || command.bit != for_frames)
             ? configured.output
             : std::string();
}

std::string config_argument(const Command& command, std::span<const char* const> words) {
  // Parsing takes time, and most command lines have no such word.
  if ((command.bit & for_tracing) == 0 ||
      std::none_of(words.begin(), words.end(), is_config_name)) {
    return {};
  }
  Options options;
  CLI::App parser;
  set_up(parser, command, options);
  try {
    parser.parse(std::vector<std::string>(words.rbegin(), words.rend()));
  } catch (const CLI::ParseError&) {
    return {};  // parse_options() reports it
  }
  return !options.help && options.arguments.size() == 1 && is_config_name(options.arguments.front())
             ? options.arguments.front()
             : std::string();
}

bool asks_for_json(const Command& command, std::span<const char* const> words) {
  const auto end = std::find(words.begin(), words.end(), std::string_view("--"));
  return has_option(command, "--json") &&
         std::find(words.begin(), end, std::string_view("--json")) != end;
}

bool was_given(const Options& options, std::string_view name) {
  return std::any_of(options.given.begin(), options.given.end(),
                     [&](const GivenOption& given) { return given.row->name == name; });
}

void set_path_mode(Options& options) {
  options.render.mode = Mode::path;
  if (!was_given(options, "--samples")) {
    // Then --time alone limits them.
    options.render.samples = options.seconds > 0 ? option_field("samples").most : path_samples;
  }
  if (!was_given(options, "--max-depth")) {
    options.render.max_depth = path_max_depth;
  }
}

std::string path_option(const Options& options) {
  if (options.render.mode == Mode::path) {
    if (was_given(options, "--mode")) {
      return "--mode path";
    }
  } else if (!may_choose_path_mode(options)) {
    return {};
  }
  for (const GivenOption& given : options.given) {
    if (!supports_option(Mode::ray, support_for(*given.row))) {
      return std::string(given.row->name);
    }
  }
  for (const Layer& layer : options.render.layers) {
    if (!has_layer(Mode::ray, layer.kind)) {
      return "--aov " + layer_name(layer);
    }
  }
  return {};
}

bool may_choose_path_mode(const Options& options) {
  return options.engine == Engine::trace && options.render.profile == Profile::fine &&
         !was_given(options, "--mode");
}

std::string option_without_paths(const Options& options) {
  for (const GivenOption& given : options.given) {
    if (!supports_option(Mode::path, support_for(*given.row))) {
      return std::string(given.row->name);
    }
  }
  for (const Layer& layer : options.render.layers) {
    if (!has_layer(Mode::path, layer.kind)) {
      return "--aov " + layer_name(layer);
    }
  }
  return {};
}

RenderOptions render_options(const Options& options, Profile profile) {
  Options other;
  other.render = default_options(profile);
  for (const auto& [row, value] : options.given) {
    if (!row->sets_defaults) {
      row->parser.set(other, value);
    }
  }
  return other.render;
}

}  // namespace scenefile::app
