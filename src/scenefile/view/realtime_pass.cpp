#include "scenefile/view/realtime_pass.h"

#include "scenefile/view/pass.h"
#include "scenefile/view/shadows.h"

#include <algorithm>

namespace scenefile {

namespace {

// Draws the filtered picture over all of `target`.
void filter_picture(GlDevice::State& device, const PixelSurface& picture,
                    const PixelSurface& target, Filter filter) {
  const gl::Functions& gl = device.gl;
  gl.BindFramebuffer(gl::FRAMEBUFFER, target.framebuffer.name());
  gl.Viewport(0, 0, target.width, target.height);
  const FilterProgram& program = device.programs.use_filter();
  gl.Uniform1i(program.kind, static_cast<int>(filter));
  gl.Uniform3f(program.target_size, static_cast<float>(target.width),
               static_cast<float>(target.height), 0);
  gl.ActiveTexture(gl::TEXTURE0 + unit_image);
  gl.BindTexture(gl::TEXTURE_2D, picture.texture.name());
  if (!device.no_vertices) {
    device.no_vertices = gl::VertexArray(gl);
  }
  gl.BindVertexArray(device.no_vertices.name());
  gl.DrawArrays(gl::TRIANGLES, 0, 3);
  gl.BindVertexArray(0);
}

}  // namespace

DrawOptions realtime_draw_options(const DrawOptions& options) {
  DrawOptions result = options;
  result.course = false;
  result.shadows = false;
  result.textures = false;
  result.transparency = false;
  result.samples = 1;
  return result;
}

bool realtime_viewport_pixel(Milestone milestone, int width, int height, int& x, int& y) {
  const RealtimeWindow frame = realtime_frame(milestone, width, height);
  x = static_cast<int>((x + 0.5) * frame.width / width);
  y = height - 1 - static_cast<int>((height - y - 0.5) * frame.height / height);
  return x < width && y >= 0;
}

Frame realtime_frame_of(const RenderCamera& camera, const RealtimeOptions& options, int width,
                        int height, const std::vector<WorldObject>& objects) {
  const RealtimeWindow window = realtime_window(width, height);
  Frame frame = frame_of(camera, window.width, window.height, objects);
  frame.height = height;
  frame.near = options.near;
  frame.far = options.far;
  return frame;
}

const PixelSurface* draw_realtime(GlDevice::State& device, Drawing::State& drawing,
                                  const RenderCamera& camera, const DrawOptions& given, int width,
                                  int height, DrawStats& stats) {
  const gl::Functions& gl = device.gl;
  const DrawOptions options = realtime_draw_options(given);
  const RealtimeOptions& realtime = *options.realtime;
  const RealtimeWindow size = realtime_frame(realtime.milestone, width, height);
  if (std::max(size.width, size.height) > device.max_side ||
      !fit_texture(gl, device.framed, size.width, size.height)) {
    return nullptr;
  }
  const Frame frame = realtime_frame_of(camera, realtime, width, height, drawing.scene.objects);
  gl.BindFramebuffer(gl::FRAMEBUFFER, device.framed.framebuffer.name());
  gl.Viewport(0, 0, width, height);
  gl.ClearColor(options.background.r, options.background.g, options.background.b, 1);
  gl.Clear(gl::COLOR_BUFFER_BIT | gl::DEPTH_BUFFER_BIT);
  make_shadows(device, drawing, options);  // only creates the emitters: the options disable shadows
  stats = draw_objects(device, drawing, frame, options, output_of(options.mode));
  stats.samples = 1;
  if (realtime.filter == Filter::none && size.width == width && size.height == height) {
    return &device.framed;
  }
  if (!fit(gl, device.resolved, width, height, 1, false)) {
    return nullptr;
  }
  filter_picture(device, device.framed, device.resolved, realtime.filter);
  return &device.resolved;
}

}  // namespace scenefile
