#include "scenefile/view/helpers.h"

#include "scenefile/base/shape_traits.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace scenefile {

namespace {

double diagonal_of(const Bounds& scene) {
  return scene.empty() ? 1 : glm::length(scene.max - scene.min);
}

glm::dvec3 center_of(const Bounds& scene) {
  return scene.empty() ? glm::dvec3(0) : 0.5 * (scene.min + scene.max);
}

glm::dvec3 side_of(const glm::dvec3& direction) {
  return glm::normalize(glm::cross(
      direction, std::abs(direction.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0)));
}

// The rings, and four lines from the light to the outer one.
void add_cone(std::vector<WorldLine>& lines, const RenderLight& light, const Bounds& scene) {
  for (const SpotEdge edge : {SpotEdge::inner, SpotEdge::outer}) {
    if (edge == SpotEdge::inner && light.inner_angle == light.outer_angle) {
      continue;
    }
    const std::vector<glm::dvec3> ring = cone_ring(light, edge, scene);
    for (std::size_t i = 1; i < ring.size(); ++i) {
      lines.push_back({ring[i - 1], ring[i]});
      if (edge == SpotEdge::outer && i % (ring.size() / 4) == 0) {
        lines.push_back({glm::dvec3(light.position), ring[i]});
      }
    }
  }
}

}  // namespace

std::vector<WorldLine> light_helper(const RenderLight& light, const Bounds& scene) {
  std::vector<WorldLine> lines;
  const double size = diagonal_of(scene);
  const glm::dvec3 direction(light.direction);
  if (!has_position(light.type)) {
    const glm::dvec3 from = center_of(scene) - 0.5 * size * direction;
    const glm::dvec3 to = from + 0.25 * size * direction;
    const glm::dvec3 side = side_of(direction);
    lines.push_back({from, to});
    for (const double s : {-1.0, 1.0}) {
      lines.push_back({to, to - 0.05 * size * direction + s * 0.025 * size * side});
    }
    return lines;
  }
  const glm::dvec3 at(light.position);
  for (int axis = 0; axis < 3; ++axis) {
    glm::dvec3 reach(0);
    reach[axis] = 0.03 * size;
    lines.push_back({at - reach, at + reach});
  }
  if (light.type == LightType::spot) {
    add_cone(lines, light, scene);
  }
  if (has_direction(light.type)) {
    lines.push_back({at, at + 0.15 * size * direction});
  }
  return lines;
}

glm::dvec3 cone_point(const RenderLight& light, SpotEdge edge, const Bounds& scene, double angle,
                      double around) {
  const glm::dvec3 at(light.position);
  const glm::dvec3 direction(light.direction);
  const double to_center = glm::dot(center_of(scene) - at, direction);
  const double reach =
      (edge == SpotEdge::outer ? 1 : 0.8) * std::max(to_center, 0.15 * diagonal_of(scene));
  const glm::dvec3 side = side_of(direction);
  const glm::dvec3 other = glm::cross(direction, side);
  return at + reach * (std::cos(angle) * direction +
                       std::sin(angle) * (std::cos(around) * side + std::sin(around) * other));
}

std::vector<glm::dvec3> cone_ring(const RenderLight& light, SpotEdge edge, const Bounds& scene) {
  constexpr int parts = 48;
  const double angle = edge == SpotEdge::outer ? light.outer_angle : light.inner_angle;
  std::vector<glm::dvec3> ring;
  for (int i = 0; i <= parts; ++i) {
    ring.push_back(cone_point(light, edge, scene, angle, 2 * std::numbers::pi * i / parts));
  }
  return ring;
}

std::vector<WorldLine> camera_helper(const RenderCamera& camera, double aspect,
                                     const Bounds& scene) {
  std::vector<WorldLine> lines;
  const double depth = 0.15 * diagonal_of(scene);
  const double half = depth * std::tan(camera.fov_y / 2);
  std::array<glm::dvec3, 4> corners;
  for (std::size_t i = 0; i < 4; ++i) {
    const double x = i == 0 || i == 3 ? -1 : 1;
    const double y = i < 2 ? -1 : 1;
    corners[i] =
        camera.position - depth * camera.w + x * half * aspect * camera.u + y * half * camera.v;
  }
  for (std::size_t i = 0; i < 4; ++i) {
    lines.push_back({camera.position, corners[i]});
    lines.push_back({corners[i], corners[(i + 1) % 4]});
  }
  const glm::dvec3 tip = 0.5 * (corners[2] + corners[3]) + 0.5 * half * camera.v;
  lines.push_back({corners[2], tip});
  lines.push_back({corners[3], tip});
  return lines;
}

}  // namespace scenefile
