#include "scenefile/trace/optics.h"

#include <cmath>

namespace scenefile {

glm::dvec3 reflect_direction(const glm::dvec3& direction, const glm::dvec3& normal) {
  return direction - 2 * glm::dot(direction, normal) * normal;
}

bool refract_direction(const glm::dvec3& direction, const glm::dvec3& normal, double eta,
                       glm::dvec3& refracted) {
  const double cosine = -glm::dot(direction, normal);
  const double squared = 1 - eta * eta * (1 - cosine * cosine);
  if (squared < 0) {
    return false;
  }
  refracted = glm::normalize(eta * direction + (eta * cosine - std::sqrt(squared)) * normal);
  return true;
}

}  // namespace scenefile
