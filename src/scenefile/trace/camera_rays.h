#pragma once

#include "scenefile/geometry/shapes.h"
#include "scenefile/scene/render_scene.h"

#include <glm/glm.hpp>

#include <cstdint>

namespace scenefile {

/// The parameters of a camera.
struct CameraFrame {
  glm::dvec3 position{0};
  glm::dvec3 u{1, 0, 0};  ///< to the right, unit length
  glm::dvec3 v{0, 1, 0};  ///< up
  glm::dvec3 w{0, 0, 1};  ///< opposite to the view direction
  double center_x = 0;    ///< center of the picture, pixels
  double center_y = 0;
  double pixel = 1;  ///< width of a pixel at unit distance
  double aperture = 0;
  double focal_length = 0;

  bool has_lens() const { return aperture > 0 && focal_length > 0; }
};

/// Maps points of the picture to rays.
class CameraRays {
 public:
  CameraRays(const RenderCamera& camera, int width, int height);

  /// `pixel`: x to the right and y down, in pixels; pixel (0, 0) extends from 0 to 1. `lens`: point
  /// on the lens, in apertures along u and v; ignored by pinholes. The direction has unit length.
  Ray ray(const glm::dvec2& pixel, const glm::dvec2& lens) const;

  bool has_lens() const { return frame_.has_lens(); }
  /// The width of a pixel at unit distance.
  double pixel_spread() const { return frame_.pixel; }
  const CameraFrame& frame() const { return frame_; }

 private:
  CameraFrame frame_;
};

/// Selects the random numbers of a ray; equal keys give equal pictures.
struct SampleKey {
  std::uint32_t sample = 0;         ///< of the pixel, from 0
  std::uint32_t pattern = 0;        ///< different for each pixel and each reflection
  std::uint32_t light_samples = 1;  ///< points on each area light (fine profile)
  int texture_grid = 1;             ///< 2: a lookup in each quarter of a footprint (fine)
};

/// A sample position in the picture, in the units of CameraRays::ray().
struct CameraSample {
  glm::dvec2 point{0};
  glm::dvec2 lens{0};
  double width = 0;  ///< of the area that the sample represents, in pixels; for texture filtering
  SampleKey key;
};

}  // namespace scenefile
