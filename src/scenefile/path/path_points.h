#pragma once
// The random numbers of a path: Owen-scrambled Sobol points that only depend on pixel, seed, index
// of the sample and use, so neither on threads nor on crops or passes.

#include "scenefile/trace/sequence.h"

#include <glm/glm.hpp>

#include <cstdint>

namespace scenefile {

/// What a pair of numbers is for. Each pair is a separate pattern (sequence.h): the samples of a
/// pixel are stratified in both numbers of a pair, and independent between pairs.
enum class PathUse : std::uint32_t {
  pixel,      ///< position in the pixel
  lens,       ///< position on the lens
  direction,  ///< per bounce: the scattered direction
  lobe,       ///< per bounce: x: lobe of the BSDF; y: roulette
  lamp,       ///< per bounce: x: triangle and position on it; y: position. By light sample
  light,      ///< per bounce: x: the light of the scene, after the first bounce
  area        ///< per bounce and light: position on an area light. By light sample
};

class PathPoints {
 public:
  PathPoints(int x, int y, std::uint64_t seed, std::uint32_t sample)
      : pixel_(mixed_bits(
            mixed_bits(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y)),
            mixed_bits(static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32)))),
        sample_(sample) {}

  /// The point for a use; `part` and `parts`: of several points of one sample, such as its light
  /// samples; `index`: of several similar uses, such as area lights.
  glm::dvec2 operator()(PathUse use, std::uint32_t bounce, std::uint32_t part = 0,
                        std::uint32_t parts = 1, std::uint32_t index = 0) const {
    const std::uint32_t pattern =
        mixed_bits(pixel_, mixed_bits(bounce << 8 | static_cast<std::uint32_t>(use), index));
    return stratified_2d(sample_ * parts + part, pattern);
  }

 private:
  std::uint32_t pixel_;
  std::uint32_t sample_;
};

}  // namespace scenefile
