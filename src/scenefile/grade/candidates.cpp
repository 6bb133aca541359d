#include "scenefile/grade/candidates.h"

#include "scenefile/trace/tasks.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <set>

namespace scenefile {

namespace {

using glm::dvec3;

constexpr double necessary = 0.01;         // share of the difference that each of several changes
constexpr double nearly_as_exact = 0.004;  // share of the differing pixels
constexpr double complete = 0.97;          // share of the differing pixels that are right
constexpr std::size_t max_shapes_to_edit = 2000;  // with more: no combinations of shape changes

// Whether the mistake has a number that was estimated from the pictures.
bool is_fitted(const Simulation& sim, std::size_t mistake) {
  return mistake >= sim.first_fitted && sim.list[mistake].cause != Cause::background;
}

bool any_fitted(const Simulation& sim, const Combination& mistakes) {
  return std::any_of(mistakes.begin(), mistakes.end(),
                     [&](std::size_t i) { return is_fitted(sim, i); });
}

// Three mistakes, a fitted number, or another brightness can imitate many pictures. Right programs
// take several samples of a pixel, too.
bool needs_to_be_sure(const Simulation& sim, const Combination& mistakes) {
  return mistakes.size() > 2 || any_fitted(sim, mistakes) ||
         std::any_of(mistakes.begin(), mistakes.end(), [&](std::uint16_t i) {
           const Cause cause = sim.list[i].cause;
           return is_about_brightness(cause) || cause == Cause::samples;
         });
}

// Whether another brightness alone comes so near to the picture that two more mistakes only imitate
// what is left.
bool only_refines_brightness(const Simulation& sim, const Tried& t) {
  constexpr double nearly = 0.95;    // of the difference
  constexpr double exactly = 0.995;  // of the differing points
  const bool exact = t.exact >= exactly && !any_fitted(sim, t.mistakes);
  return t.mistakes.size() > 2 && !exact &&
         std::any_of(t.mistakes.begin(), t.mistakes.end(), [&](std::uint16_t i) {
           const std::size_t count = sim.points.size();
           return is_about_brightness(sim.list[i].cause) &&
                  sim.rated({i}, sim.score_of({i}, count), sim.base(count)).explained >= nearly;
         });
}

// What counts as equal: fitted numbers are estimates, so that more does.
double exactness(double rounding, bool fitted) {
  return fitted ? 3 : std::max(1.6, rounding);
}

// Whether a color says much: black and full brightness have many causes.
bool is_telling(const dvec3& color) {
  return largest_of(color) > 3 && std::min({color.x, color.y, color.z}) < 252;
}

// Whether the mistakes explain pixels that are neither black nor full: the others are easily right.
// Several mistakes must be right within rounding, nearly as often as pixels without mistakes.
bool explains_telling_pixels(const Explanation& e) {
  const bool several = !e.without.empty() && e.usable;
  const double exactly = exactness(e.rounding, e.fitted);
  const double min_share = !several ? 0.5 : e.noisy ? 0.8 : 0.93;
  const auto right = [&](const Point& p, const dvec3& color) {
    const double limit = several ? exactly : std::min(right_within, 1 + 0.3 * largest_of(p.test));
    return largest_of(glm::abs(glm::clamp(color, dvec3(0), dvec3(255)) - p.test)) <=
           limit + p.noise;
  };
  double differing = 0, explained = 0, same = 0, equal = 0;
  for (std::size_t i = 0; i < e.points.size(); ++i) {
    const Point& p = e.points[i];
    if (is_telling(p.test)) {
      (p.differs ? differing : same) += p.weight;
      explained += p.differs && right(p, e.with[i]) ? p.weight : 0;
      equal += !p.differs && right(p, e.reference[i]) ? p.weight : 0;
    }
  }
  const double noise = same >= 10 * few_pixels ? 1 - equal / same : 0;
  return explained >= min_share * (1 - noise) * differing;
}

// Whether one of several mistakes is needed.
bool needed(const Simulation& sim, const Combination& mistakes, std::size_t member) {
  Combination fewer = mistakes;
  fewer.erase(fewer.begin() + std::ptrdiff_t(member));
  const std::size_t count = sim.points.size();
  const Effect e = effect_of(sim, sim.predicted(mistakes, count), sim.predicted(fewer, count));
  return needed(e, sim.weight_that_differs(count),
                sim.list[mistakes[member]].stage >= Stage::camera, is_fitted(sim, mistakes[member]),
                any_fitted(sim, mistakes));
}

// Moves points that the mistakes do not explain to the front, with one right point after every
// three of them. Returns how many points to use for screening.
std::size_t look_first_at_rest(Simulation& sim, const Combination& mistakes) {
  const auto [wrong, right] = wrong_and_right(sim, mistakes);
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

// Adds the mistake that explains most of what is left.
std::optional<Tried> with_one_more(Simulation& sim, const Tried& found, const Simulation::Base& b) {
  std::optional<Tried> best;
  for (const Tried& t : likely_additions(sim, found.mistakes)) {
    Tried whole = sim.rated(t.mistakes, sim.score_of(t.mistakes, sim.points.size()), b);
    if ((!best || clearly_better(whole, *best)) && clearly_better(whole, found) &&
        good_enough(sim, whole) && each_needed(sim, whole.mistakes)) {
      best = std::move(whole);
    }
  }
  return best;
}

// Whether the mistakes `t` give the same picture as those found.
bool equally_good(const Simulation& sim, const Tried& t, const Tried& found) {
  return t.score.raw <= tie_limit(found.score.raw, sim.base(sim.points.size()).left) &&
         t.exact >= found.exact - nearly_as_exact;
}

// Whether colors look the same that only differ in one channel, or all are gray.
bool loses_colors(const Hypothesis& curve) {
  const dvec3 before(0.2, 0.5, 0.8);
  const dvec3 after = curve.color(before);
  const auto is_lost = [&](const dvec3& step) { return curve.color(before + step) == after; };
  return (after.r == after.g && after.g == after.b) || is_lost({0.1, 0, 0}) ||
         is_lost({0, 0.1, 0}) || is_lost({0, 0, 0.1});
}

}  // namespace

double rounding_of(const Simulation& sim, const Combination& mistakes) {
  return exactness(sim.rounding(), any_fitted(sim, mistakes));
}

bool good(const Tried& t) {
  return t.explained >= min_explained && t.exact >= min_exact && t.broken <= max_broken;
}

bool good_enough(const Simulation& sim, const Tried& t) {
  return good(t) &&
         (sure(t) || (!needs_to_be_sure(sim, t.mistakes) &&
                      (t.mistakes.size() == 1 || t.exact >= min_explained))) &&
         leaves_only_rounding(sim, t.mistakes) && !only_refines_brightness(sim, t);
}

bool leaves_only_rounding(const Simulation& sim, const Combination& mistakes) {
  const std::size_t count = sim.points.size();
  const Simulation::Clean& clean = sim.clean({});
  const Colors with = sim.predicted(mistakes, count);
  Explanation e{sim.points, clean.reference, sim.usable ? clean.drawn : clean.reference, with};
  for (std::size_t k = 0; mistakes.size() > 1 && k < mistakes.size(); ++k) {
    Combination fewer = mistakes;
    fewer.erase(fewer.begin() + std::ptrdiff_t(k));
    e.without.push_back(sim.predicted(fewer, count));
  }
  for (std::size_t i = 0; sim.usable && i < count; ++i) {
    const ModelPart* seen = clean.hits[i].part;
    e.sources.push_back(seen != nullptr ? seen->source : no_index);
  }
  e.rounding = sim.rounding();
  e.usable = sim.usable;
  e.noisy = e.inexact = sim.has_noise();
  e.fitted = any_fitted(sim, mistakes);
  e.finished = std::any_of(mistakes.begin(), mistakes.end(), [&](std::uint16_t i) {
    return sim.list[i].color || sim.list[i].cause == Cause::samples;
  });
  e.moved = sim.stage_of(mistakes) == Stage::picture || !(sim.turn_of(mistakes) == Turn());
  return leaves_only_rounding(e);
}

bool leaves_only_rounding(const Explanation& e) {
  if (!explains_telling_pixels(e)) {
    return false;
  }
  constexpr double min_share_of_one = 0.65;  // of a mistake that changes much
  constexpr double much = 12;                // mean difference
  constexpr double min_share_of_several = 0.8;
  constexpr double min_share_of_object = 0.5;
  constexpr double min_share_of_member = 0.75;  // of what one of several mistakes changes
  constexpr double min_share_at_edges = 0.6;
  constexpr std::size_t enough_of_group = 2 * few_pixels;
  const bool several = !e.without.empty();
  const auto changes = [](const dvec3& a, const dvec3& b) {
    return largest_of(glm::abs(a - glm::clamp(b, dvec3(0), dvec3(255)))) > 2 * tolerance;
  };
  Share changed;
  Share unchanged;
  Share anywhere;  // of the points that differ
  double difference = 0;
  double differs = 0;
  std::map<std::uint32_t, Share> of_object;
  std::vector<Share> of_member(e.without.size());
  for (std::size_t i = 0; i < e.points.size(); ++i) {
    const Point& p = e.points[i];
    const dvec3 c = glm::clamp(e.with[i], dvec3(0), dvec3(255));
    const bool exactly =
        largest_of(glm::abs(c - p.test)) <= e.rounding + p.noise + (e.finished ? 1 : 0);
    if (several && exactly && !is_telling(p.test)) {
      continue;
    }
    if (p.differs) {
      anywhere.add(exactly);
      difference += p.weight * largest_of(glm::abs(e.reference[i] - p.test));
      differs += p.weight;
    }
    // At edges, the neighbors' colors count as equal.
    if (largest_of(p.high - p.low) > 2 * (tolerance + p.noise)) {
      continue;
    }
    for (std::size_t k = 0; k < e.without.size(); ++k) {
      if (changes(c, e.without[k][i])) {
        of_member[k].add(exactly);
      }
    }
    if (p.differs || changes(c, e.drawn[i])) {
      changed.add(exactly);
      of_object[e.usable ? e.sources[i] : no_index].add(exactly);
    } else {
      unchanged.add(exactly);
    }
  }
  // Other samples of pixels show more in a curve of the finished picture, and elsewhere in a flip.
  if (changed.all < enough_of_group || e.moved) {
    return anywhere.value() >= min_share_at_edges && (!several || anywhere.all >= enough_of_group);
  }
  const double at_best = e.inexact && unchanged.all >= enough_of_group ? unchanged.value() : 1;
  const auto enough_are_exact = [&](const Share& group, double min) {
    return group.all < enough_of_group || group.value() >= min * at_best;
  };
  // One mistake cannot imitate many pictures. Few points may have less by chance.
  const bool one = !several && !e.fitted && difference >= much * differs;
  const double chance = 0.5 / std::sqrt(static_cast<double>(changed.all));
  const double min_share = one ? min_share_of_one - chance : min_share_of_several;
  return changed.value() >= min_share * at_best &&
         std::all_of(
             of_member.begin(), of_member.end(),
             [&](const Share& one) { return enough_are_exact(one, min_share_of_member); }) &&
         std::all_of(of_object.begin(), of_object.end(), [&](const auto& one) {
           return enough_are_exact(one.second, min_share_of_object);
         });
}

bool reproduces_all(const Tried& t) {
  return t.explained >= 0.99 && t.exact >= 0.98;
}

bool sure(const Tried& t) {
  return t.explained >= 0.98 && t.exact >= nearly_all;
}

bool clearly_better(const Tried& a, const Tried& b) {
  const bool completes = a.exact >= complete && a.exact >= b.exact + 2 * necessary &&
                         a.score.left <= 1.2 * b.score.left;
  return a.score.left < 0.6 * b.score.left || completes;
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
  const auto at_edges = [&](std::uint16_t i) { return shows_at_edges(sim.list[i]); };
  if (!start.empty() && at_edges(other) && !sim.shows_edges()) {
    return false;
  }
  const bool only_at_edges = at_edges(other) || std::all_of(start.begin(), start.end(), at_edges);
  if (!start.empty() && !only_at_edges && (sim.any_heavy(start) || sim.any_heavy({other}))) {
    return false;
  }
  const auto combines = [&](std::uint16_t i) { return sim.list[i].combines; };
  if (!start.empty() && !(combines(other) && std::all_of(start.begin(), start.end(), combines))) {
    return false;
  }
  return std::none_of(start.begin(), start.end(), [&](std::uint16_t i) {
    const Hypothesis& a = sim.list[i];
    const Hypothesis& b = sim.list[other];
    // A shift makes a wrong camera fit better.
    const auto shifts = [](const Hypothesis& one, const Hypothesis& two) {
      return one.cause == Cause::half_pixel_shift && two.stage == Stage::camera;
    };
    return shifts(a, b) || shifts(b, a) || hides(a, b) || hides(b, a) ||
           (a.cause == b.cause && a.cause != Cause::specular && a.cause != Cause::texture &&
            a.cause != Cause::shapes) ||
           (replaces_objects(a) && b.stage == Stage::shapes);
  });
}

bool any_differs(const Colors& a, const Colors& b, double limit) {
  return !std::equal(a.begin(), a.end(), b.begin(), [limit](const dvec3& x, const dvec3& y) {
    return largest_of(glm::abs(glm::clamp(x, dvec3(0), dvec3(255)) -
                               glm::clamp(y, dvec3(0), dvec3(255)))) <= limit;
  });
}

bool hides(const Hypothesis& mistake, const Hypothesis& edit) {
  if (edit.cause != Cause::scene_edited) {
    return false;
  }
  if (mistake.color && loses_colors(mistake)) {
    return true;
  }
  return edit.stage == Stage::camera ? mistake.stage == Stage::camera : replaces_objects(mistake);
}

bool is_about_brightness(Cause cause) {
  return cause == Cause::brightness || cause == Cause::gamma;
}

std::vector<std::uint16_t> same_instead(const Simulation& sim, const Combination& mistakes,
                                        const Combination& members) {
  Combination others;
  std::set_difference(mistakes.begin(), mistakes.end(), members.begin(), members.end(),
                      std::back_inserter(others));
  const auto brightens = [&](std::uint16_t i) { return is_about_brightness(sim.list[i].cause); };
  // A change of brightness that fits as well is not worth listing, except for a fitted number.
  const bool may_brighten = std::any_of(members.begin(), members.end(), [&](std::uint16_t i) {
    return brightens(i) || i >= sim.first_fitted;
  });
  std::vector<std::uint16_t> candidates;
  for (std::uint16_t i = 0; i < sim.first_fitted; ++i) {
    if (std::find(mistakes.begin(), mistakes.end(), i) == mistakes.end() && fits(sim, others, i) &&
        (may_brighten || !brightens(i))) {
      candidates.push_back(i);
    }
  }
  for (const std::size_t count : {few_points, sim.points.size()}) {
    const std::size_t n = std::min(count, sim.points.size());
    const Simulation::Base b = sim.base(n);
    const Tried found = sim.rated(mistakes, sim.score_of(mistakes, n), b);
    std::vector<char> same(candidates.size());
    for_each_task(candidates.size(), [&](std::size_t k) {
      const Combination other = joined(others, {candidates[k]});
      const Tried t = sim.rated(other, sim.score_of(other, n), b);
      same[k] = t.score.raw <= tie_limit(found.score.raw, b.left) &&
                t.exact >= found.exact - nearly_as_exact;
    });
    std::vector<std::uint16_t> left;
    for (std::size_t k = 0; k < candidates.size(); ++k) {
      if (same[k] != 0) {
        left.push_back(candidates[k]);
      }
    }
    candidates = std::move(left);
  }
  return candidates;
}

Tried with_fewer(const Simulation& sim, const Tried& found) {
  for (std::size_t i = 1; i < found.mistakes.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      const Combination pair{found.mistakes[k], found.mistakes[i]};
      for (const std::uint16_t one : same_instead(sim, found.mistakes, pair)) {
        Combination fewer{one};
        std::set_difference(found.mistakes.begin(), found.mistakes.end(), pair.begin(), pair.end(),
                            std::back_inserter(fewer));
        std::sort(fewer.begin(), fewer.end());
        const std::size_t count = sim.points.size();
        const Tried t = sim.rated(fewer, sim.score_of(fewer, count), sim.base(count));
        if (good_enough(sim, t) && each_needed(sim, fewer)) {
          return with_fewer(sim, t);
        }
      }
    }
  }
  return found;
}

WrongAndRight wrong_and_right(const Simulation& sim, const Combination& mistakes) {
  WrongAndRight points;
  const Colors colors = sim.predicted(mistakes, sim.points.size());
  for (std::size_t i = 0; i < sim.points.size(); ++i) {
    const Point& p = sim.points[i];
    const dvec3 c = glm::clamp(colors[i], dvec3(0), dvec3(255));
    (largest_of(outside(c, p.low, p.high)) > exact_within ? points.wrong : points.right)
        .push_back(p);
  }
  return points;
}

double likeness(const Simulation& sim, const Colors& colors) {
  Correlation correlation;
  for (std::size_t i = 0; i < colors.size(); ++i) {
    const dvec3 c = glm::clamp(colors[i], dvec3(0), dvec3(255));
    for (int k = 0; k < 3; ++k) {
      correlation.add(c[k], sim.points[i].test[k]);
    }
  }
  return correlation.value();
}

Effect effect_of(const Simulation& sim, const Colors& with, const Colors& without) {
  return effect_of(sim.points, sim.rounding(), with, without);
}

Effect effect_of(const std::vector<Point>& points, double rounding, const Colors& with,
                 const Colors& without) {
  Effect e;
  for (std::size_t i = 0; i < with.size(); ++i) {
    const Point& p = points[i];
    const dvec3 a = glm::clamp(with[i], dvec3(0), dvec3(255));
    const dvec3 b = glm::clamp(without[i], dvec3(0), dvec3(255));
    const double now = largest_of(outside(a, p.low, p.high)) <= exact_within ? p.weight : 0;
    const double gain =
        now - (largest_of(outside(b, p.low, p.high)) <= exact_within ? p.weight : 0);
    e.differing_right += p.differs ? now : 0;
    e.gained_all += gain;
    if (largest_of(glm::abs(a - b)) > right_within) {
      ++e.points;
      e.changed += p.weight;
      e.right += now;
      e.within_rounding += largest_of(glm::abs(a - p.test)) <= rounding + p.noise ? p.weight : 0;
      e.gained += gain;
      e.shown += largest_of(p.test) > dark_up_to ? gain : 0;
    }
  }
  return e;
}

bool reproduces_its_part(const Effect& e, double differs) {
  return e.changed >= min_partial * differs && e.right >= nearly_all * e.changed &&
         e.within_rounding >= 0.8 * e.changed;
}

bool needed(const Effect& e, double differs, bool moves, bool fitted, bool any_fitted) {
  if (e.gained_all < double(few_pixels)) {
    return false;
  }
  const auto reproduces = [&](double share) {
    const double least = e.differing_right >= 0.995 * differs ? necessary : 2 * necessary;
    return e.differing_right >= share * differs && !any_fitted && e.gained_all >= least * differs;
  };
  // A mistake that moves all objects out of view explains dark pixels, whatever their cause is.
  if (moves && e.shown < std::min(0.1 * e.gained, 2 * necessary * differs)) {
    return reproduces(0.995);
  }
  // If all is reproduced without fitted numbers, the points that need a mistake are evidence
  // enough.
  if (reproduces(complete)) {
    return true;
  }
  // A mistake that changes few pixels must be right at nearly all of them. A fitted number, or such
  // a mistake combined with one, must also be needed at nearly all of them: it could hide another
  // mistake.
  const bool little = e.gained < 0.05 * differs;
  const bool strict = fitted || (little && any_fitted);
  const double min_gain = !strict ? 0.4 : e.differing_right >= 0.995 * differs ? 0.3 : 0.8;
  return e.changed >= necessary * differs && e.gained >= min_gain * e.changed &&
         (!little || e.right >= 0.9 * e.changed);
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
    // A mistake is idle if it explains nothing by itself, and adds almost nothing to the others. If
    // everything is reproduced with it, without fitted numbers, the few points that need it are
    // evidence enough.
    const bool completes = (reproduces_all(found) && rest.exact < found.exact - 2 * necessary &&
                            !any_fitted(sim, found.mistakes)) ||
                           (found.exact >= 0.995 && rest.exact < found.exact - necessary &&
                            !needs_to_be_sure(sim, found.mistakes));
    const bool idle = !completes && rest.explained > found.explained - 0.04 &&
                      rest.exact > found.exact - 0.04 &&
                      sim.rated(one, sim.score_of(one, count), b).explained < 0.015 &&
                      leaves_only_rounding(sim, fewer);
    if (!idle && needed(sim, found.mistakes, i)) {
      ++i;
      continue;
    }
    found = std::move(rest);
    i = 0;
  }
  return found;
}

