#pragma once
// Real-time rendering with OpenGL: render scene and assets to pixels, with OpenGL 4.1 core
// restricted to features of WebGL2. Uses the same lighting equation as the tracer
// (docs/rendering.md) at each pixel; docs/opengl.md lists what is left out.
//
// Usage: with a current context, create a GlDevice once; call upload() for each scene and draw()
// for each frame. All functions and destructors need the context of create() to be current on their
// thread. Independent of windows.

#include "scenefile/asset/image.h"
#include "scenefile/asset/load_assets.h"
#include "scenefile/base/diagnostics.h"
#include "scenefile/base/realtime.h"
#include "scenefile/scene/render_scene.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace scenefile {

/// Looks up an OpenGL function by name, null if it does not exist; such as glfwGetProcAddress,
/// eglGetProcAddress or find_webgl_function.
using GlFunction = void (*)();
using GetProcAddress = GlFunction (*)(const char* name);

/// Data shared by all drawings of a context: functions, shader programs, framebuffers. Programs are
/// compiled at first use.
class GlDevice {
 public:
  /// For the current context; fails if it is older than OpenGL 4.1 or ES 3.0.
  static Result<std::unique_ptr<GlDevice>> create(GetProcAddress find);
  ~GlDevice();
  GlDevice(const GlDevice&) = delete;
  GlDevice& operator=(const GlDevice&) = delete;

  /// The driver's name of the renderer, such as `llvmpipe (LLVM 15.0.6, 256 bits)`.
  const std::string& renderer() const;

  /// Sets a function that is called several times during each drawing. If it returns false, the
  /// drawing ends early, and its picture is incomplete. Each call waits for the drawing so far.
  /// Empty (the default): drawings are never interrupted.
  void interrupt_with(std::function<bool()> go_on);

  struct State;
  State& state() { return *state_; }

 private:
  explicit GlDevice(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

/// The instance that contains an object: `source` of the instance, and the placement of the group
/// that contains it, no_index at the root.
struct Placement {
  std::uint32_t source = 0;
  std::uint32_t parent = no_index;
};

/// A primitive in the world, after instancing.
struct DrawnObject {
  std::uint32_t source = 0;            ///< of the primitive
  std::uint32_t placement = no_index;  ///< into Drawing::placements(); no_index: the root group
};

struct UploadOptions {
  bool flat_meshes = false;  ///< shade flat, as in the course's pictures
  /// Below 2^24. If there are more after instancing, the smallest are left out.
  std::uint32_t max_objects = 1u << 20;
};

/// A scene on the GPU, made by upload(). Keeps no reference to scene or assets.
class Drawing {
 public:
  Drawing(Drawing&&) noexcept;
  Drawing& operator=(Drawing&&) noexcept;
  ~Drawing();

  /// In the order of the file, with templates expanded at each instance.
  std::span<const DrawnObject> objects() const;
  std::span<const Placement> placements() const;

  struct State;
  State& state() const { return *state_; }
  explicit Drawing(std::unique_ptr<State> state);

 private:
  std::unique_ptr<State> state_;
};

/// Uploads a scene to the GPU. Groups are expanded up to options.max_objects. `assets` must be
/// those of the scene; meshes that are not loaded are not drawn. The device must outlive the
/// drawing. Codes: view/codes.h.
Drawing upload(GlDevice& device, const RenderScene& scene, const Assets& assets,
               const UploadOptions& options, Diagnostics& diagnostics);

enum class DrawMode : std::uint8_t {
  shaded,
  wireframe,       ///< all edges of meshes, a few of shapes; in the diffuse color
  normals,         ///< (n + 1) / 2 of the world normal, like the tracer's
  uv,              ///< u in red, v in green; outside of 0..1 their fractional part
  depth,           ///< white at the nearest object, black at the farthest
  object_id,       ///< a distinct color for each object
  bounding_boxes,  ///< of the objects; brighter where several overlap
};

struct DrawOptions {
  DrawMode mode = DrawMode::shaded;
  /// Use the rules of the course's pictures, as with the tracer's profile: texture filters,
  /// transparentcoeff, no bump maps. (Meshes: UploadOptions; samples: `samples`.)
  bool course = false;
  bool shadows = true;
  bool textures = true;           ///< and bump maps
  bool texture_filter = true;     ///< false: nearest texel
  bool transparency = true;       ///< without refraction; false: as the tracer without `refract`
  bool directional_only = false;  ///< ignore other lights (the course's ray caster)
  /// Per pixel: 1, 4 (lit once), 16 (lit 4 times) or 64 (lit 16 times). 0: 4, or 16 if more than
  /// half of the visible objects are only a few pixels wide.
  int samples = 4;
  /// Whether each light is on, by index into RenderScene::lights; lights beyond the list are on.
  std::vector<bool> lights;
  /// Whether objects are drawn, by source of primitives and instances; sources beyond the list are.
  std::vector<bool> objects;
  glm::vec3 background{0};
  /// Draw the picture of the assignment Realtime: its tessellation, lights, clipping and filters,
  /// with one sample per pixel and without shadows, textures and transparency, regardless of the
  /// fields above.
  std::optional<RealtimeOptions> realtime;

  friend bool operator==(const DrawOptions&, const DrawOptions&) = default;
};

/// The destination: a framebuffer of the context (0: the window) and a rectangle in it, in pixels
/// from its lower left. The aspect ratio of the picture is width / height.
struct DrawTarget {
  std::uint32_t framebuffer = 0;
  int x = 0;
  int y = 0;
  int width = 0;
  int height = 0;

  friend bool operator==(const DrawTarget&, const DrawTarget&) = default;
};

/// Statistics of the last draw().
struct DrawStats {
  std::uint32_t draw_calls = 0;    ///< without those for shadow maps
  std::uint32_t shadow_calls = 0;  ///< 0 if the shadow maps were still valid
  std::uint32_t shadow_maps = 0;   ///< square depth images in use
  std::uint64_t objects = 0;
  std::uint64_t triangles = 0;   ///< of all objects; wireframe shows their edges
  std::uint64_t left_out = 0;    ///< farthest visible objects, skipped if too many
  std::uint32_t shadowless = 0;  ///< lights without shadows, because their shadow maps do not fit
  int samples = 1;               ///< per pixel
};

/// Draws the scene as seen by the camera (as a pinhole; the lens is ignored). Changes the bindings
/// of programs, textures, buffers and framebuffers; leaves tests, blending and masks in the state
/// of a new context, and `target` as framebuffer and viewport.
DrawStats draw(GlDevice& device, Drawing& drawing, const RenderCamera& camera,
               const DrawOptions& options, const DrawTarget& target);

/// Draws into a new image; binds framebuffer 0 afterwards. Values are multiples of 1/255. An error
/// if the size exceeds the limits of the device, or the driver rejects a shader.
Result<Image> draw_image(GlDevice& device, Drawing& drawing, const RenderCamera& camera,
                         const DrawOptions& options, int width, int height,
                         DrawStats* stats = nullptr);

/// Index into drawing.objects() of the object at the pixel (x, y), row 0 at the top, in a picture
/// of this size; nullopt on the background. Respects options.objects, but not the mode. Binds
/// framebuffer 0 afterwards.
std::optional<std::uint32_t> object_at(GlDevice& device, Drawing& drawing,
                                       const RenderCamera& camera, const DrawOptions& options,
                                       int width, int height, int x, int y);

}  // namespace scenefile
