#include "scenefile/path/path_layers.h"

#include "scenefile/path/lamps.h"
#include "scenefile/trace/denoise.h"
#include "scenefile/trace/layers.h"
#include "scenefile/trace/tiles.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace scenefile {

namespace {

// Light that a path adds, and what happened to it on the way to the eye.
struct PathTerm {
  Color light{0};
  std::uint32_t bounces = 0;  // reflections and refractions
  bool direct = true;         // as for direct_only: nothing, or only the last one, was rough
  bool specular = false;      // some were not
};

template <typename Visit>
void for_each_term(const PathRecord& path, const Visit& visit) {
  PathTerm term;
  bool rough = false;  // an earlier surface scattered the light
  const auto add = [&](const PathVertex& v, const Color& light) {
    term.light = (term.bounces < 2 ? 1.0 : path.clamp) * (v.throughput * light);
    visit(term);
  };
  for (const PathVertex& v : path.vertices) {
    add(v, v.emission);
    ++term.bounces;
    term.direct = !rough;
    add(v, v.light);
    term.specular = term.specular || v.next.specular();
    term.direct = !rough;
    rough = rough || !v.next.specular();
  }
}

bool holds(const Layer& layer, const PathTerm& term) {
  switch (layer.kind) {
    case LayerKind::direct:
      return term.direct;
    case LayerKind::bounce:
      return term.bounces == layer.light;
    case LayerKind::specular:
      return term.specular;
    default:
      return false;
  }
}

glm::dvec3 layer_value(const Layer& layer, const PathRecord& path) {
  if (path.vertices.empty()) {
    return glm::dvec3(0);
  }
  const PathPoint& first = path.vertices.front().point;
  if (layer.kind == LayerKind::normal) {
    return first.facing.normal;
  }
  if (layer.kind == LayerKind::albedo) {
    return first.bsdf.diffuse;
  }
  glm::dvec3 sum(0);
  for_each_term(path, [&](const PathTerm& term) {
    if (holds(layer, term)) {
      sum += term.light;
    }
  });
  return sum;
}

void add_guides(const PathRecord& path, PathGuides& guides) {
  if (path.vertices.empty()) {
    return;
  }
  const Color emission = path.vertices.front().emission;
  const Color reflected = path.light - emission;
  const PathPoint& first = path.vertices.front().point;
  const Bsdf& bsdf = first.bsdf;
  const Color albedo = bsdf.diffuse + bsdf.glossy + bsdf.mirror + bsdf.glass;
  guides.emission += emission;
  guides.squares += reflected * reflected;
  guides.normal += first.facing.normal;
  guides.albedo += albedo;
  guides.albedo_squares += glm::dot(albedo, albedo);
}

// The variance of a mean, from sums over n samples of values and their squares.
double variance_of_mean(double squares, double square_of_sum, double n) {
  return n > 1 ? std::max(0.0, squares / n - square_of_sum / (n * n)) / (n - 1) : 0;
}

PixelStatistics statistics_of(const PathState& state, std::size_t at) {
  const double n = std::max(1u, state.counts[at]);
  const PathGuides& guides = state.guides[at];
  const glm::dvec3 sum = state.sums[at] - guides.emission;
  PixelStatistics pixel;
  // Without its texture, light varies slowly. Black surfaces may be seen beside others.
  const glm::dvec3 scale = glm::max(guides.albedo / n, 1e-3);
  pixel.scale = scale;
  // A lamp in view is only noisy at its edges, where pixels around do not tell how much is covered.
  pixel.rest = guides.emission / n;
  pixel.signal = glm::min(sum / n / scale, 1e15);
  for (int c = 0; c < 3; ++c) {
    const double variance = variance_of_mean(guides.squares[c], sum[c] * sum[c], n);
    pixel.variance[c] = static_cast<float>(std::min(variance / (scale[c] * scale[c]), 1e30));
  }
  pixel.normal = guides.normal / n;
  pixel.albedo = guides.albedo / n;
  pixel.normal_variance =
      static_cast<float>(variance_of_mean(n, glm::dot(guides.normal, guides.normal), n));
  pixel.albedo_variance = static_cast<float>(
      variance_of_mean(guides.albedo_squares, glm::dot(guides.albedo, guides.albedo), n));
  return pixel;
}

// Rare bright samples would outweigh all others around them. Limits uncertain values to the third
// largest of the pixels around them, and their variances in proportion. Pixels that show nothing,
// or only black surfaces, do not count: what is beside a lamp does not make it improbable.
void limit_outliers(int width, int height, std::vector<PixelStatistics>& pixels) {
  constexpr int reach = outlier_reach;
  constexpr float errors = 3;
  const std::vector<PixelStatistics> before = pixels;
  for_each_line(height, [&](int y) {
    std::vector<float> around;
    for (int x = 0; x < width; ++x) {
      PixelStatistics& pixel = pixels[std::size_t(y) * width + x];
      for (int c = 0; c < 3; ++c) {
        around.clear();
        for (int j = std::max(0, y - reach); j <= std::min(height - 1, y + reach); ++j) {
          for (int i = std::max(0, x - reach); i <= std::min(width - 1, x + reach); ++i) {
            const PixelStatistics& other = before[std::size_t(j) * width + i];
            if ((i != x || j != y) && other.albedo != glm::vec3(0)) {
              around.push_back(other.signal[c]);
            }
          }
        }
        if (around.size() < 3) {
          continue;
        }
        std::nth_element(around.begin(), around.begin() + 2, around.end(), std::greater<>());
        const float least = pixel.signal[c] - errors * std::sqrt(pixel.variance[c]);
        const float limit = std::max(around[2], least);
        if (limit < pixel.signal[c]) {
          const float share = limit / pixel.signal[c];
          pixel.signal[c] = limit;
          pixel.variance[c] *= share * share;
        }
      }
    }
  });
}

}  // namespace

