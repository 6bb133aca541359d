#include "scenefile/view/shadows.h"

#include "scenefile/view/pass.h"
#include "scenefile/view/scene_buffers.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

namespace scenefile {

namespace {

using std::numbers::pi;

// A wider spotlight uses a cube.
constexpr double widest_view = 2.2;  // radians

// Looking along `direction`.
RenderCamera looking(const glm::dvec3& from, const glm::dvec3& direction, double fov_y) {
  RenderCamera camera;
  camera.position = from;
  camera.w = -glm::normalize(direction);
  const glm::dvec3 up = std::abs(camera.w.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0);
  camera.u = glm::normalize(glm::cross(up, camera.w));
  camera.v = glm::cross(camera.w, camera.u);
  camera.fov_y = fov_y;
  return camera;
}

Bounds box_of(const std::vector<WorldObject>& objects) {
  Bounds box;
  for (const WorldObject& object : objects) {
    box = unite(unite(box, glm::dvec3(object.box_min)), glm::dvec3(object.box_max));
  }
  return box;
}

// An orthographic view along the light that contains all objects.
Frame parallel_view(const Emitter& emitter, const std::vector<WorldObject>& objects, int side) {
  const Bounds box = box_of(objects);
  const glm::dvec3 middle = 0.5 * (box.min + box.max);
  const double radius = 0.5 * glm::length(box.max - box.min) * 1.01 + 1e-9;
  Frame frame;
  frame.camera = looking(middle + 2 * radius * emitter.position, -emitter.position, 1);
  frame.parallel = true;
  frame.tan_x = frame.tan_y = radius;
  frame.height = side;
  frame.near = radius;
  frame.far = 3 * radius;
  return frame;
}

class Planner {
 public:
  Planner(const std::vector<WorldObject>& objects, ShadowMaps& shadows)
      : objects_(objects), shadows_(shadows) {}

  ShadowCode single(const Frame& frame) {
    if (!room_for(1)) {
      return -1;
    }
    shadows_.views.push_back(frame);
    return 2 * static_cast<ShadowCode>(shadows_.views.size() - 1);
  }

  // +x -x +y -y +z -z, slightly wider than 90 degrees for lookups at the borders.
  ShadowCode six(const glm::dvec3& from) {
    if (!room_for(6)) {
      return -1;
    }
    const ShadowCode code = 2 * static_cast<ShadowCode>(shadows_.views.size()) + 1;
    for (int face = 0; face < 6; ++face) {
      glm::dvec3 direction(0);
      direction[face / 2] = face % 2 == 0 ? 1 : -1;
      const RenderCamera camera = looking(from, direction, pi / 2 + 8.0 / shadows_.side);
      shadows_.views.push_back(frame_of(camera, shadows_.side, shadows_.side, objects_));
    }
    return code;
  }

  ShadowCode of_emitter(const Emitter& emitter) {
    if (emitter.directional) {
      return single(parallel_view(emitter, objects_, shadows_.side));
    }
    const double width = 2 * double(emitter.outer_angle) + 8.0 / shadows_.side;
    if (width < widest_view) {
      const RenderCamera camera = looking(emitter.position, emitter.axis, width);
      return single(frame_of(camera, shadows_.side, shadows_.side, objects_));
    }
    return six(emitter.shadow_from);
  }

 private:
  bool room_for(std::size_t layers) const {
    return shadows_.views.size() + layers <= max_shadow_layers;
  }

