#pragma once
// Why a picture is not the reference: known mistakes are made on purpose, and one is named when
// what it makes of the reference is the picture. Nothing is named without such evidence.

#include "scenefile/scene/scene.h"
#include "scenefile/trace/render.h"

#include <array>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace scenefile {

/// Kinds of mistakes. Those up to half_pixel_shift need no scene.
enum class Cause : std::uint8_t {
  vertical_flip,
  horizontal_flip,
  gamma,     ///< values are powers of those of the reference, or sRGB codes
  rounding,  ///< off by one: truncated for rounded, or the other way round; no mistake
  swapped_channels,
  half_pixel_shift,  ///< rays through corners or edges of pixels, not their middles
  ambient,           ///< term missing, doubled, or added once for each light
  diffuse,           ///< term missing, doubled, or put together wrongly
  specular,          ///< term missing, doubled, or put together wrongly
  blinn,             ///< Blinn's highlight for Phong's
  attenuation,       ///< how lights fade with distance
  normals,           ///< not transformed by the inverse transpose, inverted, not normalized
  shadows,           ///< none, or of wrong rays
  acne,              ///< surfaces shadow themselves in spots
  texture,           ///< mirrored, not repeated, not drawn, or mixed wrongly
  recursion_depth,   ///< too few or too many reflections
  spot_falloff,      ///< no smoothstep between the angles, or other angles
  camera,            ///< angles, aspect, axes
  transforms,        ///< order, transposed, signs, degrees
  shapes,            ///< caps or kinds of shapes missing, sizes, the cone's normal
  nearest_hit,       ///< not the nearest hit is shown
  lights,            ///< vectors, colors, kinds and numbers of lights
  reflection,        ///< put together wrongly, or missing
  refraction,        ///< missing, wrong way, wrong weights
  overflow,          ///< values over 1 wrap around, or are scaled
  background,
  brightness,  ///< the whole picture times a factor, inverted, or gray
  black,       ///< nothing was drawn
  features,    ///< drawn with other features or in another mode than the reference
  samples,     ///< samples of a pixel put together wrongly
};

inline constexpr std::size_t cause_count = static_cast<std::size_t>(Cause::samples) + 1;

/// The word for programs, such as "half-pixel-shift".
std::string_view name_of(Cause cause);

/// A mistake that the pictures give evidence for.
struct Claim {
  Cause cause = Cause::rounding;
  std::string what;      ///< "the texture is upside down"
  std::string evidence;  ///< how much of the difference it explains, in words
  double explained = 0;  ///< share of the difference that is gone when the mistake is made, <= 1
};

/// The scene that the reference shows, and how it was drawn: profile, mode, features and depth;
/// size, samples and threads of the options are not used.
struct SceneView {
  const RenderScene* scene = nullptr;
  const Assets* assets = nullptr;
  RenderOptions options;
  const Scene* written = nullptr;  ///< what the scene was made of; null: transforms are not tried
  std::string said;                ///< the view in words; may be empty
};

struct CauseReport {
  /// Mistakes that explain the difference, together where they are several. None: no known mistake
  /// does.
  std::vector<Claim> claims;
  /// Other single mistakes that explain it nearly as well as the best.
  std::vector<Claim> rivals;
  /// A mistake that explains a part only: something else is wrong, or something else altogether.
  std::vector<Claim> partial;
  /// Share of pixels that differ by more than edges and rounding can.
  double share_different = 0;
  /// Share of pixels where our own picture of the scene is not the reference; the claims of a scene
  /// are none where it is great. 1 without a scene.
  double share_scene_unlike = 1;
};

/// Looks for the mistakes, at some thousand pixels: for each mistake a model of a student's ray
/// tracer makes it there. Asks `go_on` now and then with the share of work done in [0, 1]; false
/// stops with the claims so far. Pictures of different sizes: no claims.
CauseReport find_causes(const Texture& reference, const Texture& test,
                        const SceneView* view = nullptr,
                        const std::function<bool(double done)>& go_on = {});

/// What the scene shows at the middle of a pixel of a picture of that size: RenderPrimitive::source
/// of the nearest shape; none: nothing, or the scene has too many shapes.
std::optional<std::uint32_t> source_at(const SceneView& view, const glm::ivec2& pixel,
                                       const glm::ivec2& size);

/// The one of several views whose drawing is most like the reference; the first of equals. `views`
/// is not empty.
SceneView most_alike(const Texture& reference, std::span<const SceneView> views);

}  // namespace scenefile
