#include "scenefile/grade/candidates.h"

#include <algorithm>

namespace scenefile {

namespace {

using glm::dvec3;

constexpr double necessary = 0.01;  // share of the difference that each of several changes
constexpr std::size_t max_shapes_to_edit = 2000;  // with more: no combinations of shape changes

// Whether the mistake has a number that was estimated from the pictures.
bool is_fitted(const Simulation& sim, std::size_t mistake) {
  return mistake >= sim.first_measured && sim.list[mistake].cause != Cause::background;
}

bool any_fitted(const Simulation& sim, const Combination& mistakes) {
  return std::any_of(mistakes.begin(), mistakes.end(),
                     [&](std::size_t i) { return is_fitted(sim, i); });
}

// Three mistakes, or a fitted number besides others, adapt to much.
bool needs_to_be_sure(const Simulation& sim, const Combination& mistakes) {
  return mistakes.size() > 2 || (mistakes.size() > 1 && any_fitted(sim, mistakes));
}

// Whether one of several mistakes is needed: where it changes the picture, the picture is right
// with it and wrong without it.
bool needed(const Simulation& sim, const Combination& mistakes, std::size_t member) {
  Combination fewer = mistakes;
  fewer.erase(fewer.begin() + std::ptrdiff_t(member));
  const std::size_t count = sim.points.size();
  const Colors with = sim.predicted(mistakes, count);
  const Colors without = sim.predicted(fewer, count);
  double changed = 0;
  double right = 0;
  double gained = 0;
  double shown = 0;  // of what is gained: not darkness
  for (std::size_t i = 0; i < count; ++i) {
    const Point& p = sim.points[i];
    const dvec3 a = glm::clamp(with[i], dvec3(0), dvec3(255));
    const dvec3 b = glm::clamp(without[i], dvec3(0), dvec3(255));
    if (largest_of(glm::abs(a - b)) > right_within) {
      const double now = largest_of(outside(a, p.low, p.high)) <= exact_within ? p.weight : 0;
      const double gain =
          now - (largest_of(outside(b, p.low, p.high)) <= exact_within ? p.weight : 0);
      changed += p.weight;
      right += now;
      gained += gain;
      shown += largest_of(p.test) > 16 ? gain : 0;
    }
  }
  // Whatever moves everything out of sight gives darkness.
  const bool moves = sim.list[mistakes[member]].stage >= Stage::camera;
  const double differs = sim.weight_that_differs(count);
  // What changes little must be right there. A fitted number, and what changes little beside one,
  // must also be needed nearly everywhere: it could hide another mistake.
  const bool little = gained < 0.05 * differs;
  const bool strict = is_fitted(sim, mistakes[member]) || (little && any_fitted(sim, mistakes));
  return changed >= necessary * differs && gained >= (strict ? 0.8 : 0.4) * changed &&
         (!little || right >= 0.9 * changed) && (!moves || shown >= 0.1 * gained);
}

// Moves points that the mistakes do not explain to the front, with one right point in four.
// Returns their number.
std::size_t look_first_at_rest(Simulation& sim, const Combination& mistakes) {
  const Colors colors = sim.predicted(mistakes, sim.points.size());
  std::vector<Point> wrong;
  std::vector<Point> right;
  for (std::size_t i = 0; i < sim.points.size(); ++i) {
    const Point& p = sim.points[i];
    const dvec3 c = glm::clamp(colors[i], dvec3(0), dvec3(255));
    (largest_of(outside(c, p.low, p.high)) > exact_within ? wrong : right).push_back(p);
  }
  const std::size_t count = std::min<std::size_t>(wrong.size(), screen);
  sim.points.clear();
  std::size_t r = 0;
  for (std::size_t i = 0; i < wrong.size(); ++i) {
    sim.points.push_back(wrong[i]);
    if (i % 3 == 2 && r < right.size()) {
      sim.points.push_back(right[r++]);
    }
  }
  sim.points.insert(sim.points.end(), right.begin() + std::ptrdiff_t(r), right.end());
  sim.cache.clear();
  sim.prepare_clean();
  return count + count / 3;
}

// Adds the mistake that explains most of what is left of `all`.
std::optional<Tried> with_one_more(Simulation& sim, const Tried& found, const Simulation::Base& b) {
  const std::size_t count = look_first_at_rest(sim, found.mistakes);
  if (count < few_pixels) {
    return std::nullopt;
  }
  std::vector<Combination> sets;
  for (std::uint16_t i = 0; i < sim.list.size(); ++i) {
    if (std::find(found.mistakes.begin(), found.mistakes.end(), i) == found.mistakes.end() &&
        fits(sim, found.mistakes, i)) {
      sets.push_back(joined(found.mistakes, {i}));
    }
  }
  std::vector<Tried> more = sim.try_all(sets, count, 0.7, 0.9);
  sort_by(more, [](const Tried& t) { return t.score.left; });
  more.resize(std::min<std::size_t>(more.size(), 8));
  for (const Tried& t : more) {
    const Tried whole = sim.rated(t.mistakes, sim.score_of(t.mistakes, sim.points.size()), b);
    if (whole.score.left < 0.6 * found.score.left && good(whole) &&
        (sure(whole) || !needs_to_be_sure(sim, whole.mistakes)) &&
        each_needed(sim, whole.mistakes)) {
      return whole;
    }
  }
  return std::nullopt;
}

}  // namespace

bool good(const Tried& t) {
  return t.explained >= enough && t.exact >= enough_exact && t.broken <= max_broken;
}

bool sure(const Tried& t) {
  return t.explained >= 0.98 && t.exact >= nearly_all;
}

double tie_limit(double raw, double all) {
  return 1.1 * raw + 0.0003 * all;
}

void sort_by(std::vector<Tried>& list, double (*key)(const Tried&)) {
  std::stable_sort(list.begin(), list.end(),
                   [key](const Tried& a, const Tried& b) { return key(a) < key(b); });
}

void sort_by_merit(std::vector<Tried>& list) {
  sort_by(list, [](const Tried& t) { return -t.merit(); });
}

void append(std::vector<Tried>& list, const std::vector<Tried>& more) {
  list.insert(list.end(), more.begin(), more.end());
}

Combination joined(Combination a, const Combination& b) {
  a.insert(a.end(), b.begin(), b.end());
  std::sort(a.begin(), a.end());
  return a;
}

bool fits(const Simulation& sim, const Combination& start, std::uint16_t other) {
  if (sim.list[other].stage == Stage::shapes && sim.shapes->parts.size() > max_shapes_to_edit) {
    return false;
  }
  // Fitted curves of the finished picture adapt to whatever is wrong besides.
  const auto is_fitted_curve = [&](std::uint16_t i) {
    return i >= sim.first_measured && sim.list[i].stage == Stage::picture;
  };
  if (!start.empty() &&
      (is_fitted_curve(other) || std::any_of(start.begin(), start.end(), is_fitted_curve))) {
    return false;
  }
  return std::none_of(start.begin(), start.end(), [&](std::uint16_t i) {
    const Hypothesis& a = sim.list[i];
    const Hypothesis& b = sim.list[other];
    const bool shift = a.cause == Cause::half_pixel_shift || b.cause == Cause::half_pixel_shift;
    return shift ||
           (a.cause == b.cause && a.cause != Cause::specular && a.cause != Cause::texture &&
            a.cause != Cause::shapes) ||
           (a.stage == Stage::shapes && b.stage == Stage::shapes && a.cause == Cause::transforms);
  });
}

bool each_needed(const Simulation& sim, const Combination& mistakes) {
  for (std::size_t i = 0; i < mistakes.size(); ++i) {
    if (!needed(sim, mistakes, i)) {
      return false;
    }
  }
  return true;
}

Tried without_needless(Simulation& sim, Tried found) {
  const std::size_t count = sim.points.size();
  const Simulation::Base b = sim.base(count);
  for (std::size_t i = 0; found.mistakes.size() > 1 && i < found.mistakes.size();) {
    Combination fewer = found.mistakes;
    fewer.erase(fewer.begin() + std::ptrdiff_t(i));
    Tried rest = sim.rated(fewer, sim.score_of(fewer, count), b);
    const Combination one{found.mistakes[i]};
    // A mistake that explains nothing by itself, and nearly nothing beside the others. If all is
    // reproduced with it, without fitted numbers, the few points that need it are evidence enough.
    const bool completes = found.exact >= 0.995 && rest.exact < found.exact - 0.01 &&
                           !needs_to_be_sure(sim, found.mistakes);
    const bool idle = !completes && rest.explained > found.explained - 0.04 &&
                      rest.exact > found.exact - 0.04 &&
                      sim.rated(one, sim.score_of(one, count), b).explained < 0.015;
    if (!idle && needed(sim, found.mistakes, i)) {
      ++i;
      continue;
    }
    found = std::move(rest);
    i = 0;
  }
  return found;
}

Tried completed(Simulation& sim, const Tried& found) {
  const Simulation::Base b = sim.base(sim.points.size());
  if (sim.stopped || found.mistakes.size() > 2) {
    return found;
  }
  std::optional<Tried> more;
  {
    const PointsRestored restored(sim);
    more = with_one_more(sim, found, b);
  }
  return more ? completed(sim, *more) : found;
}

std::optional<Tried> first_good(Simulation& sim, const std::vector<Tried>& best) {
  std::size_t left = 6;
  for (const Tried& t : best) {
    if (!good(t) || left-- == 0) {
      break;
    }
    const Tried fewer = without_needless(sim, t);
    if (good(fewer) && (sure(fewer) || !needs_to_be_sure(sim, fewer.mistakes))) {
      return completed(sim, fewer);
    }
  }
  return std::nullopt;
}

std::vector<Tried> verified(Simulation& sim, const std::vector<Tried>& ranked, std::size_t count,
                            double from, double to) {
  std::vector<Combination> sets;
  for (std::size_t i = 0; i < std::min(count, ranked.size()); ++i) {
    if (ranked[i].merit() > 0.05) {
      sets.push_back(ranked[i].mistakes);
    }
  }
  std::vector<Tried> result = sim.try_all(sets, sim.points.size(), from, to);
  const double all = sim.base(sim.points.size()).left;
  sort_by(result, [](const Tried& t) { return t.score.raw; });
  if (result.empty()) {
    return result;
  }
  // Among those with the same remaining difference, the first in the list.
  const double least = result.front().score.raw;
  // A fitted number is exact where a mistake of known size is only nearly so.
  const bool fitted = result.front().mistakes.front() >= sim.first_measured;
  const double limit = fitted ? least + 0.003 * all : tie_limit(least, all);
  auto last = result.begin();
  while (last != result.end() && last->score.raw <= limit) {
    ++last;
  }
  std::stable_sort(result.begin(), last,
                   [](const Tried& a, const Tried& b) { return a.mistakes < b.mistakes; });
  std::stable_partition(result.begin(), result.end(), [&](const Tried& t) { return good(t); });
  return result;
}

std::vector<Tried> tried_again(Simulation& sim, const std::vector<Tried>& list,
                               std::size_t max_count, double from, double to) {
  std::vector<Combination> sets;
  for (const Tried& t : list) {
    if (sets.size() < max_count && std::find(sets.begin(), sets.end(), t.mistakes) == sets.end()) {
      sets.push_back(t.mistakes);
    }
  }
  std::vector<Tried> result = sim.try_all(sets, few_points, from, to);
  sort_by_merit(result);
  return result;
}

std::vector<Tried> extended(Simulation& sim, const std::vector<Combination>& starts,
                            std::size_t count, double from, double to) {
  std::vector<Combination> sets;
  for (const Combination& start : starts) {
    for (std::uint16_t i = 0; i < sim.list.size(); ++i) {
      Combination mistakes = start;
      if (std::find(start.begin(), start.end(), i) == start.end() && fits(sim, start, i)) {
        mistakes.push_back(i);
        std::sort(mistakes.begin(), mistakes.end());
        sets.push_back(mistakes);
      }
    }
  }
  std::sort(sets.begin(), sets.end());
  sets.erase(std::unique(sets.begin(), sets.end()), sets.end());
  std::vector<Tried> result = sim.try_all(sets, count, from, to);
  sort_by_merit(result);
  return result;
}
}  // namespace scenefile
