#pragma once

#include <glm/glm.hpp>

#include <algorithm>

namespace scenefile {

/// The largest of the components of a vector or a color.
template <typename T>
T largest(const glm::vec<3, T>& v) {
  return std::max({v.x, v.y, v.z});
}

}  // namespace scenefile
