#include "scenefile/trace/accelerator.h"

#include <algorithm>
#include <cmath>

namespace scenefile {

namespace {

constexpr double fixed_point_one = 4294967296.0;  // 2^32 steps per halving
constexpr double black_halvings = Transmission::black / fixed_point_one;

std::int64_t density_of(double factor) {
  const double halvings = factor > 0 ? -std::log2(std::min(factor, 1.0)) : black_halvings;
  return std::llround(std::min(halvings, black_halvings) * fixed_point_one);
}

}  // namespace

Transmission::Transmission(const std::vector<glm::dvec3>& factors) {
  densities_.reserve(factors.size());
  for (const glm::dvec3& factor : factors) {
    densities_.emplace_back(density_of(factor.x), density_of(factor.y), density_of(factor.z));
    all_opaque_ = all_opaque_ && blocks(densities_.back());
  }
}

bool Transmission::blocks(const glm::i64vec3& density) {
  return density.x >= black && density.y >= black && density.z >= black;
}

glm::dvec3 Transmission::factor(const glm::i64vec3& density) {
  if (blocks(density)) {
    return glm::dvec3(0);
  }
  const auto one = [](std::int64_t d) {
    const double halvings = static_cast<double>(d) / fixed_point_one;
    return halvings >= black_halvings ? 0.0 : std::exp2(-halvings);
  };
  return {one(density.x), one(density.y), one(density.z)};
}

}  // namespace scenefile
