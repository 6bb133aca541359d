#include "scenefile/trace/layer_buffers.h"

#include "scenefile/trace/course_samples.h"
#include "scenefile/trace/layers.h"

#include <algorithm>
#include <limits>

namespace scenefile {

namespace {

bool is_of_center(LayerKind kind) {
  return kind == LayerKind::depth || kind == LayerKind::uv || kind == LayerKind::object_id;
}

double sum(const Color& color) {
  return color.x + color.y + color.z;
}

// Weighted means over the samples of a pixel.
struct Means {
  glm::dvec3 normal{0};
  Color albedo{0};
  double lit = 0;
  double unshadowed = 0;
  double bounces = 0;
  std::vector<Color> lights;

  double shadow() const { return unshadowed > 0 ? std::max(0.0, 1 - lit / unshadowed) : 0; }
};

Means means_of(const PixelAovs& pixel, const std::vector<double>& weights, std::size_t lights) {
  Means means;
  means.lights.resize(lights, Color(0));
  for (std::size_t i = 0; i < weights.size(); ++i) {
    const AovSample& s = pixel.samples[i];
    means.normal += weights[i] * s.normal;
    means.albedo += weights[i] * s.albedo;
    means.lit += weights[i] * sum(s.lit);
    means.unshadowed += weights[i] * sum(s.unshadowed);
    means.bounces += weights[i] * s.bounces;
    for (std::size_t k = 0; k < lights; ++k) {
      means.lights[k] += weights[i] * pixel.light_of(i, k, lights);
    }
  }
  return means;
}

glm::dvec3 value_of(LayerKind kind, const Means& means, std::size_t light) {
  switch (kind) {
    case LayerKind::normal:
      return means.normal;
    case LayerKind::albedo:
      return means.albedo;
    case LayerKind::light:
      return means.lights[light];
    case LayerKind::shadow:
      return glm::dvec3(means.shadow());
    case LayerKind::reflection_depth:
      return glm::dvec3(means.bounces);
    case LayerKind::depth:
    case LayerKind::uv:
    case LayerKind::object_id:
    case LayerKind::direct:
    case LayerKind::bounce:
    case LayerKind::specular:
    case LayerKind::variance:
    case LayerKind::samples:
      break;
  }
  return glm::dvec3(0);
}

void store(ImageLayer& layer, std::size_t pixel, const glm::dvec3& value) {
  const std::size_t channels = layer.channels.size();
  for (std::size_t c = 0; c < channels; ++c) {
    layer.values[pixel * channels + c] = static_cast<float>(value[static_cast<int>(c)]);
  }
}

}  // namespace

std::vector<ImageLayer> make_layers(const RenderOptions& options, const PixelRegion& region) {
  std::vector<ImageLayer> layers;
  for (const Layer& wanted : options.layers) {
    ImageLayer& layer = layers.emplace_back(layer_without_values(wanted));
    layer.values.resize(layer.channels.size() * region.width() * region.height());
  }
  return layers;
}

LayerBuffers::LayerBuffers(const Tracer& tracer, const CameraRays& camera, Film& film)
    : tracer_(tracer), camera_(camera), region_(film.region), layers_(film.layers) {
  for (const Layer& wanted : tracer.options.layers) {
    if (wanted.kind == LayerKind::light) {
      lights_.push_back(wanted.light);
    }
  }
}

bool LayerBuffers::need_centers() const {
  const std::vector<Layer>& kinds = tracer_.options.layers;
  return std::any_of(kinds.begin(), kinds.end(),
                     [](const Layer& layer) { return is_of_center(layer.kind); });
}

void LayerBuffers::put(int x, int y, const PixelAovs& pixel) {
  put_center(index(x, y), pixel.center);
  put_means(index(x, y), pixel);
}

void LayerBuffers::put_center(std::size_t pixel, const AovHit& center) {
  const RenderCamera& camera = tracer_.scene.camera;
  for (std::size_t i = 0; i < layers_.size(); ++i) {
    const LayerKind kind = tracer_.options.layers[i].kind;
    if (kind == LayerKind::depth) {
      const double depth = glm::dot(camera.position - center.position, camera.w);
      store(layers_[i], pixel,
            glm::dvec3(center.hit ? depth : std::numeric_limits<double>::infinity()));
    } else if (kind == LayerKind::uv) {
      store(layers_[i], pixel, glm::dvec3(center.uv, 0));
    } else if (kind == LayerKind::object_id) {
      store(layers_[i], pixel, glm::dvec3(center.hit ? center.source + 1.0 : 0));
    }
  }
}

void LayerBuffers::put_means(std::size_t pixel, const PixelAovs& surfaces) {
  const Means means = means_of(surfaces, weights_of(surfaces.samples), lights_.size());
  std::size_t light = 0;
  for (std::size_t i = 0; i < layers_.size(); ++i) {
    const LayerKind kind = tracer_.options.layers[i].kind;
    if (!is_of_center(kind)) {
      store(layers_[i], pixel, value_of(kind, means, light));
      light += kind == LayerKind::light ? 1 : 0;
    }
  }
}

// The weights that the samples have in the color of the pixel.
std::vector<double> LayerBuffers::weights_of(const std::vector<AovSample>& samples) const {
  std::vector<double> weights(samples.size(), 1.0 / static_cast<double>(samples.size()));
  if (!tracer_.course() || camera_.has_lens() || samples.size() == 1) {
    return weights;
  }
  std::vector<glm::dvec2> points;
  for (const AovSample& sample : samples) {
    points.push_back(sample.camera.point);
  }
  const std::vector<std::uint32_t> links = course::refined_samples(points);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double share = links[i] == no_index ? 1 : weights[links[i]];
    weights[i] = share / 4;
  }
  for (const std::uint32_t replaced : links) {
    if (replaced != no_index) {
      weights[replaced] = 0;
    }
  }
  return weights;
}

}  // namespace scenefile
