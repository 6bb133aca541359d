#pragma once
// Compares two written scenes.

#include "scenefile/scene/scene.h"

#include <cstddef>
#include <string>
#include <vector>

namespace scenefile {

/// One difference between two scenes.
struct SceneDifference {
  std::string where;  ///< such as "root/arm/#2: sphere 1: diffuse"
  std::string a;      ///< its value in the first scene; empty: absent there
  std::string b;      ///< the same for the second scene
  Location in_a;      ///< place of the object or light
  Location in_b;

  friend bool operator==(const SceneDifference&, const SceneDifference&) = default;
};

/// Compares two scenes node by node. Parts that were added, removed or moved are reported as such,
/// without disturbing the comparison of the parts after them. Returns at most `most` differences.
/// Empty exactly if `a == b`, for scenes in which check() finds no error.
std::vector<SceneDifference> diff(const Scene& a, const Scene& b, std::size_t most = 10'000);

/// The result of comparing two scenes by meaning.
struct SceneDiff {
  bool equal = false;                        ///< a == b
  bool same_meaning = false;                 ///< drawn alike, however they are written
  std::vector<SceneDifference> differences;  ///< empty if the scenes have the same meaning
};

/// Compares what two scenes draw, ignoring how they are written. Returns at most `most`
/// differences.
SceneDiff diff_meaning(const Scene& a, const Scene& b, std::size_t most = 10'000);

/// "root/arm: sphere 1: diffuse: 1 0 0 -> 0 1 0".
std::string difference_text(const SceneDifference& difference);

}  // namespace scenefile
