// Normals and texture coordinates of the round sides of the shapes, for any number of lanes
// (base/one_lane.h). See surface_at(). No guard: included once for each number of lanes.

#include <cmath>

namespace scenefile::SCENEFILE_LANES {

/// The direction of a point about the y axis; on the axis, that of +x.
struct Around {
  F cosine, sine;
  F distance;  ///< from the axis
};

inline Around around_axis(const V3& p) {
  const F distance = root(p.x * p.x + p.z * p.z);
  const M beside = distance > splat(0);
  return {select(beside, p.x / distance, splat(1)), select(beside, p.z / distance, splat(0)),
          distance};
}

/// At a point of the sphere, or one near it.
inline V3 sphere_normal(const V3& p, const Around& around) {
  const F size = root(around.distance * around.distance + p.y * p.y);
  const M apart = size > splat(0);
  const F up = select(apart, p.y / size, splat(0));
  const F out = select(apart, around.distance / size, splat(1));
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

/// The u of round sides; the lanes of the mask.
inline F around_u(const Around& around, M wanted) {
  const F turn = splat(2 * 3.14159265358979323846);
  const auto angle = [](double sine, double cosine) { return std::atan2(sine, cosine); };
  const F phi = each(wanted, angle, around.sine, around.cosine);
  return select(phi < splat(0), -phi / turn, splat(1) - phi / turn);
}

/// The v of the sphere; the lanes of the mask.
inline F sphere_v(F height, const Around& around, M wanted) {
  const auto angle = [](double y, double distance) { return std::atan2(y, distance); };
  const F latitude = each(wanted, angle, height, around.distance);
  return within(latitude / splat(3.14159265358979323846) + splat(0.5), 0, 1);
}

}  // namespace scenefile::SCENEFILE_LANES
