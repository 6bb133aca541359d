#pragma once
// Searches for two or three mistakes that explain a picture together. Internal to grade.

#include "scenefile/grade/candidates.h"

namespace scenefile {

/// Tries combinations of two or three mistakes. `ranked`: all single mistakes, screened; `alone`:
/// the best of them. Sets `claims` if acne is one of the mistakes, which is not simulated, and
/// `tried` to the pairs that were tried, at a few points.
std::optional<Tried> find_several(Simulation& sim, const std::vector<Tried>& ranked,
                                  const std::vector<Tried>& alone, std::vector<Claim>& claims,
                                  std::vector<Tried>& tried);
/// Without the scene: only mistakes that change the finished picture.
std::optional<Tried> find_several_of_picture(Simulation& sim, const std::vector<Tried>& ranked);

}  // namespace scenefile
