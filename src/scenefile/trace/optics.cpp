#include "scenefile/trace/optics.h"

#include "scenefile/base/one_lane.h"
#include "scenefile/base/vector-inl.h"
#include "scenefile/trace/optics-inl.h"

#include <cmath>

namespace scenefile {

glm::dvec3 reflect_direction(const glm::dvec3& direction, const glm::dvec3& normal) {
  const one::V3 mirrored = one::mirrored(one::splat3(direction), one::splat3(normal));
  return {mirrored.x, mirrored.y, mirrored.z};
}

bool refract_direction(const glm::dvec3& direction, const glm::dvec3& normal, double eta,
                       glm::dvec3& refracted) {
  const one::Refracted found = one::refraction(one::splat3(direction), one::splat3(normal), eta);
  if (found.through) {
    refracted = {found.direction.x, found.direction.y, found.direction.z};
  }
  return found.through;
}

double fresnel_reflectance(double cosine, double eta) {
  const double squared = 1 - eta * eta * (1 - cosine * cosine);
  if (squared <= 0) {
    return 1;
  }
  const double transmitted = std::sqrt(squared);
  const double s_polarized = (eta * cosine - transmitted) / (eta * cosine + transmitted);
  const double p_polarized = (cosine - eta * transmitted) / (cosine + eta * transmitted);
  return 0.5 * (s_polarized * s_polarized + p_polarized * p_polarized);
}

}  // namespace scenefile
