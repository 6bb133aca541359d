#include "scenefile/trace/picture_state.h"

#include "scenefile/trace/camera_rays.h"
#include "scenefile/trace/fine_samples.h"
#include "scenefile/trace/layer_buffers.h"
#include "scenefile/trace/pieces.h"

#include <algorithm>
#include <utility>

namespace scenefile {

namespace {

bool has_two_passes(const RenderScene& scene, const RenderOptions& options) {
  return options.profile == Profile::fine &&
         sample_plan(options, softness(scene, options)).two_passes;
}

// Whether the picture will be denoised.
bool will_denoise(const RenderScene& scene, const RenderOptions& options) {
  return options.denoise && options.profile == Profile::fine &&
         softness(scene, options) != Softness::none;
}

PixelRegion overlap(const PixelRegion& a, const PixelRegion& b) {
  return {std::max(a.x0, b.x0), std::max(a.y0, b.y0), std::min(a.x1, b.x1), std::min(a.y1, b.y1)};
}

PixelRegion grown(const PixelRegion& region, int by) {
  return {region.x0 - by, region.y0 - by, region.x1 + by, region.y1 + by};
}

std::size_t pixels_of(const PixelRegion& region) {
  return std::size_t(region.width()) * region.height();
}

// Sets everything that follows from the crop and the own pixels.
void allocate(const RenderScene& scene, const RenderOptions& options, const PixelRegion& most,
              Image canvas, PictureState& state) {
  const bool two_passes = has_two_passes(scene, options);
  state.profile = options.profile;
  state.region =
      empty(state.own) ? PixelRegion{} : overlap(grown(state.own, two_passes ? 1 : 0), most);
  const int width = state.region.width();
  const int height = state.region.height();
  state.image =
      canvas.width == width && canvas.height == height ? std::move(canvas) : Image(width, height);
  state.layers = make_layers(options, state.region);
  state.statistics.resize(will_denoise(scene, options) ? pixels_of(state.region) : 0);
  state.sharp = softness(scene, options) < Softness::lens;
  state.pieces = Pieces(width, height);
  state.marked.resize(two_passes ? pixels_of(state.region) : 0);
}

PixelRegion whole_picture(const RenderOptions& options) {
  return {0, 0, options.width, options.height};
}

std::size_t index_in(const PixelRegion& region, int x, int y) {
  return std::size_t(y - region.y0) * region.width() + (x - region.x0);
}

// Copies the pixels of `own`, a part of `from_region`.
template <typename T>
void copy_rows(const std::vector<T>& from, const PixelRegion& from_region, std::size_t per_pixel,
               const PixelRegion& own, std::vector<T>& to) {
  for (int y = own.y0; y < own.y1; ++y) {
    std::copy_n(from.data() + per_pixel * index_in(from_region, own.x0, y),
                per_pixel * static_cast<std::size_t>(own.width()),
                to.data() + per_pixel * index_in(own, own.x0, y));
  }
}

}  // namespace

Image cut(const Image& image, const PixelRegion& region, const PixelRegion& crop) {
  Image part(crop.width(), crop.height());
  copy_rows(image.rgb, region, 3, crop, part.rgb);
  return part;
}

PictureState make_state(const RenderScene& scene, const RenderOptions& given, Image canvas) {
  const RenderOptions options = in_range(given);
  PictureState state;
  state.crop = options.crop.value_or(whole_picture(options));
  state.own =
      overlap(grown(state.crop, options.denoise ? denoise_reach : 0), whole_picture(options));
  allocate(scene, options, whole_picture(options), std::move(canvas), state);
  return state;
}

int margin_of(const RenderScene& scene, const RenderOptions& given) {
  const RenderOptions options = in_range(given);
  return (options.denoise ? denoise_reach : 0) + (has_two_passes(scene, options) ? 1 : 0);
}

bool complete(const PictureState& state) {
  return (state.marked.empty() || state.pass == 1) && state.pieces.all_done();
}

Resolved resolve(PictureState state) {
  if (!state.statistics.empty() && complete(state)) {
    const std::vector<glm::vec3> colors =
        denoised(state.region.width(), state.region.height(), state.statistics, state.sharp);
    for (std::size_t i = 0; i < colors.size(); ++i) {
      std::copy_n(&colors[i].x, 3, &state.image.rgb[3 * i]);
    }
  }
  Resolved result;
  if (state.crop == state.region) {
    result.image = std::move(state.image);
    result.layers = std::move(state.layers);
    return result;
  }
  result.image = cut(state.image, state.region, state.crop);
  for (const ImageLayer& layer : state.layers) {
    const std::size_t channels = layer.channels.size();
    ImageLayer& part =
        result.layers.emplace_back(ImageLayer{layer.name, layer.channels, layer.whole, {}});
    part.values.resize(channels * pixels_of(state.crop));
    copy_rows(layer.values, state.region, channels, state.crop, part.values);
  }
  return result;
}

void copy_done(const PictureState& state, Image& image) {
  for (int y = 0; y < state.region.height(); ++y) {
    for (int x = 0; x < state.region.width(); ++x) {
      if (state.pieces.done(state.pieces.at(x, y))) {
        std::copy_n(state.image.pixel(x, y), 3, image.pixel(x, y));
      }
    }
  }
}

}  // namespace scenefile
