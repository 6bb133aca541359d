#include "app/command.h"
#include "app/load.h"
#include "app/output.h"
#include "app/realtime.h"
#include "app/scene_files.h"
#include "scenefile/base/text.h"
#include "scenefile/edit/fix.h"
#include "scenefile/verbs/sarif.h"
#include "scenefile/verbs/scene_json.h"

#include <fmt/format.h>

#include <cstddef>
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

namespace scenefile::app {

namespace {

// Collects the findings of the scenes.
class Report {
 public:
  Report(const Options& options, std::size_t scenes) : options_(options), scenes_(scenes) {}

  // Returns an error if nothing more can be printed. `fixes`: null without --fix.
  ExitCode add(const LoadedScene& scene, const FixReport* fixes) {
    tally_.add(scene);
    if (fixes != nullptr && !options_.json) {
      print(scene, *fixes);
    }
    if (options_.json) {
      json_.push_back(scene_json(scene, fixes));
    } else if (options_.sarif) {
      sarif_.add(scene);
    } else {
      return print(scene);
    }
    return ExitCode::fine;
  }

  // `status`: the exit status of the scenes.
  ExitCode finish(ExitCode status) const {
    if (options_.json) {
      return answer(check_json(json_));
    }
    if (options_.sarif) {
      return answer(sarif_.text(static_cast<int>(status)));
    }
    const bool wanted = scenes_ > 1 && !options_.quiet;
    return wanted ? print(tally_.text(), beside_answer_) : ExitCode::fine;
  }

 private:
  ExitCode print(const LoadedScene& scene) const {
    const bool aside = scene.unreadable || beside_answer_;
    return print(findings_text(scene, options_.quiet ? Verbosity::errors : Verbosity::all,
                               wants_color(aside ? Stream::chatter : Stream::answer)),
                 aside);
  }

  void print(const LoadedScene& scene, const FixReport& fixes) {
    if (!fixes.error.empty()) {
      say_error(fixes.error);
    }
    beside_answer_ = beside_answer_ || options_.dry_run || scene.path == "-";
    std::string text;
    for (const Diagnostic& d : fixes.made) {
      text +=
          fmt::format("{}:{}:{}: fixed: {} [{}]\n", escaped(shown_name(scene.path), 4096),
                      d.location.line, d.location.column, escaped(d.message, 4096), d.code->name);
    }
    if (!options_.quiet && !options_.sarif) {
      print(text, beside_answer_);
    }
  }

  static ExitCode print(const std::string& text, bool aside) {
    if (!aside) {
      return answer(text);
    }
    say(text);
    return ExitCode::fine;
  }

  const Options& options_;
  std::size_t scenes_;
  bool beside_answer_ = false;  // standard output has a file or a difference
  VerdictCounts tally_;
  std::vector<std::string> json_;
  SarifLog sarif_;
};

// The files of a run, each to be fixed once.
class Fixer {
 public:
  Fixer(const Options& options, Context& context) : options_(options), context_(context) {}

  // Fixes the file at the path of the scene, and replaces the text of the scene. Without an error,
  // scene.text is then what the file has, or with --dry-run would have.
  FixReport fix(LoadedScene& scene) {
    FixReport report;
    if (!is_first(scene.path)) {
      return report;
    }
    context_.phase = "fixing the file";
    FixedText fixed = fix_text(
        scene.text, {.compat_course = options_.load.compat_course, .limits = options_.load.limits},
        options_.policy.allowed);
    if (!fixed.refused.empty() && !options_.quiet) {
      say(fmt::format("{}: not fixed: {}\n", escaped(shown_name(scene.path), 4096), fixed.refused));
    }
    if (options_.dry_run) {
      report.error = show(unified_diff(scene.text, fixed.text, shown_name(scene.path)));
    } else if (fixed.text != scene.text || scene.path == "-") {
      context_.phase = "writing the file";
      report.error = error_text(write_file(scene.path, fixed.text));
    }
    if (report.error.empty()) {
      scene.text = std::move(fixed.text);
      report.made = std::move(fixed.made);
    }
    return report;
  }

 private:
  bool is_first(const std::string& path) {
    std::error_code error;
    const std::filesystem::path file = std::filesystem::canonical(path, error);
    return error || seen_.insert(file).second;
  }

  std::string show(const std::string& diff) const {
    const bool shown = options_.json || options_.sarif || answer(diff) == ExitCode::fine;
    return shown ? std::string() : std::string("the differences could not be printed");
  }

  const Options& options_;
  Context& context_;
  std::set<std::filesystem::path> seen_;
};

// Reads the file and fixes it; `fixes` says how.
LoadedScene load_fixed(const std::string& path, const Options& options, LoadDepth depth,
                       Fixer& fixer, FixReport& fixes, Context& context) {
  LoadedScene scene;
  scene.path = path;
  context.phase = "reading the file";
  Result<std::string> text = read_file(path, options.load.limits.file_bytes);
  if (!text) {
    scene.unreadable = text.error();
    return scene;
  }
  scene.text = *std::move(text);
  fixes = fixer.fix(scene);
  return load_scene_text(path, std::move(scene.text), options, depth, options.load.allow_missing,
                         context);
}

}  // namespace

ExitCode run_check(const Options& options, Context& context) {
  const LoadDepth depth = options.assets ? LoadDepth::with_all_assets : LoadDepth::prepared;
  ExitCode status = ExitCode::fine;
  const std::vector<SceneFile> files = scene_files(options, context);
  Report report(options, files.size());
  Fixer fixer(options, context);
  for (const SceneFile& file : files) {
    LoadedScene scene;
    FixReport fixes;
    const bool fix = options.fix || options.dry_run;
    if (!file.unreadable && fix) {
      scene = load_fixed(file.path, options, depth, fixer, fixes, context);
    } else if (!file.unreadable) {
      scene = load_scene(file.path, options, depth, options.load.allow_missing, context);
    } else {
      scene.path = file.path;
      scene.unreadable = file.unreadable;
    }
    if (!scene.unreadable) {
      context.phase = "checking the picture";
      check_picture(scene);
      if (const auto realtime = realtime_options(options); realtime && scene.usable()) {
        check_realtime(*realtime, scene);
      }
    }
    apply_policy(options.policy, scene.diagnostics);
    status = worse(status, status_of(scene));
    status = worse(status, fixes.error.empty() ? ExitCode::fine : ExitCode::environment);
    context.phase = "writing the report";
    if (report.add(scene, fix ? &fixes : nullptr) != ExitCode::fine) {
      return ExitCode::environment;
    }
  }
  return worse(status, report.finish(status));
}

}  // namespace scenefile::app
