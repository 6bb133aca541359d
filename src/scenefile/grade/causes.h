#pragma once
// Finds out why a picture differs from its reference: simulates common mistakes, and names one only
// if simulating it turns the reference into the picture.

#include "scenefile/scene/prepare.h"
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

/// Types of mistakes. Those up to half_pixel_shift can be found without the scene.
enum class Cause : std::uint8_t {
  vertical_flip,
  horizontal_flip,
  gamma,     ///< values are powers of the reference's values, or sRGB-encoded
  rounding,  ///< off by one: truncated instead of rounded, or vice versa; not a mistake
  swapped_channels,
  half_pixel_shift,  ///< rays through corners or edges of pixels instead of centers
  ambient,           ///< term missing, doubled, or added once per light
  diffuse,           ///< term missing, doubled, or combined wrongly
  specular,          ///< term missing, doubled, or combined wrongly
  blinn,             ///< Blinn's highlight instead of Phong's
  attenuation,       ///< falloff of lights with distance
  normals,           ///< not transformed by the inverse transpose, inverted, not normalized
  shadows,           ///< none, or by wrong rays
  acne,              ///< surfaces shadow themselves in spots
  texture,           ///< mirrored, not repeated, missing, or blended wrongly
  recursion_depth,   ///< too few or too many reflections
  spot_falloff,      ///< no smoothstep between the angles, or wrong angles
  camera,            ///< angles, aspect ratio, axes
  transforms,        ///< order, transposition, signs, degrees
  shapes,            ///< caps or shapes missing, sizes, the cone's normal
  nearest_hit,       ///< a hit other than the nearest is shown
  lights,            ///< vectors, colors, types and number of lights
  reflection,        ///< combined wrongly, or missing
  refraction,        ///< missing, wrong direction, wrong weights
  overflow,          ///< values above 1 wrap around, or are scaled
  background,
  brightness,    ///< the whole picture times a factor, inverted, or gray
  black,         ///< nothing was drawn
  features,      ///< drawn with other features or in another mode than the reference
  samples,       ///< samples of a pixel combined wrongly
  scene_edited,  ///< a value of the scene file is another
  // Of the assignment Realtime (realtime_causes.h).
  tessellation,  ///< other parameters, wedges or quads
  facets,        ///< flat normals, or lighting per vertex
  culling,       ///< missing, or triangles with the wrong winding order
  clipping,      ///< near and far planes
  filter,        ///< missing, wrong kernel, wrong border
  viewport,      ///< size of the viewport, the frame and the window's aspect ratio
  // Of the assignment Path (noise/judge_path.h).
  light_samples,   ///< of lamps: distance, cosine, area, choice, shadows
  scattering,      ///< cosine, BSDF and density of directions
  path_length,     ///< where paths end, and which hits of lamps count
  specular_paths,  ///< mirrors and glass
};

inline constexpr std::size_t cause_count = static_cast<std::size_t>(Cause::specular_paths) + 1;

/// The name in JSON output, such as "half-pixel-shift".
std::string_view name_of(Cause cause);

/// A mistake, with the evidence for it.
struct Claim {
  Cause cause = Cause::rounding;
  std::string what;      ///< "the texture is upside down"
  std::string evidence;  ///< how much of the difference it explains, as text
  double explained = 0;  ///< fraction of the difference that the mistake removes, <= 1
  bool said = false;     ///< for a rival: the claim's text already names it
  /// If several mistakes give the same picture: the words for each, the likeliest first. `what`
  /// names them all.
  std::vector<std::string> alternatives = {};
};

