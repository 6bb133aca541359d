#include "app/command.h"
#include "app/json.h"
#include "app/load.h"
#include "app/output.h"
#include "app/scene_files.h"
#include "scenefile/base/text.h"
#include "scenefile/edit/format_text.h"
#include "scenefile/io/file.h"
#include "scenefile/verbs/scene_json.h"

#include <fmt/format.h>

namespace scenefile::app {

namespace {

struct Formatted {
  LoadedScene file;  // only its text and findings
  std::optional<std::string> text;
  bool changed = false;
  std::string unwritable = {};  // an error message; empty on success
};

Formatted lay_out_file(const SceneFile& file, const Limits& limits, Context& context) {
  Formatted result;
  result.file.path = file.path;
  context.phase = "reading the file";
  result.file.unreadable = file.unreadable;
  if (!file.unreadable) {
    Result<std::string> text = read_file(file.path, limits.file_bytes);
    if (text) {
      context.phase = "formatting the file";
      result.file.text = *std::move(text);
      result.text = lay_out(result.file.text, limits, result.file.diagnostics);
    } else {
      result.file.unreadable = text.error();
    }
  }
  result.changed = result.text.has_value() && *result.text != result.file.text;
  return result;
}

ExitCode status_of(const Formatted& result, const Options& options) {
  if (!result.text.has_value()) {
    return app::status_of(result.file);
  }
  if (!result.unwritable.empty()) {
    return ExitCode::environment;
  }
  return options.check && result.changed ? ExitCode::findings : ExitCode::fine;
}

// Standard input is always copied to the output; a file is only written if it changed.
void write(Formatted& result, const Options& options, Context& context) {
  if (options.check || !result.text.has_value() || (!result.changed && result.file.path != "-")) {
    return;
  }
  context.phase = "writing the file";
  result.unwritable = error_text(write_file(result.file.path, *result.text));
}

void report(const Formatted& result, const Options& options) {
  if (!result.text.has_value()) {
    say(findings_text(result.file, Verbosity::errors, wants_color(Stream::chatter)));
  } else if (!result.unwritable.empty()) {
    say_error(result.unwritable);
  } else if (result.changed && !options.quiet && result.file.path != "-") {
    say_afterwards([&] { return fmt::format("{}: formatted\n", escaped(result.file.path, 4096)); });
  }
}

}  // namespace

ExitCode run_format(const Options& options, Context& context) {
  ExitCode status = ExitCode::fine;
  std::vector<FormatReport> reports;
  std::string would_change;
  for (const SceneFile& file : scene_files(options, context)) {
    Formatted result = lay_out_file(file, options.load.limits, context);
    write(result, options, context);
    status = worse(status, status_of(result, options));
    if (options.json) {
      reports.push_back({parsed_file_json(result.file), result.changed, result.unwritable});
    } else if (!options.check || !result.text.has_value()) {
      report(result, options);
    } else if (result.changed) {
      would_change += escaped(shown_name(file.path), 4096) + "\n";
    }
  }
  if (options.json) {
    return worse(status, answer(format_json(reports, options.check)));
  }
  return would_change.empty() ? status : worse(status, answer(would_change));
}

}  // namespace scenefile::app
