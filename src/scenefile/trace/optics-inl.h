// Mirrored and refracted directions, for any number of lanes (base/one_lane.h); see optics.h.
// No guard: included once for each number of lanes.

namespace scenefile::SCENEFILE_LANES {

inline V3 mirrored(const V3& direction, const V3& normal) {
  return direction - splat(2) * dot(direction, normal) * normal;
}

struct Refracted {
  M through;  ///< no total internal reflection
  V3 direction;
};

inline Refracted refraction(const V3& direction, const V3& normal, F eta) {
  const F cosine = -dot(direction, normal);
  const F squared = splat(1) - eta * eta * (splat(1) - cosine * cosine);
  const M through = squared >= splat(0);
  return {through, normalize(eta * direction + (eta * cosine - root(squared)) * normal)};
}

}  // namespace scenefile::SCENEFILE_LANES
