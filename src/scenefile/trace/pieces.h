#pragma once
// Which tiles of a picture are done.

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace scenefile {

/// Width and height of a tile, pixels. Tiles at the right and lower border may be smaller.
inline constexpr int tile_side = 16;

/// How many tiles lie side by side in so many pixels.
constexpr int tiles_across(int pixels) {
  return (pixels + tile_side - 1) / tile_side;
}

/// A flag for each tile of a picture, row by row. One thread may finish a tile while others ask.
class Pieces {
 public:
  Pieces() = default;
  Pieces(int width, int height);  ///< pixels
  Pieces(const Pieces& other);
  Pieces& operator=(const Pieces& other);
  Pieces(Pieces&&) noexcept = default;
  Pieces& operator=(Pieces&&) noexcept = default;
  ~Pieces() = default;

  std::size_t count() const { return done_.size(); }
  /// The tile of a pixel.
  std::size_t at(int x, int y) const;
  /// What was written to a tile before finish() can be read once it is done.
  bool done(std::size_t piece) const { return done_[piece].load(std::memory_order_acquire) != 0; }
  void finish(std::size_t piece) { done_[piece].store(1, std::memory_order_release); }
  bool all_done() const;
  /// No tile is done.
  void restart();

  int width() const { return width_; }
  int height() const { return height_; }

 private:
  int width_ = 0;
  int height_ = 0;
  std::vector<std::atomic<std::uint8_t>> done_;
};

}  // namespace scenefile
