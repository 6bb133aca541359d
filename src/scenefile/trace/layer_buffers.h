#pragma once
// Fills the layers of a picture.

#include "scenefile/trace/aov_sample.h"
#include "scenefile/trace/camera_rays.h"
#include "scenefile/trace/film.h"
#include "scenefile/trace/tracer.h"

namespace scenefile {

/// Empty layers for the options, with the pixels of the region.
std::vector<ImageLayer> make_layers(const RenderOptions& options, const PixelRegion& region);

class LayerBuffers {
 public:
  /// For the layers of tracer.options, stored in the film.
  LayerBuffers(const Tracer& tracer, const CameraRays& camera, Film& film);

  bool empty() const { return layers_.empty(); }
  /// Whether some layers show the surface at the center of each pixel (PixelAovs::center).
  bool need_centers() const;
  /// The lights that have layers, and are recorded separately.
  const std::vector<std::uint32_t>& lights() const { return lights_; }

  /// Sets the pixel (x, y) of the picture. Thread-safe for different pixels.
  void put(int x, int y, const PixelAovs& pixel);

 private:
  std::size_t index(int x, int y) const {
    return std::size_t(y - region_.y0) * region_.width() + (x - region_.x0);
  }
  void put_center(std::size_t pixel, const AovHit& center);
  void put_means(std::size_t pixel, const PixelAovs& surfaces);
  std::vector<double> weights_of(const std::vector<AovSample>& samples) const;

  const Tracer& tracer_;
  const CameraRays& camera_;
  PixelRegion region_;
  std::vector<ImageLayer>& layers_;
  std::vector<std::uint32_t> lights_;
};

}  // namespace scenefile
