#pragma once
// The right picture of a scene, as sums over blocks of pixels: by what happened to the light, and
// as programs with one mistake would draw it. All of them come from the same paths, whose terms are
// weighted differently, so that their differences have little noise.

#include "scenefile/asset/load_assets.h"
#include "scenefile/scene/render_scene.h"
#include "scenefile/trace/color.h"
#include "scenefile/trace/render.h"

#include <array>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

namespace scenefile {

/// Pixels of the side of a block. Blocks at the right and lower edge may be smaller.
inline constexpr int block_side = 8;

/// By block, row by row: a value for red, green and blue.
using BlockColors = std::vector<Color>;

/// Kinds of light. All of them add up to the picture.
struct LightKind {
  bool hit =
      false;  ///< the path hit a lamp: after the camera, mirrors, glass. False: light samples
  std::uint8_t rough = 0;   ///< diffuse or glossy reflections before the last surface
  std::uint8_t mirror = 0;  ///< reflections by mirrors; 2 stands for more, too
  std::uint8_t glass = 0;   ///< reflections and refractions by glass

  int bounces() const { return rough + mirror + glass; }
  friend auto operator<=>(const LightKind&, const LightKind&) = default;
};
inline constexpr int most_rough = 9;  ///< and more
inline constexpr int most_mirror = 2;
inline constexpr int most_glass = 5;

/// Changes of the terms of paths, as by a mistake or another convention.
enum class Change : std::uint8_t {
  surface_cosine_direct,
  surface_cosine_indirect,
  surface_cosine_indirect_twice,
  surface_cosine,
  surface_cosine_twice,
  eye_cosine,
  lamp_cosine,
  lamp_cosine_twice,
  lamp_cosine_of_surface,
  falloff_distance,
  falloff_none,
  falloff_cube,
  no_visibility,
  glass_visibility,
  diffuse_missing_direct,
  diffuse_missing_indirect,
  diffuse_missing,
  diffuse_twice_direct,
  diffuse_twice_indirect,
  diffuse_twice,
  diffuse_without_pi,
  glossy_scale,
  glossy_missing,
  glossy_missing_direct,
  glossy_missing_indirect,
  glossy_flat,
  glossy_flat_direct,
  glossy_blinn,
  glossy_eye,
  lobe_alone,
  uniform_density,
  cosine_density,
  polar_density,
  y_directions,
  z_directions,
  color_roulette,
  gray_by_luminance,
  gray_by_mean,
  corner_points,
  edge_points,
  normalized_points,
  lamp_area,
  lamp_area_divided,
  lamp_area_of_first,
  lamp_area_mean,
  lamp_emission,
  lamp_emission_of_first,
  lamp_emission_of_last,
  first_lamp,
  last_lamp,
  fresnel_twice,
  no_fresnel,
  half_fresnel,
  only_reflection,
  swapped_fresnel,
  no_total_reflection,
  schlick,
  schlick_without_square,
  mirror_cosine,
  mirror_without_color,
};
inline constexpr std::size_t change_count =
    static_cast<std::size_t>(Change::mirror_without_color) + 1;

/// The picture after a change, in two parts.
struct ChangedPicture {
  BlockColors sampled;  ///< by light samples
  BlockColors hit;      ///< by paths that hit lamps after a reflection or refraction
  BlockColors noise;    ///< the variance of both together, measured
};

/// Changes of the scene, its paths or the options, as by another convention or a mistake. Each
/// needs its own paths.
enum class Variant : std::uint8_t {
  two_sided_lamps,
  inverted_index,
  always_enters,
  flat_normals,
  lamp_parallelograms,
  all_bounces,
  shaded_mirrors,
  shaded_glass
};
inline constexpr std::array all_variants{Variant::two_sided_lamps,     Variant::inverted_index,
                                         Variant::always_enters,       Variant::flat_normals,
                                         Variant::lamp_parallelograms, Variant::all_bounces,
                                         Variant::shaded_mirrors,      Variant::shaded_glass};

struct VariantPicture {
  Variant variant = Variant::two_sided_lamps;
  BlockColors picture;
  BlockColors noise;  ///< the variance of its difference from the truth, measured
};

/// What programs may do to each sample of a pixel before they take the mean, each value by itself.
enum class SampleTone : std::uint8_t { clamp, reinhard, film };
inline constexpr std::size_t sample_tone_count = static_cast<std::size_t>(SampleTone::film) + 1;

/// min(v, 1), v / (1 + v) or 1 - exp(-v).
Color toned(SampleTone tone, const Color& value);

/// Light of programs whose throughput is not the product of the factors of all directions, by the
/// number of bounces before it, as if no path ended by chance.
struct LooseThroughputs {
  static constexpr std::size_t most = 12;  ///< bounces; callers extrapolate to longer paths
  using Terms = std::array<BlockColors, most + 1>;
  Terms one;   ///< the throughput is 1
  Terms last;  ///< it is the factor of the last direction
  Terms sum;   ///< it is the sum of the factors
};

/// A surface of a path that no roulette ends, as luminances.
struct PathStep {
  float direct = 0;        ///< the light that it adds to the pixel
  float flat_direct = 0;   ///< the same without the cosine of light samples
  float white_direct = 0;  ///< the same if Kd were white in scattered directions
  float flatness = 1;      ///< product of 1 / cosine of the scattered directions that led here
  std::uint8_t rough = 0;  ///< their number
};

/// Paths of some pixels of a block, to simulate programs whose means do not converge: what matters
/// then is how the values of pixels are distributed.
struct PathPool {
  std::size_t block = 0;
  /// Directions by the BSDF, and uniform ones, as programs sample them.
  std::array<std::vector<std::vector<PathStep>>, 2> paths;
};

inline constexpr std::size_t most_lamp_triangles = 8;  ///< of PathTruth::lamp_samples

/// Means; variances are those of means over `samples`.
struct PathTruth {
  int width = 0;  ///< pixels
  int height = 0;
  int columns = 0;  ///< blocks
  int rows = 0;
  double samples = 0;                   ///< per pixel
  std::vector<Color> pixels;            ///< the picture
  std::vector<Color> sample_variances;  ///< by pixel: the variance of a single sample
  BlockColors noise;                    ///< by block: the variance of the picture's mean, measured
  std::map<LightKind, BlockColors> kinds;
  std::vector<BlockColors> first_passes;  ///< sums of the first 1, 2, 4, 8, ... passes
  std::array<ChangedPicture, change_count> changes;
  std::array<BlockColors, sample_tone_count> toned;  ///< the picture, of samples with that tone
  /// Light samples by triangle of the lamps; empty if there are more than `most_lamp_triangles`, or
  /// only one.
  std::vector<BlockColors> lamp_samples;
  /// Of independent paths, with directions by the BSDF, and uniform ones, as programs sample them.
  std::array<std::vector<LooseThroughputs>, 2> throughputs;
  std::vector<VariantPicture> variants;  ///< those that the scene can have
  /// With more samples: those that some picture needed (judge_by_truth()).
  std::vector<VariantPicture> finer_variants;
  std::vector<PathPool> pools;
  std::vector<double> lamp_areas;  ///< by triangle
  double height_angle = 0;         ///< of the camera, radians
  bool glass = false;              ///< some path met glass
  bool mirror = false;
  bool glossy = false;

  std::size_t blocks() const { return std::size_t(columns) * rows; }
};

/// Draws it with the options of mode path until `seconds` of processor time are over, or the
/// picture has `samples` per pixel, but not before it has 16. The status of `cancelled` and
/// failed work is that of render(); the truth is then of no use. `traced`: of the scene.
RenderStatus draw_truth(const TraceScene& traced, const RenderScene& scene,
                        const RenderOptions& options, double seconds, std::uint32_t samples,
                        const Progress& progress, PathTruth& truth);

/// Adds the pools.
void draw_pools(const TraceScene& traced, const RenderScene& scene, const RenderOptions& options,
                PathTruth& truth);

/// Adds the throughputs, until `seconds` of processor time are over.
RenderStatus draw_throughputs(const TraceScene& traced, const RenderScene& scene,
                              const RenderOptions& options, double seconds,
                              const Progress& progress, PathTruth& truth);

/// Draws variants, each with as many samples as fit into an equal share of the time, but no more
/// than the truth has. Those that are there already are replaced.
RenderStatus draw_variants(std::span<const Variant> variants, const RenderScene& scene,
                           const Assets& assets, const RenderOptions& options, double seconds,
                           const Progress& progress, PathTruth& truth);

}  // namespace scenefile