std::vector<Tried> equal_instead(const Simulation& sim, const Tried& found,
                                 const std::vector<Tried>& tried) {
  constexpr std::size_t max_checked = 12;
  const Simulation::Base few = sim.base(few_points);
  const double limit =
      sim.rated(found.mistakes, sim.score_of(found.mistakes, few_points), few).merit() - necessary;
  std::set<Combination> others;
  for (const Tried& t : tried) {
    const bool disjoint = std::none_of(t.mistakes.begin(), t.mistakes.end(), [&](std::uint16_t i) {
      return std::find(found.mistakes.begin(), found.mistakes.end(), i) != found.mistakes.end();
    });
    if (disjoint && t.mistakes.size() == found.mistakes.size() && t.merit() >= limit) {
      others.insert(t.mistakes);
    }
  }
  std::vector<Tried> equal;
  std::size_t left = max_checked;
  const Simulation::Base b = sim.base(sim.points.size());
  for (const Combination& mistakes : others) {
    if (left-- == 0) {
      break;
    }
    Tried t = sim.rated(mistakes, sim.score_of(mistakes, sim.points.size()), b);
    Tried rounded = found;  // a fitted factor is off by half a step
    rounded.score.raw += 0.5 * 3 * b.differs;
    if (equally_good(sim, t, rounded) && good_enough(sim, t)) {
      equal.push_back(std::move(t));
    }
  }
  return equal;
}

