#pragma once
// Affine maps as translation, rotation and scale. Internal to export.

#include "scenefile/base/affine.h"

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

#include <optional>

namespace scenefile {

/// x -> translation + rotation * (scale * x).
struct Trs {
  glm::dvec3 translation{0};
  glm::dquat rotation{1, 0, 0, 0};
  glm::dvec3 scale{1};
};

/// A map as outer * inner. Most maps need no inner part. A map with shear is not a single Trs, but
/// is the product of two, from the singular value decomposition of its linear part, up to rounding.
struct TrsPair {
  Trs outer;
  std::optional<glm::dquat> inner;  ///< a rotation that is applied first
};

/// The map must be invertible.
TrsPair decompose(const DAffine& map);

}  // namespace scenefile
