#pragma once
// The CPU ray tracer: ready scene + assets -> image. Semantics and their sources:
// docs/rendering.md.

#include "scenefile/asset/image.h"
#include "scenefile/asset/load_assets.h"
#include "scenefile/scene/render_scene.h"
#include "scenefile/trace/mistakes.h"

#include <cstdint>
#include <functional>
#include <string>

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

struct RenderOptions {
  Profile profile = Profile::fine;
  Mode mode = Mode::ray;
  Features features;
  int width = 1024;  ///< pixels, at least 1
  int height = 768;
  int samples = 16;        ///< fine: most samples a pixel, at least 1
  int max_depth = 16;      ///< reflections and refractions behind a primary ray; at most 64
  std::uint64_t seed = 0;  ///< fine: another noise pattern
  int threads = 0;         ///< 0: one a processor
  Mistakes mistakes;       ///< made on purpose
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

/// Renders. The picture is a function of scene, assets and options alone: any number of threads
/// gives the same bytes, whether the work was resumed or not (statistics are of this run alone).
/// `assets` must have been loaded for this scene.
RenderResult render(const RenderScene& scene, const Assets& assets, const RenderOptions& options,
                    const Progress& progress = {}, const Checkpoints& checkpoints = {});

}  // namespace scenefile
