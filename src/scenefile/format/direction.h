#pragma once
// Directions between points. Private to the room.

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <limits>

namespace scenefile {

/// The difference of two points, not normalized. It is scaled down if it overflows a float, because
/// only the direction matters.
inline glm::vec3 direction_to(const glm::vec3& to, const glm::vec3& from) {
  const glm::vec3 direction = to - from;
  const bool finite = glm::length(glm::dvec3(direction)) < std::numeric_limits<float>::max();
  return finite ? direction : to * 0.25f - from * 0.25f;
}

}  // namespace scenefile
