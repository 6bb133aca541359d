#pragma once
// Well-spread points that are a function of their numbers alone.

#include <glm/glm.hpp>

#include <cstdint>

namespace scenefile {

/// A well-mixed number of two.
std::uint32_t mixed_bits(std::uint32_t a, std::uint32_t b);

/// Point `index` of the pattern: Sobol's first two dimensions with Owen's scrambling (Burley,
/// "Practical Hash-based Owen Scrambling", 2020). Every first 2^n points of a pattern lie one in
/// each cell of every grid of 2^n equal boxes. In [0, 1)^2.
glm::dvec2 stratified_2d(std::uint32_t index, std::uint32_t pattern);

/// The unit square to the unit disk, areas and neighbors kept (Shirley and Chiu, 1997).
glm::dvec2 disk_of_square(const glm::dvec2& p);

}  // namespace scenefile