/// The scene of the reference, and how it was drawn: profile, mode, features and depth. Size
/// and samples of the options are not used.
struct SceneView {
  const RenderScene* scene = nullptr;
  const Assets* assets = nullptr;
  RenderOptions options;
  const Scene* written = nullptr;  ///< the written scene; null: transforms are not tried
  std::string said;                ///< a description; may be empty
  /// If the pictures are a part of the picture of the scene: its size, and where their upper left
  /// corner is in it, in their pixels. 0: they are the whole picture.
  glm::dvec2 whole{0};
  glm::dvec2 corner{0};
  int samples = 1;  ///< of a pixel, across and down; more for pictures that were scaled down
  /// That `scene` refers to; needed with `written`.
  const std::vector<Source>* sources = nullptr;
  /// By pixel of the picture, by how much compression may have changed its color, in 1/255;
  /// infinite: the color is no evidence. Empty: there was no compression.
  std::vector<float> noise = {};
  /// A place in the pictures, in their pixels, for CauseReport::asked.
  std::optional<glm::dvec2> asked = std::nullopt;
};

/// Light of a light, in 1/255.
struct LightParts {
  glm::dvec3 diffuse{0};
  glm::dvec3 specular{0};
};

/// What a program with mistakes draws at a pixel, in 1/255, not clamped.
struct MistakenPixel {
  glm::dvec3 color{0};
  /// Of the color, if these add up to it: ambient light, that of each light of the scene, and what
  /// mirrors and glass add. Without `lights`, they are not known.
  glm::dvec3 ambient{0};
  std::vector<LightParts> lights;
  glm::dvec3 followed{0};
};

/// If at most this share of the pixels differs, pictures are the same.
inline constexpr double max_share_same = 0.001;

struct CauseReport {
  /// Mistakes that together explain the difference. Empty if no known mistakes do.
  std::vector<Claim> claims;
  /// Other single mistakes that explain it almost as well as the best.
  std::vector<Claim> rivals;
  /// A mistake that explains only a part: something else is wrong too, or instead.
  std::vector<Claim> partial;
  /// Parts of the explanation that are not mistakes, such as other ways of sampling.
  std::vector<Claim> notes;
  /// Without claims: what nearly all pixels that differ have in common, and few others, in words,
  /// such as "99 % of the pixels that differ show highlights; so do 2 % of the others". May be
  /// empty.
  std::string confined;
  /// The place that was asked for, drawn with `claims` or `partial`, if these can be drawn.
  std::optional<MistakenPixel> asked;
  /// Fraction of pixels that differ by more than edges and rounding explain.
  double share_different = 0;
  /// Whether these are so few, and so scattered, that the pictures count as the same.
  bool only_details = true;
  /// Fraction of pixels where our picture of the scene differs from the reference. If it is large,
  /// there are no claims that need the scene. 1 without a scene.
  double share_scene_unlike = 1;
  /// Which steps of the search found the claims, joined by '+', and how many rays it traced: to
  /// measure the search (tests/student/ledger.py).
  std::string route;
  std::uint64_t rays = 0;
};

enum class LookFor : std::uint8_t { single_mistakes, several_at_once };

/// Looks for mistakes by simulating each one, in a model of a student's ray tracer, at a few
/// thousand pixels. Calls `go_on` occasionally with the finished fraction of the work in [0, 1]; if
/// it returns false, stops with the claims so far. No claims if the sizes differ.
CauseReport find_causes(const Texture& reference, const Texture& test,
                        const SceneView* view = nullptr,
                        const std::function<bool(double done)>& go_on = {},
                        LookFor look_for = LookFor::several_at_once);

/// What the scene shows at the center of a pixel of a picture of that size: RenderPrimitive::source
/// of the nearest shape. nullopt if there is none, or if the scene has too many shapes.
std::optional<std::uint32_t> source_at(const SceneView& view, const glm::ivec2& pixel,
                                       const glm::ivec2& size);

/// A view by its index, and whether its picture is as similar to the reference as the best one;
/// otherwise it is nearly as similar.
struct AlikeView {
  std::size_t index = 0;
  bool equally = true;
};

/// The views whose pictures are the most similar to the reference; those that are equally similar
/// come first. `views` must not be empty.
std::vector<AlikeView> alike(const Texture& reference, std::span<const SceneView> views);

}  // namespace scenefile
