// The terms of the lighting equation for any number of lanes (base/one_lane.h). No include guard:
// included once for each number of lanes.

#include "scenefile/base/shape_traits.h"
#include "scenefile/scene/render_scene.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace scenefile::SCENEFILE_LANES {

/// Light at a point, ignoring occluders. None arrives outside a spotlight's cone, behind an area
/// light, and at the light itself.
struct Arriving {
  M arrives;
  V3 to_light;
  F distance;
  F attenuation;
  F spot_factor;
};

inline F attenuated(const glm::vec3& coefficients, F distance) {
  const V3 c = splat3(coefficients);
  const F denominator = c.x + distance * (c.y + distance * c.z);
  return select(denominator > splat(1), splat(1) / denominator, splat(1));
}

inline F spot_share(const RenderLight& light, F cosine) {
  const auto angle_of = [](double c, double) { return std::acos(std::clamp(c, -1.0, 1.0)); };
  const F angle = each(cosine == cosine, angle_of, cosine, cosine);
  const double width = double(light.outer_angle) - double(light.inner_angle);
  const F t = (angle - splat(light.inner_angle)) / splat(width);
  const F falling = splat(1) - t * t * (splat(3) - splat(2) * t);
  return select(angle <= splat(light.inner_angle), splat(1),
                select(angle > splat(light.outer_angle), splat(0), falling));
}

/// Light that arrives from any light except directional ones; (u, v) selects the point of an area
/// light.
inline Arriving arriving_from(const RenderLight& light, const V3& point, F u, F v) {
  V3 from = splat3(light.position);
  if (has_rectangle(light.type)) {
    from = from + (splat(2) * u - splat(1)) * splat3(light.half_u);
    from = from + (splat(2) * v - splat(1)) * splat3(light.half_v);
  }
  const V3 path = from - point;
  Arriving light_here;
  light_here.distance = length(path);
  light_here.to_light = path / light_here.distance;
  M arrives = (light_here.distance > splat(0)) & finite(light_here.distance);
  const F cosine = -dot(light_here.to_light, splat3(light.direction));
  if (has_rectangle(light.type)) {
    arrives = arrives & (cosine > splat(0));
  }
  light_here.attenuation = attenuated(light.attenuation, light_here.distance);
  light_here.spot_factor = has_cone(light.type) ? spot_share(light, cosine) : splat(1);
  light_here.arrives = arrives & (light_here.attenuation * light_here.spot_factor > splat(0));
  return light_here;
}

inline Arriving arriving(const RenderLight& light, const V3& point, F u, F v) {
  if (has_position(light.type)) {
    return arriving_from(light, point, u, v);
  }
  const M always = !no_lanes();
  return {always, -splat3(light.direction), splat(std::numeric_limits<double>::infinity()),
          splat(1), splat(1)};
}

/// The cosine between the reflected direction to the light and the direction to the eye (Phong).
inline F mirrored_cosine(const V3& normal, const V3& to_light, F cosine, const V3& to_eye) {
  return dot(splat(2) * cosine * normal - to_light, to_eye);
}

/// x to the power n in the lanes of the mask, where both are positive. Integer exponents, which
/// files usually have, use multiplication: fast, and the same on every machine.
inline F power(F x, F n, M wanted) {
  const F largest_whole = splat(4096);
  const M whole = (floor(n) == n) & (n <= largest_whole);
  const M broken = wanted & !whole;
  F result = splat(1);
  F left = select(wanted & whole, n, splat(0));
  for (F square = x; any(left > splat(0)); square = square * square) {
    const F half = floor(splat(0.5) * left);
    result = select(half + half == left, result, result * square);
    left = half;
  }
  if (none(broken)) {
    return result;
  }
  const auto pow = [](double base, double exponent) { return std::pow(base, exponent); };
  return select(broken, each(broken, pow, x, n), result);
}

}  // namespace scenefile::SCENEFILE_LANES
