// Rays in lanes. No include guard: included once for each instruction set, after wide-inl.h.

#include "scenefile/trace/wavefront_memory.h"

namespace scenefile::SCENEFILE_LANES {

inline V3 load3(const VectorArrays& v, int at) {
  return {load(v.x + at), load(v.y + at), load(v.z + at)};
}

inline void store3(const V3& v, VectorArrays& to, int at) {
  store(v.x, to.x + at);
  store(v.y, to.y + at);
  store(v.z, to.z + at);
}

inline Derivatives load_derivatives(const DerivativeArrays& from, int at) {
  return {load3(from.dx, at), load3(from.dy, at)};
}

inline void store_derivatives(const Derivatives& derivatives, DerivativeArrays& to, int at) {
  store3(derivatives.dx, to.dx, at);
  store3(derivatives.dy, to.dy, at);
}

inline void put(const Color& color, VectorArrays& to, int at) {
  to.x[at] = color.x;
  to.y[at] = color.y;
  to.z[at] = color.z;
}

inline Color get(const VectorArrays& from, int at) {
  return {from.x[at], from.y[at], from.z[at]};
}

inline Color color_of(const double (&v)[3]) {
  return {v[0], v[1], v[2]};
}

/// The same row in all lanes.
inline V3 splat_row(const double (&v)[3]) {
  return {splat(v[0]), splat(v[1]), splat(v[2])};
}

inline void store_rows(const V3& v, double (&to)[3][lanes]) {
  store(v.x, to[0]);
  store(v.y, to[1]);
  store(v.z, to[2]);
}

inline glm::dvec3 lane_of(const double (&rows)[3][lanes], int lane) {
  return {rows[0][lane], rows[1][lane], rows[2][lane]};
}

/// A ray in each lane.
struct Rays {
  V3 origin, direction;
};

inline M finite_rays(const Rays& rays) {
  const V3 sum = rays.origin + rays.direction;
  return finite(sum.x + sum.y + sum.z);
}

/// The valid lanes in the chunk at `at` of `count` elements.
inline M present_lanes(int at, int count) {
  return first_lanes(static_cast<std::size_t>(std::clamp(count - at, 0, lanes)));
}

}  // namespace scenefile::SCENEFILE_LANES
