#pragma once
// The fine profile's samples of a pixel.
//
// Where one sample in the middle of a pixel tells enough, it is all that the pixel gets: what is
// smooth within a pixel it tells best of all, and textures are filtered over the whole pixel. Where
// it differs from a neighbor, most of all by seeing other surfaces, the pixel gets samples of its
// own in place of it, spread over the pixel by a pattern: 4, 8, 16 ... until more would gain too
// little. The error of such samples is about V n^-1.5 (squared; V:
// variance of the color in the pixel), so that a sample gains V (n^-1.5 - m^-1.5) / (m - n) on the
// way from n samples to m.

#include "scenefile/trace/camera_rays.h"
#include "scenefile/trace/integrator.h"

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
  /// Of the clamped colors, mean of the channels; 0 of less than two samples.
  double variance() const;
};

/// The 15 bits of a signature (WaveSight) that are kept until pixels are compared.
inline std::uint16_t kept_signature(std::uint32_t signature) {
  return static_cast<std::uint16_t>((signature ^ (signature >> 15)) & 0x7fff);
}

/// Whether the camera has a lens that is used.
bool has_lens(const RenderScene& scene, const RenderOptions& options);

/// Whether lenses or area lights leave noise.
bool is_soft(const RenderScene& scene, const RenderOptions& options);

/// How the samples of a picture are shared out among its pixels.
struct SamplePlan {
  bool middles = true;      ///< begin with one sample in the middle of each pixel
  std::uint32_t first = 1;  ///< else so many at least
  std::uint32_t most = 1;

  /// Pixels get more by what their neighbors saw.
  bool two_passes() const { return middles && most > 1; }
};

/// `soft`: see is_soft(). Lenses and area lights blur what one sample cannot foresee, so
/// that each pixel begins with several. So it does where so many samples are allowed that the
/// picture shall be exact.
SamplePlan sample_plan(const RenderOptions& options, bool soft);

/// The samples of a picture; each is a function of the pixel, its index and the seed.
class FineSampler {
 public:
  FineSampler(const Tracer& tracer, const CameraRays& camera);

  const SamplePlan& plan() const { return plan_; }
  /// The sample in the middle of the pixel.
  CameraSample middle(int x, int y) const;
  /// Sample number `index` of the pixel's pattern.
  CameraSample sample(int x, int y, std::uint32_t index) const;
  /// How many samples of its own a pixel has after the round that follows `count`.
  std::uint32_t next_count(std::uint32_t count) const;
  /// Whether a pixel has enough samples of its own. `mark`: see mark_of(), 0 in one pass.
  bool enough(const PixelSamples& samples, std::uint8_t mark) const;
  /// Gives a pixel samples of its own, one after the other, until it has enough.
  void take(int x, int y, std::uint8_t mark, PixelSamples& samples, RayCounts& counts) const;
  /// What is to be kept of how much a pixel differs from its neighbors until its samples are taken:
  /// 0 where its middle tells enough. `contrast`: the largest with a neighbor (edges.h).
  std::uint8_t mark_of(float contrast) const;

 private:
  bool worth(double variance, std::uint32_t count, std::uint32_t more) const;
  CameraSample sample_at(int x, int y, std::uint32_t index, const glm::dvec2& in_pixel) const;

  const Tracer& tracer_;
  const CameraRays& camera_;
  std::uint32_t seed_;
  SamplePlan plan_;
  double least_gain_;  // of a sample that is worth its time
};

}  // namespace scenefile
