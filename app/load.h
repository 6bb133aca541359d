#pragma once
// Loads scenes with the options of the command line, and converts results to exit statuses.

#include "app/command.h"
#include "scenefile/trace/render.h"
#include "scenefile/verbs/findings.h"
#include "scenefile/verbs/load_file.h"

#include <string>

namespace scenefile::app {

/// An empty error means success.
struct Outcome {
  ExitCode status = ExitCode::fine;
  std::string error;
};

/// load_scene_file() with the options. Adds the scene and its assets to context.files, if the
/// options name an output: a scene that has the output as an asset is unreadable
/// (ErrorKind::usage).
LoadedScene load_scene(const std::string& path, const Options& options, LoadDepth depth,
                       bool allow_missing, Context& context);

/// The same for the text that the file has or is to have.
LoadedScene load_scene_text(const std::string& path, std::string text, const Options& options,
                            LoadDepth depth, bool allow_missing, Context& context);

/// Loads the scene with the assets that a picture with these options needs, and adds findings that
/// depend on the options. Sets mode path for a scene without lights whose faces emit light, unless
/// an option excludes it.
LoadedScene load_for_tracing(Options& options, Context& context);

/// Where the files of a scene at `path` may be.
AssetRootsOptions asset_roots_options(const std::string& path, const Options& options);
std::vector<AssetFile> locate_files(const LoadedScene& scene, const Options& options);

ExitCode exit_code(ErrorKind kind);
/// The exit status for the scene's findings so far.
ExitCode status_of(const LoadedScene& scene);
/// The same with an error that does not repeat the findings.
Outcome outcome_of(const LoadedScene& scene);
Outcome outcome_of(const Result<void>& result);
/// Converts the tracer's status.
Outcome outcome_of(RenderStatus status, const Context& context);
/// The same for errors from the tracer.
Outcome outcome_of(const Error& error, const Context& context);
/// Answers in JSON, and says on standard error why the command failed, if it did.
ExitCode answer_json(const Outcome& outcome, const std::string& json);
/// Says why a command ends (output.h).
ExitCode fail(const Outcome& outcome);
ExitCode fail(const Error& error);

}  // namespace scenefile::app
