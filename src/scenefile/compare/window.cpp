#include "scenefile/compare/window.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>

namespace scenefile {

namespace {

constexpr int block = 32;  // pixels

}  // namespace

Taps gaussian_taps(int radius, double sigma) {
  Taps taps;
  for (int x = -radius; x <= radius; ++x) {
    taps.push_back(std::exp(-x * x / (2 * sigma * sigma)));
  }
  return taps;
}

double sum_of(const Taps& taps) {
  return std::accumulate(taps.begin(), taps.end(), 0.0);
}

Taps scaled_taps(Taps taps, double factor) {
  for (double& tap : taps) {
    tap *= factor;
  }
  return taps;
}

void PaddedRow::repeat_edges() {
  std::fill_n(values_.begin(), reach_, pixels()[0]);
  std::fill_n(values_.end() - reach_, reach_, pixels()[width_ - 1]);
}

void WeightedRows::add(double weight, const float* row) {
  weights.push_back(static_cast<float>(weight));
  rows.push_back(row);
}

void WeightedRows::add_up(const Span& span, float* to) const {
  float sum = 0;
  float size = 0;
  for (const float weight : weights) {
    sum += weight;
    size += std::abs(weight);
  }
  if (std::abs(sum) < 1e-4F * size) {
    weighted_differences(weights.data(), rows.data(), rows.size(), rows[rows.size() / 2], span, to);
  } else {
    weighted_sum(weights.data(), rows.data(), rows.size(), span, to);
  }
}

FilteredRows::FilteredRows(int width, int height, int reach, const Taps& across)
    : width_(width),
      height_(height),
      kept_(2 * reach + 1),
      across_(across),
      values_(static_cast<std::size_t>(width) * kept_) {}

std::size_t FilteredRows::start_of(int y) const {
  return static_cast<std::size_t>(y % kept_) * width_;
}

void FilteredRows::take(int y, const PaddedRow& padded, const std::vector<Span>& spans) {
  const int radius = static_cast<int>(across_.size()) / 2;
  WeightedRows shifted;
  for (int i = 0; i < static_cast<int>(across_.size()); ++i) {
    shifted.add(across_[i], padded.pixels() + i - radius);
  }
  for (const Span& span : spans) {
    shifted.add_up(span, values_.data() + start_of(y));
  }
}

void FilteredRows::add_around(int y, const Taps& down, WeightedRows& rows) const {
  const int radius = static_cast<int>(down.size()) / 2;
  for (int i = 0; i < static_cast<int>(down.size()); ++i) {
    rows.add(down[i], values_.data() + start_of(std::clamp(y + i - radius, 0, height_ - 1)));
  }
}

NearDifferences::NearDifferences(const Texture& a, const Texture& b, int across, int down)
    : width_(a.width),
      height_(a.height),
      blocks_((a.width + block - 1) / block),
      inside_(static_cast<std::size_t>(blocks_) * a.height) {
  for (int y = 0; y < height_; ++y) {
    for (int i = 0; i < blocks_; ++i) {
      const int begin = std::max(i * block - across, 0);
      const int end = std::min((i + 1) * block + across, width_);
      inside_[static_cast<std::size_t>(y) * blocks_ + i] =
          std::memcmp(a.texel(begin, y), b.texel(begin, y), std::size_t(3) * (end - begin)) != 0;
    }
  }
  *this = grown_down(down);
}

NearDifferences NearDifferences::grown_down(int more) const {
  NearDifferences result(*this);
  for (int y = 0; y < height_; ++y) {
    char* const row = result.inside_.data() + static_cast<std::size_t>(y) * blocks_;
    for (int v = std::max(y - more, 0); v <= std::min(y + more, height_ - 1); ++v) {
      const char* const other = inside_.data() + static_cast<std::size_t>(v) * blocks_;
      std::transform(row, row + blocks_, other, row,
                     [](char p, char q) { return static_cast<char>(p | q); });
    }
  }
  return result;
}

std::vector<Span> NearDifferences::spans(int y) const {
  std::vector<Span> result;
  for (int i = 0; i < blocks_; ++i) {
    if (inside_[static_cast<std::size_t>(y) * blocks_ + i] == 0) {
      continue;
    }
    if (result.empty() || result.back().end != i * block) {
      result.push_back({i * block, i * block});
    }
    result.back().end = std::min((i + 1) * block, width_);
  }
  return result;
}

}  // namespace scenefile
