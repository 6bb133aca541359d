#pragma once
// The options of a picture: plain data, shared by the ray tracer and OpenGL. Code that handles all
// options uniformly uses visit_options.h.

#include "scenefile/asset/image.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace scenefile {

/// Which pixels to produce. `course` reproduces the course's reference pictures, including their
/// sampling errors; `fine` uses the same lighting equation with good sampling.
enum class Profile : std::uint8_t { course, fine };
inline constexpr std::array<std::string_view, 2> profile_words{"course", "fine"};
constexpr std::string_view profile_word(Profile p) {
  return profile_words[static_cast<std::size_t>(p)];
}

/// `ray` traces rays recursively; `intersect` is the course's ray caster (no shadows, reflection,
/// refraction or textures; in the course profile only directional lights); `normals` shows (n + 1)
/// / 2 of the world normal; `path` traces paths of light, which only render_path() does
/// (path/render_path.h).
enum class Mode : std::uint8_t { ray, intersect, normals, path };
inline constexpr std::array<std::string_view, 4> mode_words{"ray", "intersect", "normals", "path"};
constexpr std::string_view mode_word(Mode m) {
  return mode_words[static_cast<std::size_t>(m)];
}

/// Enabled features, named as in the course's configuration files.
struct Features {
  bool shadows = true;
  bool reflect = true;
  bool refract = true;
  bool texture = true;
  bool texture_filter = true;  ///< filtered texture lookup instead of the nearest texel
  bool super_sample = true;    ///< several samples per pixel where needed
  bool depthoffield = true;

  friend bool operator==(const Features&, const Features&) = default;
};

/// The contents of a layer; docs/layers.md says how each is computed. "Center": of the ray through
/// the center of the pixel; "mean": over the pixel's samples, of what their camera rays hit, 0 if
/// nothing.
enum class LayerKind : std::uint8_t {
  depth,             ///< Z: world units along the view direction, infinity for nothing; center
  normal,            ///< X Y Z: shading normal, world space; mean
  uv,                ///< U V: texture coordinates before repetition; center
  albedo,            ///< R G B: factor of diffuse light, including texture; mean
  object_id,         ///< ID: 1 + source of the primitive, 0 for nothing; center
  light,             ///< R G B: diffuse and specular light from one light; mean
  shadow,            ///< Y: fraction of the light of all lights that shadows remove; of the means
  reflection_depth,  ///< Y: maximum depth of reflections and refractions; mean
  direct,            ///< R G B, mode path: what direct_only leaves
  bounce,            ///< R G B, mode path: light reflected or refracted a number of times
  specular,          ///< R G B, mode path: light that a mirror or glass reflected or refracted
  variance,          ///< Y, mode path: of the pixel's luminance, estimated
  samples,           ///< Y, mode path: how many were taken
};

struct Layer {
  LayerKind kind = LayerKind::depth;
  std::uint32_t light = 0;  ///< light: into RenderScene::lights; bounce: the number of times

  friend bool operator==(const Layer&, const Layer&) = default;
};

/// What mode path computes: light as in `physics`, or as in the pictures that the `course`
/// published for the assignment Path. docs/path.md lists the differences.
enum class Convention : std::uint8_t { physics, course };
inline constexpr std::array<std::string_view, 2> convention_words{"physics", "course"};
constexpr std::string_view convention_word(Convention c) {
  return convention_words[static_cast<std::size_t>(c)];
}

/// Part of a picture: x0 <= x < x1, y0 <= y < y1, row 0 at the top.
struct PixelRegion {
  int x0 = 0;
  int y0 = 0;
  int x1 = 0;
  int y1 = 0;

  int width() const { return x1 - x0; }
  int height() const { return y1 - y0; }
  friend bool operator==(const PixelRegion&, const PixelRegion&) = default;
};

/// A new field must be added to visit_options.h too; otherwise its users do not compile.
struct RenderOptions {
  Profile profile = Profile::fine;
  Mode mode = Mode::ray;
  Features features;
  int width = 1024;  ///< pixels, at least 1
  int height = 768;
  int samples = 16;        ///< fine: maximum samples per pixel, at least 1
  int min_samples = 1;     ///< fine: minimum samples per pixel, at most `samples`
  int max_depth = 16;      ///< reflections and refractions after a camera ray; at most 64
  std::uint64_t seed = 0;  ///< fine: selects the noise pattern
  bool fresnel = false;    ///< fine: glass reflects by Fresnel's equations
  int threads = 0;         ///< 0: one per processor
  /// Only these pixels, exactly as in the whole picture; a non-empty region inside of it.
  /// The image and the layers have its size.
  std::optional<PixelRegion> crop;
  std::vector<Layer> layers;  ///< to return with the picture; lights must exist
  bool denoise = false;       ///< fine: remove noise (denoise.h)

  // Mode path; docs/path.md. There max_depth counts reflections and refractions, 0: no maximum.
  int light_samples = 1;     ///< points on lamps for each surface point; 0: found by chance only
  bool mis = true;           ///< false: lamps are found by light samples only, except by mirrors
  bool direct_only = false;  ///< without light that was reflected before
  double continuation = 0;   ///< probability that a path goes on; 0: chosen by its throughput
  Convention convention = Convention::physics;
  double clamp = 0;  ///< maximum of indirect light in a sample; 0: none
};

/// The defaults of a profile: course has no super_sample, and a max_depth of 4.
RenderOptions default_options(Profile profile);
/// The defaults of `samples` and `max_depth` in mode path.
inline constexpr int path_samples = 64;
inline constexpr int path_max_depth = 0;

/// Clamps values to valid ranges. Every function that takes options does this.
RenderOptions in_range(RenderOptions options);

/// How the profile converts floats to 8 bits.
Rounding rounding_of(Profile profile);

}  // namespace scenefile
