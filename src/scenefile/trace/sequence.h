#pragma once
// Well-distributed points that only depend on their indices.

#include <glm/glm.hpp>

#include <cstdint>

namespace scenefile {

/// A hash of two numbers.
std::uint32_t mixed_bits(std::uint32_t a, std::uint32_t b);

/// Point `index` of the pattern, in [0, 1)^2: the first two Sobol dimensions with Owen scrambling
/// (Burley, "Practical Hash-based Owen Scrambling", 2020). The first 2^n points of a pattern have
/// one point in each cell of every grid of 2^n equal boxes.
glm::dvec2 stratified_2d(std::uint32_t index, std::uint32_t pattern);

/// Maps the unit square to the unit disk, preserving relative areas and neighborhoods (Shirley and
/// Chiu, 1997).
glm::dvec2 disk_of_square(const glm::dvec2& p);

}  // namespace scenefile
