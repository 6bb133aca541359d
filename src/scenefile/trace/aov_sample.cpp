#include "scenefile/trace/aov_sample.h"

#include <algorithm>
#include <bit>

namespace scenefile {

namespace {

// The value to denoise: the color, or the light on the surface.
Color signal_of(const AovSample& sample, const Color& albedo, bool sharp) {
  if (!sharp) {
    return sample.color;
  }
  Color light(0);
  for (int c = 0; c < 3; ++c) {
    light[c] = albedo[c] > 0 ? sample.diffused[c] / albedo[c] : 0;
  }
  return light;
}

// Estimated from the difference of the means of the first and the second half of the samples. Each
// half is as well distributed as the whole, which the variance of single samples ignores.
glm::dvec3 variance_of_mean(const std::vector<AovSample>& samples, const Color& albedo,
                            bool sharp) {
  const std::size_t first = std::bit_floor(samples.size() - 1);
  Color sums[2] = {Color(0), Color(0)};
  for (std::size_t i = 0; i < samples.size(); ++i) {
    sums[i < first ? 0 : 1] += signal_of(samples[i], albedo, sharp);
  }
  const auto a = static_cast<double>(first);
  const auto b = static_cast<double>(samples.size() - first);
  const Color difference = sums[0] / a - sums[1] / b;
  return difference * difference * (a * b / ((a + b) * (a + b)));
}

}  // namespace

PixelStatistics statistics_of(const std::vector<AovSample>& samples, bool sharp) {
  const auto count = static_cast<double>(samples.size());
  AovSample sum;
  double hits = 0, of_normals = 0, of_albedos = 0;
  for (const AovSample& s : samples) {
    hits += s.hit ? 1 : 0;
    sum.color += s.color;
    sum.diffused += s.diffused;
    sum.normal += s.normal;
    sum.albedo += s.albedo;
    sum.position += s.position;
    of_normals += glm::dot(s.normal, s.normal);
    of_albedos += glm::dot(s.albedo, s.albedo);
  }
  PixelStatistics result;
  const Color albedo = sum.albedo / count;
  AovSample mean;
  mean.color = sum.color / count;
  mean.diffused = sum.diffused / count;
  const Color signal = signal_of(mean, albedo, sharp);
  result.signal = signal;
  result.scale = sharp ? glm::vec3(albedo) : glm::vec3(1);
  result.rest = mean.color - (sharp ? albedo * signal : signal);
  result.normal = sum.normal / count;
  result.albedo = albedo;
  result.position = sum.position / std::max(1.0, hits);
  result.coverage = static_cast<float>(hits / count);
  if (samples.size() > 1) {
    result.variance = variance_of_mean(samples, albedo, sharp);
    const auto of_mean = [&](double squares, const glm::dvec3& total) {
      const double scatter = squares - glm::dot(total, total) / count;
      return static_cast<float>(std::max(0.0, scatter) / (count * (count - 1)));
    };
    result.normal_variance = of_mean(of_normals, sum.normal);
    result.albedo_variance = of_mean(of_albedos, sum.albedo);
  }
  return result;
}

}  // namespace scenefile
