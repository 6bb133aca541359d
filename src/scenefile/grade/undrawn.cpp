#include "scenefile/grade/undrawn.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <utility>
#include <vector>

namespace scenefile {

namespace {

constexpr int off_by = 8;                   // a larger difference is visible
constexpr double nearly_all_pixels = 0.9;   // of those that differ
constexpr double min_undrawn_share = 0.01;  // of the picture
constexpr std::size_t min_at_cut = 8;       // pixels where the reference continues beyond the cut
constexpr double nearly_all_of_grid = 0.98;
constexpr std::size_t min_in_grid = 32;

using Bytes = std::array<int, 3>;

Bytes bytes_at(const Texture& t, int x, int y) {
  const std::uint8_t* p = t.texel(x, y);
  return {p[0], p[1], p[2]};
}

int largest_step(const Bytes& a, const Bytes& b) {
  return std::max({std::abs(a[0] - b[0]), std::abs(a[1] - b[1]), std::abs(a[2] - b[2])});
}

// Columns and rows from (x0, y0) up to, but not including, (x1, y1).
struct Box {
  int x0, y0, x1, y1;
};

struct Undrawn {
  const Texture& reference;
  const Texture& test;
  Bytes empty{};                        // the color where nothing is drawn
  std::vector<std::uint8_t> differs{};  // by pixel
  std::size_t count = 0;                // of those that differ

  bool blank(int x, int y) const { return largest_step(bytes_at(test, x, y), empty) <= 2; }
  bool shown(int x, int y) const { return largest_step(bytes_at(reference, x, y), empty) > off_by; }
  bool differs_at(int x, int y) const {
    return differs[std::size_t(y) * std::size_t(test.width) + std::size_t(x)] != 0;
  }

  bool blank(const Box& box) const {
    std::size_t other = 0;
    for (int y = box.y0; y < box.y1; ++y) {
      for (int x = box.x0; x < box.x1; ++x) {
        other += blank(x, y) ? 0 : 1;
      }
    }
    return other == 0;
  }

  std::size_t count_in(const Box& box) const {
    std::size_t sum = 0;
    for (int y = box.y0; y < box.y1; ++y) {
      for (int x = box.x0; x < box.x1; ++x) {
        sum += differs_at(x, y) ? 1 : 0;
      }
    }
    return sum;
  }

