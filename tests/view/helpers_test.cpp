#include "scenefile/view/helpers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace scenefile {
namespace {

const Bounds box{glm::dvec3(-1, 0, -2), glm::dvec3(1, 2, 2)};
const double diagonal = std::sqrt(4.0 + 4.0 + 16.0);

double length(const WorldLine& line) {
  return glm::length(line.to - line.from);
}

RenderLight light_of(LightType type) {
  RenderLight light;
  light.type = type;
  light.position = {3, 4, 5};
  light.direction = {0, 0, -1};
  light.inner_angle = light.outer_angle = 0.5F;
  return light;
}

TEST(Helpers, PointLightIsACrossAtItsPosition) {
  const std::vector<WorldLine> lines = light_helper(light_of(LightType::point), box);
  ASSERT_EQ(lines.size(), 3U);
  for (const WorldLine& line : lines) {
    EXPECT_NEAR(glm::length(0.5 * (line.from + line.to) - glm::dvec3(3, 4, 5)), 0, 1e-12);
    EXPECT_NEAR(length(line), 0.06 * diagonal, 1e-12);
  }
}

TEST(Helpers, SpotlightsAndAreaLightsShowTheirDirection) {
  for (const LightType type : {LightType::spot, LightType::area}) {
    const std::vector<WorldLine> lines = light_helper(light_of(type), box);
    ASSERT_GE(lines.size(), 4U);
    const glm::dvec3 way = lines.back().to - lines.back().from;
    EXPECT_NEAR(glm::length(glm::normalize(way) - glm::dvec3(0, 0, -1)), 0, 1e-12);
  }
}

TEST(Helpers, ASpotlightShowsBothEdgesOfItsCone) {
  RenderLight light = light_of(LightType::spot);
  light.outer_angle = 0.6F;
  light.inner_angle = 0.4F;
  for (const SpotEdge edge : {SpotEdge::outer, SpotEdge::inner}) {
    const double angle = edge == SpotEdge::outer ? light.outer_angle : light.inner_angle;
    // The center of the scene is 5 ahead.
    const double reach = edge == SpotEdge::outer ? 5 : 4;
    const std::vector<glm::dvec3> ring = cone_ring(light, edge, box);
    EXPECT_NEAR(glm::length(ring.front() - ring.back()), 0, 1e-9);
    for (const glm::dvec3& point : ring) {
      const glm::dvec3 way = point - glm::dvec3(3, 4, 5);
      EXPECT_NEAR(glm::length(way), reach, 1e-9);
      EXPECT_NEAR(std::acos(-way.z / glm::length(way)), angle, 1e-9);
    }
  }
  const std::size_t both = light_helper(light, box).size();
  light.inner_angle = light.outer_angle;
  EXPECT_LT(light_helper(light, box).size(), both) << "there is no inner edge";
}

TEST(Helpers, DirectionalLightPointsAtTheCenterOfTheScene) {
  const std::vector<WorldLine> lines = light_helper(light_of(LightType::directional), box);
  ASSERT_EQ(lines.size(), 3U);
  const glm::dvec3 center(0, 1, 0);
  const glm::dvec3 way = lines.front().to - lines.front().from;
  EXPECT_NEAR(glm::length(glm::cross(glm::normalize(way), center - lines.front().from)), 0, 1e-12);
  EXPECT_GT(glm::dot(way, center - lines.front().to), 0);
}

TEST(Helpers, AnEmptySceneHasFiniteLines) {
  for (const LightType type :
       {LightType::point, LightType::directional, LightType::spot, LightType::area}) {
    for (const WorldLine& line : light_helper(light_of(type), Bounds{})) {
      EXPECT_TRUE(std::isfinite(length(line)));
      EXPECT_GT(length(line), 0);
    }
  }
}

TEST(Helpers, CameraIsThePyramidOfItsPicture) {
  RenderCamera camera;
  camera.position = {0, 1, 10};
  camera.fov_y = 1;
  const std::vector<WorldLine> lines = camera_helper(camera, 2, box);
  ASSERT_EQ(lines.size(), 10U);
  const double depth = 0.15 * diagonal;
  EXPECT_EQ(std::count_if(lines.begin(), lines.end(),
                          [&](const WorldLine& line) { return line.from == camera.position; }),
            4);
  for (const WorldLine& line : lines) {
    if (line.from == camera.position) {
      const glm::dvec3 way = line.to - line.from;
      EXPECT_NEAR(-way.z, depth, 1e-12);
      EXPECT_NEAR(std::abs(way.y), depth * std::tan(0.5), 1e-12);
      EXPECT_NEAR(std::abs(way.x), 2 * depth * std::tan(0.5), 1e-12);
    }
  }
}

}  // namespace
}  // namespace scenefile
