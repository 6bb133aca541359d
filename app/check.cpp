#include "app/command.h"
#include "app/load.h"
#include "app/output.h"
#include "app/realtime.h"
#include "app/scene_files.h"
#include "scenefile/verbs/sarif.h"
#include "scenefile/verbs/scene_json.h"

#include <cstddef>
#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

namespace scenefile::app {

namespace {

std::string path_from_here(const std::string& path) {
  std::error_code error;
  const std::filesystem::path here = std::filesystem::current_path(error);
  const std::string relative = std::filesystem::path(path).lexically_relative(here).string();
  return error || relative.empty() || relative.starts_with("..") ? path : relative;
}

// Collects the findings of the scenes.
class Report {
 public:
  Report(const Options& options, std::size_t scenes) : options_(options), scenes_(scenes) {}

  // Returns an error if nothing more can be printed.
  ExitCode add(const LoadedScene& scene) {
    tally_.add(scene);
    if (options_.json) {
      json_.push_back(scene_json(scene));
    } else if (options_.sarif) {
      sarif_.add(scene, [&](const std::string& name) { return path_of(scene, name); });
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
    return wanted ? answer(tally_.text()) : ExitCode::fine;
  }

 private:
  ExitCode print(const LoadedScene& scene) const {
    const std::string text = findings_text(
        scene, options_.quiet ? Verbosity::errors : Verbosity::all, wants_color(Stream::answer));
    if (!scene.unreadable) {
      return answer(text);
    }
    say(text);
    return ExitCode::fine;
  }

  // The path of a file of the scene, relative to the working directory if it is inside.
  std::string path_of(const LoadedScene& scene, const std::string& name) const {
    for (const AssetFile& file : locate_files(scene, options_)) {
      if (file.reference.name == name && !file.resolved.path.empty()) {
        return path_from_here(file.resolved.path);
      }
    }
    return {};
  }

  const Options& options_;
  std::size_t scenes_;
  VerdictCounts tally_;
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
    if (!file.unreadable) {
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
    context.phase = "writing the report";
    if (report.add(scene) != ExitCode::fine) {
      return ExitCode::environment;
    }
  }
  return worse(status, report.finish(status));
}

}  // namespace scenefile::app
