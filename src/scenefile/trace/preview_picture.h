#pragma once
// The picture on the way, as Preview wants it.

#include "scenefile/trace/camera_rays.h"
#include "scenefile/trace/picture_state.h"
#include "scenefile/trace/tracer.h"

#include <chrono>

namespace scenefile {

/// The crop of an image that holds the region.
Image cut(const Image& image, const PixelRegion& region, const PixelRegion& crop);

/// Used by one thread at a time.
class PreviewPicture {
 public:
  /// All must outlive it.
  PreviewPicture(const Preview& preview, const PictureState& picture, const PixelRegion& region,
                 const PixelRegion& crop);

  /// Nothing else may be called where nobody looks.
  bool wanted() const { return preview_.show != nullptr; }
  /// One ray for each block of pixels, before the first pass.
  void start(const Tracer& tracer, const CameraRays& camera);
  /// Takes over what is done in this pass; at its end everything.
  void update();
  /// Shows the picture when it is time.
  void show_in_time();

 private:
  void fill(int x0, int y0, const Color& color);
  void show();

  const Preview& preview_;
  const PictureState& picture_;
  PixelRegion region_;
  PixelRegion crop_;
  Image shown_;
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

}  // namespace scenefile
