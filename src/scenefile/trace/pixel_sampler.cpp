#include "scenefile/trace/pixel_sampler.h"

#include "scenefile/trace/course_samples.h"

#include <algorithm>
#include <array>
#include <utility>

namespace scenefile {

namespace {

std::vector<SampledPixel*> pointers_to(std::vector<SampledPixel>& pixels) {
  std::vector<SampledPixel*> pointers;
  pointers.reserve(pixels.size());
  for (SampledPixel& pixel : pixels) {
    pointers.push_back(&pixel);
  }
  return pointers;
}

glm::dvec2 center_of(const glm::ivec2& pixel) {
  return glm::dvec2(pixel) + 0.5;
}

CameraSample center_sample(const glm::ivec2& pixel) {
  return {center_of(pixel), {}, {}, {}};
}

// The cells of the adaptive pattern for many pixels, each after the one that it refines.
struct Cell {
  std::size_t pixel = 0;
  glm::dvec2 corner{0};
  double size = 1;
  int level = 1;
  std::array<Color, 4> colors;
  std::array<std::size_t, 4> finer{};  // the cells that replace its quadrants; 0: none
};

// Adds the refined cells of a sampled cell.
void refine_cell(std::size_t index, std::vector<Cell>& cells) {
  const Cell cell = cells[index];
  for (int i = 0; i < 4 && cell.level < course::max_level; ++i) {
    if (course::uneven(cell.colors, i)) {
      cells[index].finer[static_cast<std::size_t>(i)] = cells.size();
      cells.push_back({cell.pixel,
                       course::quadrant(cell.corner, cell.size, i),
                       cell.size / 2,
                       cell.level + 1,
                       {},
                       {}});
    }
  }
}

// The colors of all cells; those of the pixels come first.
std::vector<Color> colors_of(const std::vector<Cell>& cells) {
  std::vector<Color> colors(cells.size());
  for (std::size_t c = cells.size(); c-- > 0;) {
    Color sum(0);
    for (std::size_t i = 0; i < 4; ++i) {
      const std::size_t finer = cells[c].finer[i];
      sum += finer != 0 ? colors[finer] : cells[c].colors[i];
    }
    colors[c] = sum / 4.0;
  }
  return colors;
}

// In the order in which the samples would be taken one by one.
void append_surfaces(const std::vector<Cell>& cells, std::size_t index, const PixelAovs& all,
                     std::size_t lights, PixelAovs& surfaces) {
  const auto first = static_cast<std::ptrdiff_t>(4 * index);
  surfaces.samples.insert(surfaces.samples.end(), all.samples.begin() + first,
                          all.samples.begin() + first + 4);
  const auto light = first * static_cast<std::ptrdiff_t>(lights);
  surfaces.light_colors.insert(
      surfaces.light_colors.end(), all.light_colors.begin() + light,
      all.light_colors.begin() + light + 4 * static_cast<std::ptrdiff_t>(lights));
  for (const std::size_t finer : cells[index].finer) {
    if (finer != 0) {
      append_surfaces(cells, finer, all, lights, surfaces);  // the depth is at most max_level
    }
  }
}

}  // namespace

WavefrontPointer WavefrontPool::take() {
  const std::lock_guard lock(mutex_);
  if (free_.empty()) {
    WavefrontPointer wavefront = make_wavefront();
    free_.reserve(made_ + 1);
    ++made_;
    return wavefront;
  }
  WavefrontPointer wavefront = std::move(free_.back());
  free_.pop_back();
  return wavefront;
}

void WavefrontPool::give(WavefrontPointer wavefront) noexcept {
  const std::lock_guard lock(mutex_);
  free_.push_back(std::move(wavefront));
}

PixelSampler::PixelSampler(const WavefrontScene& scene, WavefrontPool& pool,
                           const AovRequest& request, RayCounts& counts)
    : scene_(scene), pool_(pool), request_(request), counts_(counts), memory_(pool.take()) {}

PixelSampler::~PixelSampler() {
  pool_.give(std::move(memory_));
}

// Traces samples_.
void PixelSampler::trace(int count, bool recorded) {
  if (recorded) {
    surfaces_.resize(std::max(surfaces_.size(), static_cast<std::size_t>(count)));
    light_colors_.resize(surfaces_.size() * request_.lights.size());
  }
  const AovOutput aovs{surfaces_.data(), light_colors_.data(), request_.lights};
  trace_wavefront(scene_, samples_.data(), count, *memory_, results_.data(), counts_,
                  recorded ? &aovs : nullptr);
  for (int i = 0; i < count && recorded; ++i) {
    const auto k = static_cast<std::size_t>(i);
    surfaces_[k].camera = samples_[k];
    surfaces_[k].color = results_[k].color;
  }
}

// Calls keep(i, k) for `count` samples, where sample i is at index k of the current wavefront.
template <typename SampleOf, typename Keep>
void PixelSampler::trace(std::size_t count, const SampleOf& sample_of, const Keep& keep) {
  for (std::size_t first = 0; first < count; first += wavefront_samples) {
    const std::size_t size = std::min<std::size_t>(wavefront_samples, count - first);
    for (std::size_t k = 0; k < size; ++k) {
      samples_[k] = sample_of(first + k);
    }
    trace(static_cast<int>(size), request_.wanted);
    for (std::size_t k = 0; k < size; ++k) {
      keep(first + k, static_cast<int>(k));
    }
  }
}

void PixelSampler::add_surface(int index, PixelAovs& surfaces) const {
  if (request_.wanted) {
    const auto k = static_cast<std::size_t>(index);
    surfaces.samples.push_back(surfaces_[k]);
    const Color* const first = light_colors_.data() + k * request_.lights.size();
    surfaces.light_colors.insert(surfaces.light_colors.end(), first,
                                 first + request_.lights.size());
  }
}

std::span<const SampleResult> PixelSampler::center_samples(std::span<const glm::ivec2> pixels) {
  for (std::size_t k = 0; k < pixels.size(); ++k) {
    samples_[k] = center_sample(pixels[k]);
  }
  trace(static_cast<int>(pixels.size()), false);
  return {results_.data(), pixels.size()};
}

// Sets the surfaces at the centers of the pixels. Pixels without a sample there are traced by an
// additional wavefront, whose rays are not counted.
void PixelSampler::find_centers(std::vector<SampledPixel>& pixels) {
  if (!request_.centers) {
    return;
  }
  std::vector<SampledPixel*> left;
  for (SampledPixel& pixel : pixels) {
    const AovSample& first = pixel.surfaces.samples.front();
    if (first.camera.point == center_of(pixel.at) && first.camera.lens == glm::dvec2(0)) {
      pixel.surfaces.center = first;
    } else {
      left.push_back(&pixel);
    }
  }
  surfaces_.resize(std::max<std::size_t>(surfaces_.size(), wavefront_samples));
  AovOutput aovs;
  aovs.samples = surfaces_.data();
  aovs.only_surfaces = true;
  for (std::size_t first = 0; first < left.size(); first += wavefront_samples) {
    const std::size_t size = std::min<std::size_t>(wavefront_samples, left.size() - first);
    for (std::size_t k = 0; k < size; ++k) {
      samples_[k] = center_sample(left[first + k]->at);
    }
    RayCounts not_counted;
    trace_wavefront(scene_, samples_.data(), static_cast<int>(size), *memory_, results_.data(),
                    not_counted, &aovs);
    for (std::size_t k = 0; k < size; ++k) {
      left[first + k]->surfaces.center = surfaces_[k];
    }
  }
}

void PixelSampler::lens_pixels(std::vector<SampledPixel>& pixels) {
  constexpr std::size_t each = course::lens_points.size();
  trace(
      each * pixels.size(),
      [&](std::size_t i) -> CameraSample {
        const auto& [u, v] = course::lens_points[i % each];
        return {center_of(pixels[i / each].at), {u, v}, {}, {}};
      },
      [&](std::size_t i, int k) {
        SampledPixel& pixel = pixels[i / each];
        pixel.color += results_[static_cast<std::size_t>(k)].color;
        add_surface(k, pixel.surfaces);
      });
  for (SampledPixel& pixel : pixels) {
    pixel.color /= double(each);
  }
}

void PixelSampler::cell_pixels(std::vector<SampledPixel>& pixels) {
  std::vector<Cell> cells(pixels.size());
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    cells[i].pixel = i;
    cells[i].corner = glm::dvec2(pixels[i].at);
  }
  PixelAovs surfaces;  // by cell and quadrant
  for (std::size_t first = 0; first < cells.size();) {
    const std::size_t last = cells.size();
    trace(
        4 * (last - first),
        [&](std::size_t i) -> CameraSample {
          const Cell& cell = cells[first + i / 4];
          return {course::center_of_quadrant(cell.corner, cell.size, int(i % 4)), {}, {}, {}};
        },
        [&](std::size_t i, int k) {
          cells[first + i / 4].colors[i % 4] = results_[static_cast<std::size_t>(k)].color;
          add_surface(k, surfaces);
        });
    for (; first < last; ++first) {
      refine_cell(first, cells);
    }
  }
  const std::vector<Color> colors = colors_of(cells);
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    pixels[i].color = colors[i];
    if (request_.wanted) {
      append_surfaces(cells, i, surfaces, request_.lights.size(), pixels[i].surfaces);
    }
  }
}

