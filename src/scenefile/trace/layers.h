#pragma once
// Layers as words and as pictures: `depth normal uv albedo object-id light-1 shadow
// reflection-depth`. What they hold: LayerKind and docs/layers.md.

#include "scenefile/trace/render.h"

#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace scenefile {

/// The words; light-N stands as "light-1" for all of its kind.
std::span<const std::string_view> layer_words();

/// Reads a comma-separated list of the words, light-1 being the scene's first light. Returns the
/// first word that is none of them or stands twice, empty when all are good; `layers` is then
/// complete. Whether the lights exist only the scene can tell.
std::string_view parse_layers(std::string_view list, std::vector<Layer>& layers);

/// The word of a layer: the inverse of parse_layers().
std::string layer_name(const Layer& layer);

/// Name and channels of a layer.
ImageLayer layer_without_values(const Layer& layer);

/// From the least to the most of the numbers that are finite; the default is the range of none.
struct ValueRange {
  float least = std::numeric_limits<float>::max();
  float most = std::numeric_limits<float>::lowest();

  friend bool operator==(const ValueRange&, const ValueRange&) = default;
};
ValueRange range_of(std::span<const float> values);
/// The range of both.
ValueRange joined(const ValueRange& a, const ValueRange& b);

/// A layer as a picture, for formats that hold only colors, in [0, 1]: depth is white at the
/// nearest point, black at the farthest and where nothing is; normals are (n + 1) / 2, black where
/// nothing is; u is red and v is green; each object-id has a color of its own; reflection-depth is
/// divided by `max_depth`; the others are as they are.
Image layer_picture(const Layer& layer, const ImageLayer& values, int width, int height,
                    int max_depth);
/// The same for some pixels: `range` is that of the whole layer. Writes 3 numbers a pixel to `rgb`.
void layer_colors(const Layer& layer, std::span<const float> values, const ValueRange& range,
                  int max_depth, float* rgb);

}  // namespace scenefile
