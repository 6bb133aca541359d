#pragma once

#include <glm/glm.hpp>

#include <cstdint>

namespace scenefile {

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
