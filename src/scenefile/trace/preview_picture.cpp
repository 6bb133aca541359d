#include "scenefile/trace/preview_picture.h"

#include "scenefile/trace/integrator.h"
#include "scenefile/trace/tiles.h"

#include <algorithm>

namespace scenefile {

namespace {

using Clock = std::chrono::steady_clock;

constexpr int block = 8;

}  // namespace

Image cut(const Image& image, const PixelRegion& region, const PixelRegion& crop) {
  Image part(crop.width(), crop.height());
  for (int y = 0; y < crop.height(); ++y) {
    const float* const row = image.pixel(crop.x0 - region.x0, y + crop.y0 - region.y0);
    std::copy_n(row, std::size_t{3} * crop.width(), part.pixel(0, y));
  }
  return part;
}

PreviewPicture::PreviewPicture(const Preview& preview, const PictureState& picture,
                               const PixelRegion& region, const PixelRegion& crop)
    : preview_(preview), picture_(picture), region_(region), crop_(crop) {
  if (wanted()) {
    shown_ = Image(region.width(), region.height());
  }
}

void PreviewPicture::start(const Tracer& tracer, const CameraRays& camera) {
  for_each_line((region_.height() + block - 1) / block, [&](int row) {
    for (int x = 0; x < region_.width(); x += block) {
      const glm::dvec2 corner(region_.x0 + x, region_.y0 + row * block);
      const RayCone cone{0, camera.pixel_spread() * block};
      RayCounts counts;
      fill(x, row * block,
           trace_sample(tracer, camera, {corner + block / 2.0, {}, cone, {}}, counts));
    }
  });
  show();
}

void PreviewPicture::update() {
  for (int y = 0; y < region_.height(); ++y) {
    for (int x = 0; x < region_.width(); ++x) {
      if (picture_.pieces.done(picture_.pieces.at(x, y))) {
        std::copy_n(picture_.image.pixel(x, y), 3, shown_.pixel(x, y));
      }
    }
  }
}

void PreviewPicture::show_in_time() {
  const std::chrono::duration<double> since = Clock::now() - last_;
  if (since.count() >= preview_.interval_seconds) {
    update();
    show();
  }
}

void PreviewPicture::fill(int x0, int y0, const Color& color) {
  for (int y = y0; y < std::min(y0 + block, region_.height()); ++y) {
    for (int x = x0; x < std::min(x0 + block, region_.width()); ++x) {
      for (int c = 0; c < 3; ++c) {
        shown_.pixel(x, y)[c] = static_cast<float>(color[c]);
      }
    }
  }
}

void PreviewPicture::show() {
  preview_.show(cut(shown_, region_, crop_));
  last_ = Clock::now();
}

}  // namespace scenefile
