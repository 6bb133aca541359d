#include "app/carry_files.h"
#include "app/codes.h"
#include "app/command.h"
#include "app/findings.h"
#include "app/json.h"
#include "app/load.h"
#include "app/output.h"
#include "scenefile/base/report.h"
#include "scenefile/base/text.h"
#include "scenefile/format/layout.h"
#include "scenefile/io/file.h"

#include <fmt/format.h>

namespace scenefile::app {

namespace {

std::string_view format_name(SceneFormat format) {
  return format == SceneFormat::xml ? "XML" : "JSON";
}

// What would make the work useless, found before it starts.
ExitCode check_target(const std::string& input, const std::string& output) {
  if (same_file(input, output)) {
    say_error("the output would replace the scene; choose another name");
    return ExitCode::usage;
  }
  if (const IoError error = check_writable(output); !error.empty()) {
    say_error(error.text);
    return ExitCode::environment;
  }
  return ExitCode::fine;
}

// Notes of the reader are no news to one who converts; those of the writer say what it changed.
void drop_notes(Diagnostics& diagnostics) {
  diagnostics.rewrite([](const Code&, Severity severity) {
    return severity == Severity::note ? std::nullopt : std::optional(severity);
  });
}

std::string convert(LoadedScene& scene, const Options& options, SceneFormat format,
                    Context& context) {
  drop_notes(scene.diagnostics);
  if (const std::size_t comments = count_comments(scene.text); comments != 0) {
    scene.diagnostics.report(
        convert_comments, {},
        fmt::format("{} comment{} not carried over", comments, comments == 1 ? " is" : "s are"));
  }
  context.phase = "looking for textures and meshes";
  carry_files(scene, options.arguments[1], options);
  context.phase = "writing the scene";
  return write_scene(scene.written, format, options.limits, scene.diagnostics);
}

std::string summary_text(const ConvertReport& report) {
  return fmt::format("{}: {}, {} bytes\n",
                     report.output == "-" ? "<stdout>" : escaped(report.output, 4096),
                     format_name(report.format), report.bytes);
}

// A verdict only where there is something to judge.
std::string findings_of(const LoadedScene& scene, bool quiet) {
  const bool color = wants_color(Stream::chatter);
  if (quiet || status_of(scene) != ExitCode::fine) {
    return findings_text(scene, quiet ? Verbosity::errors : Verbosity::warnings, color);
  }
  return report_text(scene.diagnostics, shown_name(scene.path), scene.text, {.color = color});
}

}  // namespace

ExitCode run_convert(const Options& options, Context& context) {
  ConvertReport report{.output = options.arguments[1], .format = *options.to};
  if (const ExitCode status = check_target(options.arguments[0], report.output);
      status != ExitCode::fine) {
    return status;
  }
  LoadedScene scene = load_scene(options.arguments[0], options, LoadDepth::prepared,
                                 /*allow_missing=*/true, context);
  std::string text;
  if (status_of(scene) == ExitCode::fine) {
    text = convert(scene, options, report.format, context);
  }
  ExitCode status = status_of(scene);
  report.error =
      status == ExitCode::fine ? write_file(report.output, text).text : "the scene cannot be used";
  report.bytes = text.size();
  if (status == ExitCode::fine && !report.error.empty()) {
    status = ExitCode::environment;
  }
  if (options.json) {
    return report.output == "-" ? status : worse(status, answer(convert_json(scene, report)));
  }
  say(findings_of(scene, options.quiet));
  if (status_of(scene) == ExitCode::fine && !report.error.empty()) {
    say_error(report.error);
  } else if (status == ExitCode::fine && !options.quiet) {
    say(summary_text(report));
  }
  return status;
}

}  // namespace scenefile::app
