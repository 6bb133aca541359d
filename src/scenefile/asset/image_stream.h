#pragma once
// Writes image files row by row, for pictures that do not fit in memory. The bytes are those of
// encode_image() and encode_layers() (image_file.h).

#include "scenefile/asset/image.h"
#include "scenefile/base/result.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace scenefile {

/// Receives the bytes of a file. Each function returns false to cancel.
struct ByteSink {
  std::function<bool(std::string_view bytes)> append;
  /// Replaces appended bytes, starting at offset `at` in the file.
  std::function<bool(std::uint64_t at, std::string_view bytes)> replace;
};

/// A sink that appends to `bytes`, which must be empty and outlive it.
ByteSink sink_to(std::string& bytes);

/// Returns the 3 * width values of row y, valid until the next call; null to cancel.
using RowSource = std::function<const float*(int y)>;

/// Requests each row once, from the top. Returns false if it was canceled.
bool stream_png(int width, int height, int bits, Rounding rounding, const RowSource& rows,
                const ByteSink& sink);

/// Requests each row once, from the bottom. Returns false if it was canceled.
bool stream_pfm(int width, int height, const RowSource& rows, const ByteSink& sink);

/// Some rows of all layers.
struct LayerRows {
  std::span<const ImageLayer> layers;
  int first = 0;  ///< the first row in `layers`
};

/// Returns the rows from y up to, but not including, `end`, valid until the next call; none to
/// cancel.
using LayerSource = std::function<std::optional<LayerRows>(int y, int end)>;

/// Requests each row once, from the top. `layers`: names, channels and `whole`, without values.
/// Fails with ErrorKind::cancelled if it was canceled, or as encode_layers() does.
Result<void> stream_layers(int width, int height, std::span<const ImageLayer> layers,
                           const LayerSource& rows, const ByteSink& sink);

}  // namespace scenefile