  // Whether the reference continues from one pixel to the other, while the test stops between them.
  bool cut(int x, int y, int u, int v) const {
    return shown(x, y) && shown(u, v) && !blank(u, v) &&
           largest_step(bytes_at(reference, x, y), bytes_at(reference, u, v)) <= 2 * off_by;
  }
};

// Whether nothing is drawn where the color is seen: it is black, or the reference has it, too.
bool is_background(const Texture& reference, const Bytes& color) {
  std::size_t same = 0;
  for (int y = 0; y < reference.height; ++y) {
    for (int x = 0; x < reference.width; ++x) {
      same += largest_step(bytes_at(reference, x, y), color) <= 2 ? 1 : 0;
    }
  }
  return largest_step(color, {0, 0, 0}) <= 2 ||
         static_cast<double>(same) >= min_undrawn_share * reference.width * reference.height;
}

// The color that nearly all differing pixels have; false if there is none.
bool find_empty_color(const std::vector<std::uint32_t>& different, Undrawn& u) {
  const auto color_at = [&](std::uint32_t i) {
    const auto width = static_cast<std::uint32_t>(u.test.width);
    return bytes_at(u.test, static_cast<int>(i % width), static_cast<int>(i / width));
  };
  std::ptrdiff_t votes = 0;  // the color of a majority wins the vote
  u.differs.assign(u.test.rgb.size() / 3, 0);
  for (const std::uint32_t i : different) {
    u.differs[i] = 1;
    ++u.count;
    const Bytes color = color_at(i);
    u.empty = votes == 0 ? color : u.empty;
    votes += color == u.empty ? 1 : -1;
  }
  if (u.count < min_at_cut) {
    return false;
  }
  const auto most = std::count_if(different.begin(), different.end(),
                                  [&](std::uint32_t i) { return color_at(i) == u.empty; });
  return static_cast<double>(most) >= nearly_all_pixels * static_cast<double>(u.count);
}

// Whether what is drawn equals the reference at its place. Otherwise, the picture is not a part of
// the reference: it may show the scene smaller, for example.
bool rest_is_right(const Undrawn& u) {
  std::size_t drawn = 0;
  std::size_t wrong = 0;
  for (int y = 0; y < u.test.height; ++y) {
    for (int x = 0; x < u.test.width; ++x) {
      if (!u.blank(x, y)) {
        ++drawn;
        wrong += u.differs_at(x, y) ? 1 : 0;
      }
    }
  }
  return static_cast<double>(wrong) <= (1 - nearly_all_pixels) * static_cast<double>(drawn);
}

// "rows 120 to 239 of 240 are not drawn", "every second row is not drawn". `gaps`: the lines where
// the reference shows something; `missing`: by line, whether the test shows nothing.
std::string gaps_text(const std::vector<int>& gaps, const std::vector<bool>& missing,
                      const char* line) {
  const auto lines = static_cast<int>(missing.size());
  const auto all_missing = [&](int from, int to) {
    return std::all_of(missing.begin() + from, missing.begin() + to, [](bool m) { return m; });
  };
  const int first = all_missing(0, gaps.front()) ? 0 : gaps.front();
  const int end = all_missing(gaps.back(), lines) ? lines : gaps.back() + 1;
  if (all_missing(first, end)) {
    return end - first == 1
               ? fmt::format("{} {} of {} is not drawn", line, first, lines)
               : fmt::format("{}s {} to {} of {} are not drawn", line, first, end - 1, lines);
  }
  const int step = gaps[1] - gaps[0];
  std::size_t regular = 0;
  for (std::size_t i = 1; i < gaps.size(); ++i) {
    regular += gaps[i] - gaps[i - 1] == step ? 1 : 0;
  }
  if (step > 1 && gaps.size() > 4 && 10 * (regular + 1) >= 9 * gaps.size()) {
    return step == 2 ? fmt::format("every second {} is not drawn", line)
                     : fmt::format("one {} in {} is not drawn", line, step);
  }
  return fmt::format("{} of {} {}s are not drawn", gaps.size(), lines, line);
}

// Whole rows, or whole columns.
std::string missing_lines(const Undrawn& u, bool rows) {
  const int lines = rows ? u.test.height : u.test.width;
  const int length = rows ? u.test.width : u.test.height;
  std::vector<bool> missing(static_cast<std::size_t>(lines));
  std::vector<int> gaps;
  std::size_t covered = 0;
  for (int i = 0; i < lines; ++i) {
    const Box line = rows ? Box{0, i, length, i + 1} : Box{i, 0, i + 1, length};
    missing[static_cast<std::size_t>(i)] = u.blank(line);
    const std::size_t differing = u.count_in(line);
    if (differing > 0 && missing[static_cast<std::size_t>(i)]) {
      gaps.push_back(i);
      covered += differing;
    }
  }
  // The other lines must show what the reference shows: a picture may be dark for another reason.
  std::size_t shown = 0;
  for (int i = 0; i < lines; ++i) {
    for (int k = 0; k < length && !missing[static_cast<std::size_t>(i)]; ++k) {
      shown += (rows ? u.shown(k, i) : u.shown(i, k)) ? 1 : 0;
    }
  }
  if (gaps.empty() ||
      static_cast<double>(covered) < nearly_all_pixels * static_cast<double>(u.count) ||
      static_cast<double>(u.count - covered) >
          (1 - nearly_all_pixels) * static_cast<double>(shown)) {
    return {};
  }
  std::size_t cuts = 0;
  for (const int i : gaps) {
    for (const int other : {i - 1, i + 1}) {
      if (other < 0 || other >= lines || missing[static_cast<std::size_t>(other)]) {
        continue;
      }
      for (int k = 0; k < length; ++k) {
        cuts += (rows ? u.cut(k, i, k, other) : u.cut(i, k, other, k)) ? 1 : 0;
      }
    }
  }
  return cuts < std::max(min_at_cut, static_cast<std::size_t>(length) / 20)
             ? std::string()
             : gaps_text(gaps, missing, rows ? "row" : "column");
}

// From the first line to one past the last line that has at least a quarter as many pixels as the
// fullest line.
std::pair<int, int> full_lines(const std::vector<std::size_t>& pixels) {
  const std::size_t most = *std::max_element(pixels.begin(), pixels.end());
  const auto full = [most](std::size_t count) { return 4 * count >= most; };
  const auto first = std::find_if(pixels.begin(), pixels.end(), full);
  const auto last = std::find_if(pixels.rbegin(), pixels.rend(), full);
  return {static_cast<int>(first - pixels.begin()), static_cast<int>(pixels.rend() - last)};
}

// A rectangle.
std::string missing_box(const Undrawn& u) {
  std::vector<std::size_t> in_row(static_cast<std::size_t>(u.test.height));
  std::vector<std::size_t> in_column(static_cast<std::size_t>(u.test.width));
  for (int y = 0; y < u.test.height; ++y) {
    for (int x = 0; x < u.test.width; ++x) {
      if (u.differs_at(x, y) && u.blank(x, y)) {
        ++in_row[static_cast<std::size_t>(y)];
        ++in_column[static_cast<std::size_t>(x)];
      }
    }
  }
  const auto [y0, y1] = full_lines(in_row);
  const auto [x0, x1] = full_lines(in_column);
  const Box box{x0, y0, x1, y1};
  if (!u.blank(box) ||
      static_cast<double>(u.count_in(box)) < nearly_all_pixels * static_cast<double>(u.count)) {
    return {};
  }
  // The edge of an object is not a cut: each side must cut through something that the reference
  // shows.
  const auto side = [&](bool inside, int length, const auto& cut_at) {
    std::size_t cuts = 0;
    for (int k = 0; inside && k < length; ++k) {
      cuts += cut_at(k) ? 1 : 0;
    }
    return !inside || cuts >= std::max(min_at_cut, static_cast<std::size_t>(length) / 5);
  };
  const int across = box.x1 - box.x0;
  const int down = box.y1 - box.y0;
  const bool all_cut =
      side(box.y0 > 0, across,
           [&](int k) { return u.cut(box.x0 + k, box.y0, box.x0 + k, box.y0 - 1); }) &&
      side(box.y1 < u.test.height, across,
           [&](int k) { return u.cut(box.x0 + k, box.y1 - 1, box.x0 + k, box.y1); }) &&
      side(box.x0 > 0, down,
           [&](int k) { return u.cut(box.x0, box.y0 + k, box.x0 - 1, box.y0 + k); }) &&
      side(box.x1 < u.test.width, down,
           [&](int k) { return u.cut(box.x1 - 1, box.y0 + k, box.x1, box.y0 + k); });
  return all_cut ? fmt::format("the rectangle from {},{} to {},{} is not drawn", box.x0, box.y0,
                               box.x1 - 1, box.y1 - 1)
                 : std::string();
}

// Pixels at even or odd places, such as those of a checkerboard.
std::string missing_grid(const Undrawn& u) {
  std::array<std::size_t, 4> shown{};
  std::array<std::size_t, 4> missing{};
  for (int y = 0; y < u.test.height; ++y) {
    for (int x = 0; x < u.test.width; ++x) {
      const auto place = static_cast<std::size_t>(2 * (y % 2) + x % 2);
      if (u.shown(x, y)) {
        ++shown[place];
        missing[place] += u.blank(x, y) ? 1 : 0;
      }
    }
  }
  int places = 0;
  for (std::size_t i = 0; i < shown.size(); ++i) {
    const double share = static_cast<double>(missing[i]) / static_cast<double>(shown[i]);
    if (shown[i] < min_in_grid || (share > 1 - nearly_all_of_grid && share < nearly_all_of_grid)) {
      return {};
    }
    places += share >= nearly_all_of_grid ? 1 : 0;
  }
  switch (places) {
    case 1:
      return "one pixel in four is not drawn";
    case 2:
      return "every second pixel is not drawn";
    case 3:
      return "only one pixel in four is drawn";
    default:
      return {};
  }
}

std::size_t other_pixels(const Texture& picture, const Bytes& color) {
  std::size_t others = 0;
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      others += largest_step(bytes_at(picture, x, y), color) > 2 ? 1 : 0;
    }
  }
  return others;
}