std::vector<SampledPixel> PixelSampler::course(std::span<const glm::ivec2> places) {
  std::vector<SampledPixel> pixels = pixels_at(places);
  if (scene_.camera.has_lens()) {
    lens_pixels(pixels);
  } else if (scene_.tracer.options.features.super_sample) {
    cell_pixels(pixels);
  } else {
    trace(
        pixels.size(), [&](std::size_t i) { return center_sample(pixels[i].at); },
        [&](std::size_t i, int k) {
          pixels[i].color = results_[static_cast<std::size_t>(k)].color;
          add_surface(k, pixels[i].surfaces);
        });
  }
  find_centers(pixels);
  return pixels;
}

// Takes `count` samples of each pixel: sample_of(pixel, i) is the i-th.
template <typename SampleOf>
void PixelSampler::take(const std::vector<SampledPixel*>& pixels, std::size_t each,
                        const SampleOf& sample_of) {
  trace(
      each * pixels.size(),
      [&](std::size_t i) {
        return sample_of(*pixels[i / each], static_cast<std::uint32_t>(i % each));
      },
      [&](std::size_t i, int k) {
        SampledPixel& pixel = *pixels[i / each];
        const SampleResult& result = results_[static_cast<std::size_t>(k)];
        pixel.samples.add(result.color, result.penumbra);
        pixel.surface_hash = result.surface_hash;
        add_surface(k, pixel.surfaces);
      });
}

