#include "scenefile/trace/layers.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace scenefile {

namespace {

constexpr std::string_view light_prefix = "light-";
constexpr std::string_view bounce_prefix = "bounce-";

bool parse_layer(std::string_view word, Layer& layer) {
  const auto found = std::find(layer_words.begin(), layer_words.end(), word);
  layer.kind = static_cast<LayerKind>(found - layer_words.begin());
  layer.light = layer.kind == LayerKind::bounce ? 1 : 0;
  if (found != layer_words.end()) {
    return true;
  }
  const bool bounce = word.starts_with(bounce_prefix);
  if (!bounce && !word.starts_with(light_prefix)) {
    return false;
  }
  layer.kind = bounce ? LayerKind::bounce : LayerKind::light;
  const std::string_view number = word.substr(word.find('-') + 1);
  const char* const end = number.data() + number.size();
  const auto [rest, error] = std::from_chars(number.data(), end, layer.light);
  if (error != std::errc() || rest != end || (number.front() == '0' && number.size() > 1)) {
    return false;
  }
  return bounce || layer.light-- > 0;
}

std::vector<std::string> channels_of(LayerKind kind) {
  switch (kind) {
    case LayerKind::depth:
      return {"Z"};
    case LayerKind::normal:
      return {"X", "Y", "Z"};
    case LayerKind::uv:
      return {"U", "V"};
    case LayerKind::albedo:
    case LayerKind::light:
    case LayerKind::direct:
    case LayerKind::bounce:
    case LayerKind::specular:
      return {"R", "G", "B"};
    case LayerKind::object_id:
      return {"ID"};
    case LayerKind::shadow:
    case LayerKind::reflection_depth:
    case LayerKind::variance:
    case LayerKind::samples:
      break;
  }
  return {"Y"};
}

float share(const ValueRange& range, float value) {
  return range.most > range.least ? (value - range.least) / (range.most - range.least) : 0;
}

// Hues at golden ratio steps, in three brightnesses.
glm::vec3 color_of_id(float id) {
  if (id == 0) {
    return glm::vec3(0);
  }
  const double turn = std::fmod(id * 0.6180339887498949, 1.0);
  const float value = 1 - 0.25f * std::fmod(id, 3.0f);
  glm::vec3 color;
  for (int c = 0; c < 3; ++c) {
    const double from_hue = std::abs(std::fmod(6 * turn + 4 - 2 * c, 6.0) - 3);
    color[c] = value * static_cast<float>(0.15 + 0.85 * std::clamp(from_hue - 1, 0.0, 1.0));
  }
  return color;
}

glm::vec3 color_of(const Layer& layer, const float* value, const ValueRange& range, int max_depth) {
  switch (layer.kind) {
    case LayerKind::depth:
      return glm::vec3(std::isfinite(*value) ? 1 - share(range, *value) : 0);
    case LayerKind::normal: {
      const glm::vec3 n(value[0], value[1], value[2]);
      return n == glm::vec3(0) ? n : 0.5f * (n + 1.0f);
    }
    case LayerKind::uv:
      return {value[0], value[1], 0};
    case LayerKind::object_id:
      return color_of_id(*value);
    case LayerKind::albedo:
    case LayerKind::light:
    case LayerKind::direct:
    case LayerKind::bounce:
    case LayerKind::specular:
      return {value[0], value[1], value[2]};
    case LayerKind::variance:
    case LayerKind::samples:
      return glm::vec3(range.most > 0 ? *value / range.most : 0);
    case LayerKind::shadow:
      return glm::vec3(*value);
    case LayerKind::reflection_depth:
      break;
  }
  return glm::vec3(*value / static_cast<float>(std::max(1, max_depth)));
}

}  // namespace

std::string_view parse_layers(std::string_view list, std::vector<Layer>& layers) {
  layers.clear();
  for (bool more = true; more;) {
    const std::size_t comma = list.find(',');
    const std::string_view word = list.substr(0, comma);
    Layer layer;
    if (!parse_layer(word, layer) ||
        std::find(layers.begin(), layers.end(), layer) != layers.end()) {
      return word.empty() ? std::string_view(",") : word;
    }
    layers.push_back(layer);
    more = comma != std::string_view::npos;
    list.remove_prefix(more ? comma + 1 : list.size());
  }
  return {};
}

std::string layer_name(const Layer& layer) {
  if (layer.kind == LayerKind::light) {
    return std::string(light_prefix) + std::to_string(layer.light + 1);
  }
  if (layer.kind == LayerKind::bounce) {
    return std::string(bounce_prefix) + std::to_string(layer.light);
  }
  return std::string(word_of(layer.kind));
}

std::string missing_light(std::span<const Layer> layers, std::size_t lights) {
  for (const Layer& layer : layers) {
    if (layer.kind == LayerKind::light && layer.light >= lights) {
      return "the scene has no " + layer_name(layer) + ", but " + std::to_string(lights) +
             (lights == 1 ? " light" : " lights");
    }
  }
  return {};
}

ImageLayer layer_without_values(const Layer& layer) {
  return {layer_name(layer), channels_of(layer.kind), layer.kind == LayerKind::object_id, {}};
}

ValueRange range_of(std::span<const float> values) {
  ValueRange range;
  for (const float v : values) {
    if (std::isfinite(v)) {
      range = joined(range, {v, v});
    }
  }
  return range;
}

ValueRange joined(const ValueRange& a, const ValueRange& b) {
  return {std::min(a.least, b.least), std::max(a.most, b.most)};
}

Image layer_picture(const Layer& layer, const ImageLayer& values, int width, int height,
                    int max_depth) {
  Image image(width, height);
  layer_colors(layer, values.values, range_of(values.values), max_depth, image.rgb.data());
  return image;
}

void layer_colors(const Layer& layer, std::span<const float> values, const ValueRange& range,
                  int max_depth, float* rgb) {
  const std::size_t channels = channels_of(layer.kind).size();
  for (std::size_t p = 0; p < values.size() / channels; ++p) {
    const glm::vec3 color = color_of(layer, &values[p * channels], range, max_depth);
    for (int c = 0; c < 3; ++c) {
      rgb[3 * p + static_cast<std::size_t>(c)] = color[c];
    }
  }
}

}  // namespace scenefile
