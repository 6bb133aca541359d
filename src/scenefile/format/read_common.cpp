#include "scenefile/format/read_common.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <limits>

namespace scenefile {

glm::vec3 direction_to(const glm::vec3& to, const glm::vec3& from) {
  const glm::vec3 direction = to - from;
  const bool finite = glm::length(glm::dvec3(direction)) < std::numeric_limits<float>::max();
  return finite ? direction : to * 0.25f - from * 0.25f;
}

void reserve_nodes(std::vector<Node>& nodes, double progress) {
  constexpr std::size_t small = 4096;
  if (nodes.size() < nodes.capacity() || nodes.size() < small) {
    return;
  }
  const auto size = static_cast<double>(nodes.size());
  const double expected = 1.02 * size / progress;
  nodes.reserve(static_cast<std::size_t>(std::clamp(expected, 1.25 * size, 16 * size)));
}

bool needs_place(Field color, const glm::vec3& value) {
  const bool by_itself = color == Field::diffuse || color == Field::ambient;
  return !by_itself || !glm::all(glm::greaterThanEqual(value, glm::vec3(0))) ||
         !glm::all(glm::lessThanEqual(value, glm::vec3(1)));
}

}  // namespace scenefile
