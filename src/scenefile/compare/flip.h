#pragma once

#include "scenefile/asset/image.h"

#include <vector>

namespace scenefile {

/// The viewer that the authors of FLIP assume: 0.7 m before a monitor 0.7 m and 3840 pixels wide.
inline constexpr double flip_pixels_per_degree = 67.0206432765823;

/// How much a viewer who flips between two pictures of one size notices, for each pixel.
struct FlipMap {
  std::vector<float> errors;  ///< in [0, 1], row after row; empty for pictures of different sizes
  double mean = 0;            ///< 1 for pictures of different sizes
  double max = 0;             ///< 1 for pictures of different sizes
};

/// LDR-FLIP: P. Andersson, J. Nilsson, T. Akenine-Moeller, M. Oskarsson, K. Astrom, M. D.
/// Fairchild: FLIP: A Difference Evaluator for Alternating Images, Proc. ACM Comput. Graph.
/// Interact. Tech. 3(2), 2020, with the constants of the authors' program. The pictures are taken
/// for sRGB, as a monitor shows them.
FlipMap flip(const Texture& reference, const Texture& test,
             double pixels_per_degree = flip_pixels_per_degree);

}  // namespace scenefile
