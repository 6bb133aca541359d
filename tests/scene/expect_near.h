#pragma once

#include <glm/glm.hpp>
#include <gtest/gtest.h>

namespace scenefile::test {

inline void expect_near(const glm::dvec3& a, const glm::dvec3& b) {
  EXPECT_LT(glm::length(a - b), 1e-12) << a.x << ' ' << a.y << ' ' << a.z;
}

}  // namespace scenefile::test
