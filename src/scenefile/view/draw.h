#pragma once
// The real-time sibling of the tracer: ready scene + assets -> pixels, with OpenGL 4.1 core and
// nothing that WebGL2 lacks. Same lighting equation (docs/rendering.md), per pixel; what it leaves
// out is listed in docs/view.md.
//
// Life cycle: with a context current, create a GlDevice once; upload() each scene; draw() each
// frame. All functions need the context that was current at create(), on its thread; so do the
// destructors, where the context is still alive. Nothing here knows windows.

#include "scenefile/asset/image.h"
#include "scenefile/asset/load_assets.h"
#include "scenefile/base/diagnostics.h"
#include "scenefile/scene/render_scene.h"
#include "scenefile/view/realtime.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace scenefile {

/// Finds an OpenGL function by name, null where there is none; glfwGetProcAddress and
/// eglGetProcAddress are such functions.
using GlFunction = void (*)();
using GetProcAddress = GlFunction (*)(const char* name);

/// What all drawings of one context share: functions, shader programs, framebuffers. Programs are
/// compiled when they are first needed.
class GlDevice {
 public:
  /// For the current context; null, with `error` set, where it is not OpenGL 4.1 or newer.
  static std::unique_ptr<GlDevice> create(GetProcAddress find, std::string& error);
  ~GlDevice();
  GlDevice(const GlDevice&) = delete;
  GlDevice& operator=(const GlDevice&) = delete;

  /// What draws, in the driver's words, such as `llvmpipe (LLVM 15.0.6, 256 bits)`.
  const std::string& renderer() const;

  struct State;
  State& state() { return *state_; }

 private:
  explicit GlDevice(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

/// Where an object that was copied with its template stands: `source` of the instance, and the
/// placement of the group that holds that, no_index at the root.
struct Placement {
  std::uint32_t source = 0;
  std::uint32_t parent = no_index;
};

/// One primitive in the world, after instancing.
struct DrawnObject {
  std::uint32_t source = 0;            ///< of the primitive
  std::uint32_t placement = no_index;  ///< into Drawing::placements(); no_index: in the root group
};

struct UploadOptions {
  bool flat_meshes = false;  ///< with the normals of their triangles, as the course's pictures
  /// Below 2^24. Where copies of templates are more, the smallest are left out.
  std::uint32_t max_objects = 1u << 20;
};

/// A scene on the graphics card. Made by upload(); keeps no reference to scene or assets.
class Drawing {
 public:
  Drawing(Drawing&&) noexcept;
  Drawing& operator=(Drawing&&) noexcept;
  ~Drawing();

  /// In the order of the file, templates where they are instantiated.
  std::span<const DrawnObject> objects() const;
  std::span<const Placement> placements() const;

  struct State;
  State& state() const { return *state_; }
  explicit Drawing(std::unique_ptr<State> state);

 private:
  std::unique_ptr<State> state_;
};

/// Puts a scene on the card. Groups are expanded up to options.max_objects. `assets` must have been
/// loaded for the scene; a mesh that is not loaded is not drawn. Codes: view/codes.h. The device
/// must outlive the drawing.
Drawing upload(GlDevice& device, const RenderScene& scene, const Assets& assets,
               const UploadOptions& options, Diagnostics& diagnostics);

enum class DrawMode : std::uint8_t {
  shaded,
  wireframe,       ///< of meshes all edges, of shapes a few; in the diffuse color
  normals,         ///< (n + 1) / 2 of the world normal, as the tracer's
  uv,              ///< red u, green v, as far as they lie in 0..1, else their fraction
  depth,           ///< white at the nearest, black at the farthest object
  object_id,       ///< a color of each object
  bounding_boxes,  ///< the object's boxes, brighter where more lie behind each other
};

struct DrawOptions {
  DrawMode mode = DrawMode::shaded;
  /// Rules of the course's pictures instead of the better ones, as for the tracer's profiles:
  /// filters of textures, kt, no bump maps. (UploadOptions has meshes, `samples` the samples.)
  bool course = false;
  bool shadows = true;
  bool textures = true;           ///< bump maps too
  bool texture_filter = true;     ///< false: nearest texel
  bool transparency = true;       ///< not bent; false: as the tracer without `refract`
  bool directional_only = false;  ///< of the lights (the course's ray caster)
  /// A pixel: 1, 4 (light is computed once), 16 (four times) or 64 (16 times). 0: 4, and 16 where
  /// more than half of the objects in the picture are only a few pixels wide.
  int samples = 4;
  /// By index into RenderScene::lights, true: it shines; lights beyond the list do.
  std::vector<bool> lights;
  /// By source of primitives and instances, true: it is drawn; sources beyond the list are.
  std::vector<bool> objects;
  /// Source of a primitive or instance that is drawn with a tint; no_index: none.
  std::uint32_t highlighted = no_index;
  glm::vec3 background{0};
  /// Draw what the assignment Realtime draws: its tessellation, lights, clipping and filters, one
  /// sample a pixel, without shadows, textures and transparency whatever the fields above say.
  std::optional<RealtimeOptions> realtime;

  friend bool operator==(const DrawOptions&, const DrawOptions&) = default;
};

/// Where the pixels go: a framebuffer of the context (0: that of the window) and the part of it, in
/// pixels from its lower left. The aspect of the picture is width / height.
struct DrawTarget {
  std::uint32_t framebuffer = 0;
  int x = 0;
  int y = 0;
  int width = 0;
  int height = 0;

  friend bool operator==(const DrawTarget&, const DrawTarget&) = default;
};

/// What the last draw() took.
struct DrawStats {
  std::uint32_t draw_calls = 0;    ///< without those for shadow maps
  std::uint32_t shadow_calls = 0;  ///< for shadow maps; 0 where they were still good
  std::uint32_t shadow_maps = 0;   ///< square depth images in use
  std::uint64_t objects = 0;
  std::uint64_t triangles = 0;   ///< of all objects, or lines
  std::uint64_t left_out = 0;    ///< of the objects in the picture the farthest: there are too many
  std::uint32_t shadowless = 0;  ///< lights whose depth images found no room: they throw no shadows
  int samples = 1;               ///< of each pixel
};

/// Draws the scene as the camera sees it (the lens is taken for a pinhole). Of the GL state,
/// bindings of programs, textures, buffers and framebuffers change; tests, blending and masks are
/// left as a new context has them, and `target` is the bound framebuffer and viewport.
DrawStats draw(GlDevice& device, Drawing& drawing, const RenderCamera& camera,
               const DrawOptions& options, const DrawTarget& target);

/// The same into a picture of its own; the framebuffer 0 is bound afterwards. Values are those of
/// 8-bit pixels. Empty, with `error` set, where the size is more than the device can draw.
Image draw_image(GlDevice& device, Drawing& drawing, const RenderCamera& camera,
                 const DrawOptions& options, int width, int height, std::string& error,
                 DrawStats* stats = nullptr);

/// Index into drawing.objects() of what a picture of this size shows at the pixel (x, y), row 0 on
/// top; nothing on the background. Masks count, the mode does not. The framebuffer 0 is bound
/// afterwards.
std::optional<std::uint32_t> object_at(GlDevice& device, Drawing& drawing,
                                       const RenderCamera& camera, const DrawOptions& options,
                                       int width, int height, int x, int y);

}  // namespace scenefile
