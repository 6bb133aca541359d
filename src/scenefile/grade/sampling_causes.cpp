#include "scenefile/grade/sampling_causes.h"

#include "scenefile/grade/claims.h"
#include "scenefile/trace/tasks.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numeric>

namespace scenefile {

namespace {

using glm::dvec2;
using glm::dvec3;

constexpr double enough_shift = 0.6;  // share of edges that a subpixel shift must explain

dvec3 mean_around(const Simulation& sim, int x, int y, const PixelFilter& filter) {
  dvec3 sum(0);
  double all = 0;
  const int size = static_cast<int>(filter.weights.size());
  for (int v = 0; v < size; ++v) {
    for (int u = 0; u < size; ++u) {
      const int column = std::clamp(x + u - filter.before, 0, sim.test.width - 1);
      const int row = std::clamp(y + v - filter.before, 0, sim.test.height - 1);
      const double w =
          filter.weights[static_cast<std::size_t>(u)] * filter.weights[static_cast<std::size_t>(v)];
      sum += w * at(sim.reference, column, row);
      all += w;
    }
  }
  return sum / all;
}

std::optional<std::uint16_t> mistake_at_edges(Simulation& sim, const Combination& mistakes) {
  sim.points.clear();
  sim.cache.clear();
  const bool other_view = sim.stage_of(mistakes) >= Stage::camera;
  const Texture& picture = other_view ? sim.test : sim.reference;
  std::vector<std::uint32_t> edges;
  for (int y = 1; y + 1 < sim.reference.height; ++y) {
    for (int x = 1; x + 1 < sim.reference.width; ++x) {
      if (!around(picture, x, y).calm()) {
        edges.push_back(static_cast<std::uint32_t>(y * sim.reference.width + x));
      }
    }
  }
  std::mt19937 random(7);
  add_points(sim.reference, sim.test, edges, 800, true, true, random, sim.points);
  sim.prepare_clean();
  const std::size_t count = sim.points.size();
  const Colors before = sim.predicted(mistakes, count);
  const auto is_right = [&](std::size_t k, const dvec3& color) {
    const dvec3 c = glm::clamp(color, dvec3(0), dvec3(255));
    return largest_of(glm::abs(c - sim.points[k].test)) <= exact_within;
  };
  std::size_t right = 0;
  for (std::size_t k = 0; k < count; ++k) {
    right += is_right(k, before[k]) ? 1 : 0;
  }
  if (count < right + 2 * few_pixels) {
    return std::nullopt;
  }
  std::optional<std::uint16_t> best;
  double most = 0;
  for (const std::uint16_t i : edge_mistakes(sim)) {
    const Colors after = sim.predicted(joined(mistakes, {i}), count);
    double changed = 0;
    double gained = 0;
    for (std::size_t k = 0; k < count; ++k) {
      // Where the middle of a pixel misses, one sample gives black, too.
      const bool counts = sim.view->samples == 1 || sim.clean({}).hits[k].part != nullptr;
      if (counts && largest_of(glm::abs(after[k] - before[k])) > right_within) {
        changed += 1;
        gained += (is_right(k, after[k]) ? 1 : 0) - (is_right(k, before[k]) ? 1 : 0);
      }
    }
    // Other filters are exact, where shifts also move what edges show.
    const double least = other_view || sim.list[i].cause == Cause::samples ? 0.9 : 0.5;
    if (changed >= 2 * few_pixels && gained > std::max(most, least) * changed) {
      most = gained / changed;
      best = i;
    }
  }
  return best;
}

// Samples of each pixel across and down, from border to border, for programs whose samples are at
// random places.
constexpr int dense = 9;

// The colors of side x side samples of each point's pixel; points beside each other.
std::vector<Colors> samples_of_points(const Simulation& sim, const Trial& trial,
                                      const std::vector<Point>& points, int side) {
  std::vector<Colors> result(points.size());
  const double first = side == dense ? 0 : 0.5 / side;
  const double step = side == dense ? 1.0 / (side - 1) : 1.0 / side;
  constexpr std::size_t chunk = 16;
  for_each_task((points.size() + chunk - 1) / chunk, [&](std::size_t task) {
    const Model model(trial.scene, *sim.shapes, *sim.view->assets, trial.options, trial.mistakes);
    for (std::size_t i = task * chunk; i < std::min(points.size(), (task + 1) * chunk); ++i) {
      for (int k = 0; k < side * side; ++k) {
        const dvec2 place = dvec2(points[i].x, points[i].y) + first +
                            step * dvec2(k % side, k / side) + sim.view->corner;
        result[i].push_back(255.0 * clamped(model.pixel(place, sim.whole().x, sim.whole().y,
                                                        nullptr, {k, side * side})));
      }
    }
    sim.rays += model.rays();
  });
  return result;
}

dvec3 mean_of(const Colors& colors) {
  dvec3 sum(0);
  for (const dvec3& c : colors) {
    sum += c;
  }
  return sum / static_cast<double>(colors.size());
}

double share_of(const std::vector<bool>& right) {
  return static_cast<double>(std::count(right.begin(), right.end(), true)) /
         static_cast<double>(std::max<std::size_t>(1, right.size()));
}

// Which points are means of a grid of samples.
std::vector<bool> means_of_samples(const Simulation& sim, const Trial& trial,
                                   const std::vector<Point>& points, int side) {
  const std::vector<Colors> samples = samples_of_points(sim, trial, points, side);
  std::vector<bool> right;
  for (std::size_t i = 0; i < points.size(); ++i) {
    right.push_back(largest_of(glm::abs(mean_of(samples[i]) - points[i].test)) <= exact_within);
  }
  return right;
}

// Which points may be means of samples anywhere in the pixel.
struct WithinSamples {
  std::vector<bool> right;
  // Whether the colors are biased, scatter more than single samples, or are those at one place of
  // all pixels, as with a shift.
  bool odd = false;
};

WithinSamples within_samples(const Simulation& sim, const Trial& trial,
                             const std::vector<Point>& points) {
  constexpr double max_bias = 0.6;  // pixels that differ are not chosen at random
  constexpr double max_scatter = 1.5;
  constexpr double max_at_one_place = 0.7;
  const std::vector<Colors> samples = samples_of_points(sim, trial, points, dense);
  WithinSamples result;
  dvec3 bias(0);
  dvec3 deviation(0);
  dvec3 scatter(0);
  dvec3 variance(0);
  std::array<std::size_t, std::size_t{dense} * dense> at_place{};
  for (std::size_t i = 0; i < points.size(); ++i) {
    const dvec3 mean = mean_of(samples[i]);
    dvec3 low(255);
    dvec3 high(0);
    dvec3 squares(0);
    for (std::size_t k = 0; k < samples[i].size(); ++k) {
      const dvec3& c = samples[i][k];
      low = glm::min(low, c);
      high = glm::max(high, c);
      squares += (c - mean) * (c - mean);
      at_place[k] += largest_of(glm::abs(c - points[i].test)) <= exact_within ? 1 : 0;
    }
    result.right.push_back(largest_of(outside(points[i].test, low, high)) <= exact_within);
    if (result.right.back()) {
      const dvec3 off = points[i].test + 0.5 - mean;  // truncated
      bias += off;
      scatter += off * off;
      squares /= static_cast<double>(samples[i].size());
      variance += squares;
      deviation += glm::sqrt(squares);
    }
  }
  const auto most = static_cast<double>(*std::max_element(at_place.begin(), at_place.end()));
  const auto count = static_cast<double>(points.size());
  result.odd = largest_of(glm::abs(bias) - max_bias * deviation) > count ||
               largest_of(scatter - max_scatter * variance) > count ||
               most > max_at_one_place * count;
  return result;
}

// A way of sampling in which right programs differ.
struct Sampling {
  TextureMistake texture = TextureMistake::none;
  int side = 1;  // of the grid of samples in each pixel; dense: anywhere in it
};

Trial trial_of(const Simulation& sim, const Sampling& way) {
  Trial trial = sim.right_trial(false);
  trial.mistakes.texture = way.texture;
  return trial;
}

std::string words_of(const Simulation& sim, const Sampling& way) {
  std::string texture;
  if (way.texture != TextureMistake::none) {
    texture = way.texture == TextureMistake::not_filtered
                  ? "textures are not filtered, but those of the reference are"
              : sim.view->options.features.texture_filter
                  ? "textures are filtered half a texel from where those of the reference are"
                  : "textures are filtered, but those of the reference are not";
  }
  const std::string samples =
      way.side == dense ? "samples are at other places in the pixels than those of the reference"
      : way.side > 1    ? words_of_samples(way.side)
      : texture.empty() ? "pixels have one sample, but those of the reference are means of several"
                        : "";
  return texture + (texture.empty() || samples.empty() ? "" : "; ") + samples;
}

// The points of the reference.
std::vector<Point> reference_points(const Simulation& sim, std::vector<Point> points) {
  for (Point& p : points) {
    p.test = at(sim.reference, p.x, p.y);
  }
  return points;
}

std::vector<Sampling> possible_samplings(const Simulation& sim) {
  const Features& features = sim.view->options.features;
  std::vector<TextureMistake> textures{TextureMistake::none};
  const bool any = std::any_of(sim.view->scene->materials.begin(), sim.view->scene->materials.end(),
                               [](const RenderMaterial& m) { return m.texture.used(); });
  if (any && features.texture && features.texture_filter) {
    textures.insert(textures.end(),
                    {TextureMistake::not_filtered, TextureMistake::filtered_centered});
  } else if (any && features.texture) {
    textures.insert(textures.end(), {TextureMistake::filtered_centered, TextureMistake::filtered});
  }
  std::vector<Sampling> ways;
  for (const TextureMistake texture : textures) {
    for (const int side : {1, 2, 3, 4, dense}) {
      ways.push_back({texture, side});
    }
  }
  return ways;
}

void drop(const std::vector<bool>& dropped, std::vector<Point>& points) {
  std::size_t i = 0;
  std::erase_if(points, [&](const Point&) { return dropped[i++]; });
}

// Whether the points are sampled this way. `rest`: the points that are not exactly that.
bool is_sampled(const Simulation& sim, const Sampling& way, const std::vector<Point>& points,
                std::vector<Point>& rest) {
  constexpr double exact = 0.9;      // share of the points
  constexpr double possible = 0.95;  // share, without any that is exact
  const Trial trial = trial_of(sim, way);
  if (way.side == dense) {
    const WithinSamples within = within_samples(sim, trial, points);
    return !within.odd && share_of(within.right) >= possible;
  }
  const std::vector<bool> right = means_of_samples(sim, trial, points, way.side);
  rest = points;
  drop(right, rest);
  if (share_of(right) < exact) {
    return false;
  }
  // Rays that hit by a hair may be reflected elsewhere.
  std::vector<Point> unlike = rest;
  drop(within_samples(sim, trial, rest).right, unlike);
  return unlike.size() < few_pixels;
}

}  // namespace

std::optional<Claim> drop_other_samples(Simulation& sim,
                                        const std::vector<std::uint32_t>& different) {
  constexpr std::size_t first_points = 60;
  constexpr std::size_t many_points = 6000;
  constexpr double plausible = 0.85;
  // Black is in the range of the samples of pixels that objects cover partly.
  if (!sim.usable || sim.has_noise() || sim.points.size() < few_pixels ||
      claim_of_missed_samples(sim)) {
    return std::nullopt;
  }
  const std::vector<Point> first(
      sim.points.begin(),
      sim.points.begin() + std::ptrdiff_t(std::min(first_points, sim.points.size())));
  std::vector<Point> least = sim.points;
  for (const Sampling& way : possible_samplings(sim)) {
    const Trial trial = trial_of(sim, way);
    if (way.side == dense ? share_of(within_samples(sim, trial, first).right) < plausible
                          : share_of(means_of_samples(sim, trial, first, way.side)) < min_partial) {
      continue;
    }
    // The reference may have other samples than our picture, but it must show the same.
    if (way.texture == TextureMistake::none && way.side == 1 &&
        share_of(within_samples(sim, trial, reference_points(sim, first)).right) < plausible) {
      continue;
    }
    std::vector<Point> rest = sim.points;
    bool sampled = is_sampled(sim, way, sim.points, rest);
    if (sampled && way.side != dense) {
      // A mistake may show in few of the pixels.
      std::vector<Point> many;
      std::mt19937 random(8);
      add_points(sim.reference, sim.test, different, many_points, true, false, random, many);
      sampled = is_sampled(sim, way, many, rest);
    }
    if (sampled) {
      return Claim{Cause::samples, words_of(sim, way), evidence_of_share(1), 1};
    }
    if (rest.size() < least.size()) {
      least = std::move(rest);
    }
  }
  if (2 * least.size() < sim.points.size()) {
    sim.points = std::move(least);
  }
  return std::nullopt;
}

std::optional<Claim> claim_of_missed_samples(Simulation& sim) {
  const Trial trial = sim.right_trial(false);
  const Model model(trial.scene, *sim.shapes, *sim.view->assets, trial.options, trial.mistakes);
  std::size_t partly = 0;
  std::size_t black = 0;
  std::size_t whole = 0;
  std::size_t bright = 0;
  std::size_t candidates = 0;
  const std::size_t all = std::size_t(sim.test.width) * sim.test.height;
  std::vector<std::uint32_t> pixels(all);
  std::iota(pixels.begin(), pixels.end(), 0);
  std::mt19937 random(5);
  for (std::size_t k = 0; k < all && candidates < 3000; ++k) {
    std::swap(pixels[k], pixels[k + random() % (all - k)]);
    const std::size_t i = pixels[k];
    const auto x = static_cast<int>(i % std::size_t(sim.test.width));
    const auto y = static_cast<int>(i / std::size_t(sim.test.width));
    const Range range = around(sim.reference, x, y);
    if (range.calm() || largest_of(range.low) > 4 || largest_of(at(sim.reference, x, y)) < 24) {
      continue;
    }
    ++candidates;
    int hits = 0;
    for (int k = 0; k < 4; ++k) {
      const dvec2 place(x + 0.25 + 0.5 * (k % 2), y + 0.25 + 0.5 * (k / 2));
      hits += model.first_hit(sim.ray(model, place)).part != nullptr;
    }
    if (hits > 0 && hits < 4) {
      ++partly;
      black += largest_of(at(sim.test, x, y)) <= 3 ? 1 : 0;
    } else if (hits == 4) {
      ++whole;
      bright += largest_of(at(sim.test, x, y)) > 3 ? 1 : 0;
    }
  }
  if (partly < few_pixels || static_cast<double>(black) < 0.9 * static_cast<double>(partly) ||
      whole < few_pixels || static_cast<double>(bright) < 0.9 * static_cast<double>(whole)) {
    return std::nullopt;
  }
  return Claim{Cause::samples, missed_samples,
               fmt::format("{} of the pixels that objects cover partly are black",
                           percent(static_cast<double>(black) / static_cast<double>(partly))),
               static_cast<double>(black) / static_cast<double>(partly)};
}

std::optional<Claim> claim_of_blur(Simulation& sim, const Pixels& pixels) {
  std::vector<Point> points;
  std::mt19937 random(6);
  add_points(sim.reference, sim.test, pixels.off, 800, true, true, random, points);
  add_points(sim.reference, sim.test, pixels.same, 300, false, true, random, points);
  for (const auto& [size, filter] : pixel_filters()) {
    Colors predicted;
    Colors before;
    for (const Point& p : points) {
      predicted.push_back(mean_around(sim, p.x, p.y, filter));
      before.push_back(at(sim.reference, p.x, p.y));
    }
    const Score s = score(points, points.size(), predicted);
    const Score b = score(points, points.size(), before);
    double differs = 0;
    double same = 0;
    for (const Point& p : points) {
      (p.differs ? differs : same) += p.weight;
    }
    if (differs > 0 && s.left < (1 - min_explained) * b.left && s.exact >= min_exact * differs &&
        s.broken <= max_broken * same) {
      return Claim{Cause::samples, blurred_by(size), evidence_of_share(1 - s.left / b.left),
                   1 - s.left / b.left};
    }
  }
  return std::nullopt;
}

std::vector<std::uint16_t> edge_mistakes(const Simulation& sim) {
  std::vector<std::uint16_t> found;
  for (std::uint16_t i = 0; i < sim.list.size(); ++i) {
    if (shows_at_edges(sim.list[i])) {
      found.push_back(i);
    }
  }
  return found;
}

Tried with_edges(Simulation& sim, const Tried& found) {
  // A shift makes a camera with a fitted number, or an edited one, fit better.
  const bool other_camera = std::any_of(
      found.mistakes.begin(), found.mistakes.end(),
      [&](std::uint16_t i) { return sim.list[i].stage >= Stage::camera && i >= sim.first_fitted; });
  if (!sim.usable || other_camera || found.mistakes.size() > 2 || !sim.shows_edges()) {
    return found;
  }
  std::optional<std::uint16_t> more;
  {
    const PointsRestored restored(sim);
    more = mistake_at_edges(sim, found.mistakes);
  }
  if (!more) {
    return found;
  }
  const Combination mistakes = joined(found.mistakes, {*more});
  Tried whole =
      sim.rated(mistakes, sim.score_of(mistakes, sim.points.size()), sim.base(sim.points.size()));
  return good(whole) && whole.broken <= found.broken + 0.01 ? whole : found;
}

std::optional<Tried> find_shift(Simulation& sim, const Pixels& pixels) {
  sim.points.clear();
  std::mt19937 random(3);
  add_points(sim.reference, sim.test, pixels.off, 1500, true, true, random, sim.points);
  const std::size_t before = sim.points.size();
  sim.drop_what_samples_explain(false);
  if (sim.points.size() < few_pixels || sim.points.size() < before / 4) {
    return std::nullopt;
  }
  const std::size_t different = sim.points.size();
  add_points(sim.reference, sim.test, pixels.same, 500, false, true, random, sim.points);
  sim.interleave(different);
  sim.prepare_clean();
  std::vector<Combination> shifts;
  for (std::uint16_t i = 0; i < sim.list.size(); ++i) {
    if (sim.list[i].cause == Cause::half_pixel_shift || sim.list[i].stage == Stage::camera) {
      shifts.push_back({i});
    }
  }
  // The best at few points are tried at more.
  std::vector<Tried> tried;
  for (const auto& [count, max_tried] :
       {std::pair(screen / 2, shifts.size()), std::pair(2 * screen, std::size_t{24}),
        std::pair(sim.points.size(), std::size_t{12})}) {
    shifts.resize(std::min(shifts.size(), max_tried));
    tried = sim.try_all(shifts, count, 0.95, 1);
    sort_by(tried, [](const Tried& t) { return t.score.raw; });
    if (tried.empty() || tried.front().explained < enough_shift / 2) {
      return std::nullopt;
    }
    shifts.clear();
    for (const Tried& t : tried) {
      shifts.push_back(t.mistakes);
    }
  }
  // Only a subpixel shift leaves much of the edges unexplained.
  const Tried& best = tried.front();
  return (is_subpixel(sim, best) ? best.explained >= enough_shift && best.exact >= 0.5
                                 : sure(best) && leaves_only_rounding(sim, best.mistakes))
             ? std::optional(best)
             : std::nullopt;
}

bool is_subpixel(const Simulation& sim, const Tried& shift) {
  return sim.list[shift.mistakes.front()].cause == Cause::half_pixel_shift;
}
}  // namespace scenefile
