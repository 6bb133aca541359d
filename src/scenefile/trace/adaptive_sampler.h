#pragma once
// The fine profile's samples of a pixel.
//
// Every pixel first gets one sample at its center. That sample is enough where the picture is
// smooth: textures are filtered over the whole pixel. A pixel that differs from a neighbor, above
// all because it sees another surface, gets new samples instead, spread over the pixel by a
// pattern: 4, then 8, 16 and so on, until more would gain too little. The squared error of n such
// samples is about V n^-1.5, where V is the variance of the color within the pixel; going from n to
// m samples therefore gains V (n^-1.5 - m^-1.5) / (m - n) per sample.
//
// Behind a lens every pixel starts with a quarter of the samples of the pattern, at most four.
// Where they differ, or where the pixel differs from a neighbor, it takes all.

#include "scenefile/trace/camera_rays.h"
#include "scenefile/trace/edges.h"
#include "scenefile/trace/tracer.h"

namespace scenefile {

/// Sums over the samples of a pixel so far.
struct PixelSamples {
  Color sum{0};
  Color sum_of_squares{0};  ///< of colors clamped to [0, 1]
  Color clamped_sum{0};
  std::uint32_t count = 0;
  bool penumbra = false;  ///< a sample saw part of an area light

  /// `partly_lit`: the sample saw an area light partially.
  void add(const Color& color, bool partly_lit);
  Color mean() const { return count == 0 ? Color(0) : sum / double(count); }
  /// The variance of the clamped colors, averaged over the channels; 0 for fewer than two samples.
  double variance() const;
};

/// The 15 bits of a surface hash (SampleResult) that are kept until pixels are compared.
inline std::uint16_t kept_hash(std::uint32_t hash) {
  return static_cast<std::uint16_t>((hash ^ (hash >> 15)) & 0x7fff);
}

/// What makes the samples of a pixel differ.
enum class NoiseSource : std::uint8_t {
  none,  ///< only what the pixel covers
  area_lights,
  lens,         ///< maybe area lights, too
  strong_lens,  ///< blurs so strongly that a few samples are not representative
};
NoiseSource noise_source(const RenderScene& scene, const RenderOptions& options);

/// How the samples of a picture are distributed among its pixels.
struct SamplePlan {
  bool centers_first = true;  ///< start with one sample at the center of each pixel
  std::uint32_t first = 1;    ///< otherwise at least this many samples per pixel
  std::uint32_t most = 1;
  /// A second pass refines pixels, depending on what their neighbors saw.
  bool two_passes = false;
};

/// With lenses and area lights, one sample cannot predict the variance, so each pixel starts with
/// several. The same applies if so many samples are allowed that the picture should be exact.
/// Behind a strong lens, each pixel takes all samples.
SamplePlan sample_plan(const RenderOptions& options, NoiseSource noise_source);

/// The samples of a picture; each is a function of the pixel, its index and the seed.
class AdaptiveSampler {
 public:
  AdaptiveSampler(const Tracer& tracer, const CameraRays& camera);

  const SamplePlan& plan() const { return plan_; }
  /// The sample at the center of the pixel.
  CameraSample center_sample(int x, int y) const;
  /// Sample number `index` of the pixel's pattern.
  CameraSample sample(int x, int y, std::uint32_t index) const;
  /// The number of pattern samples that a pixel has after the next round, given `count` so far.
  std::uint32_t next_count(std::uint32_t count) const;
  /// Whether a pixel has enough pattern samples. `refinement`: see refinement_of(); 0 if there is
  /// only one pass.
  bool enough(const PixelSamples& samples, std::uint16_t refinement) const;
  /// How much a pixel must be refined: its contrast with its neighbors, quantized for the
  /// refinement map (film.h); 0 if the first samples are enough. `contrast`: with the eight
  /// neighbors.
  std::uint16_t refinement_of(const Contrast& contrast) const;

 private:
  bool worth(double variance, std::uint32_t count, std::uint32_t more) const;
  CameraSample sample_at(int x, int y, std::uint32_t index, const glm::dvec2& in_pixel) const;

  const CameraRays& camera_;
  std::uint32_t seed_;
  SamplePlan plan_;
  double min_gain_;  // per sample, for a sample to be worth its time
};

}  // namespace scenefile
