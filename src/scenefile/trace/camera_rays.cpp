#include "scenefile/trace/camera_rays.h"

#include "scenefile/base/one_lane.h"
#include "scenefile/base/vector-inl.h"
#include "scenefile/trace/camera-inl.h"

#include <cmath>

namespace scenefile {

CameraRays::CameraRays(const RenderCamera& camera, int width, int height)
    : frame_{camera.position,
             camera.u,
             camera.v,
             camera.w,
             double(width) / 2,
             double(height) / 2,
             2 * std::tan(camera.fov_y / 2) / double(height),
             camera.aperture,
             camera.focal_length} {}

Ray CameraRays::ray(const glm::dvec2& pixel, const glm::dvec2& lens) const {
  const auto [origin, direction] = one::camera_ray(frame_, pixel.x, pixel.y, lens.x, lens.y);
  return {{origin.x, origin.y, origin.z}, {direction.x, direction.y, direction.z}};
}

}  // namespace scenefile
