#include "app/tracing.h"

#include "app/codes.h"
#include "app/findings.h"
#include "scenefile/io/interrupt.h"
#include "scenefile/scene/codes.h"

#include <fmt/format.h>

#include <algorithm>
#include <csignal>

namespace scenefile::app {

namespace {

// Whether the course's ray caster would see no light at all.
bool dark_in_caster(const RenderOptions& options, const RenderScene& scene) {
  return options.profile == Profile::course && options.mode == Mode::intersect &&
         !scene.lights.empty() &&
         std::none_of(scene.lights.begin(), scene.lights.end(),
                      [](const RenderLight& l) { return l.type == LightType::directional; });
}

// Whether the picture depends on what an absent transparentcoeff means.
bool guesses_transparency(const RenderOptions& options) {
  return options.profile == Profile::fine && options.mode == Mode::ray && options.features.refract;
}

// What the way of rendering makes doubtful, and what it makes sure.
void judge_picture(const RenderOptions& options, LoadedScene& scene) {
  ViewQuestion question;
  question.aspect = static_cast<double>(options.width) / options.height;
  question.shadows = options.mode == Mode::ray && options.features.shadows;
  check_picture(scene, question);
  if (dark_in_caster(options, scene.ready.scene)) {
    scene.diagnostics.report(render_no_directional_light, {},
                             "the scene has no directional light, and the course's ray caster "
                             "knows no other");
  }
  if (!guesses_transparency(options)) {
    scene.diagnostics.rewrite([](const Code& code, Severity severity) {
      return &code == &global_transparent_default ? std::nullopt : std::optional(severity);
    });
  }
}

}  // namespace

LoadedScene load_for_tracing(const Options& options, const RenderOptions& render,
                             Context& context) {
  const bool textures = render.mode == Mode::ray && render.features.texture;
  LoadedScene scene = load_scene(options.arguments.front(), options,
                                 textures ? LoadDepth::with_all_assets : LoadDepth::with_meshes,
                                 options.allow_missing, context);
  if (status_of(scene) == ExitCode::fine) {
    judge_picture(render, scene);
  }
  return scene;
}

Outcome judge(RenderStatus status, const Context& context) {
  switch (status) {
    case RenderStatus::complete:
      return {};
    case RenderStatus::cancelled:
      return {DeferredSignals::pending() == SIGTERM ? ExitCode::terminated : ExitCode::interrupted,
              "interrupted"};
    case RenderStatus::not_resumed:
      return {ExitCode::findings, "the checkpoint is of another picture"};
    case RenderStatus::limit_reached:
      return {ExitCode::limit, "templates are nested deeper than can be traced"};
    case RenderStatus::failed:
      if (context.max_memory != 0) {
        return {ExitCode::limit,
                fmt::format("more memory than --max-memory {} is needed for building the "
                            "acceleration structure",
                            context.max_memory)};
      }
      return {ExitCode::environment, "out of memory while building the acceleration structure"};
  }
  return {};
}

}  // namespace scenefile::app
