#include "scenefile/grade/reordered.h"

#include "scenefile/grade/evidence.h"
#include "scenefile/grade/placed_copy.h"
#include "scenefile/mistakes/hypotheses.h"

#include <array>
#include <cmath>
#include <functional>
#include <utility>

namespace scenefile {

namespace {

using glm::ivec2;

// Where the pixel of a picture is stored.
using StoredAt = std::function<ivec2(int x, int y)>;

Texture with_places(const Texture& test, const StoredAt& place) {
  Texture picture = test;
  for (int y = 0; y < test.height; ++y) {
    for (int x = 0; x < test.width; ++x) {
      const ivec2 from = place(x, y);
      const std::size_t to = 3 * (std::size_t(y) * std::size_t(test.width) + std::size_t(x));
      for (std::size_t c = 0; c < 3; ++c) {
        picture.rgb[to + c] = test.texel(from.x, from.y)[c];
      }
    }
  }
  return picture;
}

// The channel that each channel of the changed colors has; nullopt if the change is another one.
std::optional<std::array<int, 3>> order_of_channels(
    const std::function<glm::dvec3(const glm::dvec3&)>& change) {
  const glm::dvec3 before(0.25, 0.5, 0.75);
  const glm::dvec3 after = change(before);
  std::array<int, 3> order{};
  std::array<bool, 3> taken{};
  for (int c = 0; c < 3; ++c) {
    for (int from = 0; from < 3; ++from) {
      if (after[c] == before[from]) {
        order[std::size_t(c)] = from;
        taken[std::size_t(from)] = true;
      }
    }
  }
  return taken[0] && taken[1] && taken[2] ? std::optional(order) : std::nullopt;
}

// `order`: the channel of the right picture that each of the test has.
Texture with_channels(const Texture& test, const std::array<int, 3>& order) {
  Texture picture = test;
  for (std::size_t i = 0; i < test.rgb.size(); i += 3) {
    for (std::size_t c = 0; c < 3; ++c) {
      picture.rgb[i + std::size_t(order[c])] = test.rgb[i + c];
    }
  }
  return picture;
}

// The sum of the steps between neighboring pixels.
double roughness(const Texture& t) {
  double sum = 0;
  for (int y = 1; y < t.height; ++y) {
    for (int x = 1; x < t.width; ++x) {
      for (int c = 0; c < 3; ++c) {
        sum += std::abs(int{t.texel(x, y)[c]} - t.texel(x - 1, y)[c]) +
               std::abs(int{t.texel(x, y)[c]} - t.texel(x, y - 1)[c]);
      }
    }
  }
  return sum;
}

// The correlation of values, or of the differences of the channels from their mean.
double likeness(const Texture& a, const Texture& b, bool of_hues) {
  constexpr std::size_t max_pixels = 20000;
  const std::size_t pixels = a.rgb.size() / 3;
  const std::size_t step = std::max<std::size_t>(1, pixels / max_pixels);
  Correlation correlation;
  for (std::size_t i = 0; i < pixels; i += step) {
    const std::uint8_t* p = &a.rgb[3 * i];
    const std::uint8_t* q = &b.rgb[3 * i];
    const double mean_p = of_hues ? (p[0] + p[1] + p[2]) / 3.0 : 0;
    const double mean_q = of_hues ? (q[0] + q[1] + q[2]) / 3.0 : 0;
    for (int c = 0; c < 3; ++c) {
      correlation.add(p[c] - mean_p, q[c] - mean_q);
    }
  }
  return correlation.value();
}

}  // namespace

std::optional<Reordered> in_right_order(const Texture& test) {
  constexpr double clearly_less = 0.7;
  const int width = test.width;
  const int height = test.height;
  const double now = roughness(test);
  const auto at_index = [&](int i) { return ivec2(i % width, i / width); };
  Texture stored = with_places(test, [&](int x, int y) { return at_index(x * height + y); });
  if (roughness(stored) < clearly_less * now) {
    return Reordered{{Cause::viewport, stored_by_columns, {}, 1}, std::move(stored)};
  }
  Texture read = with_places(test, [&](int x, int y) {
    const int i = y * width + x;
    return ivec2(i / height, i % height);
  });
  if (roughness(read) < clearly_less * now) {
    return Reordered{{Cause::viewport, read_by_columns, {}, 1}, std::move(read)};
  }
  return std::nullopt;
}

std::optional<Reordered> in_likelier_order(const Texture& reference, const Texture& test) {
  constexpr double much = 0.4;  // of a correlation
  constexpr double unlike = 0.25;
  constexpr double like = 0.75;
  std::optional<Reordered> best;
  double most = 0;
  const auto try_picture = [&](const Hypothesis& change, Texture picture, bool of_hues) {
    const double likeness_now = likeness(reference, picture, of_hues);
    if (likeness_now > most) {
      most = likeness_now;
      best = {{change.cause, change.what, {}, 1}, std::move(picture), likeness_now >= like};
    }
  };
  const std::vector<Hypothesis> changes = picture_hypotheses();
  for (const bool of_hues : {false, true}) {
    // A negative is unlike the reference, too.
    const double before = std::max(0.0, likeness(reference, test, of_hues));
    most = before + much;
    for (const Hypothesis& h : changes) {
      if (!of_hues && h.turn != Turn()) {
        const auto place = [&](int x, int y) {
          return ivec2(h.turn.across ? test.width - 1 - x : x,
                       h.turn.down ? test.height - 1 - y : y);
        };
        try_picture(h, with_places(test, place), of_hues);
      }
      const auto order = of_hues && h.color ? order_of_channels(h.color) : std::nullopt;
      if (order && *order != std::array{0, 1, 2}) {
        try_picture(h, with_channels(test, *order), of_hues);
      }
    }
    if (best) {
      // Hues also change where textures or lights are missing.
      best->sure = best->sure && before <= unlike && !of_hues;
      return best;
    }
  }
  return std::nullopt;
}

}  // namespace scenefile
