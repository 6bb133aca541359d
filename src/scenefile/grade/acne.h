#pragma once
// Surfaces that shadow or reflect themselves in spots. Internal to grade.

#include "scenefile/grade/candidates.h"

namespace scenefile {

/// Claims about acne, and about the mistakes `made`, which the picture also has; empty if there is
/// no acne. `least`: the minimum share of the examined pixels that acne must explain.
std::vector<Claim> claims_of_acne(Simulation& sim, const Combination& made, double least);

}  // namespace scenefile
