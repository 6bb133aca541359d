#pragma once
// Well-distributed points that only depend on their indices.

#include <glm/glm.hpp>

#include <cmath>
#include <cstdint>
#include <numbers>

namespace scenefile {

/// A hash of two numbers.
inline std::uint32_t mixed_bits(std::uint32_t a, std::uint32_t b) {
  // The finalizer of splitmix64 (Steele, Lea, Flood 2014).
  std::uint64_t x = (std::uint64_t{a} << 32 | b) + 0x9e3779b97f4a7c15ull;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ull;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebull;
  return static_cast<std::uint32_t>(x ^ (x >> 31));
}

/// The seeds of a pattern: of the order of its points, and of their coordinates.
struct PatternSeeds {
  std::uint32_t order = 0;
  std::uint32_t first = 0;
  std::uint32_t second = 0;
};

inline PatternSeeds seeds_of(std::uint32_t pattern) {
  return {mixed_bits(pattern, 0), mixed_bits(pattern, 1), mixed_bits(pattern, 2)};
}

inline std::uint32_t reversed_bits(std::uint32_t x) {
  x = ((x >> 1) & 0x55555555u) | ((x & 0x55555555u) << 1);
  x = ((x >> 2) & 0x33333333u) | ((x & 0x33333333u) << 2);
  x = ((x >> 4) & 0x0f0f0f0fu) | ((x & 0x0f0f0f0fu) << 4);
  x = ((x >> 8) & 0x00ff00ffu) | ((x & 0x00ff00ffu) << 8);
  return (x >> 16) | (x << 16);
}

/// For a number with reversed bits: randomly permutes the halves, quarters, eighths ... of the
/// range (Laine and Karras).
inline std::uint32_t scrambled_reversed(std::uint32_t x, std::uint32_t seed) {
  x += seed;
  x ^= x * 0x6c50b47cu;
  x ^= x * 0xb82f1e52u;
  x ^= x * 0xc7afe638u;
  x ^= x * 0x8d22f6e6u;
  return x;
}

/// The second Sobol dimension of an index, with reversed bits: bit k is the sum of the bits of the
/// index whose numbers contain the bits of k (binomial coefficients modulo 2).
inline std::uint32_t sobol_second_reversed(std::uint32_t x) {
  x ^= (x & 0xaaaaaaaau) >> 1;
  x ^= (x & 0xccccccccu) >> 2;
  x ^= (x & 0xf0f0f0f0u) >> 4;
  x ^= (x & 0xff00ff00u) >> 8;
  return x ^ (x >> 16);
}

/// Coordinates in units of 2^-32.
struct PatternPoint {
  std::uint32_t x, y;
};

/// Point `index` of a pattern: the first two Sobol dimensions with Owen scrambling (Burley,
/// "Practical Hash-based Owen Scrambling", 2020). The first 2^n points of a pattern have one point
/// in each cell of every grid of 2^n equal boxes. Without branches, for loops over lanes.
inline PatternPoint pattern_point(std::uint32_t index, const PatternSeeds& seeds) {
  const std::uint32_t shuffled =
      reversed_bits(scrambled_reversed(reversed_bits(index), seeds.order));
  return {reversed_bits(scrambled_reversed(shuffled, seeds.first)),
          reversed_bits(scrambled_reversed(sobol_second_reversed(shuffled), seeds.second))};
}

inline constexpr double pattern_unit = 1.0 / 4294967296.0;

/// In [0, 1)^2.
inline glm::dvec2 in_unit_square(const PatternPoint& point) {
  return {point.x * pattern_unit, point.y * pattern_unit};
}

inline glm::dvec2 stratified_2d(std::uint32_t index, std::uint32_t pattern) {
  return in_unit_square(pattern_point(index, seeds_of(pattern)));
}

/// Maps the unit square to the unit disk, preserving relative areas and neighborhoods (Shirley and
/// Chiu, 1997).
inline glm::dvec2 disk_of_square(const glm::dvec2& p) {
  constexpr double pi = std::numbers::pi;
  const glm::dvec2 s = 2.0 * p - 1.0;
  if (s.x == 0 && s.y == 0) {
    return {0, 0};
  }
  const bool wide = std::abs(s.x) > std::abs(s.y);
  const double radius = wide ? s.x : s.y;
  const double angle = wide ? pi / 4 * (s.y / s.x) : pi / 2 - pi / 4 * (s.x / s.y);
  return radius * glm::dvec2(std::cos(angle), std::sin(angle));
}

}  // namespace scenefile