std::vector<Tried> likely_additions(Simulation& sim, const Combination& mistakes) {
  constexpr std::size_t glance = 60;  // points
  constexpr std::size_t max_at_a_glance = 100;
  constexpr std::size_t max_count = 8;
  const PointsRestored restored(sim);
  const std::size_t count = look_first_at_rest(sim, mistakes);
  if (count < few_pixels) {
    return {};
  }
  std::vector<Combination> sets;
  for (std::uint16_t i = 0; i < sim.list.size(); ++i) {
    // What shows at edges is looked for there (with_edges() of sampling_causes.cpp).
    if (std::find(mistakes.begin(), mistakes.end(), i) == mistakes.end() &&
        !shows_at_edges(sim.list[i]) && fits(sim, mistakes, i)) {
      sets.push_back(joined(mistakes, {i}));
    }
  }
  const auto best = [&](std::size_t point_count, std::size_t max_sets) {
    std::vector<Tried> tried = sim.try_all(sets, std::min(count, point_count), 0.7, 0.9);
    sort_by(tried, [](const Tried& t) { return t.score.left; });
    tried.resize(std::min(tried.size(), max_sets));
    return tried;
  };
  const std::vector<Tried> at_a_glance = best(glance, max_at_a_glance);
  sets.clear();
  for (const Tried& t : at_a_glance) {
    sets.push_back(t.mistakes);
  }
  return best(count, max_count);
}