void add_layers(const PathRecord& path, const RenderOptions& options, std::size_t at,
                PathState& state) {
  for (std::size_t i = 0; i < state.layers.size(); ++i) {
    state.layers[i][at] += layer_value(options.layers[i], path);
  }
  if (!state.guides.empty()) {
    add_guides(path, state.guides[at]);
  }
}

Image denoised_image_of(const PathState& state) {
  std::vector<PixelStatistics> pixels(state.sums.size());
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    pixels[i] = statistics_of(state, i);
  }
  Image image(state.region.width(), state.region.height());
  limit_outliers(image.width, image.height, pixels);
  const std::vector<glm::vec3> colors = denoised(image.width, image.height, pixels, false, 0);
  for (std::size_t i = 0; i < colors.size(); ++i) {
    std::copy(&colors[i].x, &colors[i].x + 3, &image.rgb[3 * i]);
  }
  return image;
}

std::vector<ImageLayer> layers_of(const PathState& state, const RenderOptions& options,
                                  const PixelRegion& crop) {
  std::vector<ImageLayer> layers;
  if (options.layers.empty()) {
    return layers;
  }
  const std::vector<float> variances = variances_of(state);
  for (std::size_t i = 0; i < options.layers.size(); ++i) {
    const Layer& wanted = options.layers[i];
    ImageLayer& layer = layers.emplace_back(layer_without_values(wanted));
    for (int y = crop.y0; y < crop.y1; ++y) {
      for (int x = crop.x0; x < crop.x1; ++x) {
        const std::size_t at = std::size_t(y - state.region.y0) * state.region.width() +
                               std::size_t(x - state.region.x0);
        glm::dvec3 value = state.layers[i][at] / double(std::max(1u, state.counts[at]));
        if (wanted.kind == LayerKind::variance) {
          value.x = variances[at];
        } else if (wanted.kind == LayerKind::samples) {
          value.x = state.counts[at];
        }
        for (std::size_t c = 0; c < layer.channels.size(); ++c) {
          layer.values.push_back(stored_float(value[static_cast<int>(c)]));
        }
      }
    }
  }
  return layers;
}

}  // namespace scenefile
