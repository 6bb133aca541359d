#include "scenefile/trace/bands.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

namespace scenefile {

namespace {

constexpr int rows_of_block = 16;

constexpr int blocks_of(int rows) {
  return (rows + rows_of_block - 1) / rows_of_block;
}

}  // namespace

RowRange share_of(const RowRange& whole, std::uint32_t index, std::uint32_t count) {
  const auto blocks = static_cast<std::uint64_t>(blocks_of(whole.rows()));
  const auto row_of = [&](std::uint64_t share) {
    return std::min(whole.end,
                    whole.first + rows_of_block * static_cast<int>(blocks * share / count));
  };
  return {row_of(index), row_of(std::uint64_t{index} + 1)};
}

std::vector<RowRange> rows_without(const std::vector<RowRange>& bands, const RowRange& wanted) {
  std::vector<RowRange> sorted = bands;
  std::sort(sorted.begin(), sorted.end(),
            [](const RowRange& a, const RowRange& b) { return a.first < b.first; });
  std::vector<RowRange> missing;
  int y = wanted.first;
  for (const RowRange& band : sorted) {
    if (const int next = std::min(band.first, wanted.end); next > y) {
      missing.push_back({y, next});
    }
    y = std::max(y, band.end);
  }
  if (y < wanted.end) {
    missing.push_back({y, wanted.end});
  }
  return missing;
}

int rows_of_band(int width, int height, int margin, int threads) {
  const int of_picture = height / 64 / rows_of_block * rows_of_block;
  const int of_margin = 64 * margin;
  const int tiles = 32 * std::max(1, threads);
  const int of_threads = rows_of_block * ((tiles - 1) / blocks_of(width) + 1);
  return std::max({of_picture, of_margin, of_threads});
}

std::string band_name(const RowRange& band) {
  return fmt::format("{:05}-{:05}.exr", band.first, band.end);
}

std::optional<RowRange> band_of_name(std::string_view name) {
  RowRange band;
  const char* const end = name.data() + name.size();
  const auto [dash, wrong] = std::from_chars(name.data(), end, band.first);
  if (wrong != std::errc() || dash == end || *dash != '-') {
    return std::nullopt;
  }
  std::from_chars(dash + 1, end, band.end);
  const bool possible = band.first >= 0 && band.first < band.end;
  return possible && band_name(band) == name ? std::optional(band) : std::nullopt;
}

}  // namespace scenefile
