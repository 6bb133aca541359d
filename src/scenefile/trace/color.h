#pragma once

#include <glm/glm.hpp>

namespace scenefile {

/// Linear red, green, blue; 1 is full.
using Color = glm::dvec3;

}  // namespace scenefile
