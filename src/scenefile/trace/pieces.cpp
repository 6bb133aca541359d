#include "scenefile/trace/pieces.h"

#include <algorithm>
#include <utility>

namespace scenefile {

Pieces::Pieces(int width, int height)
    : width_(width),
      height_(height),
      done_(std::size_t(tiles_across(width)) * tiles_across(height)) {}

Pieces::Pieces(const Pieces& other) : Pieces(other.width_, other.height_) {
  for (std::size_t i = 0; i < done_.size(); ++i) {
    done_[i].store(other.done_[i].load(std::memory_order_acquire), std::memory_order_relaxed);
  }
}

Pieces& Pieces::operator=(const Pieces& other) {
  *this = Pieces(other);
  return *this;
}

std::size_t Pieces::at(int x, int y) const {
  return std::size_t(y / tile_side) * tiles_across(width_) + x / tile_side;
}

bool Pieces::all_done() const {
  return std::all_of(done_.begin(), done_.end(), [](const std::atomic<std::uint8_t>& done) {
    return done.load(std::memory_order_acquire) != 0;
  });
}

void Pieces::restart() {
  for (std::atomic<std::uint8_t>& done : done_) {
    done.store(0, std::memory_order_relaxed);
  }
}

namespace {

// The pixels of tiles `first` to `last` along one axis, for a region of `size` pixels at `from`.
std::pair<int, int> pixels_of_tiles(int first, int last, int from, int to) {
  return {std::min(from + first * tile_side, to), std::min(from + last * tile_side, to)};
}

}  // namespace

bool empty(const PixelRegion& region) {
  return region.width() <= 0 || region.height() <= 0;
}

// Repeatedly halves the region along its longer side.
PixelRegion part_of(const PixelRegion& region, std::uint32_t index, std::uint32_t count) {
  PixelRegion tiles{0, 0, tiles_across(region.width()), tiles_across(region.height())};
  while (count > 1 && !empty(tiles)) {
    const std::uint32_t before = count / 2;
    const bool is_first = index < before;
    const bool across = tiles.width() > tiles.height();
    int& low = across ? tiles.x0 : tiles.y0;
    int& high = across ? tiles.x1 : tiles.y1;
    const int middle = low + static_cast<int>(std::int64_t(high - low) * before / count);
    (is_first ? high : low) = middle;
    index -= is_first ? 0 : before;
    count = is_first ? before : count - before;
  }
  if (empty(tiles)) {
    return {};
  }
  const auto [x0, x1] = pixels_of_tiles(tiles.x0, tiles.x1, region.x0, region.x1);
  const auto [y0, y1] = pixels_of_tiles(tiles.y0, tiles.y1, region.y0, region.y1);
  return {x0, y0, x1, y1};
}

}  // namespace scenefile
