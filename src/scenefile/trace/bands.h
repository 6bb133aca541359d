#pragma once
// Bands: rows of a picture over its whole width, for drawing it piece by piece or on several
// machines. A band begins at a multiple of 16 rows, and ends at one or at the bottom: such bands
// are whole blocks of an EXR file (asset/image_stream.h).

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace scenefile {

/// Rows from `first` up to, but not including, `end`, counted from 0 at the top.
struct RowRange {
  int first = 0;
  int end = 0;

  int rows() const { return end - first; }
  friend bool operator==(const RowRange&, const RowRange&) = default;
};

/// The maximum number of shares.
inline constexpr std::uint32_t max_shares = 1000000;

/// Share `index`, counted from 0, of `count` shares of `whole`, a band. They cover it without
/// overlap, and their sizes differ by at most 16 rows. Empty if there are more shares than blocks.
RowRange share_of(const RowRange& whole, std::uint32_t index, std::uint32_t count);

/// The rows of `wanted` that are in none of the bands.
std::vector<RowRange> rows_without(const std::vector<RowRange>& bands, const RowRange& wanted);

/// The height of the bands into which a picture is divided by default: a 64th of it, but so that
/// margins (`margin` more rows above and below are drawn) cost at most 3 %, and that each thread
/// gets at least 32 tiles of 16 x 16 pixels.
int rows_of_band(int width, int height, int margin, int threads);

/// The file name of a band: 00064-00128.exr.
std::string band_name(const RowRange& band);
/// Its inverse; none for any other name.
std::optional<RowRange> band_of_name(std::string_view name);

}  // namespace scenefile
