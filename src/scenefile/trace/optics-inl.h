// Reflected and refracted directions for any number of lanes (base/one_lane.h); see optics.h. No
// include guard: included once for each number of lanes.

namespace scenefile::SCENEFILE_LANES {

inline V3 mirrored(const V3& direction, const V3& normal) {
  return direction - splat(2) * dot(direction, normal) * normal;
}

/// Start of secondary rays in the course profile: the smallest t of their hits.
inline constexpr double course_offset = 1e-3;

/// The same for the fine profile: hits are accurate to about 1e-15 of the numbers involved.
/// `point`: start of the new ray; `distance`: length of the previous ray.
inline F fine_offset(const V3& point, F distance) {
  const F size = max(max(abs(point.x), abs(point.y)), abs(point.z));
  return splat(1e-9) * (size + distance);
}

struct Refracted {
  M through;  ///< false: total internal reflection
  V3 direction;
};

inline Refracted refraction(const V3& direction, const V3& normal, F eta) {
  const F cosine = -dot(direction, normal);
  const F squared = splat(1) - eta * eta * (splat(1) - cosine * cosine);
  const M through = squared >= splat(0);
  return {through, normalize(eta * direction + (eta * cosine - sqrt(squared)) * normal)};
}

}  // namespace scenefile::SCENEFILE_LANES
