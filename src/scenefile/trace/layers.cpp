#include "scenefile/trace/layers.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>

namespace scenefile {

namespace {

// By LayerKind.
constexpr std::array<std::string_view, 8> words{
    "depth", "normal", "uv", "albedo", "object-id", "light-1", "shadow", "reflection-depth"};
constexpr std::string_view light_prefix = "light-";

bool parse_layer(std::string_view word, Layer& layer) {
  const auto found = std::find(words.begin(), words.end(), word);
  layer.kind = static_cast<LayerKind>(found - words.begin());
  layer.light = 0;
  if (found != words.end()) {
    return true;
  }
  if (!word.starts_with(light_prefix)) {
    return false;
  }
  layer.kind = LayerKind::light;
  const std::string_view number = word.substr(light_prefix.size());
  const char* const end = number.data() + number.size();
  const auto [rest, error] = std::from_chars(number.data(), end, layer.light);
  return error == std::errc() && rest == end && number.front() != '0' && layer.light-- > 0;
}

// The range of the numbers that are finite.
struct Range {
  float least = std::numeric_limits<float>::max();
  float most = std::numeric_limits<float>::lowest();

  explicit Range(const std::vector<float>& values) {
    for (const float v : values) {
      if (std::isfinite(v)) {
        least = std::min(least, v);
        most = std::max(most, v);
      }
    }
  }
  float share(float value) const { return most > least ? (value - least) / (most - least) : 0; }
};

// Hues a golden section apart, in three brightnesses.
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

glm::vec3 color_of(const Layer& layer, const float* value, const Range& depths, int max_depth) {
  switch (layer.kind) {
    case LayerKind::depth:
      return glm::vec3(std::isfinite(*value) ? 1 - depths.share(*value) : 0);
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
      return {value[0], value[1], value[2]};
    case LayerKind::shadow:
      return glm::vec3(*value);
    case LayerKind::reflection_depth:
      break;
  }
  return glm::vec3(*value / static_cast<float>(std::max(1, max_depth)));
}

}  // namespace

std::span<const std::string_view> layer_words() {
  return words;
}

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
  return std::string(words[static_cast<std::size_t>(layer.kind)]);
}

Image layer_picture(const Layer& layer, const ImageLayer& values, int width, int height,
                    int max_depth) {
  Image image(width, height);
  const Range depths(layer.kind == LayerKind::depth ? values.values : std::vector<float>());
  const std::size_t channels = values.channels.size();
  for (std::size_t p = 0; p < image.rgb.size() / 3; ++p) {
    const glm::vec3 color = color_of(layer, &values.values[p * channels], depths, max_depth);
    for (int c = 0; c < 3; ++c) {
      image.rgb[3 * p + static_cast<std::size_t>(c)] = color[c];
    }
  }
  return image;
}

}  // namespace scenefile
