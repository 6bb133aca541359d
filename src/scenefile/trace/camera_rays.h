#pragma once

#include "scenefile/geometry/shapes.h"
#include "scenefile/scene/render_scene.h"

#include <glm/glm.hpp>

namespace scenefile {

/// From points of the picture to rays.
class CameraRays {
 public:
  CameraRays(const RenderCamera& camera, int width, int height);

  /// `pixel`: x to the right and y down in pixels, pixel (0, 0) reaches from 0 to 1. `lens`: where
  /// the ray leaves the lens, in apertures along u and v; pinholes ignore it. Unit direction.
  Ray ray(const glm::dvec2& pixel, const glm::dvec2& lens) const;

  bool has_lens() const { return has_lens_; }
  /// Width of a pixel at unit distance.
  double pixel_spread() const { return 2 * half_height_ / height_; }

 private:
  RenderCamera camera_;
  double width_;
  double height_;
  double half_height_;  // of the picture, at unit distance
  bool has_lens_;
};

}  // namespace scenefile
