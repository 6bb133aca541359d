#include "trace/scalar_lights.h"

#include "scenefile/base/one_lane.h"
#include "scenefile/base/shape_traits.h"
#include "scenefile/base/vector-inl.h"
#include "scenefile/trace/lighting-inl.h"

namespace scenefile {

double attenuation(const glm::vec3& coefficients, double distance) {
  return one::attenuated(coefficients, distance);
}

double spot_factor(const RenderLight& light, double cosine) {
  return one::spot_share(light, cosine);
}

double highlight(double cosine, double shininess) {
  return one::power(cosine, shininess, true);
}

bool illuminate(const RenderLight& light, const glm::dvec3& point, const glm::dvec2& on_light,
                Illumination& result) {
  const one::Arriving arriving = one::arriving(light, one::splat3(point), on_light.x, on_light.y);
  result.to_light = {arriving.to_light.x, arriving.to_light.y, arriving.to_light.z};
  result.distance = arriving.distance;
  result.attenuation = arriving.attenuation;
  result.spot_factor = arriving.spot_factor;
  result.color = glm::dvec3(light.color);
  if (has_position(light.type)) {
    result.color *= result.attenuation * result.spot_factor;
  }
  return arriving.arrives;
}

}  // namespace scenefile
