// Rays of a camera without a lens, for any number of lanes (base/one_lane.h).
// No guard: included once for each number of lanes.

#include "scenefile/trace/camera_rays.h"

namespace scenefile::SCENEFILE_LANES {

/// The direction through (x, y) of the picture, in pixels, not of unit length. Counted in pixels
/// from the middle, so that opposite and diagonal pixels get exactly mirrored rays.
inline V3 pinhole_forward(const Pinhole& camera, F x, F y) {
  const F right = (x - splat(camera.middle_x)) * splat(camera.pixel);
  const F up = (splat(camera.middle_y) - y) * splat(camera.pixel);
  return right * splat3(camera.u) + up * splat3(camera.v) - splat3(camera.w);
}

inline V3 pinhole_direction(const Pinhole& camera, F x, F y) {
  return normalize(pinhole_forward(camera, x, y));
}

}  // namespace scenefile::SCENEFILE_LANES
