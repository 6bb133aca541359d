#pragma once
// The CPU ray tracer: ready scene + assets -> image. Semantics and their sources:
// docs/rendering.md.

#include "scenefile/asset/image.h"
#include "scenefile/asset/load_assets.h"
#include "scenefile/scene/render_scene.h"
#include "scenefile/trace/mistakes.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace scenefile {

/// Whose pixels. `course` reproduces the course's reference pictures, faults of sampling included;
/// `fine` is the same lighting equation with good sampling.
enum class Profile : std::uint8_t { course, fine };

/// `ray` traces rays recursively; `intersect` is the course's ray caster (no shadows, reflection,
/// refraction or textures; in the course profile only directional lights); `normals` colors by
/// (n + 1) / 2 of the world normal.
enum class Mode : std::uint8_t { ray, intersect, normals };

/// What is switched on, in the words of the course's configuration files.
struct Features {
  bool shadows = true;
  bool reflect = true;
  bool refract = true;
  bool texture = true;
  bool texture_filter = true;  ///< filtered texture lookup instead of the nearest texel
  bool super_sample = true;    ///< several samples a pixel where the picture needs them
  bool depthoffield = true;

  friend bool operator==(const Features&, const Features&) = default;
};

/// What a buffer beside the picture holds; docs/layers.md says how each is computed. Middle: of the
/// ray through the middle of the pixel; mean: over the pixel's samples, of what their camera rays
/// met, 0 where they met nothing.
enum class LayerKind : std::uint8_t {
  depth,             ///< Z: world units along the view direction, infinite for nothing; middle
  normal,            ///< X Y Z: for shading, world space; mean
  uv,                ///< U V: texture coordinates before they repeat; middle
  albedo,            ///< R G B: what diffuse light is multiplied by, texture included; mean
  object_id,         ///< ID: 1 + source of the primitive, 0 for nothing; middle
  light,             ///< R G B: diffuse and specular light of one light of the scene; mean
  shadow,            ///< Y: share of the light of all lights that shadows take; of the means
  reflection_depth,  ///< Y: most reflections and refractions behind each other; mean
};

struct Layer {
  LayerKind kind = LayerKind::depth;
  std::uint32_t light = 0;  ///< into RenderScene::lights

  friend bool operator==(const Layer&, const Layer&) = default;
};

/// Part of a picture: x0 <= x < x1, y0 <= y < y1, row 0 on top.
struct PixelRegion {
  int x0 = 0;
  int y0 = 0;
  int x1 = 0;
  int y1 = 0;

  int width() const { return x1 - x0; }
  int height() const { return y1 - y0; }
  friend bool operator==(const PixelRegion&, const PixelRegion&) = default;
};

struct RenderOptions {
  Profile profile = Profile::fine;
  Mode mode = Mode::ray;
  Features features;
  int width = 1024;  ///< pixels, at least 1
  int height = 768;
  int samples = 16;        ///< fine: most samples a pixel, at least 1
  int max_depth = 16;      ///< reflections and refractions behind a primary ray; at most 64
  std::uint64_t seed = 0;  ///< fine: another noise pattern
  bool fresnel = false;    ///< fine: glass mirrors the share that Fresnel's equations say
  int threads = 0;         ///< 0: one a processor
  /// Only these pixels, exactly as they are in the whole picture; must not be empty nor reach
  /// outside. The image and the layers have its size.
  std::optional<PixelRegion> crop;
  std::vector<Layer> layers;  ///< to be returned beside the picture; lights must exist
  bool denoise = false;       ///< fine: take noise away (denoise.h)
  Mistakes mistakes;          ///< made on purpose
};

/// The defaults of a profile: course has no super_sample and 4 bounces.
RenderOptions default_options(Profile profile);

/// How the float picture becomes 8-bit in this profile.
Rounding rounding_of(Profile profile);

struct RenderStats {
  std::uint64_t primary_rays = 0;
  std::uint64_t shadow_rays = 0;
  std::uint64_t secondary_rays = 0;  ///< reflected and refracted
  double build_seconds = 0;          ///< wall time of building the acceleration structure
  double trace_seconds = 0;          ///< wall time of tracing
};

enum class RenderStatus : std::uint8_t {
  complete,
  cancelled,      ///< the progress function said so; the image is partial
  limit_reached,  ///< the scene nests instances deeper than the tracer can follow
  failed,         ///< the acceleration structure could not be built (out of memory)
  not_resumed,    ///< Checkpoints::resume is no state of such a picture; nothing was done
};

struct RenderResult {
  Image image;
  std::vector<ImageLayer> layers;  ///< as RenderOptions::layers
  RenderStatus status = RenderStatus::complete;
  RenderStats stats;
};

/// Called now and then, from any one thread at a time, with the share of the picture that is done
/// in [0, 1]. Returns false to stop.
using Progress = std::function<bool(double done)>;

/// For renders that something may cut short.
struct Checkpoints {
  /// A state that `save` was given; empty: from the start. It must be of the same scene, assets,
  /// options and build: nothing here can tell.
  std::string resume;
  /// Called as Progress is, with the state of the work, whenever `interval_seconds` have passed
  /// since the last time, and when Progress says to stop.
  std::function<void(const std::string& state)> save;
  double interval_seconds = 4;
};

/// Pictures on the way, for someone who waits.
struct Preview {
  /// Called as Progress is, with the picture as far as it is: first one color for each block of
  /// pixels, then pixels, then better ones, in the end the result.
  std::function<void(const Image& image)> show;
  double interval_seconds = 2;  ///< at least, between calls
};

/// Renders. The picture is a function of scene, assets and options alone: any number of threads
/// gives the same bytes, whether the work was resumed or not (statistics are of this run alone).
/// `assets` must have been loaded for this scene. Work that is resumed has neither layers nor noise
/// taken away. `canvas`: a black image in which to draw the picture, if it has the same size; for
/// those who know cheaper memory than the allocator does (io/memory.h).
RenderResult render(const RenderScene& scene, const Assets& assets, const RenderOptions& options,
                    const Progress& progress = {}, const Checkpoints& checkpoints = {},
                    const Preview& preview = {}, Image canvas = {});
/// The same, for one who needs the scene no more: what only finding hits needed is given back
/// before the first ray, 64 bytes a primitive.
RenderResult render(RenderScene&& scene, const Assets& assets, const RenderOptions& options,
                    const Progress& progress = {}, const Checkpoints& checkpoints = {},
                    const Preview& preview = {}, Image canvas = {});

}  // namespace scenefile
