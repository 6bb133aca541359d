#include "scenefile/grade/acne.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <vector>

namespace scenefile {

namespace {

constexpr int tolerance = 4;
constexpr int darker = 10;  // in 1/255: what a spot of acne takes away at least

// The test is darker here than the lit surface.
bool is_spot(const std::uint8_t* test, const std::uint8_t* lit) {
  bool spot = false;
  for (int c = 0; c < 3; ++c) {
    spot = spot || std::abs(int{lit[c]} - int{test[c]}) >= darker;
  }
  return spot;
}

bool between(const std::uint8_t* value, const std::uint8_t* a, const std::uint8_t* b) {
  bool inside = true;
  for (int c = 0; c < 3; ++c) {
    inside = inside && value[c] >= std::min(a[c], b[c]) - tolerance &&
             value[c] <= std::max(a[c], b[c]) + tolerance;
  }
  return inside;
}

}  // namespace

AcneEvidence look_for_acne(const Texture& test, const Texture& lit, const Texture& dark) {
  std::vector<bool> spots(test.rgb.size() / 3);
  for (std::size_t i = 0; i < spots.size(); ++i) {
    spots[i] = is_spot(test.rgb.data() + 3 * i, lit.rgb.data() + 3 * i);
  }
  std::size_t count = 0;
  std::size_t inside = 0;
  std::size_t right_neighbors = 0;
  const auto place = [&](int x, int y) { return static_cast<std::size_t>(test.width) * y + x; };
  // Only where light could be taken away is a right neighbor worth anything.
  const auto right = [&](int x, int y) {
    return x >= 0 && y >= 0 && x < test.width && y < test.height && !spots[place(x, y)] &&
           is_spot(dark.texel(x, y), lit.texel(x, y));
  };
  for (int y = 0; y < test.height; ++y) {
    for (int x = 0; x < test.width; ++x) {
      if (spots[place(x, y)]) {
        ++count;
        inside += between(test.texel(x, y), lit.texel(x, y), dark.texel(x, y)) ? 1 : 0;
        right_neighbors += std::size_t(right(x - 1, y)) + std::size_t(right(x + 1, y)) +
                           std::size_t(right(x, y - 1)) + std::size_t(right(x, y + 1));
      }
    }
  }
  const auto spots_found = static_cast<double>(std::max<std::size_t>(count, 1));
  return {static_cast<double>(inside) / spots_found,
          static_cast<double>(right_neighbors) / spots_found};
}

}  // namespace scenefile
