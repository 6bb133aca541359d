#include "scenefile/grade/sampling_causes.h"

#include "scenefile/grade/claims.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

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
  std::vector<std::uint32_t> edges;
  for (int y = 1; y + 1 < sim.reference.height; ++y) {
    for (int x = 1; x + 1 < sim.reference.width; ++x) {
      if (!around(sim.reference, x, y).calm()) {
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
    const double least = sim.list[i].cause == Cause::samples ? 0.9 : 0.5;
    if (changed >= 2 * few_pixels && gained > std::max(most, least) * changed) {
      most = gained / changed;
      best = i;
    }
  }
  return best;
}

}  // namespace

std::span<const std::pair<const char*, PixelFilter>> pixel_filters() {
  static const std::array<std::pair<const char*, PixelFilter>, 6> filters{
      {{"3 by 3 pixels", {{1, 1, 1}, 1}},
       {"5 by 5 pixels", {{1, 1, 1, 1, 1}, 2}},
       {"2 by 2 pixels", {{1, 1}, 0}},
       {"2 by 2 pixels", {{1, 1}, 1}},
       {"3 by 3 pixels, weighted", {{1, 2, 1}, 1}},
       {"5 by 5 pixels, weighted", {{1, 4, 6, 4, 1}, 2}}}};
  return filters;
}

std::string blurred_by(std::string_view size) {
  return fmt::format("the picture is blurred: each pixel is the mean of {}", size);
}

bool shows_at_edges(const Hypothesis& h) {
  return h.cause == Cause::half_pixel_shift || h.cause == Cause::samples;
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
  std::mt19937 random(5);
  for (std::size_t i = 0; i < all && candidates < 3000; ++i) {
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
    if (differs > 0 && s.left < (1 - enough) * b.left && s.exact >= enough_exact * differs &&
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
  if (!sim.usable || sim.stage_of(found.mistakes) >= Stage::camera || found.mistakes.size() > 2) {
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
  constexpr std::size_t max_tried = 12;  // at all points
  const auto by_rest = [](const Tried& t) { return t.score.raw; };
  std::vector<Tried> tried = sim.try_all(shifts, 2 * screen, 0.95, 0.98);
  sort_by(tried, by_rest);
  shifts.clear();
  for (std::size_t i = 0; i < std::min(max_tried, tried.size()); ++i) {
    shifts.push_back(tried[i].mistakes);
  }
  tried = sim.try_all(shifts, sim.points.size(), 0.98, 1);
  sort_by(tried, by_rest);
  if (tried.empty()) {
    return std::nullopt;
  }
  // Only a subpixel shift leaves much of the edges unexplained.
  const Tried& best = tried.front();
  const bool by_less = sim.list[best.mistakes.front()].cause == Cause::half_pixel_shift;
  return (by_less ? best.explained >= enough_shift && best.exact >= 0.5
                  : sure(best) && leaves_only_rounding(sim, best.mistakes))
             ? std::optional(best)
             : std::nullopt;
}
}  // namespace scenefile
