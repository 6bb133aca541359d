#include "scenefile/trace/preview_picture.h"

#include "scenefile/trace/integrator.h"
#include "scenefile/trace/tiles.h"

#include <algorithm>

namespace scenefile {

namespace {

using Clock = std::chrono::steady_clock;

constexpr int block = 8;

}  // namespace

PreviewPicture::PreviewPicture(const Preview& preview, const PictureState& picture)
    : preview_(preview), picture_(picture) {
  if (wanted()) {
    shown_ = Image(picture.region.width(), picture.region.height());
  }
}

void PreviewPicture::start(const Tracer& tracer) {
  const CameraRays camera = tracer.camera();
  for_each_line((shown_.height + block - 1) / block, [&](int row) {
    for (int x = 0; x < shown_.width; x += block) {
      const glm::dvec2 corner(picture_.region.x0 + x, picture_.region.y0 + row * block);
      RayCounts counts;
      fill(x, row * block,
           trace_sample(tracer, camera, {corner + block / 2.0, {}, block, {}}, counts));
    }
  });
  show();
}

void PreviewPicture::show_in_time() {
  const std::chrono::duration<double> since = Clock::now() - last_;
  if (since.count() >= preview_.interval_seconds) {
    update();
    show();
  }
}

void PreviewPicture::fill(int x0, int y0, const Color& color) {
  for (int y = y0; y < std::min(y0 + block, shown_.height); ++y) {
    for (int x = x0; x < std::min(x0 + block, shown_.width); ++x) {
      for (int c = 0; c < 3; ++c) {
        shown_.pixel(x, y)[c] = static_cast<float>(color[c]);
      }
    }
  }
}

void PreviewPicture::show() {
  preview_.show(cut(shown_, picture_.region, picture_.crop));
  last_ = Clock::now();
}

}  // namespace scenefile
