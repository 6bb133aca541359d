#include "app/course_program.h"

#include "app/load.h"
#include "app/named_files.h"
#include "app/output.h"
#include "scenefile/asset/image_file.h"
#include "scenefile/base/report.h"
#include "scenefile/base/text.h"
#include "scenefile/format/codes.h"
#include "scenefile/format/recognize.h"
#include "scenefile/io/file.h"
#include "scenefile/trace/features.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <vector>

namespace scenefile::app {

namespace {

struct CourseProgram {
  std::string_view name;
  std::string_view tracer;
  std::string_view help;
};

// Indexed by ConfigKind.
constexpr std::array programs{
    CourseProgram{
        "projects_ray", "ray tracer",
        "projects_ray CONFIG.ini\n"
        "\n"
        "Draws a scene like the course's own program, as described in the configuration:\n"
        "\n"
        "  [IO]\n"
        "  scene = test_unit/unit_cone.xml      ; relative to the working directory\n"
        "  output = unit_cone.png\n"
        "  [Canvas]\n"
        "  width = 1024\n"
        "  height = 768\n"
        "  [Feature]                            ; true or false (default: false)\n"
        "  shadows = true                       ; reflect, refract, texture, texture-filter,\n"
        "                                       ; super-sample, depthoffield\n"
        "  parallel = true                      ; no effect: rendering is always parallel\n"
        "  acceleration = true                  ; no effect: rendering is always accelerated\n"
        "  [Settings]                           ; optional\n"
        "  maximum-recursive-depth = 4\n"
        "  only-render-normals = false\n"
        "\n"
        "It equals \"scenefile render CONFIG.ini\", which also takes options; \"scenefile help\" "
        "says\nwhat else there is.\n"},
    CourseProgram{"projects_path", "path tracer",
                  "projects_path CONFIG.ini\n"
                  "\n"
                  "Draws a scene of the assignment Path, as described in the configuration:\n"
                  "\n"
                  "  [IO]\n"
                  "  scene = example-scenes/CornellBox.xml  ; relative to the working directory\n"
                  "  output = student_outputs/box.png       ; its folder is created\n"
                  "  [Settings]\n"
                  "  imageWidth = 512\n"
                  "  imageHeight = 512\n"
                  "  samplesPerPixel = 50                   ; 0, or not given: 1\n"
                  "  pathContinuationProb = 0.9             ; 0, or not given: direct light only\n"
                  "  directLightingOnly = false\n"
                  "  numDirectLightingSamples = 1           ; 0, or not given: 1\n"
                  "\n"
                  "It equals \"scenefile render CONFIG.ini\", which also takes options such as "
                  "--convention course;\n\"scenefile help render\" lists them.\n"},
};

const CourseProgram& info_of(ConfigKind kind) {
  return programs[static_cast<std::size_t>(kind)];
}

std::vector<std::string> ray_words(const CourseConfig& config) {
  std::vector<std::string> words{
      "--profile=course", config.features.empty()
                              ? "--features=none"
                              : fmt::format("--features={}", fmt::join(config.features, ","))};
  if (config.maximum_recursive_depth) {
    words.push_back(fmt::format("--max-depth={}", *config.maximum_recursive_depth));
  }
  if (config.only_render_normals) {
    words.emplace_back("--mode=normals");
  }
  return words;
}

std::vector<std::string> path_words(const CourseConfig& config) {
  std::vector<std::string> words{
      "--mode=path", fmt::format("--samples={}", config.samples_per_pixel),
      fmt::format("--light-samples={}", config.num_direct_lighting_samples)};
  if (config.direct_lighting_only) {
    words.emplace_back("--direct-only");
  }
  // Probabilities only affect the noise, and those near 1 only the time that it takes.
  words.push_back(
      config.most_bounces() > 0
          ? fmt::format("--max-depth={}", config.most_bounces())
          : fmt::format("--continue={}", std::clamp(config.path_continuation_prob, 0.01F, 0.99F)));
  return words;
}

void check_picture_format(const CourseConfig& config, Diagnostics& diagnostics) {
  if (!diagnostics.has_errors() && !image_format_of(config.output)) {
    diagnostics.report(
        "config.picture-format"_code, config.output_place,
        fmt::format("output does not end in {}; it will be a PNG", image_extensions));
  }
}

// Whether the argument is a scene instead of a configuration, by its name or first character.
bool is_scene(const LoadedScene& config) {
  const std::size_t first = config.text.find_first_not_of(" \t\r\n");
  const char start = first == std::string::npos ? ' ' : config.text[first];
  return is_scene_name(config.path) || start == '<' || start == '{';
}

// Reads without printing.
ExitCode read_quietly(const std::string& path, Context& context, Configured& configured,
                      std::optional<ConfigKind> program = std::nullopt) {
  context.phase = "reading the configuration";
  LoadedScene& file = configured.file;
  file.path = path;
  static_cast<void>(context.files.read(named_file("configuration", path)));  // the first
  Result<std::string> text = read_file(path, Limits{}.value_bytes);
  if (!text) {
    file.unreadable = text.error();
    return status_of(file);
  }
  file.text = *std::move(text);
  const CourseConfig config = read_config(file.text, Limits{}, file.diagnostics, program);
  check_picture_format(config, file.diagnostics);
  configured.kind = config.kind;
  configured.scene = config.scene;
  configured.output = config.output;
  configured.words = config.kind == ConfigKind::ray ? ray_words(config) : path_words(config);
  configured.words.push_back(fmt::format("--size={}x{}", config.width, config.height));
  return status_of(file);
}

ExitCode read_and_print(ExitCode status, const Configured& configured) {
  if (status != ExitCode::fine) {
    say(findings_text(configured.file, Verbosity::warnings, wants_color(Stream::chatter)));
  }
  return status;
}

}  // namespace

bool is_config_name(std::string_view name) {
  return lower_case(name).ends_with(".ini");
}

ExitCode read_configuration(const std::string& path, Context& context, Configured& configured) {
  return read_and_print(read_quietly(path, context, configured), configured);
}

std::optional<ConfigKind> course_program(std::string_view program) {
  const std::string_view name = program.substr(program.rfind('/') + 1);
  for (std::size_t i = 0; i < programs.size(); ++i) {
    if (name == programs[i].name) {
      return static_cast<ConfigKind>(i);
    }
  }
  return std::nullopt;
}

ExitCode read_course_arguments(ConfigKind program, std::span<const char* const> words,
                               Context& context, Configured& configured) {
  const auto& [program_name, tracer, help] = info_of(program);
  const std::string_view path = words.empty() ? std::string_view() : words.front();
  if (path == "--help" || path == "-h") {
    return answer(std::string(help));
  }
  if (words.size() != 1) {
    return fail(ExitCode::usage,
                fmt::format("expected one argument, a configuration: {} CONFIG.ini", program_name));
  }
  const ExitCode status = read_quietly(std::string(path), context, configured, program);
  const std::string name = escaped(path, 4096);
  if ((status == ExitCode::findings || status == ExitCode::limit) && is_scene(configured.file)) {
    say_error(fmt::format("{} is a scene; {} takes a configuration that names the scene", name,
                          program_name));
    say(fmt::format(
        "\"{} --help\" shows one. To draw the scene itself: scenefile render {} -o "
        "OUT.png {}\n",
        program_name, name, program == ConfigKind::ray ? "--profile course" : "--mode path"));
    return ExitCode::findings;
  }
  if (status == ExitCode::fine && configured.kind != program) {
    say(findings_text(configured.file, Verbosity::warnings, wants_color(Stream::chatter)));
    return fail(
        ExitCode::findings,
        fmt::format("{} is a configuration of the {}, not of the {}: use {}, or scenefile "
                    "render",
                    name, info_of(configured.kind).tracer, tracer, info_of(configured.kind).name));
  }
  return read_and_print(status, configured);
}

}  // namespace scenefile::app
