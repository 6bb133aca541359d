#include "scenefile/grade/evidence.h"

#include "scenefile/grade/causes.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

namespace scenefile {

using glm::dvec3;

namespace {

constexpr double worst = 64;         // larger errors count as this
constexpr int small_difference = 4;  // other arithmetic may cause it

}  // namespace

Range around(const Texture& t, int x, int y) {
  std::array<std::uint8_t, 3> low{255, 255, 255};
  std::array<std::uint8_t, 3> high{0, 0, 0};
  const int right = std::min(x + 1, t.width - 1);
  for (int v = std::max(y - 1, 0); v <= std::min(y + 1, t.height - 1); ++v) {
    const std::uint8_t* p = t.texel(std::max(x - 1, 0), v);
    for (int u = std::max(x - 1, 0); u <= right; ++u, p += 3) {
      for (int c = 0; c < 3; ++c) {
        low[c] = std::min(low[c], p[c]);
        high[c] = std::max(high[c], p[c]);
      }
    }
  }
  return {dvec3(low[0], low[1], low[2]), dvec3(high[0], high[1], high[2])};
}

double off_beyond_edges(const Texture& a, const Texture& b, int x, int y) {
  const Range of_a = around(a, x, y);
  const Range of_b = around(b, x, y);
  return std::max(largest_of(outside(at(a, x, y), of_b.low, of_b.high)),
                  largest_of(outside(at(b, x, y), of_a.low, of_a.high)));
}

Score score(const std::vector<Point>& points, std::size_t count, const Colors& colors) {
  Score s;
  for (std::size_t i = 0; i < count; ++i) {
    const Point& p = points[i];
    const dvec3 c = glm::clamp(colors[i], dvec3(0), dvec3(255));
    const dvec3 off = outside(c, p.low, p.high);
    s.left += p.weight * (std::min(off.x, worst) + std::min(off.y, worst) + std::min(off.z, worst));
    const dvec3 d = glm::abs(c - p.test);
    s.raw += p.weight * (std::min(d.x, worst) + std::min(d.y, worst) + std::min(d.z, worst));
    const double most = largest_of(off);
    if (p.differs) {
      s.exact += most <= exact_within - tolerance ? p.weight : 0;
    } else {
      s.broken += most > right_within ? p.weight : 0;
    }
  }
  return s;
}

void Correlation::add(double x, double y) {
  n_ += 1;
  x_ += x;
  y_ += y;
  xx_ += x * x;
  yy_ += y * y;
  xy_ += x * y;
}

double Correlation::value() const {
  const double spread = (n_ * xx_ - x_ * x_) * (n_ * yy_ - y_ * y_);
  return spread > 0 ? (n_ * xy_ - x_ * y_) / std::sqrt(spread) : 0;
}

void add_points(const Texture& reference, const Texture& test, std::vector<std::uint32_t> pixels,
                std::size_t count, bool differs, bool strict, std::mt19937& random,
                std::vector<Point>& points, const std::vector<float>& noise) {
  const std::size_t all = pixels.size();
  count = std::min(count, all);
  for (std::size_t i = 0; i < count; ++i) {
    std::swap(pixels[i], pixels[i + random() % (all - i)]);
    Point p;
    p.x = static_cast<int>(pixels[i] % static_cast<std::uint32_t>(test.width));
    p.y = static_cast<int>(pixels[i] / static_cast<std::uint32_t>(test.width));
    p.test = at(test, p.x, p.y);
    const Range of_test = around(test, p.x, p.y);
    const Range of_reference = around(reference, p.x, p.y);
    const dvec3 r = at(reference, p.x, p.y);
    // At edges of the reference, any color in the neighborhood counts as equal, so that small
    // shifts of edges do not matter.
    const bool exactly =
        strict || (of_reference.calm() && (differs || of_test.calm())) ||
        (differs && largest_of(outside(r, of_test.low, of_test.high)) <= 2 * tolerance);
    p.noise = noise.empty() ? 0 : double{noise[pixels[i]]};
    p.low = (exactly ? p.test : of_test.low) - tolerance - p.noise;
    p.high = (exactly ? p.test : of_test.high) + tolerance + p.noise;
    p.weight = static_cast<double>(all) / static_cast<double>(count);
    p.differs = differs;
    points.push_back(p);
  }
}

std::vector<Point> alternating(const std::vector<Point>& a, const std::vector<Point>& b) {
  std::vector<Point> both;
  for (std::size_t i = 0; i < std::max(a.size(), b.size()); ++i) {
    if (i < a.size()) {
      both.push_back(a[i]);
    }
    if (i < b.size()) {
      both.push_back(b[i]);
    }
  }
  return both;
}

void add_differing_points(const Texture& reference, const Texture& test,
                          const std::vector<std::uint32_t>& pixels, std::size_t count,
                          std::mt19937& random, std::vector<Point>& points,
                          const std::vector<float>& noise) {
  std::vector<std::uint32_t> dark;
  std::vector<std::uint32_t> bright;
  for (const std::uint32_t i : pixels) {
    const std::uint8_t* p = &test.rgb[std::size_t{3} * i];
    (std::max({p[0], p[1], p[2]}) <= dark_up_to ? dark : bright).push_back(i);
  }
  if (bright.size() < 2 * few_pixels || bright.size() >= dark.size()) {
    add_points(reference, test, pixels, count, true, false, random, points, noise);
    return;
  }
  std::vector<Point> of_dark;
  std::vector<Point> of_bright;
  add_points(reference, test, dark, count / 2, true, false, random, of_dark, noise);
  add_points(reference, test, bright, count / 2, true, false, random, of_bright, noise);
  const double half = double(pixels.size()) / 2;
  for (Point& p : of_dark) {
    p.weight *= half / double(dark.size());
  }
  for (Point& p : of_bright) {
    p.weight *= half / double(bright.size());
  }
  const std::vector<Point> both = alternating(of_dark, of_bright);
  points.insert(points.end(), both.begin(), both.end());
}

bool only_details(const Pixels& pixels, const Texture& test) {
  const auto width = static_cast<std::uint32_t>(test.width);
  // Whether all of 3x3 pixels are among these, which are in ascending order.
  const auto fill_a_square = [&](const std::vector<std::uint32_t>& all) {
    // Whether three pixels in a row are, from this one on.
    const auto three = [&](std::uint32_t first) {
      const auto at = std::lower_bound(all.begin(), all.end(), first);
      return all.end() - at > 2 && at[0] == first && at[2] == first + 2 &&
             first % width + 2 < width;
    };
    return std::any_of(all.begin(), all.end(), [&](std::uint32_t first) {
      return three(first) && three(first + width) && three(first + 2 * width);
    });
  };
  return double(pixels.different.size()) <= max_share_same * test.width * test.height &&
         !fill_a_square(pixels.different) && !fill_a_square(pixels.off);
}

std::string words_of_details(const Texture& reference, const Texture& test) {
  constexpr double nearly_all = 0.9;
  std::array<std::size_t, small_difference + 1> pixels{};  // by their difference, but for edges
  std::size_t higher = 0;
  std::size_t lower = 0;
  double sum = 0;
  for (int y = 0; y < test.height; ++y) {
    for (int x = 0; x < test.width; ++x) {
      const dvec3 d = at(test, x, y) - at(reference, x, y);
      const double most = largest_of(glm::abs(d));
      if (most <= small_difference) {
        const double off = most > 1 ? off_beyond_edges(reference, test, x, y) : most;
        ++pixels[static_cast<std::size_t>(off)];
        sum += d.x + d.y + d.z;
        for (const double value : {d.x, d.y, d.z}) {
          higher += value > 0 ? 1 : 0;
          lower += value < 0 ? 1 : 0;
        }
      }
    }
  }
  // A few pixels may be at edges that the neighbors do not show.
  const double all = double(test.width) * test.height;
  double left = 0;
  int largest = small_difference;
  while (largest > 1 && left + double(pixels[largest]) <= max_share_same * all) {
    left += double(pixels[largest--]);
  }
  const double values = 3 * all;
  const bool shifted = double(std::max(higher, lower)) >= nearly_all * values;
  if (largest == 1 && !shifted) {
    return "at edges and by rounding";
  }
  return fmt::format("at edges, and by up to {}/255 elsewhere{}", largest,
                     shifted
                         ? fmt::format("; nearly all values are {}, on average by {:.1f}/255",
                                       higher > lower ? "higher" : "lower", std::abs(sum) / values)
                         : "");
}

Pixels sorted_pixels(const Texture& reference, const Texture& test,
                     const std::vector<float>& noise) {
  Pixels pixels;
  for (int y = 0; y < test.height; ++y) {
    for (int x = 0; x < test.width; ++x) {
      const std::uint8_t* r = reference.texel(x, y);
      const std::uint8_t* t = test.texel(x, y);
      const auto index = static_cast<std::uint32_t>(y) * static_cast<std::uint32_t>(test.width) +
                         static_cast<std::uint32_t>(x);
      const double within = noise.empty() ? 0 : double{noise[index]};
      if (std::isinf(within)) {
        continue;
      }
      const int most =
          std::max({std::abs(r[0] - t[0]), std::abs(r[1] - t[1]), std::abs(r[2] - t[2])});
      if (most > small_difference + within) {
        if (off_beyond_edges(reference, test, x, y) > small_difference + within) {
          pixels.different.push_back(index);
        }
        if (most > right_within + within) {
          pixels.off.push_back(index);
        }
      } else {
        pixels.same.push_back(index);
      }
    }
  }
  return pixels;
}

}  // namespace scenefile
