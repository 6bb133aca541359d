#pragma once
// The tiles of a picture: which are finished.

#include "scenefile/trace/render_options.h"

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace scenefile {

/// Width and height of a tile, pixels. Tiles at the right and lower border may be smaller.
inline constexpr int tile_side = 16;

/// The number of tiles for this number of pixels.
constexpr int tiles_across(int pixels) {
  return (pixels + tile_side - 1) / tile_side;
}

/// A flag for each tile of a picture, row by row. Tiles can be finished by one thread while others
/// check them.
class TileFlags {
 public:
  TileFlags() = default;
  TileFlags(int width, int height);  ///< pixels

  std::size_t count() const { return done_.size(); }
  /// The index of the tile that contains a pixel.
  std::size_t at(int x, int y) const;
  /// If done, everything written to the tile before finish() can be read.
  bool done(std::size_t tile) const { return done_[tile].load(std::memory_order_acquire) != 0; }
  void finish(std::size_t tile) { done_[tile].store(1, std::memory_order_release); }
  bool all_done() const;
  /// Marks all tiles as unfinished.
  void restart();

  int width() const { return width_; }
  int height() const { return height_; }

 private:
  int width_ = 0;
  int height_ = 0;
  std::vector<std::atomic<std::uint8_t>> done_;
};

/// Whether the region has no pixels.
bool empty(const PixelRegion& region);

}  // namespace scenefile
