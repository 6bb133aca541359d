#pragma once
// Names of layers, and layers as pictures: `depth normal uv albedo object-id light-1 shadow
// reflection-depth direct bounce-1 specular variance samples`. Their contents: LayerKind and
// docs/layers.md.

#include "scenefile/base/shape.h"
#include "scenefile/trace/render.h"

#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace scenefile {

/// The name of a kind; those of the first light and bounce represent all of them.
constexpr std::string_view word_of(LayerKind kind) {
  switch (kind) {
    case LayerKind::depth:
      return "depth";
    case LayerKind::normal:
      return "normal";
    case LayerKind::uv:
      return "uv";
    case LayerKind::albedo:
      return "albedo";
    case LayerKind::object_id:
      return "object-id";
    case LayerKind::light:
      return "light-1";
    case LayerKind::shadow:
      return "shadow";
    case LayerKind::reflection_depth:
      return "reflection-depth";
    case LayerKind::direct:
      return "direct";
    case LayerKind::bounce:
      return "bounce-1";
    case LayerKind::specular:
      return "specular";
    case LayerKind::variance:
      return "variance";
    case LayerKind::samples:
      return "samples";
  }
  return {};
}
inline constexpr auto layer_words = words_of<LayerKind>();

/// Whether pictures of a mode have a layer.
constexpr bool has_layer(Mode mode, LayerKind kind) {
  const bool of_both = kind == LayerKind::normal || kind == LayerKind::albedo;
  return of_both || (kind >= LayerKind::direct) == (mode == Mode::path);
}

/// Whether a layer is light of mode path, which is shown with the tone curve of the picture.
constexpr bool is_path_light(LayerKind kind) {
  return kind == LayerKind::direct || kind == LayerKind::bounce || kind == LayerKind::specular;
}

/// Parses a comma-separated list of names; light-1 is the scene's first light, bounce-0 what
/// lamps emit toward the camera. Returns the first
/// name that is unknown or repeated; empty on success. Does not check whether the lights exist.
std::string_view parse_layers(std::string_view list, std::vector<Layer>& layers);

/// The name of a layer: the inverse of parse_layers().
std::string layer_name(const Layer& layer);

/// If a layer is for a light that the scene lacks: "the scene has no light-3, but 2 lights".
/// Empty otherwise. `lights`: how many there are.
std::string missing_light(std::span<const Layer> layers, std::size_t lights);

/// Name and channels of a layer.
ImageLayer layer_without_values(const Layer& layer);

/// The range of all finite values; by default the empty range.
struct ValueRange {
  float least = std::numeric_limits<float>::max();
  float most = std::numeric_limits<float>::lowest();

  friend bool operator==(const ValueRange&, const ValueRange&) = default;
};
ValueRange range_of(std::span<const float> values);
/// The range of both together.
ValueRange joined(const ValueRange& a, const ValueRange& b);

/// A layer as a picture in [0, 1], for formats that only store colors. Depth is white at the
/// nearest point and black at the farthest or if nothing is hit; normals are (n + 1) / 2, black if
/// nothing is hit; u is red and v is green; each object-id has a different color; reflection-depth
/// is divided by `max_depth`, variance and samples by their largest value; others are unchanged.
Image layer_picture(const Layer& layer, const ImageLayer& values, int width, int height,
                    int max_depth);
/// The same for some of the pixels; `range` is that of the whole layer. Writes 3 numbers per pixel.
void layer_colors(const Layer& layer, std::span<const float> values, const ValueRange& range,
                  int max_depth, float* rgb);

}  // namespace scenefile
