#include "scenefile/view/draw.h"

#include "scenefile/view/pass.h"
#include "scenefile/view/picture.h"
#include "scenefile/view/realtime_pass.h"
#include "scenefile/view/shadows.h"

#include <algorithm>
#include <array>

namespace scenefile {

namespace {

void clear(const gl::Functions& gl, const glm::vec3& color) {
  gl.ClearColor(color.r, color.g, color.b, 1);
  gl.Clear(gl::COLOR_BUFFER_BIT | gl::DEPTH_BUFFER_BIT);
}

void blit(const gl::Functions& gl, const PixelSurface& from, const PixelSurface& to) {
  gl.BindFramebuffer(gl::READ_FRAMEBUFFER, from.framebuffer.name());
  gl.BindFramebuffer(gl::DRAW_FRAMEBUFFER, to.framebuffer.name());
  gl.BlitFramebuffer(0, 0, from.width, from.height, 0, 0, to.width, to.height, gl::COLOR_BUFFER_BIT,
                     from.width == to.width ? gl::NEAREST : gl::LINEAR);
}

int samples_for(const Frame& frame, const std::vector<WorldObject>& objects) {
  constexpr double small = 4;  // pixels, half the diagonal of the box
  std::size_t seen = 0;
  std::size_t few_pixels = 0;
  for (const WorldObject& object : objects) {
    if (may_be_seen(frame, object)) {
      ++seen;
      few_pixels += radius_in_pixels(frame, object) < small ? 1 : 0;
    }
  }
  return 2 * few_pixels > seen ? 16 : 4;
}

// Pixels of the surface per pixel of the picture, along each axis.
int oversampling(int samples) {
  return samples >= 64 ? 4 : samples >= 16 ? 2 : 1;
}

}  // namespace

Output output_of(DrawMode mode) {
  switch (mode) {
    case DrawMode::shaded:
      return Output::shaded;
    case DrawMode::wireframe:
      return Output::flat_color;
    case DrawMode::normals:
      return Output::normals;
    case DrawMode::uv:
      return Output::uv;
    case DrawMode::depth:
      return Output::depth;
    case DrawMode::object_id:
      return Output::object_color;
    case DrawMode::bounding_boxes:
      return Output::box;
  }
  return Output::shaded;
}

const PixelSurface* draw_resolved(GlDevice::State& device, Drawing::State& drawing,
                                  const RenderCamera& camera, const DrawOptions& options, int width,
                                  int height, DrawStats& stats) {
  device.interrupted = false;
  if (options.realtime) {
    return draw_realtime(device, drawing, camera, options, width, height, stats);
  }
  const gl::Functions& gl = device.gl;
  const Frame frame = frame_of(camera, width, height, drawing.scene.objects);
  const int wanted =
      options.samples == 0 ? samples_for(frame, drawing.scene.objects) : options.samples;
  int scale = oversampling(wanted);
  while (scale > 1 && (width * scale > device.max_side || height * scale > device.max_side)) {
    scale /= 2;
  }
  if (width > device.max_side || height > device.max_side) {
    return nullptr;
  }
  const int samples = wanted >= 4 ? std::min(4, device.max_samples) : 1;
  if (!fit(gl, device.multisampled, width * scale, height * scale, samples, true) ||
      !fit(gl, device.resolved, width * scale, height * scale, 1, false)) {
    return nullptr;
  }
  const Output output = output_of(options.mode);
  stats = DrawStats();
  if (output == Output::shaded) {
    stats.shadow_calls = make_shadows(device, drawing, options);
  }
  gl.BindFramebuffer(gl::FRAMEBUFFER, device.multisampled.framebuffer.name());
  gl.Viewport(0, 0, width * scale, height * scale);
  clear(gl, options.background);
  const DrawStats pass = draw_objects(device, drawing, frame, options, output);
  stats = {pass.draw_calls,
           stats.shadow_calls,
           static_cast<std::uint32_t>(drawing.shadows.views.size()),
           pass.objects,
           pass.triangles,
           pass.left_out,
           count_shadowless(drawing),
           wanted};
  blit(gl, device.multisampled, device.resolved);
  PixelSurface* last = &device.resolved;
  for (; scale > 1; scale /= 2) {
    PixelSurface& smaller = scale == 4 ? device.quartered : device.halved;
    if (!fit(gl, smaller, last->width / 2, last->height / 2, 1, false)) {
      return nullptr;
    }
    blit(gl, *last, smaller);
    last = &smaller;
  }
  return last;
}

DrawStats draw(GlDevice& device, Drawing& drawing, const RenderCamera& camera,
               const DrawOptions& options, const DrawTarget& target) {
  const gl::Functions& gl = device.state().gl;
  DrawStats stats;
  if (target.width > 0 && target.height > 0) {
    const PixelSurface* const picture = draw_resolved(device.state(), drawing.state(), camera,
                                                      options, target.width, target.height, stats);
    if (picture != nullptr) {
      gl.BindFramebuffer(gl::READ_FRAMEBUFFER, picture->framebuffer.name());
      gl.BindFramebuffer(gl::DRAW_FRAMEBUFFER, target.framebuffer);
      gl.BlitFramebuffer(0, 0, target.width, target.height, target.x, target.y,
                         target.x + target.width, target.y + target.height, gl::COLOR_BUFFER_BIT,
                         gl::NEAREST);
    }
  }
  gl.BindFramebuffer(gl::FRAMEBUFFER, target.framebuffer);
  gl.Viewport(target.x, target.y, target.width, target.height);
  return stats;
}

std::optional<std::uint32_t> object_at(GlDevice& device, Drawing& drawing,
                                       const RenderCamera& camera, const DrawOptions& options,
                                       int width, int height, int x, int y) {
  GlDevice::State& state = device.state();
  const gl::Functions& gl = state.gl;
  const bool in_picture = x >= 0 && y >= 0 && x < width && y < height;
  if (!in_picture || !fit(gl, state.picking, 1, 1, 1, true) ||
      (options.realtime &&
       !realtime_viewport_pixel(options.realtime->milestone, width, height, x, y))) {
    return std::nullopt;
  }
  gl.BindFramebuffer(gl::FRAMEBUFFER, state.picking.framebuffer.name());
  gl.Viewport(-x, y + 1 - height, width, height);
  clear(gl, glm::vec3(0));
  const std::vector<WorldObject>& objects = drawing.state().scene.objects;
  const Frame frame = options.realtime
                          ? realtime_frame_of(camera, *options.realtime, width, height, objects)
                          : frame_of(camera, width, height, objects);
  draw_objects(state, drawing.state(), frame, options, Output::object_number);
  std::array<std::uint8_t, 4> rgba{};
  gl.ReadPixels(0, 0, 1, 1, gl::RGBA, gl::UNSIGNED_BYTE, rgba.data());
  gl.BindFramebuffer(gl::FRAMEBUFFER, 0);
  const std::uint32_t number = rgba[0] | rgba[1] << 8 | rgba[2] << 16;
  return number == 0 ? std::nullopt : std::optional(number - 1);
}

}  // namespace scenefile
