#include "scenefile/trace/denoise.h"

#include "scenefile/trace/tiles.h"

#include <algorithm>
#include <cmath>

namespace scenefile {

namespace {

constexpr int window = 7;           // pixels around the filtered one
constexpr int patch = 1;            // pixels around each of them to compare
constexpr int variance_window = 2;  // pixels around each to average the variance over
static_assert(denoise_reach == window + patch + variance_window);

// Tolerances for guides, as standard sample_variances.
constexpr float normal_width = 0.1f;
constexpr float albedo_width = 0.02f;
constexpr float coverage_width = 0.05f;
constexpr float plane_width = 0.05f;  // sine of the angle to the tangent plane

constexpr float color_width = 0.7f;  // in standard errors
constexpr float max_errors = 3;      // by which a channel may change
constexpr float negligible_weight = 1e-3f;

float square(float x) {
  return x * x;
}

float square(const glm::vec3& v) {
  return glm::dot(v, v);
}

// The squared difference of guides beyond their noise, relative to the tolerance.
float excess(float squared_difference, float variance, float width) {
  return std::max(0.0f, squared_difference - variance) / (width * width + variance);
}

class Filter {
 public:
  Filter(int width, int height, const std::vector<PixelStatistics>& pixels, bool sharp,
         float invisible)
      : width_(width),
        height_(height),
        pixels_(pixels),
        sharp_(sharp),
        invisible_(invisible),
        // Keeps quotients finite.
        least_variance_(invisible > 0 ? 1e-7f : 1e-30f),
        variances_(pixels.size()) {}

  std::vector<glm::vec3> run() {
    std::vector<glm::vec3> colors(pixels_.size());
    for_each_line(height_, [&](int y) {
      for (int x = 0; x < width_; ++x) {
        variances_[index(x, y)] = smooth_variance(x, y);
      }
    });
    for_each_line(height_, [&](int y) {
      for (int x = 0; x < width_; ++x) {
        colors[index(x, y)] = filtered(x, y);
      }
    });
    return colors;
  }

 private:
  std::size_t index(int x, int y) const { return std::size_t(y) * width_ + x; }

  // Calls f(x, y) for the pixels around a pixel, inside the picture.
  template <typename F>
  void around(int x, int y, int radius, const F& f) const {
    for (int j = std::max(0, y - radius); j <= std::min(height_ - 1, y + radius); ++j) {
      for (int i = std::max(0, x - radius); i <= std::min(width_ - 1, x + radius); ++i) {
        f(i, j);
      }
    }
  }

  // Whether two pixels show the same smooth surface, in [0, 1].
  float likeness(const PixelStatistics& p, const PixelStatistics& q) const {
    const float of_normals = sharp_ ? 0 : p.normal_variance + q.normal_variance;
    float sum = excess(square(p.normal - q.normal), of_normals, normal_width);
    if (sharp_) {
      sum += excess(square(p.coverage - q.coverage), 0, coverage_width) + plane_excess(p, q);
    } else {
      const float of_albedos = p.albedo_variance + q.albedo_variance;
      sum += excess(square(p.albedo - q.albedo), of_albedos, albedo_width);
    }
    return std::exp(-sum);
  }

  static float plane_excess(const PixelStatistics& p, const PixelStatistics& q) {
    const glm::vec3 step = q.position - p.position;
    const float length = square(step);
    return length > 0 ? square(glm::dot(p.normal, step)) / length / square(plane_width) : 0;
  }

  // The variance from few samples is unreliable: averages it over the same surface.
  glm::vec3 smooth_variance(int x, int y) const {
    const PixelStatistics& p = pixels_[index(x, y)];
    glm::vec3 sum(0);
    float weights = 0;
    around(x, y, variance_window, [&](int i, int j) {
      const PixelStatistics& q = pixels_[index(i, j)];
      const float weight = likeness(p, q);
      sum += weight * q.variance;
      weights += weight;
    });
    return sum / weights;
  }

  // The squared difference of the patches around two pixels beyond their noise, relative to it.
  float color_excess(int px, int py, int qx, int qy) const {
    float sum = 0;
    int count = 0;
    for (int j = -patch; j <= patch; ++j) {
      for (int i = -patch; i <= patch; ++i) {
        if (inside(px + i, py + j) && inside(qx + i, qy + j)) {
          sum += color_excess(index(px + i, py + j), index(qx + i, qy + j));
          count += 3;
        }
      }
    }
    return std::max(0.0f, sum / static_cast<float>(count));
  }

  float color_excess(std::size_t p, std::size_t q) const {
    float sum = 0;
    for (int c = 0; c < 3; ++c) {
      const float difference = square(pixels_[p].signal[c] - pixels_[q].signal[c]);
      const float of_p = variances_[p][c];
      const float of_q = variances_[q][c];
      sum += (difference - (of_p + std::min(of_p, of_q))) /
             (square(color_width) * (of_p + of_q) + least_variance_);
    }
    return sum;
  }

  bool inside(int x, int y) const { return x >= 0 && x < width_ && y >= 0 && y < height_; }

  glm::vec3 filtered(int x, int y) const {
    const PixelStatistics& p = pixels_[index(x, y)];
    const glm::vec3 error = glm::sqrt(variances_[index(x, y)]);
    if (const float most = std::max({error.x, error.y, error.z}); most < invisible_ || most == 0) {
      return p.rest + p.scale * p.signal;
    }
    glm::vec3 sum(0);
    float weights = 0;
    around(x, y, window, [&](int i, int j) {
      const PixelStatistics& q = pixels_[index(i, j)];
      float weight = likeness(p, q);
      if (weight > negligible_weight) {
        weight *= std::exp(-color_excess(x, y, i, j));
        sum += weight * q.signal;
        weights += weight;
      }
    });
    const glm::vec3 signal =
        glm::clamp(sum / weights, p.signal - max_errors * error, p.signal + max_errors * error);
    return p.rest + p.scale * signal;
  }

  int width_;
  int height_;
  const std::vector<PixelStatistics>& pixels_;
  bool sharp_;
  float invisible_;
  float least_variance_;
  std::vector<glm::vec3> variances_;
};

}  // namespace

std::vector<glm::vec3> denoised(int width, int height, const std::vector<PixelStatistics>& pixels,
                                bool sharp, float invisible) {
  return Filter(width, height, pixels, sharp, invisible).run();
}

}  // namespace scenefile
