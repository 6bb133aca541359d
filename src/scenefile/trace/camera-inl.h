// Camera rays for any number of lanes (base/one_lane.h). No include guard: included once for each
// number of lanes.

#include "scenefile/trace/camera_rays.h"

namespace scenefile::SCENEFILE_LANES {

struct CameraRay {
  V3 origin, direction;
};

// The direction through (x, y) of the picture, in pixels; not normalized. Computed from the center,
// so that opposite pixels get exactly mirrored rays.
inline V3 pinhole_forward(const CameraFrame& camera, F x, F y) {
  const F right = (x - splat(camera.center_x)) * splat(camera.pixel);
  const F up = (splat(camera.center_y) - y) * splat(camera.pixel);
  return right * splat3(camera.u) + up * splat3(camera.v) - splat3(camera.w);
}

/// See CameraRays::ray().
inline CameraRay camera_ray(const CameraFrame& camera, F x, F y, F lens_x, F lens_y) {
  const V3 forward = pinhole_forward(camera, x, y);
  const V3 position = splat3(camera.position);
  if (!camera.has_lens()) {
    return {position, normalize(forward)};
  }
  const V3 offset =
      splat(camera.aperture) * (lens_x * splat3(camera.u) + lens_y * splat3(camera.v));
  return {position + offset, normalize(splat(camera.focal_length) * forward - offset)};
}

}  // namespace scenefile::SCENEFILE_LANES
