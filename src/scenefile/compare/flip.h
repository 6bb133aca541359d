#pragma once

#include "scenefile/asset/image.h"

#include <vector>

namespace scenefile {

/// The viewing distance that the authors of FLIP assume: 0.7 m from a monitor that is 0.7 m and
/// 3840 pixels wide.
inline constexpr double flip_pixels_per_degree = 67.0206432765823;

/// The visible difference when flipping between two pictures of the same size, for each pixel.
struct FlipMap {
  std::vector<float> errors;  ///< in [0, 1], row by row; empty if the sizes differ
  double mean = 0;            ///< 1 if the sizes differ
  double max = 0;             ///< 1 if the sizes differ
};

/// LDR-FLIP: P. Andersson, J. Nilsson, T. Akenine-Moeller, M. Oskarsson, K. Astrom, M. D.
/// Fairchild: FLIP: A Difference Evaluator for Alternating Images, Proc. ACM Comput. Graph.
/// Interact. Tech. 3(2), 2020, with the constants of the authors' program. The pictures are
/// interpreted as sRGB, as a monitor shows them.
FlipMap flip(const Texture& reference, const Texture& test,
             double pixels_per_degree = flip_pixels_per_degree);

}  // namespace scenefile
