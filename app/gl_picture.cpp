#include "app/gl_picture.h"

#include "app/realtime.h"
#include "scenefile/view/codes.h"
#include "scenefile/view/draw_options.h"
#include "scenefile/view/headless.h"

#include <fmt/format.h>

namespace scenefile::app {

Outcome draw_with_gl(const Options& options, LoadedScene& scene, Image& image, GlReport& report,
                     Context& context) {
  context.phase = "drawing with OpenGL";
  std::string error;
  const auto gl = HeadlessContext::create(error);
  const auto device = gl == nullptr ? nullptr : GlDevice::create(gl->get_proc_address(), error);
  if (device == nullptr) {
    return {ExitCode::environment, fmt::format("--engine gl: {}", error)};
  }
  const RenderScene& ready = scene.ready.scene;
  Drawing drawing =
      upload(*device, ready, scene.assets, upload_options(options.render), scene.diagnostics);
  if (options.realtime) {
    // For the assignment, realtime.not-drawn reports this.
    scene.diagnostics.rewrite([](const Code& code, Severity severity) {
      return &code == &gl_not_drawn ? std::nullopt : std::optional(severity);
    });
  }
  DrawOptions draw = draw_options(options.render);
  draw.realtime = realtime_options(options);
  if (was_given(options, "--samples")) {
    draw.samples = options.render.samples;
  }
  DrawStats stats;
  image = draw_image(*device, drawing, ready.camera, draw, options.render.width,
                     options.render.height, error, &stats);
  if (stats.left_out != 0) {
    scene.diagnostics.report(
        gl_copies_left_out, {},
        fmt::format("the picture shows more than OpenGL draws in a reasonable time: of {} objects "
                    "the farthest {} are left out; the ray tracer draws them all",
                    stats.objects + stats.left_out, stats.left_out));
  }
  if (stats.shadowless != 0) {
    scene.diagnostics.report(
        gl_shadows_left_out, {},
        fmt::format(
            "there are more lights than OpenGL keeps shadows for: {} of {} {} no shadows; the "
            "ray tracer draws them all",
            stats.shadowless, ready.lights.size(), stats.shadowless == 1 ? "throws" : "throw"));
  }
  report = {device->renderer(), stats.draw_calls, stats.shadow_maps,
            stats.objects,      stats.triangles,  stats.samples};
  return {error.empty() ? ExitCode::fine : ExitCode::environment, error};
}

}  // namespace scenefile::app
