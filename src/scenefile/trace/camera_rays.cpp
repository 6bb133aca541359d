#include "scenefile/trace/camera_rays.h"

#include <cmath>

namespace scenefile {

CameraRays::CameraRays(const RenderCamera& camera, int width, int height)
    : camera_(camera),
      width_(width),
      height_(height),
      half_height_(std::tan(camera.fov_y / 2)),
      has_lens_(camera.aperture > 0 && camera.focal_length > 0) {}

Ray CameraRays::ray(const glm::dvec2& pixel, const glm::dvec2& lens) const {
  // Counted in pixels from the middle, so that opposite and diagonal pixels get exactly mirrored
  // rays.
  const double x = (pixel.x - width_ / 2) * pixel_spread();
  const double y = (height_ / 2 - pixel.y) * pixel_spread();
  const glm::dvec3 forward = x * camera_.u + y * camera_.v - camera_.w;
  if (!has_lens_) {
    return {camera_.position, glm::normalize(forward)};
  }
  const glm::dvec3 offset = camera_.aperture * (lens.x * camera_.u + lens.y * camera_.v);
  return {camera_.position + offset, glm::normalize(camera_.focal_length * forward - offset)};
}

}  // namespace scenefile
