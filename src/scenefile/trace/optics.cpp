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

double fresnel_reflectance(double cosine, double eta) {
  const double squared = 1 - eta * eta * (1 - cosine * cosine);
  if (squared <= 0) {
    return 1;
  }
  const double behind = std::sqrt(squared);
  const double across = (eta * cosine - behind) / (eta * cosine + behind);
  const double along = (cosine - eta * behind) / (cosine + eta * behind);
  return 0.5 * (across * across + along * along);
}

}  // namespace scenefile
