#include "scenefile/trace/lights.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace scenefile {

double attenuation(const glm::vec3& coefficients, double distance) {
  const glm::dvec3 c(coefficients);
  const double denominator = c.x + distance * (c.y + distance * c.z);
  return denominator > 1 ? 1 / denominator : 1;
}

double spot_factor(const RenderLight& light, double cosine, bool linear) {
  const double angle = std::acos(std::clamp(cosine, -1.0, 1.0));
  if (angle <= light.inner_angle) {
    return 1;
  }
  if (angle > light.outer_angle) {
    return 0;
  }
  const double t = (angle - light.inner_angle) / (double(light.outer_angle) - light.inner_angle);
  return linear ? 1 - t : 1 - t * t * (3 - 2 * t);
}

bool illuminate(const RenderLight& light, const glm::dvec3& point, const glm::dvec2& on_light,
                Illumination& result, const Mistakes& mistakes) {
  const glm::dvec3 direction(light.direction);
  result.color = glm::dvec3(light.color);
  if (light.type == LightType::directional) {
    result.to_light = -direction;
    result.distance = std::numeric_limits<double>::infinity();
    return true;
  }
  glm::dvec3 from(light.position);
  if (light.type == LightType::area) {
    from += (2 * on_light.x - 1) * glm::dvec3(light.half_u);
    from += (2 * on_light.y - 1) * glm::dvec3(light.half_v);
  }
  const glm::dvec3 path = from - point;
  result.distance = glm::length(path);
  if (!(result.distance > 0) || !std::isfinite(result.distance)) {
    return false;
  }
  result.to_light = path / result.distance;
  const double cosine = -glm::dot(result.to_light, direction);
  if (light.type == LightType::area && cosine <= 0) {
    return false;
  }
  result.attenuation = attenuation(light.attenuation, result.distance);
  result.spot_factor =
      light.type == LightType::spot ? spot_factor(light, cosine, mistakes.linear_spots) : 1;
  const double share = result.attenuation * result.spot_factor;
  result.color *= share;
  return share > 0;
}

}  // namespace scenefile
