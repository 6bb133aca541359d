#pragma once
// Loading scenes as the command line asks, and what became of them as exit statuses.

#include "app/command.h"
#include "scenefile/trace/render.h"
#include "scenefile/verbs/findings.h"
#include "scenefile/verbs/load_file.h"

#include <string>

namespace scenefile::app {

/// Nothing went wrong where the error is empty.
struct Outcome {
  ExitCode status = ExitCode::fine;
  std::string error;
};

/// load_scene_file() with the options.
LoadedScene load_scene(const std::string& path, const Options& options, LoadDepth depth,
                       bool allow_missing, Context& context);

/// Loads the scene with the files that a render with the options looks at, and adds warnings of
/// what only the way of rendering makes doubtful.
LoadedScene load_for_tracing(const Options& options, Context& context);

/// Where the files may be that a scene at `path` names.
AssetRootsOptions asset_roots_options(const std::string& path, const Options& options);
std::vector<AssetFile> locate_files(const LoadedScene& scene, const Options& options);

ExitCode exit_code(ErrorKind kind);
/// The exit status that the scene has earned so far.
ExitCode status_of(const LoadedScene& scene);
Outcome outcome_of(const Result<void>& result);
/// What the tracer's status means to the program.
Outcome judge(RenderStatus status, const Context& context);
/// The same of an error that the tracer is behind.
Outcome judge(const Error& error, const Context& context);

}  // namespace scenefile::app
