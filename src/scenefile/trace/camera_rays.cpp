#include "scenefile/trace/camera_rays.h"

#include "scenefile/base/one_lane.h"
#include "scenefile/base/vector-inl.h"
#include "scenefile/trace/camera-inl.h"

#include <cmath>

namespace scenefile {

CameraRays::CameraRays(const RenderCamera& camera, int width, int height)
    : pinhole_{camera.position,
               camera.u,
               camera.v,
               camera.w,
               double(width) / 2,
               double(height) / 2,
               2 * std::tan(camera.fov_y / 2) / double(height)},
      aperture_(camera.aperture),
      focal_length_(camera.focal_length) {}

Ray CameraRays::ray(const glm::dvec2& pixel, const glm::dvec2& lens) const {
  const one::V3 f = one::pinhole_forward(pinhole_, pixel.x, pixel.y);
  const glm::dvec3 forward(f.x, f.y, f.z);
  if (!has_lens()) {
    return {pinhole_.position, glm::normalize(forward)};
  }
  const glm::dvec3 offset = aperture_ * (lens.x * pinhole_.u + lens.y * pinhole_.v);
  return {pinhole_.position + offset, glm::normalize(focal_length_ * forward - offset)};
}

}  // namespace scenefile
