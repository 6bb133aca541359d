#include "app/load.h"

#include "app/named_files.h"
#include "app/output.h"
#include "scenefile/io/interrupt.h"
#include "scenefile/io/parallel.h"
#include "scenefile/verbs/render_error.h"

#include <fmt/format.h>

#include <csignal>
#include <utility>

namespace scenefile::app {

namespace {

LoadSettings settings_of(const Options& options, LoadDepth depth, bool allow_missing,
                         Context& context) {
  LoadSettings settings = options.load;
  settings.depth = depth;
  settings.allow_missing = allow_missing;
  settings.materials = settings.materials || options.render.mode == Mode::path;
  settings.entering = [&](const char* phase) { context.phase = phase; };
  settings.for_each = [&](std::size_t count, const std::function<void(std::size_t)>& work) {
    for_each_index(count, options.render.threads, work);
  };
  return settings;
}

}  // namespace

LoadedScene load_scene_text(const std::string& path, std::string text, const Options& options,
                            LoadDepth depth, bool allow_missing, Context& context) {
  return scenefile::load_scene_text(
      path, std::move(text), settings_of(options, depth, allow_missing, context), options.access);
}

LoadedScene load_scene(const std::string& path, const Options& options, LoadDepth depth,
                       bool allow_missing, Context& context) {
  const LoadSettings settings = settings_of(options, depth, allow_missing, context);
  LoadedScene scene = load_scene_file(path, settings, options.access);
  if (!scene.unreadable && writes_files(options)) {
    for (const UsedFile& file : used_files(scene, options.access, options.load.limits)) {
      if (const Result<void> added = context.files.read(file); !added) {
        scene.unreadable = added.error();
        break;
      }
    }
  }
  return scene;
}

LoadedScene load_for_tracing(Options& options, Context& context) {
  LoadedScene scene = load_scene(options.arguments.front(), options, depth_for(options.render),
                                 options.load.allow_missing, context);
  if (options.render.mode != Mode::path && may_choose_path_mode(options) &&
      lit_by_faces_only(scene)) {
    const std::string other = option_without_paths(options);
    if (other.empty()) {
      set_path_mode(options);
    }
    if (!options.quiet && !options.json) {
      say(other.empty()
              ? "note: faces of this scene emit light, and it has no lights: using --mode path\n"
              : fmt::format("note: {} is not for path tracing, so this scene is ray traced\n",
                            other));
    }
  }
  if (options.render.mode == Mode::path && options.render.denoise && options.render.samples == 1 &&
      !options.quiet && !options.json) {
    say("note: the noise of one sample per pixel is unknown, so --denoise changes nothing\n");
  }
  check_picture(scene, options.render);
  return scene;
}

AssetRootsOptions asset_roots_options(const std::string& path, const Options& options) {
  return asset_roots_options(path, options.access, options.load.limits);
}

std::vector<AssetFile> locate_files(const LoadedScene& scene, const Options& options) {
  return locate_files(scene, options.access, options.load.limits);
}

ExitCode exit_code(ErrorKind kind) {
  switch (kind) {
    case ErrorKind::environment:
      return ExitCode::environment;
    case ErrorKind::limit:
      return ExitCode::limit;
    case ErrorKind::input:
      return ExitCode::findings;
    case ErrorKind::usage:
      return ExitCode::usage;
    case ErrorKind::cancelled:
      return DeferredSignals::pending() == SIGTERM ? ExitCode::terminated : ExitCode::interrupted;
  }
  return ExitCode::fine;
}

ExitCode status_of(const LoadedScene& scene) {
  const std::optional<ErrorKind> failure = failure_of(scene);
  return failure ? exit_code(*failure) : ExitCode::fine;
}

Outcome outcome_of(const LoadedScene& scene) {
  const ExitCode status = status_of(scene);
  return {status, status == ExitCode::fine ? "" : "the scene cannot be used"};
}

Outcome outcome_of(const Result<void>& result) {
  return result ? Outcome() : Outcome{exit_code(result.error().kind), result.error().text};
}

Outcome outcome_of(RenderStatus status, const Context& context) {
  const std::optional<Error> error = render_error(status);
  return error ? outcome_of(*error, context) : Outcome();
}

Outcome outcome_of(const Error& error, const Context& context) {
  if (error.kind == ErrorKind::environment && context.max_memory != 0) {
    return {ExitCode::limit,
            fmt::format("more memory than --max-memory {} is needed for building the "
                        "acceleration structure",
                        context.max_memory)};
  }
  return {exit_code(error.kind), error.text};
}

ExitCode answer_json(const Outcome& outcome, const std::string& json) {
  if (!outcome.error.empty()) {
    say_error(outcome.error);
  }
  return worse(outcome.status, answer(json));
}

ExitCode fail(const Outcome& outcome) {
  return fail(outcome.status, outcome.error);
}

ExitCode fail(const Error& error) {
  return fail(exit_code(error.kind), error.text);
}

}  // namespace scenefile::app
