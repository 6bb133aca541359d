#include "scenefile/grade/placed_copy.h"

#include "scenefile/base/text.h"
#include "scenefile/grade/claims.h"
#include "scenefile/grade/evidence.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace scenefile {

namespace {

using glm::dvec2;
using glm::dvec3;

constexpr double min_share_moved = 0.01;  // of the pixels, that must differ
constexpr double nearly_all_of_copy = 0.95;
constexpr int max_shift = 16;  // pixels

// Where a pixel of the reference is in the test: scale * pixel + offset.
struct CopyPlace {
  dvec2 scale{1};
  dvec2 offset{0};
};

struct ContentBox {
  glm::ivec2 low{0};
  glm::ivec2 high{0};  // one past the last
};

// The rectangle around all pixels that are not black.
std::optional<ContentBox> content_of(const Texture& t) {
  ContentBox box{{t.width, t.height}, {0, 0}};
  for (int y = 0; y < t.height; ++y) {
    for (int x = 0; x < t.width; ++x) {
      if (largest_of(at(t, x, y)) > right_within) {
        box.low = glm::min(box.low, glm::ivec2(x, y));
        box.high = glm::max(box.high, glm::ivec2(x + 1, y + 1));
      }
    }
  }
  return box.low.x < box.high.x ? std::optional(box) : std::nullopt;
}

// The color of the copy at the center of a pixel of the test: black outside of the reference.
dvec3 color_of_copy(const Texture& reference, const CopyPlace& place, int x, int y) {
  const dvec2 p = (dvec2(x + 0.5, y + 0.5) - place.offset) / place.scale;
  if (p.x < 0 || p.y < 0 || p.x >= reference.width || p.y >= reference.height) {
    return dvec3(0);
  }
  return at(reference, static_cast<int>(p.x), static_cast<int>(p.y));
}

// Whether the test is the copy: nearly all pixels that are not black in both, and all of a sample.
bool is_copy(const Texture& reference, const Texture& test, const Copy& color_at, bool exactly) {
  std::size_t shown = 0;
  std::size_t right = 0;
  std::size_t varied = 0;
  // More wrong pixels are too many, however many others are shown.
  const double max_wrong = (1 - nearly_all_of_copy) * (0.5 * test.width + 1) * test.height;
  for (int y = 0; y < test.height; ++y) {
    if (static_cast<double>(shown - right) > max_wrong) {
      return false;
    }
    for (int x = y % 2; x < test.width; x += 2) {
      const dvec3 copy = color_at(x, y);
      const dvec3 color = at(test, x, y);
      if (largest_of(copy) <= right_within && largest_of(color) <= right_within) {
        continue;
      }
      ++shown;
      const Range range = exactly ? Range{color, color} : around(test, x, y);
      const bool same = largest_of(outside(copy, range.low, range.high)) <= (exactly ? 3 : 10);
      right += same ? 1 : 0;
      varied += same && largest_of(glm::abs(color - at(reference, x, y))) > right_within ? 1 : 0;
    }
  }
  return shown >= 4 * few_pixels && varied >= 2 * few_pixels &&
         static_cast<double>(right) >= nearly_all_of_copy * static_cast<double>(shown);
}

bool is_copy(const Texture& reference, const Texture& test, const CopyPlace& place, bool exactly) {
  return is_copy(
      reference, test, [&](int x, int y) { return color_of_copy(reference, place, x, y); },
      exactly);
}

PlacedCopy placed_copy(std::string what, Copy color) {
  return {{Cause::viewport, std::move(what),
           fmt::format("at least {} of the pixels that show something equal the reference there",
                       percent(nearly_all_of_copy)),
           nearly_all_of_copy},
          std::move(color)};
}

PlacedCopy placed_copy(std::string what, const Texture& reference, const CopyPlace& place) {
  return placed_copy(std::move(what), [&reference, place](int x, int y) {
    return color_of_copy(reference, place, x, y);
  });
}

// Whether the shift is the same in all parts of the picture. If the camera moved, near objects
// move farther than distant ones, and the edges of the picture move differently from its middle.
bool same_everywhere(const Texture& reference, const Texture& test, const glm::ivec2& shift) {
  constexpr int tiles = 4;  // across and down
  constexpr int min_pixels = 24;
  constexpr double clearly_less = 0.8;
  for (int tile = 0; tile < tiles * tiles; ++tile) {
    const glm::ivec2 from(tile % tiles * test.width / tiles, tile / tiles * test.height / tiles);
    const glm::ivec2 to = from + glm::ivec2(test.width, test.height) / tiles;
    std::array<double, 9> off{};
    int pixels = 0;
    for (int y = from.y; y < to.y; ++y) {
      for (int x = from.x; x < to.x; ++x) {
        const glm::ivec2 at_reference = glm::ivec2(x, y) - shift;
        if (at_reference.x < 1 || at_reference.y < 1 || at_reference.x + 1 >= test.width ||
            at_reference.y + 1 >= test.height ||
            around(reference, at_reference.x, at_reference.y).calm()) {
          continue;
        }
        ++pixels;
        for (int k = 0; k < 9; ++k) {
          const dvec3 d =
              glm::abs(at(reference, at_reference.x + k % 3 - 1, at_reference.y + k / 3 - 1) -
                       at(test, x, y));
          off[std::size_t(k)] += std::min(largest_of(d), 64.0);
        }
      }
    }
    const double least = *std::min_element(off.begin(), off.end());
    if (pixels >= min_pixels && least < clearly_less * off[4]) {
      return false;
    }
  }
  return true;
}

const char* corner_word(bool right, bool low) {
  return low ? (right ? "lower right" : "lower left") : (right ? "upper right" : "upper left");
}

// By a quarter turn or transposed, with the pixel of the reference for one of the test.
std::array<std::pair<const char*, Copy>, 3> turns_of(const Texture& reference) {
  const auto at_or_black = [&reference](int x, int y) {
    const bool inside = x >= 0 && y >= 0 && x < reference.width && y < reference.height;
    return inside ? at(reference, x, y) : dvec3(0);
  };
  return {{{"rows and columns are exchanged: the picture is transposed",
            [=](int x, int y) { return at_or_black(y, x); }},
           {"the picture is rotated by a quarter turn, clockwise",
            [=, &reference](int x, int y) { return at_or_black(y, reference.height - 1 - x); }},
           {"the picture is rotated by a quarter turn, counterclockwise",
            [=, &reference](int x, int y) { return at_or_black(reference.width - 1 - y, x); }}}};
}

// Pixels that are stored in another order.
std::optional<PlacedCopy> find_order(const Texture& reference, const Texture& test) {
  const int width = test.width;
  const int height = test.height;
  const auto at_or_black = [&](int x, int y) {
    const bool inside = x >= 0 && y >= 0 && x < width && y < height;
    return inside ? at(reference, x, y) : dvec3(0);
  };
  // The pixel at this place in the order of rows.
  const auto place = [width](int x, int y) { return y * width + x; };
  const auto rows_of = [&](int length) {
    return [=](int x, int y) { return at_or_black(place(x, y) % length, place(x, y) / length); };
  };
  const auto [transposed, clockwise, counterclockwise] = turns_of(reference);
  const std::array<std::pair<const char*, Copy>, 8> orders{
      {transposed,
       {"rows and columns are exchanged and scaled to the size of the picture",
        [=](int x, int y) {
          return at_or_black(int((y + 0.5) * width / height), int((x + 0.5) * height / width));
        }},
       clockwise,
       counterclockwise,
       {stored_by_columns,
        [=](int x, int y) { return at_or_black(place(x, y) / height, place(x, y) % height); }},
       {read_by_columns,
        [=](int x, int y) {
          const int i = x * height + y;
          return at_or_black(i % width, i / width);
        }},
       {"rows are stored one pixel too far apart: the picture is skewed", rows_of(width + 1)},
       {"rows are stored one pixel too close together: the picture is skewed",
        rows_of(width - 1)}}};
  for (const auto& [what, copy] : orders) {
    if (width > 1 && is_copy(reference, test, copy, true)) {
      return placed_copy(what, copy);
    }
  }
  return std::nullopt;
}

std::optional<PlacedCopy> find_shift_of_copy(const Texture& reference, const Texture& test,
                                             const std::vector<std::uint32_t>& different) {
  // The shift with which most of some differing pixels are right.
  const std::size_t step = std::max<std::size_t>(1, different.size() / 300);
  std::size_t most = 0;
  glm::ivec2 best(0);
  for (int dy = -max_shift; dy <= max_shift; ++dy) {
    for (int dx = -max_shift; dx <= max_shift; ++dx) {
      std::size_t right = 0;
      for (std::size_t i = 0; i < different.size(); i += step) {
        const int x = static_cast<int>(different[i]) % test.width;
        const int y = static_cast<int>(different[i]) / test.width;
        const dvec3 copy = color_of_copy(reference, {dvec2(1), dvec2(dx, dy)}, x, y);
        right += largest_of(glm::abs(copy - at(test, x, y))) <= 3 ? 1 : 0;
      }
      if (right > most) {
        most = right;
        best = {dx, dy};
      }
    }
  }
  // A shift of a few pixels is certain even if the edges are drawn with other samples.
  const bool exactly = std::max(std::abs(best.x), std::abs(best.y)) < 3;
  if (best == glm::ivec2(0) || !is_copy(reference, test, {dvec2(1), dvec2(best)}, exactly) ||
      !same_everywhere(reference, test, best)) {
    return std::nullopt;
  }
  const auto by = [](int pixels, const char* less, const char* more) {
    return fmt::format("{} {}", counted(static_cast<std::size_t>(std::abs(pixels)), "pixel"),
                       pixels < 0 ? less : more);
  };
  std::string what = "the picture is shifted by ";
  what += best.x != 0 ? by(best.x, "to the left", "to the right") : std::string();
  what += best.x != 0 && best.y != 0 ? " and " : "";
  what += best.y != 0 ? by(best.y, "up", "down") : std::string();
  return placed_copy(std::move(what), reference, {dvec2(1), dvec2(best)});
}

}  // namespace

