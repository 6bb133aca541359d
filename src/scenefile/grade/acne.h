#pragma once
// Surfaces that shadow or reflect themselves in spots. Internal to grade.

#include "scenefile/grade/candidates.h"

namespace scenefile {

/// Acne, in addition to the mistakes `made`. `least`: the share of the differing pixels
/// that it must explain.
std::vector<Claim> claims_of_acne(Simulation& sim, const Combination& made, double least);

}  // namespace scenefile
