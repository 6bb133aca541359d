#include "scenefile/grade/claims.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>

namespace scenefile {

std::string percent(double share) {
  return fmt::format("{:.0f} %", 100 * share);
}

std::string evidence_of_one(double left, double before, double exact) {
  return fmt::format(
      "simulating this mistake reduces the mean difference from {:.3f}/255 to {:.3f}/255 "
      "(not counting edges and rounding) and reproduces {} of the differing pixels",
      before, left, percent(exact));
}

std::string evidence_of_several(double together, double by_itself) {
  return fmt::format("together they explain {} of the difference; by itself {}", percent(together),
                     percent(std::max(0.0, by_itself)));
}

std::string evidence_of_share(double explained) {
  return fmt::format("simulating this mistake explains {} of the difference", percent(explained));
}

std::optional<Claim> claim_of_one_color(const Texture& reference, const Texture& test) {
  const auto color = [](const Texture& t, std::size_t pixel) {
    return std::array<int, 3>{t.rgb[3 * pixel], t.rgb[3 * pixel + 1], t.rgb[3 * pixel + 2]};
  };
  const std::size_t pixels = test.rgb.size() / 3;
  const std::array<int, 3> only = color(test, pixels / 2);
  const auto off = [&](const std::array<int, 3>& c) {
    return std::max({std::abs(c[0] - only[0]), std::abs(c[1] - only[1]), std::abs(c[2] - only[2])});
  };
  std::size_t same = 0;
  std::size_t drawn = 0;
  for (std::size_t i = 0; i < pixels; ++i) {
    same += off(color(test, i)) <= 2 ? 1 : 0;
    drawn += off(color(reference, i)) > 8 ? 1 : 0;
  }
  const auto all = static_cast<double>(pixels);
  if (static_cast<double>(same) < 0.9995 * all || static_cast<double>(drawn) < 0.005 * all) {
    return std::nullopt;
  }
  const bool black = *std::max_element(only.begin(), only.end()) <= 2;
  return Claim{Cause::black,
               black ? "the picture is black: nothing is drawn"
                     : fmt::format("the picture has one color, {} {} {}: nothing is drawn", only[0],
                                   only[1], only[2]),
               black ? "all pixels are black, and the reference shows something"
                     : "all pixels are equal, and the reference shows something",
               1};
}

}  // namespace scenefile
