#include "app/command.h"
#include "app/load.h"
#include "app/named_files.h"
#include "app/output.h"
#include "app/realtime.h"
#include "app/view_answers.h"
#include "scenefile/format/recognize.h"
#include "scenefile/io/file.h"
#include "scenefile/io/folder.h"
#include "scenefile/viewer/playlist.h"
#include "scenefile/viewer/recent_files.h"
#include "scenefile/viewer/window.h"

#include <fmt/format.h>

#include <cstdlib>
#include <utility>
#include <vector>

namespace scenefile::app {

namespace {

// Runs on a thread of the window.
viewer::OpenedScene open_for_view(const viewer::SceneRequest& request, Options options) {
  Context context;
  options.load.materials = options.load.materials || request.materials;
  const bool allow_missing = options.load.allow_missing;
  LoadedScene loaded =
      request.text
          ? load_scene_text(request.path, *request.text, options, LoadDepth::with_all_assets,
                            allow_missing, context)
          : load_scene(request.path, options, LoadDepth::with_all_assets, allow_missing, context);
  check_picture(loaded);
  viewer::OpenedScene opened;
  if (loaded.usable()) {
    for (const AssetFile& file : locate_files(loaded, options)) {
      opened.files.push_back(file.resolved.path);
    }
  }
  opened.path = request.path;
  opened.text = std::move(loaded.text);
  opened.unreadable = loaded.unreadable ? loaded.unreadable->text : "";
  opened.written = std::move(loaded.written);
  opened.ready = std::move(loaded.ready);
  opened.assets = std::move(loaded.assets);
  opened.diagnostics = std::move(loaded.diagnostics);
  return opened;
}

// Why the window cannot open; empty if it can. A scene that does not exist is a new one, but a
// picture of it would show nothing.
std::string missing(const Options& options) {
  if (options.arguments.empty()) {
    return {};
  }
  const std::string& scene = options.arguments.front();
  if (scene != "-" && viewer::scene_at(scene).empty()) {
    return scene + ": there is no scene in this folder";
  }
  const bool edited = options.screenshot.empty() || !options.script.empty();
  const bool can_be_new = edited && is_scene_name(scene) && is_folder(folder_of(scene));
  if (scene != "-" && !stamp_of(scene).exists && !can_be_new) {
    return scene + ": there is no such file";
  }
  return {};
}

// The pictures that are compared.
std::vector<std::string> pictures_of(const Options& options) {
  std::vector<std::string> pictures;
  for (const std::string& path : {options.reference, options.mine}) {
    if (!path.empty()) {
      pictures.push_back(path);
    }
  }
  if (options.arguments.size() > 1) {
    pictures.push_back(options.arguments[1]);
  }
  return pictures;
}

viewer::ScriptStep& add_step(viewer::Script& script, viewer::StepKind kind) {
  viewer::ScriptStep step;
  step.kind = kind;
  return script.steps.emplace_back(std::move(step));
}

// The scripted steps, after which the window closes.
Result<viewer::Script> script_of(const Options& options) {
  Result<std::string> text = std::string();
  if (!options.script.empty()) {
    text = read_file(options.script, options.load.limits.file_bytes);
  }
  if (!text) {
    return text.error();
  }
  viewer::Script script = viewer::parse_script(*text);
  if (!options.screenshot.empty()) {
    add_step(script, viewer::StepKind::settle);
    add_step(script, viewer::StepKind::frames).number = options.frames;
    add_step(script, viewer::StepKind::screenshot).text = options.screenshot;
  }
  if (script.steps.empty() && !options.script.empty()) {
    add_step(script, viewer::StepKind::settle);
  }
  if (!script.steps.empty()) {
    add_step(script, viewer::StepKind::quit);
  }
  return script;
}

// Adds the pictures and texts that the script writes to context.files. Its step `copy` is meant to
// replace a file, like an editor.
Outcome claim_script_outputs(const Options& options, const viewer::Script& script,
                             Context& context) {
  std::vector<UsedFile> outputs;
  for (const viewer::ScriptStep& step : script.steps) {
    if (step.kind == viewer::StepKind::screenshot || step.kind == viewer::StepKind::copied ||
        step.kind == viewer::StepKind::times) {
      outputs.push_back(named_file(
          step.kind == viewer::StepKind::screenshot ? "screenshot" : "output", step.text));
    }
  }
  std::vector<UsedFile> inputs;
  if (!outputs.empty() && !options.arguments.empty() && options.arguments.front() != "-") {
    const LoadedScene scene = load_scene(viewer::scene_at(options.arguments.front()), options,
                                         LoadDepth::prepared, true, context);
    inputs = used_files(scene, options.access, options.load.limits);
  }
  Outcome claimed = claim_inputs(inputs, context);
  return claimed.status == ExitCode::fine ? claim_outputs(outputs, context) : claimed;
}

void set_tracing(const Options& options, viewer::SessionSetup& setup) {
  const bool paths = options.render.mode == Mode::path;
  setup.trace = paths ? default_options(Profile::fine) : options.render;
  setup.trace.threads = options.render.threads;
  if (paths || !may_choose_path_mode(options) || !option_without_paths(options).empty()) {
    setup.trace_paths = paths;
  }
  Options traced = options;
  set_path_mode(traced);
  setup.paths = traced.render;
  // Without a number of samples, the noise says when there are enough.
  if (was_given(options, "--samples")) {
    setup.samples = options.render.samples;
    setup.path_noise = 0;
  } else {
    setup.paths.samples = viewer::most_path_samples;
  }
}

viewer::WindowOptions window_options(const Options& options, viewer::Script script) {
  viewer::WindowOptions window;
  window.setup.load = [&options](const viewer::SceneRequest& request) {
    return open_for_view(request, options);
  };
  window.setup.read = {.compat_course = options.load.compat_course, .limits = options.load.limits};
  set_tracing(options, window.setup);
  window.setup.explain_pixel = explain_for_view;
  window.setup.find_cause = [&options](const viewer::CauseQuestion& question,
                                       const std::function<bool()>& go_on) {
    return cause_for_view(question, options, go_on);
  };
  window.setup.fit_picture = [&options](const viewer::FitQuestion& question) {
    return fit_for_view(question, options);
  };
  window.setup.realtime = realtime_options(options);
  window.setup.layer = options.layer;
  window.scene = options.arguments.empty() ? "" : options.arguments.front();
  window.reference = options.reference;
  window.mine = options.mine;
  window.picture = options.arguments.size() > 1 ? options.arguments[1] : "";
  if (script.steps.empty()) {
    window.settings = viewer::user_path(std::getenv("XDG_CONFIG_HOME"), std::getenv("HOME"),
                                        ".config", "view.ini");
    window.setup.recent_files = viewer::user_path(std::getenv("XDG_STATE_HOME"),
                                                  std::getenv("HOME"), ".local/state", "recent");
  }
  if (options.window[0] != 0) {
    window.size = {options.window[0], options.window[1]};
  }
  if (options.live_trace) {
    window.ray_tracing = true;
  }
  window.script = std::move(script);
  return window;
}

void say_failure(const viewer::WindowResult& result) {
  const bool no_display = result.status == viewer::WindowStatus::no_display;
  say_error(result.error +
            (no_display ? "; \"scenefile render\" draws to a file without a screen" : ""));
}

}  // namespace

ExitCode run_view(const Options& options, Context& context) {
  if (const std::string text = missing(options); !text.empty()) {
    return fail(ExitCode::environment, text);
  }
  Result<viewer::Script> script = script_of(options);
  if (!script) {
    return fail(ExitCode::environment, script.error().text);
  }
  if (!script->wrong.empty()) {
    return fail(ExitCode::usage, fmt::format("{}: {}", options.script, script->wrong));
  }
  if (const Outcome refused = claim_script_outputs(options, *script, context);
      refused.status != ExitCode::fine) {
    return fail(refused);
  }
  const bool unattended = !script->steps.empty();
  for (const std::string& path : pictures_of(options)) {  // later, only the window would say so
    if (!stamp_of(path).exists) {
      return fail(ExitCode::environment, path + ": there is no such file");
    }
    const Result<DecodedPicture> picture =
        unattended ? load_picture_file(path, options.layer, options.load.limits) : DecodedPicture();
    if (!picture) {
      return fail(picture.error());
    }
  }
  context.phase = "showing the window";
  viewer::WindowOptions window = window_options(options, *std::move(script));
  bool opened = true;
  window.failed = [&](const viewer::WindowResult& result) {
    opened = false;
    say_failure(result);
  };
  const viewer::WindowResult result = viewer::run_window(window);
  if (result.status != viewer::WindowStatus::closed) {
    if (opened) {
      say_failure(result);
    }
    return ExitCode::environment;
  }
  if (unattended && !result.shown) {
    return fail(ExitCode::findings,
                "the window could not show the scene; \"scenefile check\" says why");
  }
  return ExitCode::fine;
}

}  // namespace scenefile::app
