#include "scenefile/noise/growing_light.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

namespace scenefile {

namespace {

using std::numbers::pi;

// A program whose paths go on with a constant probability.
struct Program {
  Meaning meaning;           // no name: light does not grow
  double scattered = 1;      // factor of each scattered direction
  double direct = 1;         // factor of light samples
  bool flat = false;         // no cosine of scattered directions
  bool white = false;        // no Kd in scattered light
  bool flat_direct = false;  // no cosine of light samples
  bool any_brightness = false;
  double (*weight)(double p) = [](double p) { return 1 / p; };  // of going on
};

std::vector<Program> programs() {
  constexpr auto page = Cause::scattering;
  const auto by_inverse = [](double p) { return 1 / (1 - p); };
  const auto by_square = [](double p) { return 1 / (p * p); };
  return {
      {.meaning = {page, "surface-cosine",
                   "scattered light is not multiplied by the cosine at the surface"},
       .flat = true},
      {.meaning = {page, "surface-cosine", "light is not multiplied by the cosine at the surface"},
       .flat = true,
       .flat_direct = true},
      {.meaning = {page, "pi", "Kd is not divided by pi in scattered light"}, .scattered = pi},
      {.meaning = {page, "pi", "Kd is not divided by pi"}, .scattered = pi, .direct = pi},
      {.meaning = {page, "scattered-factor",
                   "scattered light counts twice at each bounce, as if divided by the density of "
                   "directions of a whole sphere"},
       .scattered = 2},
      {.meaning = {Cause::path_length, "roulette",
                   "paths are divided by the probability of ending, not of going on"},
       .weight = by_inverse},
      {.meaning = {Cause::path_length, "roulette",
                   "paths are divided twice by the probability of going on"},
       .weight = by_square},
      {.meaning = {page, "diffuse-color", "scattered light is not multiplied by Kd"},
       .white = true},
      {.meaning = {}, .any_brightness = true}};
}

constexpr std::array quantiles{0.05, 0.1, 0.25, 0.5, 0.75, 0.9, 0.95};
// Blocks by how much of their light is direct: mistakes of scattered light leave that as it is.
constexpr std::array most_direct{0.25, 0.6, 1.1};

// Logarithms of pixels relative to the truth of their block, by group of blocks.
using Groups = std::array<std::vector<double>, most_direct.size()>;

struct PoolBlock {
  const PathPool* pool = nullptr;
  std::size_t group = 0;
  double truth = 0;
};

std::vector<PoolBlock> blocks_of(const TruthBlocks& back) {
  const BlockColors direct =
      back.sum([](const LightKind& k) { return !k.hit && k.bounces() == 0; });
  std::vector<PoolBlock> blocks;
  // Its paths stand for all of its pixels, so it must not show the background or an edge.
  const auto is_even = [&](std::size_t block, double all) {
    bool even = all > 0;
    for_each_pixel(back.truth, block, [&](int, int, std::size_t at) {
      even = even && luminance(back.truth.pixels[at]) > 0.2 * all;
    });
    return even;
  };
  for (const PathPool& pool : back.truth.pools) {
    const double all = luminance(back.all[pool.block]);
    if (back.left_out[pool.block] == 0 && is_even(pool.block, all)) {
      const double share = luminance(direct[pool.block]) / all;
      const auto group = std::find_if(most_direct.begin(), most_direct.end(),
                                      [&](double most) { return share < most; });
      blocks.push_back({&pool, static_cast<std::size_t>(group - most_direct.begin()), all});
    }
  }
  return blocks;
}

double relative_logarithm(double value, double truth) {
  return std::log(std::max(value / truth, 1e-6));
}

Groups observed(const TruthBlocks& back, const LinearPicture& picture,
                const std::vector<PoolBlock>& blocks) {
  Groups groups;
  for (const PoolBlock& block : blocks) {
    for_each_pixel(back.truth, block.pool->block, [&](int, int, std::size_t at) {
      // Where values are clipped, or not finite, they are above the others.
      groups[block.group].push_back(
          picture.usable[at] != 0 ? relative_logarithm(luminance(picture.pixels[at]), block.truth)
                                  : 1e3);
    });
  }
  for (std::vector<double>& group : groups) {
    std::sort(group.begin(), group.end());
  }
  return groups;
}

double at_share(const std::vector<double>& sorted, double share) {
  return sorted[std::min(sorted.size() - 1,
                         static_cast<std::size_t>(share * static_cast<double>(sorted.size())))];
}

// The variance of a quantile: q (1 - q) / n / density^2, with the density between its neighbors.
double quantile_variance(const std::vector<double>& sorted, double share) {
  const double reach = std::min(share, 1 - share) / 2;
  const double width = at_share(sorted, share + reach) - at_share(sorted, share - reach);
  const double by = width / (2 * reach);
  return share * (1 - share) / static_cast<double>(sorted.size()) * by * by;
}

double misfit(const Groups& picture, const Groups& simulated, bool any_brightness) {
  double squares = 0;  // weighted
  double sum = 0;
  double weights = 0;
  int count = 0;
  for (std::size_t g = 0; g < picture.size(); ++g) {
    if (picture[g].empty() || simulated[g].empty()) {
      continue;
    }
    for (const double share : quantiles) {
      constexpr double differently = 0.03;  // programs sample lamps and pixels differently
      const double off = at_share(picture[g], share) - at_share(simulated[g], share);
      const double weight =
          1 / (quantile_variance(picture[g], share) + quantile_variance(simulated[g], share) +
               differently * differently);
      squares += weight * off * off;
      sum += weight * off;
      weights += weight;
      ++count;
    }
  }
  if (count == 0) {
    return 1e300;
  }
  return (any_brightness ? squares - sum * sum / weights : squares) / count;
}

// Random numbers that need no quality (Marsaglia, "Xorshift RNGs", 2003).
struct QuickRandom {
  std::uint64_t state = 88172645463325252u;
  std::uint32_t next() {
    state ^= state << 13;
    state ^= state >> 7;
    state ^= state << 17;
    return static_cast<std::uint32_t>(state >> 32);
  }
};

constexpr std::size_t longest = 64;  // bounces

// For each path: what it adds up to if it ends after n bounces.
std::vector<std::array<double, longest>> sums_of(const Program& program, double p,
                                                 const std::vector<std::vector<PathStep>>& paths) {
  std::vector<std::array<double, longest>> sums;
  for (const std::vector<PathStep>& steps : paths) {
    std::array<double, longest>& sum = sums.emplace_back();
    double total = 0;
    double weight = 1;
    std::uint8_t rough = 0;
    constexpr std::size_t few = 8;
    double last = 0;  // sums of the last few terms, and of as many before
    double before = 0;
    double growth = 1;
    double term = 0;
    for (std::size_t n = 0; n < longest; ++n) {
      if (n < steps.size()) {
        const PathStep& step = steps[n];
        for (; rough < step.rough; ++rough) {
          weight *= program.scattered;
        }
        term = program.direct *
               (program.flat_direct ? step.flat_direct
                : program.white     ? step.white_direct
                                    : step.direct) *
               (program.flat ? step.flatness : 1) * weight;
        weight *= program.weight(p);
        last += n + few >= steps.size() ? term : 0;
        before += n + 2 * few >= steps.size() && n + few < steps.size() ? term : 0;
      } else {
        if (n == steps.size()) {
          growth = before > 0 ? std::pow(last / before, 1.0 / few) : 0;
          term = last / few * std::pow(growth, (few - 1) / 2.0);
        }
        term *= growth;
      }
      total += term;
      sum[n] = total;
    }
  }
  return sums;
}

constexpr int octaves = 9;  // numbers of samples from 4 to 2048
constexpr double fewest_samples = 4;
constexpr int per_octave = 4;

struct Simulation {
  double misfit = 1e300;
  double p = 0;
  double samples = 0;
};

// The best number of samples.
Simulation simulated(const Program& program, bool uniform, double p, int pixels,
                     const std::vector<PoolBlock>& blocks, const Groups& picture) {
  std::vector<Groups> by_samples(octaves * per_octave + 1);
  QuickRandom random;
  const double scale = 1 / std::log(p);
  for (const PoolBlock& block : blocks) {
    const auto sums = sums_of(program, p, block.pool->paths[uniform ? 1 : 0]);
    for (int pixel = 0; pixel < pixels && !sums.empty(); ++pixel) {
      double sum = 0;
      std::size_t drawn = 0;
      for (std::size_t i = 0; i < by_samples.size(); ++i) {
        const auto count =
            static_cast<std::size_t>(fewest_samples * std::exp2(double(i) / per_octave));
        for (; drawn < count; ++drawn) {
          const auto& path = sums[random.next() % sums.size()];
          const double length = scale * std::log((random.next() + 0.5) * 0x1p-32);
          sum += path[std::min(longest - 1, static_cast<std::size_t>(length))];
        }
        by_samples[i][block.group].push_back(
            relative_logarithm(sum / static_cast<double>(drawn), block.truth));
      }
    }
  }
  Simulation best;
  for (std::size_t i = 0; i < by_samples.size(); ++i) {
    for (std::vector<double>& group : by_samples[i]) {
      std::sort(group.begin(), group.end());
    }
    const double off = misfit(picture, by_samples[i], program.any_brightness);
    if (off < best.misfit) {
      best = {off, p, fewest_samples * std::exp2(double(i) / per_octave)};
    }
  }
  return best;
}

}  // namespace

std::vector<GrowthMatch> match_growth(const TruthBlocks& back, const LinearPicture& picture) {
  std::vector<GrowthMatch> matches;
  const std::vector<PoolBlock> blocks = blocks_of(back);
  if (blocks.empty()) {
    return matches;
  }
  const Groups groups = observed(back, picture, blocks);
  for (const Program& program : programs()) {
    GrowthMatch match{program.meaning, 1e300};
    for (const bool uniform : {false, true}) {
      // First coarsely with few pixels, then near the best with more.
      Simulation best;
      for (double p = 0.5; p < 0.96; p += 0.05) {
        const Simulation found = simulated(program, uniform, p, 4, blocks, groups);
        best = found.misfit < best.misfit ? found : best;
      }
      for (int i = -2; i <= 2; ++i) {
        const double p = std::min(0.97, best.p + 0.015 * i);
        const Simulation found = simulated(program, uniform, p, 16, blocks, groups);
        if (found.misfit < match.misfit) {
          match = {program.meaning, found.misfit, found.p, found.samples};
        }
      }
    }
    matches.push_back(std::move(match));
  }
  std::sort(matches.begin(), matches.end(),
            [](const GrowthMatch& a, const GrowthMatch& b) { return a.misfit < b.misfit; });
  // The variances do not know that the simulated pixels of a block have its paths in common: of the
  // program that made a picture, 0.5 to 2.2 is left, and others do not fit better by more than 1.4.
  constexpr double most = 3;
  constexpr double alike = 2;
  std::vector<GrowthMatch> likely;
  for (const GrowthMatch& match : matches) {
    if (match.misfit > std::min(most, matches.front().misfit + alike)) {
      break;
    }
    if (match.meaning.name.empty()) {
      return {};
    }
    const auto same = std::find_if(likely.begin(), likely.end(), [&](const GrowthMatch& other) {
      return other.meaning.name == match.meaning.name;
    });
    if (same == likely.end()) {
      likely.push_back(match);
    } else {
      same->meaning.what += "; or " + match.meaning.what;
    }
  }
  return likely;
}

}  // namespace scenefile
