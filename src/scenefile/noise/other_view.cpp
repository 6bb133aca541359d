#include "scenefile/noise/other_view.h"

#include <algorithm>
#include <cmath>

namespace scenefile {

LinearPicture with_right_view(const PathTruth& truth, const LinearPicture& picture,
                              const ViewScale& scale) {
  LinearPicture result = picture;
  // The nearest pixel: a mean of pixels would have less noise than the others.
  const auto place = [](int at, int size, double by) {
    return static_cast<int>(std::floor(size / 2.0 + by * (at + 0.5 - size / 2.0)));
  };
  for (int y = 0; y < truth.height; ++y) {
    for (int x = 0; x < truth.width; ++x) {
      const std::size_t to = std::size_t(y) * truth.width + x;
      const int i = place(x, truth.width, scale.across);
      const int j = place(y, truth.height, scale.down);
      if (i < 0 || j < 0 || i >= truth.width || j >= truth.height) {
        result.usable[to] = 0;
        continue;
      }
      const std::size_t from = std::size_t(j) * truth.width + i;
      result.pixels[to] = picture.pixels[from];
      result.rounding[to] = picture.rounding[from];
      result.usable[to] = picture.usable[from];
    }
  }
  return result;
}

ViewScale fitted_view(const TruthBlocks& back, const Reading& reading) {
  ViewScale best;
  double least = 1e300;
  const auto attempt = [&](const ViewScale& scale) {
    const Reading other =
        read_again(back, reading, with_right_view(back.truth, reading.picture, scale));
    const double cost = other.right.chi2 / other.values();
    // Of fewer blocks, the mean could be small by chance.
    if (2 * other.seen.tested > reading.seen.tested && cost < least) {
      least = cost;
      best = scale;
    }
  };
  const auto attempt_near = [&](const ViewScale& middle, double step, int steps, bool across,
                                bool down) {
    for (int i = -steps; i <= steps; ++i) {
      const double by = std::exp(step * i);
      attempt({across ? middle.across * by : middle.across, down ? middle.down * by : middle.down});
    }
  };
  // Steps of a pixel at the border of pictures of 100 pixels, then of an eighth of it, as edges
  // count that much; from a third to three times as large.
  constexpr double coarse = 0.02;
  constexpr int reach = 55;
  for (const auto& [across, down] : {std::pair{true, true}, {true, false}, {false, true}}) {
    attempt_near({}, coarse, reach, across, down);
  }
  const ViewScale found = best;
  const bool across = found.across != 1;
  const bool down = found.down != 1;
  attempt_near(found, coarse / 8, 8, across || !down, down || !across);
  return best;
}

}  // namespace scenefile