// The test has a single color, such as black, and the reference does not.
std::optional<Claim> claim_of_one_color(const Texture& reference, const Texture& test) {
  const std::optional<glm::ivec3> only = only_color(test);
  if (!only) {
    return std::nullopt;
  }
  const Bytes color{only->x, only->y, only->z};
  std::size_t shown = 0;
  for (int y = 0; y < test.height; ++y) {
    for (int x = 0; x < test.width; ++x) {
      shown += largest_step(bytes_at(reference, x, y), color) > off_by ? 1 : 0;
    }
  }
  if (static_cast<double>(shown) < 0.005 * test.width * test.height) {
    return std::nullopt;
  }
  const std::size_t others = other_pixels(test, color);
  if (shown < 20 * others) {
    return std::nullopt;
  }
  const bool black = std::max({only->x, only->y, only->z}) <= 2;
  const std::string but = others == 0 ? "" : fmt::format(" but for {} pixels", others);
  return Claim{Cause::black,
               black ? "the picture is black" + but
                     : fmt::format("the whole picture{} shows one color, {} {} {}", but, only->x,
                                   only->y, only->z),
               black
                   ? fmt::format("all pixels{} are black, but the reference shows something", but)
                   : fmt::format("all pixels{} are equal, and those of the reference are not", but),
               1};
}

}  // namespace