std::span<const SampleResult> PixelSampler::center_samples(const AdaptiveSampler& sampler,
                                                           std::span<const glm::ivec2> pixels) {
  for (std::size_t k = 0; k < pixels.size(); ++k) {
    samples_[k] = sampler.center_sample(pixels[k].x, pixels[k].y);
  }
  trace(static_cast<int>(pixels.size()), false);
  return {results_.data(), pixels.size()};
}

std::vector<SampledPixel> PixelSampler::take_center_samples(const AdaptiveSampler& sampler,
                                                            std::span<const glm::ivec2> places) {
  std::vector<SampledPixel> pixels = pixels_at(places);
  take(pointers_to(pixels), 1, [&](const SampledPixel& pixel, std::uint32_t) {
    return sampler.center_sample(pixel.at.x, pixel.at.y);
  });
  find_centers(pixels);
  return pixels;
}

std::vector<SampledPixel> PixelSampler::take(const AdaptiveSampler& sampler,
                                             std::span<const glm::ivec2> places,
                                             std::span<const std::uint16_t> refinements) {
  std::vector<SampledPixel> pixels = pixels_at(places);
  std::vector<SampledPixel*> left = pointers_to(pixels);
  for (std::uint32_t count = 0; !left.empty();) {
    const std::uint32_t next = sampler.next_count(count);
    take(left, next - count, [&](const SampledPixel& pixel, std::uint32_t i) {
      return sampler.sample(pixel.at.x, pixel.at.y, count + i);
    });
    count = next;
    std::erase_if(left, [&](const SampledPixel* pixel) {
      return sampler.enough(pixel->samples,
                            refinements[static_cast<std::size_t>(pixel - pixels.data())]);
    });
  }
  find_centers(pixels);
  return pixels;
}

}  // namespace scenefile
