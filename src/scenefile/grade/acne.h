#pragma once
// Surfaces that shadow or reflect themselves in spots. Internal to grade.

#include "scenefile/grade/candidates.h"

#include <optional>

namespace scenefile {

struct Acne {
  std::vector<Claim> claims;  ///< about acne and the mistakes beside it; empty: there is no acne
  double unexplained = 1;     ///< share of the examined pixels
};

/// Looks for acne in a picture that also has the mistakes `made`. `least`: the minimum share of the
/// examined pixels that acne must explain.
Acne find_acne(const Simulation& sim, const Combination& made, double least);
/// The claim of shadow acne in a picture whose colors are inexact where there is contrast, as in a
/// JPEG.
std::optional<Claim> claim_of_inexact_acne(const Simulation& sim);
/// Looks for a camera or a sampling of pixels, beside acne, that explains most of the pixels that
/// `acne` alone leaves unexplained. Returns `acne` if there is none.
Acne with_camera(const Simulation& sim, Acne acne);
/// Looks for acne beside each of the mistakes, and returns that which explains most.
Acne find_acne_beside(const Simulation& sim, const std::vector<Combination>& mistakes);

}  // namespace scenefile