Tried completed(Simulation& sim, const Tried& found) {
  const Simulation::Base b = sim.base(sim.points.size());
  if (sim.stopped || found.mistakes.size() > 2) {
    return found;
  }
  const std::optional<Tried> more = with_one_more(sim, found, b);
  return more ? completed(sim, *more) : found;
}

std::optional<Tried> first_good(Simulation& sim, const std::vector<Tried>& best) {
  std::optional<Tried> found;
  std::size_t left = 6;
  for (const Tried& t : best) {
    if (!good(t) || left-- == 0) {
      break;
    }
    Tried fewer = without_needless(sim, t);
    if (good_enough(sim, fewer) && (!found || clearly_better(fewer, *found))) {
      found = std::move(fewer);
    }
  }
  return found;
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
  const double max_exact =
      std::max_element(result.begin(), result.end(), [](const Tried& a, const Tried& b) {
        return a.exact < b.exact;
      })->exact;
  // A fitted number is exact where a mistake of known size is only nearly so.
  const bool fitted = result.front().mistakes.front() >= sim.first_fitted;
  const double limit = fitted ? least + 0.003 * all : tie_limit(least, all);
  auto last = result.begin();
  while (last != result.end() && last->score.raw <= limit) {
    ++last;
  }
  std::stable_sort(result.begin(), last,
                   [](const Tried& a, const Tried& b) { return a.mistakes < b.mistakes; });
  std::stable_partition(result.begin(), last,
                        [&](const Tried& t) { return t.exact >= max_exact - nearly_as_exact; });
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
