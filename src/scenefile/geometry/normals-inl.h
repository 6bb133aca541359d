// Normals and texture coordinates on the round sides of the shapes, for any number of lanes
// (base/one_lane.h). See surface_at(). No include guard: included once for each number of lanes.

#include <cmath>
#include <iterator>
#include <numbers>

namespace scenefile::SCENEFILE_LANES {

/// The direction of a point around the y axis; +x for a point on the axis.
struct Around {
  F cosine, sine;
  F distance;  ///< from the axis
};

inline Around around_axis(const V3& p) {
  const F distance = sqrt(p.x * p.x + p.z * p.z);
  const M beside = distance > splat(0);
  return {select(beside, p.x / distance, splat(1)), select(beside, p.z / distance, splat(0)),
          distance};
}

/// For a point on the sphere or near it.
inline V3 sphere_normal(const V3& p, const Around& around) {
  const F size = sqrt(around.distance * around.distance + p.y * p.y);
  const M nonzero = size > splat(0);
  const F up = select(nonzero, p.y / size, splat(0));
  const F out = select(nonzero, around.distance / size, splat(1));
  return {out * around.cosine, up, out * around.sine};
}

inline V3 cylinder_normal(const Around& around) {
  return {around.cosine, splat(0), around.sine};
}

inline V3 cone_normal(const Around& around) {
  const F size = splat(std::sqrt(5.0));
  const M beside = around.distance > splat(0);
  return select(beside,
                V3{splat(2) * around.cosine / size, splat(1) / size, splat(2) * around.sine / size},
                V3{splat(0), splat(1), splat(0)});
}

/// std::atan2(y, x) for finite numbers, to 2 units in the last place; 0 if both are 0. The rational
/// approximation is that of atan() in Cephes (Moshier, 1989).
inline F angle_of(F y, F x) {
  constexpr double half_turn = std::numbers::pi;
  const F longer = max(abs(x), abs(y));
  const F shorter = min(abs(x), abs(y));
  const M steep = shorter > splat(0.66) * longer;
  const F over = select(steep, shorter - longer, shorter);
  const F under = select(steep, shorter + longer, longer);
  const F t = over / select(under > splat(0), under, splat(1));
  const F z = t * t;
  constexpr double above[] = {-8.750608600031904122785e-1, -1.615753718733365076637e1,
                              -7.500855792314704667340e1, -1.228866684490136173410e2,
                              -6.485021904942025371773e1};
  constexpr double below[] = {1,
                              2.485846490142306297962e1,
                              1.650270098316988542046e2,
                              4.328810604912902668951e2,
                              4.853903996359136964868e2,
                              1.945506571482613964425e2};
  const auto polynomial = [&](const auto& factors) {
    F sum = splat(factors[0]);
    for (std::size_t i = 1; i < std::size(factors); ++i) {
      sum = sum * z + splat(factors[i]);
    }
    return sum;
  };
  const F arc = t + t * (z * polynomial(above) / polynomial(below));
  // Adds the low-order part of pi where it matters.
  const F eighth = select(steep, splat(half_turn / 4) + (arc + splat(3.061616997868383e-17)), arc);
  const F quarter = select(abs(y) > abs(x),
                           splat(half_turn / 2) - (eighth - splat(6.123233995736766e-17)), eighth);
  const F half = select(x < splat(0), splat(half_turn) - quarter, quarter);
  return copysign(half, y);
}

/// The u coordinate on round sides.
inline F around_u(const Around& around) {
  const F turn = splat(2 * std::numbers::pi);
  const F phi = angle_of(around.sine, around.cosine);
  return select(phi < splat(0), -phi / turn, splat(1) - phi / turn);
}

/// The v coordinate on the sphere.
inline F sphere_v(F height, const Around& around) {
  const F latitude = angle_of(height, around.distance);
  return clamp(latitude / splat(std::numbers::pi) + splat(0.5), 0, 1);
}

}  // namespace scenefile::SCENEFILE_LANES
