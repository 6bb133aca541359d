#include "scenefile/trace/sequence.h"

#include <cmath>

namespace scenefile {

namespace {

constexpr double pi = 3.14159265358979323846;

std::uint32_t reversed_bits(std::uint32_t x) {
  x = ((x >> 1) & 0x55555555u) | ((x & 0x55555555u) << 1);
  x = ((x >> 2) & 0x33333333u) | ((x & 0x33333333u) << 2);
  x = ((x >> 4) & 0x0f0f0f0fu) | ((x & 0x0f0f0f0fu) << 4);
  x = ((x >> 8) & 0x00ff00ffu) | ((x & 0x00ff00ffu) << 8);
  return (x >> 16) | (x << 16);
}

// Randomly permutes the halves, quarters, eighths ... of the range (Laine and Karras).
std::uint32_t owen_scrambled(std::uint32_t x, std::uint32_t seed) {
  x = reversed_bits(x);
  x += seed;
  x ^= x * 0x6c50b47cu;
  x ^= x * 0xb82f1e52u;
  x ^= x * 0xc7afe638u;
  x ^= x * 0x8d22f6e6u;
  return reversed_bits(x);
}

std::uint32_t sobol_second(std::uint32_t index) {
  std::uint32_t result = 0;
  for (std::uint32_t v = 1u << 31; index != 0; index >>= 1, v ^= v >> 1) {
    if ((index & 1) != 0) {
      result ^= v;
    }
  }
  return result;
}

double unit(std::uint32_t x) {
  return x * (1.0 / 4294967296.0);
}

}  // namespace

std::uint32_t mixed_bits(std::uint32_t a, std::uint32_t b) {
  // The finalizer of splitmix64 (Steele, Lea, Flood 2014).
  std::uint64_t x = (std::uint64_t{a} << 32 | b) + 0x9e3779b97f4a7c15ull;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ull;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebull;
  return static_cast<std::uint32_t>(x ^ (x >> 31));
}

glm::dvec2 stratified_2d(std::uint32_t index, std::uint32_t pattern) {
  const std::uint32_t shuffled = owen_scrambled(index, mixed_bits(pattern, 0));
  return {unit(owen_scrambled(reversed_bits(shuffled), mixed_bits(pattern, 1))),
          unit(owen_scrambled(sobol_second(shuffled), mixed_bits(pattern, 2)))};
}

glm::dvec2 disk_of_square(const glm::dvec2& p) {
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
