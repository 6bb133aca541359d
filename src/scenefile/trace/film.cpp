#include "scenefile/trace/film.h"

#include "scenefile/trace/adaptive_sampler.h"
#include "scenefile/trace/camera_rays.h"
#include "scenefile/trace/layer_buffers.h"
#include "scenefile/trace/tile_flags.h"

#include <algorithm>
#include <utility>

namespace scenefile {

namespace {

bool has_two_passes(const RenderScene& scene, const RenderOptions& options) {
  return options.profile == Profile::fine &&
         sample_plan(options, noise_source(scene, options)).two_passes;
}

// Whether the picture will be denoised.
bool will_denoise(const RenderScene& scene, const RenderOptions& options) {
  return options.denoise && options.profile == Profile::fine &&
         noise_source(scene, options) != NoiseSource::none;
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
              Image canvas, Film& film) {
  const bool two_passes = has_two_passes(scene, options);
  film.profile = options.profile;
  film.region =
      empty(film.own) ? PixelRegion{} : overlap(grown(film.own, two_passes ? 1 : 0), most);
  const int width = film.region.width();
  const int height = film.region.height();
  film.image =
      canvas.width == width && canvas.height == height ? std::move(canvas) : Image(width, height);
  film.layers = make_layers(options, film.region);
  film.statistics.resize(will_denoise(scene, options) ? pixels_of(film.region) : 0);
  film.sharp = noise_source(scene, options) < NoiseSource::lens;
  film.tiles = TileFlags(width, height);
  film.refinement_map.resize(two_passes ? pixels_of(film.region) : 0);
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

Film make_film(const RenderScene& scene, const RenderOptions& given, Image canvas) {
  const RenderOptions options = in_range(given);
  Film film;
  film.crop = options.crop.value_or(whole_picture(options));
  film.own = overlap(grown(film.crop, options.denoise ? denoise_reach : 0), whole_picture(options));
  allocate(scene, options, whole_picture(options), std::move(canvas), film);
  return film;
}

int margin_of(const RenderScene& scene, const RenderOptions& given) {
  const RenderOptions options = in_range(given);
  return (options.denoise ? denoise_reach : 0) + (has_two_passes(scene, options) ? 1 : 0);
}

bool complete(const Film& film) {
  return (film.refinement_map.empty() || film.pass == 1) && film.tiles.all_done();
}

Resolved resolve(Film film) {
  if (!film.statistics.empty() && complete(film)) {
    const std::vector<glm::vec3> colors =
        denoised(film.region.width(), film.region.height(), film.statistics, film.sharp);
    for (std::size_t i = 0; i < colors.size(); ++i) {
      std::copy_n(&colors[i].x, 3, &film.image.rgb[3 * i]);
    }
  }
  Resolved result;
  if (film.crop == film.region) {
    result.image = std::move(film.image);
    result.layers = std::move(film.layers);
    return result;
  }
  result.image = cut(film.image, film.region, film.crop);
  for (const ImageLayer& layer : film.layers) {
    const std::size_t channels = layer.channels.size();
    ImageLayer& part =
        result.layers.emplace_back(ImageLayer{layer.name, layer.channels, layer.whole, {}});
    part.values.resize(channels * pixels_of(film.crop));
    copy_rows(layer.values, film.region, channels, film.crop, part.values);
  }
  return result;
}

void copy_done(const Film& film, Image& image) {
  for (int y = 0; y < film.region.height(); ++y) {
    for (int x = 0; x < film.region.width(); ++x) {
      if (film.tiles.done(film.tiles.at(x, y))) {
        std::copy_n(film.image.pixel(x, y), 3, image.pixel(x, y));
      }
    }
  }
}

}  // namespace scenefile
