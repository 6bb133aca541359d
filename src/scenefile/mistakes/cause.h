#pragma once
// What students' programs do wrong, by type; and a mistake that was found in a picture.

#include <array>
#include <cstdint>
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

}  // namespace scenefile
