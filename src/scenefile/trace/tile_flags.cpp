#include "scenefile/trace/tile_flags.h"

#include <algorithm>

namespace scenefile {

TileFlags::TileFlags(int width, int height)
    : width_(width),
      height_(height),
      done_(std::size_t(tiles_across(width)) * tiles_across(height)) {}

std::size_t TileFlags::at(int x, int y) const {
  return std::size_t(y / tile_side) * tiles_across(width_) + x / tile_side;
}

bool TileFlags::all_done() const {
  return std::all_of(done_.begin(), done_.end(), [](const std::atomic<std::uint8_t>& done) {
    return done.load(std::memory_order_acquire) != 0;
  });
}

void TileFlags::restart() {
  for (std::atomic<std::uint8_t>& done : done_) {
    done.store(0, std::memory_order_relaxed);
  }
}

bool empty(const PixelRegion& region) {
  return region.width() <= 0 || region.height() <= 0;
}

}  // namespace scenefile
