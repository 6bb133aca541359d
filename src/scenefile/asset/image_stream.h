#pragma once
// Image files of pictures that are nowhere whole: written while their rows come. The bytes are
// those of encode_image() and encode_layers() (image_file.h).

#include "scenefile/asset/image.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace scenefile {

/// Where the bytes of a file go. Each returns false to give up.
struct ByteSink {
  std::function<bool(std::string_view bytes)> append;
  /// Replaces bytes that were appended, from the place `at`, counted from the first of all.
  std::function<bool(std::uint64_t at, std::string_view bytes)> replace;
};

/// Appends to `bytes`, which must be empty and outlive the sink.
ByteSink sink_to(std::string& bytes);

/// The 3 * width values of the row y, good until the next call; null to give up.
using RowSource = std::function<const float*(int y)>;

/// Asks for each row once, from the top. False: given up.
bool stream_png(int width, int height, int bits, Rounding rounding, const RowSource& rows,
                const ByteSink& sink);

/// Asks for each row once, from the bottom. False: given up.
bool stream_pfm(int width, int height, const RowSource& rows, const ByteSink& sink);

/// Some rows of all layers.
struct LayerRows {
  std::span<const ImageLayer> layers;
  int first = 0;  ///< the row that the values begin with
};

/// The rows from y to, but without, `end`, good until the next call; none to give up.
using LayerSource = std::function<std::optional<LayerRows>(int y, int end)>;

/// Asks for the rows once, from the top. `layers`: names, channels and whole; no values. False:
/// given up, or `error` says why such a file cannot be written.
bool stream_layers(int width, int height, std::span<const ImageLayer> layers,
                   const LayerSource& rows, const ByteSink& sink, std::string& error);

}  // namespace scenefile