  const std::vector<WorldObject>& objects_;
  ShadowMaps& shadows_;
};

// The total memory is bounded by a good share of a small card, for any number of layers.
int side_for(std::size_t layers) {
  return layers <= 4 ? 2048 : layers <= 24 ? 1024 : 512;
}

ShadowMaps layers_of(const std::vector<Emitter>& emitters,
                     const std::vector<WorldObject>& objects) {
  ShadowMaps trial;
  trial.side = 512;
  plan_shadows(emitters, objects, trial);
  return trial;
}

// If there are too many area lights for a cube per quarter, each gets a single cube at its center.
void share_views(std::vector<Emitter>& emitters, const std::vector<WorldObject>& objects,
                 const std::vector<RenderLight>& lights) {
  const std::vector<ShadowCode> codes = layers_of(emitters, objects).codes;
  if (std::find(codes.begin(), codes.end(), -1) == codes.end()) {
    return;
  }
  for (Emitter& emitter : emitters) {
    emitter.shadow_from = lights[emitter.light].position;
  }
}

void make_layers(const gl::Functions& gl, ShadowMaps& shadows) {
  shadows.layers = gl::Texture(gl);
  gl.BindTexture(gl::TEXTURE_2D_ARRAY, shadows.layers.name());
  gl.TexImage3D(gl::TEXTURE_2D_ARRAY, 0, gl::DEPTH_COMPONENT24, shadows.side, shadows.side,
                std::max<gl::Size>(1, static_cast<gl::Size>(shadows.views.size())), 0,
                gl::DEPTH_COMPONENT, gl::UNSIGNED_INT, nullptr);
  for (const gl::Enum filter : {gl::TEXTURE_MIN_FILTER, gl::TEXTURE_MAG_FILTER}) {
    gl.TexParameteri(gl::TEXTURE_2D_ARRAY, filter, gl::LINEAR);
  }
  for (const gl::Enum wrap : {gl::TEXTURE_WRAP_S, gl::TEXTURE_WRAP_T}) {
    gl.TexParameteri(gl::TEXTURE_2D_ARRAY, wrap, gl::CLAMP_TO_EDGE);
  }
  gl.TexParameteri(gl::TEXTURE_2D_ARRAY, gl::TEXTURE_COMPARE_MODE, gl::COMPARE_REF_TO_TEXTURE);
  gl.TexParameteri(gl::TEXTURE_2D_ARRAY, gl::TEXTURE_COMPARE_FUNC, gl::LEQUAL);
}

// None: another profile.
std::optional<Milestone> milestone_of(const DrawOptions& options) {
  return options.realtime ? std::optional(options.realtime->milestone) : std::nullopt;
}

bool same_shadows(const DrawOptions& a, const DrawOptions& b) {
  return a.shadows == b.shadows && a.course == b.course && a.transparency == b.transparency &&
         a.directional_only == b.directional_only && milestone_of(a) == milestone_of(b) &&
         a.lights == b.lights && a.objects == b.objects;
}

std::uint32_t draw_layers(GlDevice::State& device, Drawing::State& drawing,
                          const DrawOptions& options) {
  const gl::Functions& gl = device.gl;
  ShadowMaps& shadows = drawing.shadows;
  if (!shadows.framebuffer) {
    shadows.framebuffer = gl::Framebuffer(gl);
  }
  gl.BindFramebuffer(gl::FRAMEBUFFER, shadows.framebuffer.name());
  gl.Viewport(0, 0, shadows.side, shadows.side);
  gl.Enable(gl::POLYGON_OFFSET_FILL);
  gl.PolygonOffset(1.5f, 4);
  std::uint32_t calls = 0;
  for (std::size_t layer = 0; layer < shadows.views.size() && !device.interrupted; ++layer) {
    gl.FramebufferTextureLayer(gl::FRAMEBUFFER, gl::DEPTH_ATTACHMENT, shadows.layers.name(), 0,
                               static_cast<int>(layer));
    gl.Clear(gl::DEPTH_BUFFER_BIT);
    calls +=
        draw_objects(device, drawing, shadows.views[layer], options, Output::nothing).draw_calls;
  }
  gl.Disable(gl::POLYGON_OFFSET_FILL);
  return calls;
}

}  // namespace

void plan_shadows(const std::vector<Emitter>& emitters, const std::vector<WorldObject>& objects,
                  ShadowMaps& shadows) {
  Planner planner(objects, shadows);
  shadows.views.clear();
  shadows.codes.clear();
  for (std::size_t i = 0; i < emitters.size(); ++i) {
    // Emitters in the same quarter of an area light share their views.
    const auto same =
        std::find_if(emitters.begin(), emitters.begin() + std::ptrdiff_t(i), [&](const Emitter& e) {
          return !e.directional && e.light == emitters[i].light &&
                 e.shadow_from == emitters[i].shadow_from;
        });
    shadows.codes.push_back(same == emitters.begin() + std::ptrdiff_t(i)
                                ? planner.of_emitter(emitters[i])
                                : shadows.codes[std::size_t(same - emitters.begin())]);
  }
}

std::uint32_t make_shadows(GlDevice::State& device, Drawing::State& drawing,
                           const DrawOptions& options) {
  ShadowMaps& shadows = drawing.shadows;
  if (shadows.made_for && same_shadows(*shadows.made_for, options)) {
    return 0;
  }
  drawing.emitters = emitters(drawing.lights, options);
  shadows.made_for = options;
  shadows.views.clear();
  shadows.codes.clear();
  if (!options.shadows || drawing.scene.objects.empty()) {
    return 0;
  }
  share_views(drawing.emitters, drawing.scene.objects, drawing.lights);
  shadows.side = side_for(layers_of(drawing.emitters, drawing.scene.objects).views.size());
  plan_shadows(drawing.emitters, drawing.scene.objects, shadows);
  make_layers(device.gl, shadows);
  const std::uint32_t calls = draw_layers(device, drawing, options);
  if (device.interrupted) {
    shadows.made_for.reset();
  }
  return calls;
}

std::uint32_t count_shadowless(const Drawing::State& drawing) {
  std::set<std::uint32_t> lights;
  for (std::size_t i = 0; i < drawing.shadows.codes.size(); ++i) {
    if (drawing.shadows.codes[i] < 0) {
      lights.insert(drawing.emitters[i].light);
    }
  }
  return static_cast<std::uint32_t>(lights.size());
}

void bind_shadows(const gl::Functions& gl, ShadowMaps& shadows, const glm::dvec3& eye) {
  std::vector<glm::vec4> values;
  for (const Frame& view : shadows.views) {
    glm::dmat4 to_view(1);
    to_view[3] = glm::dvec4(eye - view.camera.position, 1);
    glm::dmat4 half(0.5);
    half[3] = glm::dvec4(0.5, 0.5, 0.5, 1);
    const glm::mat4 place(half * glm::dmat4(clip_from_world(view)) * to_view);
    values.insert(values.end(), {place[0], place[1], place[2], place[3]});
    const auto texel = static_cast<float>(2 * view.tan_y / shadows.side);
    values.emplace_back(view.parallel ? texel : 0, view.parallel ? 0 : texel, 0, 0);
  }
  gl.ActiveTexture(gl::TEXTURE0 + unit_shadow_table);
  fill_table(gl, shadows.table, shadow_texels, values);
  gl.ActiveTexture(gl::TEXTURE0 + unit_shadows);
  gl.BindTexture(gl::TEXTURE_2D_ARRAY, shadows.layers.name());
}

}  // namespace scenefile
