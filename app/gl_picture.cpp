#include "app/gl_picture.h"

#include "app/realtime.h"
#include "scenefile/view/codes.h"
#include "scenefile/view/draw_options.h"
#include "scenefile/view/headless.h"

#include <fmt/format.h>

#include <optional>
#include <utility>

namespace scenefile::app {

struct GlPainter::State {
  HeadlessDevice gl;
  std::optional<Drawing> drawing;
  bool copies_left_out = false;  // as reported
  bool shadows_left_out = false;
};

GlPainter::GlPainter(const Options& options, LoadedScene& scene)
    : options_(options), scene_(scene) {}

GlPainter::~GlPainter() = default;

Outcome GlPainter::draw(Image& image, GlReport& report, Context& context) {
  context.phase = "drawing with OpenGL";
  const RenderScene& ready = scene_.ready.scene;
  if (state_ == nullptr) {
    Result<HeadlessDevice> gl = open_headless_device();
    if (!gl) {
      return {ExitCode::environment, fmt::format("--engine gl: {}", gl.error().text)};
    }
    auto state = std::make_unique<State>();
    state->gl = *std::move(gl);
    state->drawing.emplace(upload(*state->gl.device, ready, scene_.assets,
                                  upload_options(options_.render), scene_.diagnostics));
    if (options_.realtime) {
      // For the assignment Realtime, realtime.not-drawn reports this.
      scene_.diagnostics.rewrite([](const Code& code, Severity severity) {
        return &code == &"gl.not-drawn"_code ? std::nullopt : std::optional(severity);
      });
    }
    state_ = std::move(state);
  }
  DrawOptions draw = draw_options(options_.render);
  draw.realtime = realtime_options(options_);
  if (was_given(options_, "--samples")) {
    draw.samples = options_.render.samples;
  }
  DrawStats stats;
  Result<Image> drawn = draw_image(*state_->gl.device, *state_->drawing, ready.camera, draw,
                                   options_.render.width, options_.render.height, &stats);
  if (stats.left_out != 0 && !std::exchange(state_->copies_left_out, true)) {
    scene_.diagnostics.report(
        "gl.copies-left-out"_code, {},
        fmt::format("the picture shows more than OpenGL draws in a reasonable time: of {} objects "
                    "the farthest {} are left out; the ray tracer draws them all",
                    stats.objects + stats.left_out, stats.left_out));
  }
  if (stats.shadowless != 0 && !std::exchange(state_->shadows_left_out, true)) {
    scene_.diagnostics.report(
        "gl.shadows-left-out"_code, {},
        fmt::format(
            "there are more lights than OpenGL keeps shadows for: {} of {} {} no shadows; the "
            "ray tracer draws them all",
            stats.shadowless, ready.lights.size(), stats.shadowless == 1 ? "throws" : "throw"));
  }
  report = {state_->gl.device->renderer(),
            stats.draw_calls,
            stats.shadow_maps,
            stats.objects,
            stats.triangles,
            stats.samples};
  if (!drawn) {
    return {ExitCode::environment, drawn.error().text};
  }
  image = *std::move(drawn);
  return {};
}

}  // namespace scenefile::app
