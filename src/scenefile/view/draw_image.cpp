#include "scenefile/view/picture.h"

#include <fmt/format.h>

#include <string_view>
#include <utility>

namespace scenefile {

GlDevice::GlDevice(std::unique_ptr<State> state) : state_(std::move(state)) {}

GlDevice::~GlDevice() = default;

const std::string& GlDevice::renderer() const {
  return state_->renderer;
}

void GlDevice::interrupt_with(std::function<bool()> go_on) {
  state_->go_on = std::move(go_on);
}

Result<std::unique_ptr<GlDevice>> GlDevice::create(GetProcAddress find) {
  auto state = std::make_unique<State>();
  gl::Functions& gl = state->gl;
  if (const std::string missing = gl::load(find, gl); !missing.empty()) {
    return Error{fmt::format("the OpenGL driver has no {}", missing)};
  }
  int major = 0;
  int minor = 0;
  gl.GetIntegerv(gl::MAJOR_VERSION, &major);
  gl.GetIntegerv(gl::MINOR_VERSION, &minor);
  const std::string_view version(reinterpret_cast<const char*>(gl.GetString(gl::VERSION)));
  gl.es = version.starts_with("OpenGL ES");
  if (major * 10 + minor < (gl.es ? 30 : 41)) {
    return Error{fmt::format("OpenGL 4.1 is needed, the driver has {}.{}", major, minor)};
  }
  state->renderer = reinterpret_cast<const char*>(gl.GetString(gl::RENDERER));
  gl.GetIntegerv(gl::MAX_SAMPLES, &state->max_samples);
  gl.GetIntegerv(gl::MAX_RENDERBUFFER_SIZE, &state->max_side);
  return std::unique_ptr<GlDevice>(new GlDevice(std::move(state)));
}

Result<Image> draw_image(GlDevice& device, Drawing& drawing, const RenderCamera& camera,
                         const DrawOptions& options, int width, int height, DrawStats* stats) {
  GlDevice::State& state = device.state();
  const gl::Functions& gl = state.gl;
  DrawStats taken;
  const PixelSurface* const picture =
      draw_resolved(state, drawing.state(), camera, options, width, height, taken);
  gl.BindFramebuffer(gl::FRAMEBUFFER, 0);
  if (stats != nullptr) {
    *stats = taken;
  }
  if (picture == nullptr) {
    return Error{fmt::format("{} cannot draw a picture of {}x{}", state.renderer, width, height)};
  }
  if (const std::string& refusal = state.programs.error(); !refusal.empty()) {
    return Error{fmt::format("the OpenGL driver rejects a shader: {}", refusal)};
  }
  std::vector<std::uint8_t> rgba(std::size_t{4} * width * height);
  gl.BindFramebuffer(gl::FRAMEBUFFER, picture->framebuffer.name());
  gl.ReadPixels(0, 0, width, height, gl::RGBA, gl::UNSIGNED_BYTE, rgba.data());
  gl.BindFramebuffer(gl::FRAMEBUFFER, 0);
  Image image(width, height);
  for (int y = 0; y < height; ++y) {
    const std::uint8_t* from = rgba.data() + std::size_t{4} * width * (height - 1 - y);
    for (int x = 0; x < width; ++x) {
      for (int c = 0; c < 3; ++c) {
        image.pixel(x, y)[c] = static_cast<float>(from[4 * x + c]) / 255;
      }
    }
  }
  return image;
}

}  // namespace scenefile
