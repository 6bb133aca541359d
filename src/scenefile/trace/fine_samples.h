#pragma once
// The fine profile's samples of a pixel.

#include "scenefile/trace/camera_rays.h"
#include "scenefile/trace/integrator.h"

namespace scenefile {

/// Sums over the samples that a pixel has had so far.
struct PixelSamples {
  Color sum{0};
  Color sum_of_squares{0};  ///< of colors clamped to [0, 1]
  Color clamped_sum{0};
  std::uint32_t count = 0;
  bool penumbra = false;  ///< a sample saw part of an area light: how much, few samples cannot tell

  /// `partly_lit`: the sample saw part of an area light.
  void add(const Color& color, bool partly_lit);
  Color mean() const { return count == 0 ? Color(0) : sum / double(count); }
  /// Standard error of the clamped mean, largest of the channels.
  double error() const;
};

/// Samples of one picture; each is a function of the pixel, its number and the seed.
class FineSampler {
 public:
  FineSampler(const Tracer& tracer, const CameraRays& camera);

  /// How many samples every pixel gets before any gets more.
  static std::uint32_t first_samples(const RenderOptions& options);
  std::uint32_t first_samples() const { return first_samples(tracer_.options); }
  /// Sample number `index` of the pixel.
  CameraSample sample(int x, int y, std::uint32_t index) const;
  /// Takes samples number samples.count to `count`.
  void take(int x, int y, std::uint32_t count, PixelSamples& samples, RayCounts& counts) const;
  /// Takes more, in rounds of doubled number, until they agree or options.samples are taken.
  void refine(int x, int y, PixelSamples& samples, RayCounts& counts) const;
  /// How many samples a pixel has after the round that follows `count`.
  std::uint32_t next_count(std::uint32_t count) const;
  /// Whether refine() ends with these.
  bool enough(const PixelSamples& samples) const;

 private:
  const Tracer& tracer_;
  const CameraRays& camera_;
  std::uint32_t seed_;
};

/// Whether the pixel's samples tell its color well enough.
bool settled(const PixelSamples& samples);

/// Whether two neighboring pixels differ enough for both to need more samples.
bool differ(const Color& a, const Color& b);

}  // namespace scenefile
