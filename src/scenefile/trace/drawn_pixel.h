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
  std::uint32_t signature = 0;  ///< of the last of them, where waves took them
  PixelSurfaces surfaces;       ///< where they are wished for
};

/// What is to be told of the surfaces that camera rays meet.
struct SurfaceWish {
  bool wanted = false;
  std::vector<std::uint32_t> lights;  ///< whose light is to be kept apart, into RenderScene::lights
};

inline std::vector<DrawnPixel> pixels_at(std::span<const glm::ivec2> places) {
  std::vector<DrawnPixel> pixels(places.size());
  for (std::size_t i = 0; i < places.size(); ++i) {
    pixels[i].at = places[i];
  }
  return pixels;
}

}  // namespace scenefile