std::optional<glm::ivec3> only_color(const Texture& picture) {
  const Bytes only = bytes_at(picture, picture.width / 2, picture.height / 2);
  constexpr double max_others = 0.002;
  return static_cast<double>(other_pixels(picture, only)) >
                 max_others * picture.width * picture.height
             ? std::nullopt
             : std::optional(glm::ivec3(only[0], only[1], only[2]));
}

std::optional<Claim> claim_of_undrawn_part(const Texture& reference, const Texture& test,
                                           const std::vector<std::uint32_t>& different) {
  if (std::optional<Claim> one_color = claim_of_one_color(reference, test)) {
    return one_color;
  }
  Undrawn u{reference, test};
  if (!find_empty_color(different, u)) {
    return std::nullopt;
  }
  if (!is_background(reference, u.empty) || !rest_is_right(u)) {
    return std::nullopt;
  }
  std::string what = missing_lines(u, true);
  what = what.empty() ? missing_lines(u, false) : what;
  // A single line is exact; a small rectangle may be an object.
  if (what.empty() &&
      static_cast<double>(u.count) >= min_undrawn_share * static_cast<double>(u.differs.size())) {
    what = missing_box(u);
    what = what.empty() ? missing_grid(u) : what;
  }
  if (what.empty()) {
    return std::nullopt;
  }
  std::size_t blank = 0;
  for (int y = 0; y < test.height; ++y) {
    for (int x = 0; x < test.width; ++x) {
      blank += u.differs_at(x, y) && u.blank(x, y) ? 1 : 0;
    }
  }
  const double share = static_cast<double>(blank) / static_cast<double>(u.count);
  return Claim{Cause::black, std::move(what),
               fmt::format("{:.0f} % of the pixels that differ are there, all of them {} {} {}",
                           100 * share, u.empty[0], u.empty[1], u.empty[2]),
               share};
}

}  // namespace scenefile
