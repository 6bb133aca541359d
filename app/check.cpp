#include "app/command.h"
#include "app/findings.h"
#include "app/json.h"
#include "app/load.h"
#include "app/output.h"
#include "app/realtime.h"
#include "app/sarif.h"
#include "app/scene_files.h"

#include <cstddef>
#include <string>
#include <vector>

namespace scenefile::app {

namespace {

// Where the findings of one scene after the other go.
class Report {
 public:
  Report(const Options& options, std::size_t scenes) : options_(options), scenes_(scenes) {}

  // Not fine when nothing more can be said.
  ExitCode add(const LoadedScene& scene) {
    tally_.add(scene);
    if (options_.json) {
      json_.push_back(scene_json(scene));
    } else if (options_.sarif) {
      sarif_.add(scene, options_);
    } else {
      return print(scene);
    }
    return ExitCode::fine;
  }

  // `status` is that of the scenes.
  ExitCode finish(ExitCode status) const {
    if (options_.json) {
      return answer(check_json(json_));
    }
    if (options_.sarif) {
      return answer(sarif_.text(status));
    }
    const bool wanted = scenes_ > 1 && !options_.quiet;
    return wanted ? answer(tally_.text()) : ExitCode::fine;
  }

 private:
  ExitCode print(const LoadedScene& scene) const {
    const std::string text = findings_text(
        scene, options_.quiet ? Verbosity::errors : Verbosity::all, wants_color(Stream::answer));
    if (scene.unreadable.empty()) {
      return answer(text);
    }
    say(text);
    return ExitCode::fine;
  }

  const Options& options_;
  std::size_t scenes_;
  Tally tally_;
  std::vector<std::string> json_;
  SarifLog sarif_;
};

}  // namespace

ExitCode run_check(const Options& options, Context& context) {
  const LoadDepth depth = options.assets ? LoadDepth::with_all_assets : LoadDepth::prepared;
  ExitCode status = ExitCode::fine;
  const std::vector<SceneFile> files = scene_files(options, context);
  Report report(options, files.size());
  for (const SceneFile& file : files) {
    LoadedScene scene;
    if (file.unreadable.empty()) {
      scene = load_scene(file.path, options, depth, options.allow_missing, context);
    } else {
      scene.path = file.path;
      scene.unreadable = file.unreadable;
    }
    if (scene.unreadable.empty()) {
      context.phase = "checking the picture";
      check_picture(scene, {});
      if (const auto realtime = realtime_options(options);
          realtime && status_of(scene) == ExitCode::fine) {
        check_realtime(*realtime, scene);
      }
    }
    apply_policy(options, scene.diagnostics);
    status = worse(status, status_of(scene));
    context.phase = "writing the report";
    if (report.add(scene) != ExitCode::fine) {
      return ExitCode::environment;
    }
  }
  return worse(status, report.finish(status));
}

}  // namespace scenefile::app
