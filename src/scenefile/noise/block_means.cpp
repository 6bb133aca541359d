#include "scenefile/noise/block_means.h"

#include <cmath>
#include <numbers>

namespace scenefile {

namespace {

// Differences of our model from a right program: the shape of filters, float precision.
constexpr double model_error = 0.004;

// Pixels that differ by less than a step of 8-bit values are rounded alike: the variance of the
// mean's error (the first harmonic of the error of rounding, for normal values).
Color shared_rounding(const LinearPicture& picture, const PathTruth& truth, std::size_t b,
                      const Color& mean, const Color& rounding) {
  Color squares(0);
  double count = 0;
  for_each_pixel(truth, b, [&](int, int, std::size_t at) {
    if (picture.usable[at] != 0) {
      const Color off = picture.pixels[at] - mean;
      squares += off * off;
      ++count;
    }
  });
  Color shared(0);
  for (int c = 0; c < 3; ++c) {
    if (rounding[c] > 0) {
      // In steps, without what rounding adds (Sheppard's correction).
      const double variance = (squares[c] / count / rounding[c] - 1) / 12;
      const double pi = std::numbers::pi;
      shared[c] = rounding[c] * std::exp(-4 * pi * pi * std::max(0.0, variance));
    }
  }
  return shared;
}

}  // namespace

double median_of(std::vector<double> values) {
  if (values.empty()) {
    return 0;
  }
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

BlockColors shrunk(const BlockColors& values, int columns) {
  const int rows = static_cast<int>(values.size()) / columns;
  BlockColors result = values;
  for (int y = 0; y < rows; ++y) {
    for (int x = 0; x < columns; ++x) {
      Color sum(0);
      int count = 0;
      for (int j = std::max(0, y - 1); j <= std::min(rows - 1, y + 1); ++j) {
        for (int i = std::max(0, x - 1); i <= std::min(columns - 1, x + 1); ++i) {
          sum += values[std::size_t(j) * columns + i];
          ++count;
        }
      }
      const std::size_t at = std::size_t(y) * columns + x;
      result[at] = 0.5 * values[at] + 0.5 * sum / double(count);
    }
  }
  return result;
}

BlockColors combined(const BlockColors& a, double by, const BlockColors& b) {
  BlockColors sum = a;
  for (std::size_t i = 0; i < sum.size() && i < b.size(); ++i) {
    sum[i] += by * b[i];
  }
  return sum;
}

TruthBlocks::TruthBlocks(const PathTruth& t) : truth(t), zero(t.blocks(), Color(0)) {
  lamp = sum([](const LightKind& k) { return k.hit && k.bounces() == 0; });
  hit = sum([](const LightKind& k) { return k.hit && k.bounces() > 0; });
  sampled = sum([](const LightKind& k) { return !k.hit; });
  all = combined(combined(lamp, 1, hit), 1, sampled);
  variance.resize(t.blocks());
  gradient_x = gradient_y = edge = zero;
  for (std::size_t b = 0; b < t.blocks(); ++b) {
    double count = 0;
    Color steps(0);
    for_each_pixel(t, b, [&](int x, int y, std::size_t at) {
      variance[b] += t.sample_variances[at];
      const auto pixel = [&](int i, int j) {
        return t.pixels[std::size_t(std::clamp(j, 0, t.height - 1)) * t.width +
                        std::clamp(i, 0, t.width - 1)];
      };
      const Color dx = (pixel(x + 1, y) - pixel(x - 1, y)) / 2.0;
      const Color dy = (pixel(x, y + 1) - pixel(x, y - 1)) / 2.0;
      gradient_x[b] += dx;
      gradient_y[b] += dy;
      // Noise has steps, too.
      steps += dx * dx + dy * dy - 1.5 * t.sample_variances[at] / t.samples;
      ++count;
    });
    variance[b] /= count;
    pixels.push_back(count);
    gradient_x[b] /= count;
    gradient_y[b] /= count;
    // Samples in the middle of pixels, and other filters, move edges by parts of a pixel: all of a
    // side alike.
    edge[b] = glm::max(steps, Color(0)) * double(block_side) / (count * count * 12);
  }
  variance = shrunk(variance, t.columns);
  truth_noise = shrunk(t.noise, t.columns);
  left_out.resize(t.blocks());
  for (int y = 0; y < t.rows; ++y) {
    for (int x = 0; x < t.columns; ++x) {
      if (lamp[std::size_t(y) * t.columns + x] != Color(0)) {
        for (int j = std::max(0, y - 1); j <= std::min(t.rows - 1, y + 1); ++j) {
          for (int i = std::max(0, x - 1); i <= std::min(t.columns - 1, x + 1); ++i) {
            left_out[std::size_t(j) * t.columns + i] = 1;
          }
        }
      }
    }
  }
}

ObservedBlocks observe(const TruthBlocks& back, const LinearPicture& picture, double brighter) {
  const PathTruth& truth = back.truth;
  ObservedBlocks result;
  MeasuredBlocks& m = result.measured;
  m.mean.resize(truth.blocks());
  m.weight.resize(truth.blocks());
  result.cautious.resize(truth.blocks());
  result.unrelated.resize(truth.blocks());
  BlockColors rounding(truth.blocks(), Color(0));
  BlockColors shared(truth.blocks(), Color(0));
  BlockColors own(truth.blocks(), Color(0));  // variances of means as seen in the picture
  std::vector<double> ratios;
  std::vector<char> bad = back.left_out;
  for (std::size_t b = 0; b < truth.blocks(); ++b) {
    double unusable = 0;
    double count = 0;
    Color sum(0);
    Color truth_sum(0);
    // Clipped where the truth is bright, too, and taken as that; others are single bright samples.
    Color bright(0);
    double bright_count = 0;
    for_each_pixel(truth, b, [&](int, int, std::size_t at) {
      if (picture.usable[at] == 0) {
        ++unusable;
        if (luminance(truth.pixels[at]) > 0.5 * luminance(picture.pixels[at])) {
          bright += truth.pixels[at];
          ++bright_count;
        }
        return;
      }
      ++count;
      sum += picture.pixels[at];
      truth_sum += truth.pixels[at];
      rounding[b] += picture.rounding[at];
    });
    result.clipped += static_cast<std::size_t>(unusable);
    if (unusable > 0.02 * back.pixels[b] || count < 2) {
      bad[b] = 1;
      continue;
    }
    m.mean[b] = (sum + bright) / (count + bright_count);
    rounding[b] /= count * count;
    shared[b] = shared_rounding(picture, truth, b, sum / count, rounding[b] * count);
    // How much pixels vary beyond the pattern of the truth.
    const double scale = luminance(truth_sum) > 0 ? luminance(sum) / luminance(truth_sum) : 1;
    double squares = 0;
    for_each_pixel(truth, b, [&](int, int, std::size_t at) {
      if (picture.usable[at] != 0) {
        const double off = luminance(picture.pixels[at]) - scale * luminance(truth.pixels[at]);
        squares += off * off;
      }
    });
    const double variance = luminance(back.variance[b]);
    const double truth_part = variance / truth.samples * scale * scale;
    const double varied = squares / (count - 1);
    // Of the truth's samples, stratified ones, less may be left.
    const double beyond = std::max(varied / 2, varied - truth_part);
    own[b] = Color(beyond / count);
    if (bad[b] == 0 && variance > 0) {
      ratios.push_back(beyond / variance);
    }
  }
  own = shrunk(own, truth.columns);
  result.per_sample = std::max(1e-7, median_of(ratios));
  std::vector<double> relative;
  for (std::size_t b = 0; b < truth.blocks(); ++b) {
    if (bad[b] != 0) {
      continue;
    }
    const Color systematic = model_error * (back.all[b] + m.mean[b]) / 2.0;
    const Color noise = result.per_sample / back.pixels[b] * back.variance[b];
    const Color of_truth = back.truth_noise[b] + back.edge[b];
    const Color others = of_truth + rounding[b] + shared[b] + systematic * systematic;
    result.unrelated[b] = others;
    const double more = luminance(noise) > 0 ? std::max(1.0, own[b].x / luminance(noise)) : 1;
    // In a dark color, noise may only not have been seen.
    const double floor = luminance(noise + others) * 0.05;
    for (int c = 0; c < 3; ++c) {
      const double v = std::max(noise[c] + others[c], floor);
      m.weight[b][c] = v > 0 ? 1 / v : 0;
      const double most = std::max(more * noise[c] + others[c], floor);
      result.cautious[b][c] = v > 0 ? 1 / most : 0;
      const double in_file = most + (brighter * brighter - 1) * of_truth[c];
      result.log_variance += rounding[b][c] > 0 ? std::log(in_file / rounding[b][c]) / 3 : 0;
    }
    ++result.tested;
    const double light = std::max(luminance(m.mean[b]), luminance(back.all[b]));
    if (light > 0) {
      relative.push_back(std::sqrt(luminance(more * noise)) / light);
    }
  }
  result.log_variance /= static_cast<double>(std::max<std::size_t>(1, result.tested));
  result.relative_noise = median_of(std::move(relative));
  return result;
}

std::vector<const BlockColors*> gradients(const TruthBlocks& back, const MeasuredBlocks& measured) {
  std::vector<const BlockColors*> columns;
  for (const BlockColors* gradient : {&back.gradient_x, &back.gradient_y}) {
    for (std::size_t b = 0; b < gradient->size(); ++b) {
      if (measured.weight[b] * (*gradient)[b] != Color(0)) {
        columns.push_back(gradient);
        break;
      }
    }
  }
  return columns;
}

}  // namespace scenefile
