#include "app/gl_picture.h"

#include "scenefile/view/codes.h"
#include "scenefile/view/headless.h"

#include <fmt/format.h>

namespace scenefile::app {

namespace {

// Samples of a pixel where nobody asks for a number; 0: by the size of the objects.
int default_samples(const RenderOptions& options) {
  if (options.profile == Profile::fine) {
    return 0;
  }
  return options.features.super_sample ? 16 : 1;
}

DrawOptions draw_options(const Options& options) {
  const RenderOptions render = render_options(options);
  DrawOptions result;
  const bool ray = render.mode == Mode::ray;
  result.mode = render.mode == Mode::normals ? DrawMode::normals : DrawMode::shaded;
  result.course = render.profile == Profile::course;
  result.shadows = ray && render.features.shadows;
  result.textures = ray && render.features.texture;
  result.texture_filter = render.features.texture_filter;
  result.transparency = ray && render.features.refract;
  result.directional_only = result.course && render.mode == Mode::intersect;
  result.samples = options.samples.value_or(default_samples(render));
  return result;
}

}  // namespace

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
  UploadOptions upload_options;
  upload_options.flat_meshes = options.profile == Profile::course;
  Drawing drawing = upload(*device, ready, scene.assets, upload_options, scene.diagnostics);
  DrawStats stats;
  image = draw_image(*device, drawing, ready.camera, draw_options(options), options.width,
                     options.height, error, &stats);
  if (stats.left_out != 0) {
    scene.diagnostics.report(
        gl_copies_left_out, {},
        fmt::format("the picture shows more than OpenGL draws in a fit time: of {} objects the "
                    "farthest {} are left out; the ray tracer draws them all",
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
