#pragma once
// Pictures whose pixels or channels are in another order, whatever else is wrong with them.
// Internal to grade.

#include "scenefile/grade/causes.h"

#include <optional>

namespace scenefile {

struct Reordered {
  Claim claim;       ///< without evidence
  Texture picture;   ///< the test in the other order
  bool sure = true;  ///< the test is unlike the reference, and the picture is like it
};

/// The test with pixels in the order of rows, if they are in that of columns: neighboring pixels
/// are far more alike then.
std::optional<Reordered> in_right_order(const Texture& test);

/// The test turned, or with channels in another order, if it is far more like the reference in it.
/// Sizes must be equal.
std::optional<Reordered> in_likelier_order(const Texture& reference, const Texture& test);

}  // namespace scenefile
