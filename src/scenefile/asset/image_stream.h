#pragma once
// Writes image files row by row, for pictures that do not fit in memory. The bytes are those of
// encode_image() and encode_layers() (image_file.h).

#include "scenefile/asset/image_file.h"
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

/// Requests each row once, from the top. Returns false if it was canceled. `text`: as
/// FileNote::text.
bool stream_png(int width, int height, int bits, Rounding rounding, const RowSource& rows,
                const ByteSink& sink, std::string_view text = {});

/// Requests each row once, from the bottom. Returns false if it was canceled.
bool stream_pfm(int width, int height, const RowSource& rows, const ByteSink& sink);

/// The rows of a block of an EXR file; the last block may have less.
inline constexpr int exr_block_rows = 16;

/// Returns the packed block of the rows from y up to, but not including, `end`, counted from the
/// first row of the file; none to cancel.
using BlockSource = std::function<std::optional<std::string>(int y, int end)>;

/// Writes an EXR file from packed blocks (ExrRows::block() in exr_rows.h) of the same channels.
/// Requests each once, from the top. `layers`: names, channels and `whole`, without values. Fails
/// with ErrorKind::cancelled if it was canceled, or as encode_layers() does.
Result<void> stream_blocks(int width, int height, std::span<const ImageLayer> layers,
                           const BlockSource& block_at, const ByteSink& sink,
                           const FileNote& note = {});

}  // namespace scenefile
