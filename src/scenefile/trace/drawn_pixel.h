#pragma once
// A pixel with its samples.

#include "scenefile/trace/fine_samples.h"
#include "scenefile/trace/surface_sample.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace scenefile {

struct DrawnPixel {
  glm::ivec2 at{0};
  Color color{0};               ///< of the course profile
  PixelSamples samples;         ///< of the fine profile
  std::uint32_t signature = 0;  ///< of the last sample; only set by waves
  PixelSurfaces surfaces;       ///< if requested
};

/// Which surface data of camera rays to record.
struct SurfaceWish {
  bool wanted = false;
  std::vector<std::uint32_t> lights;  ///< lights to record separately, into RenderScene::lights
  bool centers = false;               ///< also the surface at the center of each pixel
};

inline std::vector<DrawnPixel> pixels_at(std::span<const glm::ivec2> places) {
  std::vector<DrawnPixel> pixels(places.size());
  for (std::size_t i = 0; i < places.size(); ++i) {
    pixels[i].at = places[i];
  }
  return pixels;
}

}  // namespace scenefile