std::optional<Claim> find_turned(const Texture& reference, const Texture& test) {
  if (test.width != reference.height || test.height != reference.width) {
    return std::nullopt;
  }
  std::optional<Claim> found;
  for (const auto& [what, color_at] : turns_of(reference)) {
    Share right;
    for (int y = 0; y < test.height; ++y) {
      for (int x = 0; x < test.width; ++x) {
        const dvec3 copy = color_at(x, y);
        const dvec3 color = at(test, x, y);
        if (largest_of(copy) > right_within || largest_of(color) > right_within) {
          right.add(largest_of(glm::abs(copy - color)) <= exact_within);
        }
      }
    }
    if (right.all >= 4 * few_pixels && right.value() >= nearly_all_of_copy) {
      if (found) {
        return std::nullopt;  // such as a plain color, which fits every turn
      }
      found = placed_copy(what, color_at).claim;
    }
  }
  return found;
}

std::optional<PlacedCopy> find_placed_copy(const Texture& reference, const Texture& test,
                                           const std::vector<std::uint32_t>& different) {
  const dvec2 size(test.width, test.height);
  if (static_cast<double>(different.size()) < min_share_moved * size.x * size.y) {
    return std::nullopt;
  }
  if (std::optional<PlacedCopy> order = find_order(reference, test)) {
    return order;
  }
  for (const bool right : {false, true}) {
    for (const bool low : {false, true}) {
      const dvec2 corner(right ? size.x : 0, low ? size.y : 0);
      const CopyPlace place{dvec2(2), -corner};
      if (is_copy(reference, test, place, false)) {
        return placed_copy(
            fmt::format("only the {} quarter of the picture is shown, twice as large",
                        corner_word(right, low)),
            reference, place);
      }
    }
  }
  const std::optional<ContentBox> of_reference = content_of(reference);
  const std::optional<ContentBox> of_test = content_of(test);
  if (of_reference && of_test) {
    CopyPlace place;
    place.scale =
        dvec2(of_test->high - of_test->low) / dvec2(of_reference->high - of_reference->low);
    place.offset = dvec2(of_test->low) - place.scale * dvec2(of_reference->low);
    const dvec2 drawn = place.scale * size;
    const dvec2 middle = place.offset + drawn / 2.0 - size / 2.0;
    const int touching = (of_reference->low.x == 0) + (of_reference->low.y == 0) +
                         (of_reference->high.x == test.width) +
                         (of_reference->high.y == test.height);
    const double off_center = std::max(std::abs(middle.x), std::abs(middle.y));
    const bool left = std::abs(place.offset.x) <= 2;
    const bool up = std::abs(place.offset.y) <= 2;
    const bool right = std::abs(place.offset.x + drawn.x - size.x) <= 2;
    const bool low = std::abs(place.offset.y + drawn.y - size.y) <= 2;
    const bool cornered = (left || right) && (up || low);
    // A single object may be smaller for another reason: the edges of the frame must be visible.
    if (std::max(place.scale.x, place.scale.y) < 0.97 && off_center > 2 &&
        (cornered || touching >= 2) && is_copy(reference, test, place, false)) {
      const std::string pixels = fmt::format("{:.0f}x{:.0f}", drawn.x, drawn.y);
      return placed_copy(cornered
                             ? fmt::format("the picture fills only {} pixels in the {} corner",
                                           pixels, corner_word(!left, !up))
                             : fmt::format("the picture fills only {} pixels, from {:.0f},{:.0f}",
                                           pixels, place.offset.x, place.offset.y),
                         reference, place);
    }
  }
  return find_shift_of_copy(reference, test, different);
}

}  // namespace scenefile
