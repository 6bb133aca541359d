#include "scenefile/trace/bump.h"

#include <algorithm>
#include <cmath>

namespace scenefile {

namespace {

double height(const Pyramid& map, const RenderTexture& use, const glm::dvec2& uv,
              const UvFootprint& footprint) {
  const glm::dvec3 color = lookup_filtered(map, use, uv, footprint);
  return bump_height * (color.x + color.y + color.z) / 3;
}

// The largest extent of the footprint along one coordinate.
double reach(const UvFootprint& footprint, int coordinate) {
  const double size =
      std::max(std::abs(footprint.right[coordinate]), std::abs(footprint.down[coordinate]));
  return std::isfinite(size) ? std::min(size, 0.25) : 0.25;
}

}  // namespace

glm::dvec3 bumped_normal(const SurfacePoint& point, const Pyramid& map,
                         const UvFootprint& footprint) {
  const RenderTexture& use = point.material->bump_map;
  const Surface& s = point.object;
  const double area = glm::dot(glm::cross(s.tangent_u, s.tangent_v), s.normal);
  const double flat = 1e-12 * glm::length(s.tangent_u) * glm::length(s.tangent_v);
  if (!(std::abs(area) > flat) || use.repeat_u == 0 || use.repeat_v == 0) {
    return point.normal;
  }
  const Texture& texture = map.level(0);
  const double du =
      std::max(1 / std::abs(double(use.repeat_u) * texture.width), reach(footprint, 0));
  const double dv =
      std::max(1 / std::abs(double(use.repeat_v) * texture.height), reach(footprint, 1));
  const auto slope = [&](const glm::dvec2& step, double size) {
    return (height(map, use, s.uv + step, footprint) - height(map, use, s.uv - step, footprint)) /
           (2 * size);
  };
  const double slope_u = slope({du, 0}, du);
  const double slope_v = slope({0, dv}, dv);
  const glm::dvec3 gradient =
      (slope_u * glm::cross(s.tangent_v, s.normal) + slope_v * glm::cross(s.normal, s.tangent_u)) /
      area;
  return world_normal(point.hit.object_from_world, s.normal - gradient);
}

}  // namespace scenefile
