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

/// The test with its pixels in row-major order, if they seem to be in column-major order:
/// neighboring pixels are then far more alike.
std::optional<Reordered> in_right_order(const Texture& test);

/// The test turned, or with its channels in another order, if that makes it far more similar to the
/// reference. Sizes must be equal.
std::optional<Reordered> in_likelier_order(const Texture& reference, const Texture& test);

}  // namespace scenefile
