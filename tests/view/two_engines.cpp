#include "view/two_engines.h"

#include "scenefile/trace/render.h"

#include <algorithm>
#include <cmath>

namespace scenefile::view_test {

namespace {

constexpr int outline_width = 2;  // pixels

RenderResult trace(const testing_support::LoadedScene& scene, int width, int height) {
  RenderOptions options = default_options(Profile::fine);
  options.features = {.shadows = false,
                      .reflect = false,
                      .refract = false,
                      .texture = true,
                      .texture_filter = false,
                      .super_sample = false,
                      .depthoffield = false};
  options.width = width;
  options.height = height;
  options.min_samples = options.samples;  // compare engines, not where the sampler stops
  options.layers = {{LayerKind::object_id, 0}};
  return render(scene.ready.scene, scene.assets, options);
}

DrawOptions same_features() {
  DrawOptions options;
  options.shadows = false;
  options.texture_filter = false;
  options.transparency = false;
  options.samples = 0;
  return options;
}

// A color for each object. Here instances of a template differ, while the tracer's layer has one
// number for all of them.
Image draw_objects(GlDevice& device, Drawing& drawing, const RenderCamera& camera, int width,
                   int height) {
  DrawOptions options = same_features();
  options.mode = DrawMode::object_id;
  options.samples = 1;
  return *draw_image(device, drawing, camera, options, width, height);
}

std::vector<bool> outlines(const std::vector<float>& numbers, const Image& objects) {
  const int width = objects.width;
  const int height = objects.height;
  const auto differ = [&](int x, int y, int other_x, int other_y) {
    return numbers[std::size_t(y) * width + x] != numbers[std::size_t(other_y) * width + other_x] ||
           !std::equal(objects.pixel(x, y), objects.pixel(x, y) + 3,
                       objects.pixel(other_x, other_y));
  };
  std::vector<bool> result(std::size_t(width) * height);
  const auto mark_around = [&](int x, int y) {
    for (int j = std::max(0, y - outline_width); j <= std::min(height - 1, y + outline_width);
         ++j) {
      for (int i = std::max(0, x - outline_width); i <= std::min(width - 1, x + outline_width);
           ++i) {
        result[std::size_t(j) * width + i] = true;
      }
    }
  };
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      if ((x + 1 < width && differ(x, y, x + 1, y)) || (y + 1 < height && differ(x, y, x, y + 1))) {
        mark_around(x, y);
      }
    }
  }
  return result;
}

// Computed from 8-bit values, as in files.
double psnr(const Texture& a, const Texture& b, const std::vector<bool>& without) {
  double squares = 0;
  std::size_t count = 0;
  for (std::size_t pixel = 0; pixel < a.rgb.size() / 3; ++pixel) {
    if (!without.empty() && without[pixel]) {
      continue;
    }
    for (std::size_t c = 3 * pixel; c < 3 * pixel + 3; ++c) {
      const double difference = double(a.rgb[c]) - double(b.rgb[c]);
      squares += difference * difference;
      ++count;
    }
  }
  return squares == 0 ? 99
                      : std::min(99.0, 10 * std::log10(255.0 * 255.0 * double(count) / squares));
}

}  // namespace

Agreement two_engines(GlDevice& device, const testing_support::LoadedScene& scene, int width,
                      int height) {
  Agreement result;
  RenderResult traced = trace(scene, width, height);
  if (traced.status != RenderStatus::complete) {
    result.error = "the tracer gives no picture";
    return result;
  }
  Diagnostics diagnostics;
  const RenderCamera& camera = scene.ready.scene.camera;
  Drawing drawing = upload(device, scene.ready.scene, scene.assets, {}, diagnostics);
  Result<Image> drawn = draw_image(device, drawing, camera, same_features(), width, height);
  if (!drawn) {
    result.error = drawn.error().text;
    return result;
  }
  result.drawn = *std::move(drawn);
  result.near_outline =
      outlines(traced.layers[0].values, draw_objects(device, drawing, camera, width, height));
  result.traced = std::move(traced.image);
  const Texture a = quantize(result.traced, Rounding::nearest);
  const Texture b = quantize(result.drawn, Rounding::nearest);
  result.whole_db = psnr(a, b, {});
  result.inside_db = psnr(a, b, result.near_outline);
  return result;
}

}  // namespace scenefile::view_test
