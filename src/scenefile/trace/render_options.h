#pragma once
// What picture is asked for: plain data, shared by the ray tracer and OpenGL. Whoever handles all
// options alike visits them with visit_options.h.

#include "scenefile/asset/image.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace scenefile {

/// Whose pixels. `course` reproduces the course's reference pictures, faults of sampling included;
/// `fine` is the same lighting equation with good sampling.
enum class Profile : std::uint8_t { course, fine };
inline constexpr std::array<std::string_view, 2> profile_words{"course", "fine"};
constexpr std::string_view profile_word(Profile p) {
  return profile_words[static_cast<std::size_t>(p)];
}

/// `ray` traces rays recursively; `intersect` is the course's ray caster (no shadows, reflection,
/// refraction or textures; in the course profile only directional lights); `normals` colors by
/// (n + 1) / 2 of the world normal.
enum class Mode : std::uint8_t { ray, intersect, normals };
inline constexpr std::array<std::string_view, 3> mode_words{"ray", "intersect", "normals"};
constexpr std::string_view mode_word(Mode m) {
  return mode_words[static_cast<std::size_t>(m)];
}

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

/// A new field needs a line in visit_options.h too; without it nothing compiles that visits them.
struct RenderOptions {
  Profile profile = Profile::fine;
  Mode mode = Mode::ray;
  Features features;
  int width = 1024;  ///< pixels, at least 1
  int height = 768;
  int samples = 16;        ///< fine: most samples a pixel, at least 1
  int min_samples = 1;     ///< fine: fewest samples a pixel, at most `samples`
  int max_depth = 16;      ///< reflections and refractions behind a primary ray; at most 64
  std::uint64_t seed = 0;  ///< fine: another noise pattern
  bool fresnel = false;    ///< fine: glass mirrors the share that Fresnel's equations say
  int threads = 0;         ///< 0: one a processor
  /// Only these pixels, exactly as they are in the whole picture; must not be empty nor reach
  /// outside. The image and the layers have its size.
  std::optional<PixelRegion> crop;
  std::vector<Layer> layers;  ///< to be returned beside the picture; lights must exist
  bool denoise = false;       ///< fine: take noise away (denoise.h)
};

/// The defaults of a profile: course has no super_sample and 4 bounces.
RenderOptions default_options(Profile profile);

/// Values out of range become the nearest that can be drawn. All that takes options does this.
RenderOptions in_range(RenderOptions options);

/// How the float picture becomes 8-bit in this profile.
Rounding rounding_of(Profile profile);

}  // namespace scenefile
