#include "app/projects_ray.h"

#include "app/load.h"
#include "app/named_files.h"
#include "app/output.h"
#include "scenefile/asset/image_file.h"
#include "scenefile/base/report.h"
#include "scenefile/base/text.h"
#include "scenefile/format/codes.h"
#include "scenefile/format/read_config.h"
#include "scenefile/format/recognize.h"
#include "scenefile/io/file.h"

#include <fmt/format.h>

#include <string>

namespace scenefile::app {

namespace {

constexpr std::string_view help_text =
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
    "It equals \"scenefile render\" with --profile course; \"scenefile help\" says what else there "
    "is.\n";

Features features_of(const CourseConfig& config) {
  return {.shadows = config.shadows,
          .reflect = config.reflect,
          .refract = config.refract,
          .texture = config.texture,
          .texture_filter = config.texture_filter,
          .super_sample = config.super_sample,
          .depthoffield = config.depthoffield};
}

Options options_of(const CourseConfig& config) {
  Options options;
  options.arguments = {config.scene};
  options.output = config.output;
  options.render = default_options(Profile::course);
  options.render.width = config.width;
  options.render.height = config.height;
  options.render.mode = config.only_render_normals ? Mode::normals : Mode::ray;
  options.render.features = features_of(config);
  options.render.max_depth = config.maximum_recursive_depth.value_or(options.render.max_depth);
  options.load.compat_course = true;
  return options;
}

void check_picture_format(const CourseConfig& config, Diagnostics& diagnostics) {
  if (!diagnostics.has_errors() && !image_format_of(config.output)) {
    diagnostics.report(
        config_picture_format, config.output_place,
        fmt::format("output does not end in {}; it will be a PNG", image_extensions));
  }
}

// Whether the argument is a scene instead of a configuration, by its name or first character.
bool is_scene(const LoadedScene& config) {
  const std::size_t first = config.text.find_first_not_of(" \t\r\n");
  const char start = first == std::string::npos ? ' ' : config.text[first];
  return is_scene_name(config.path) || start == '<' || start == '{';
}

}  // namespace

bool is_projects_ray(std::string_view program) {
  return program.substr(program.rfind('/') + 1) == "projects_ray";
}

ExitCode run_projects_ray(std::span<const char* const> words, Context& context) {
  const std::string_view path = words.empty() ? std::string_view() : words.front();
  if (path == "--help" || path == "-h") {
    return answer(std::string(help_text));
  }
  if (words.size() != 1) {
    say_error("expected one argument, a configuration: projects_ray CONFIG.ini");
    return ExitCode::usage;
  }
  context.phase = "reading the configuration";
  LoadedScene config;
  config.path = path;
  static_cast<void>(context.files.read(named_file("configuration", config.path)));  // the first
  CourseConfig read;
  if (Result<std::string> text = read_file(config.path, Limits{}.value_bytes); !text) {
    config.unreadable = text.error();
  } else {
    config.text = *std::move(text);
    read = read_config(config.text, Limits{}, config.diagnostics);
    check_picture_format(read, config.diagnostics);
  }
  const ExitCode read_status = status_of(config);
  if ((read_status == ExitCode::findings || read_status == ExitCode::limit) && is_scene(config)) {
    const std::string name = escaped(config.path, 4096);
    say_error(fmt::format("{} is a scene; projects_ray takes a configuration that names the scene",
                          name));
    say(
        fmt::format("\"projects_ray --help\" shows one. To draw the scene itself: scenefile render "
                    "{} -o OUT.png --profile course\n",
                    name));
    return ExitCode::findings;
  }
  say(findings_text(config, Verbosity::warnings, wants_color(Stream::chatter)));
  if (read_status != ExitCode::fine) {
    return read_status;
  }
  if (read.kind != ConfigKind::ray) {
    say_error(fmt::format("{} is a configuration of the path tracer, not of the ray tracer",
                          escaped(config.path, 4096)));
    return ExitCode::findings;
  }
  const ExitCode status = run_render(options_of(read), context);
  if (status == ExitCode::environment && !read.scene.starts_with('/')) {
    say("Relative paths of a configuration start at the working directory.\n");
  }
  return status;
}

}  // namespace scenefile::app
