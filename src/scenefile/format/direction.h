#pragma once
// Directions from points. Private to the room.

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <limits>

namespace scenefile {

/// From one point to another, not normalized. Between points that are far apart the difference may
/// be too large for a float, its direction is not: the result is then shorter.
inline glm::vec3 direction_to(const glm::vec3& to, const glm::vec3& from) {
  const glm::vec3 direction = to - from;
  const bool finite = glm::length(glm::dvec3(direction)) < std::numeric_limits<float>::max();
  return finite ? direction : to * 0.25f - from * 0.25f;
}

}  // namespace scenefile
