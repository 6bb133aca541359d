#pragma once
// What two written scenes say differently.

#include "scenefile/scene/scene.h"

#include <cstddef>
#include <string>
#include <vector>

namespace scenefile {

/// One difference between two scenes.
struct SceneDifference {
  std::string where;  ///< such as "root/arm/#2: sphere 1: diffuse"
  std::string a;      ///< what it is in the first scene; empty: it is not there
  std::string b;      ///< the same in the second
  Location in_a;      ///< of the object or light
  Location in_b;

  friend bool operator==(const SceneDifference&, const SceneDifference&) = default;
};

/// Compares two scenes node by node, in words. Parts that were added, removed or moved are
/// reported as such, without disturbing the comparison of those behind them. At most `most`
/// differences. Empty exactly when `a == b`, for scenes in which check() finds no error.
std::vector<SceneDifference> diff(const Scene& a, const Scene& b, std::size_t most = 10'000);

/// What two scenes say differently, as far as it matters.
struct SceneDiff {
  bool equal = false;                        ///< a == b
  bool same_meaning = false;                 ///< drawn alike, however they are written
  std::vector<SceneDifference> differences;  ///< empty when they have the same meaning
};

/// Compares two scenes by their meaning. At most `most` differences.
SceneDiff diff_meaning(const Scene& a, const Scene& b, std::size_t most = 10'000);

/// "root/arm: sphere 1: diffuse: 1 0 0 -> 0 1 0".
std::string difference_text(const SceneDifference& difference);

}  // namespace scenefile
