#include "scenefile/grade/several_mistakes.h"

#include "scenefile/grade/acne.h"
#include "scenefile/grade/fitted_mistakes.h"
#include "scenefile/grade/sampling_causes.h"
#include "scenefile/trace/tasks.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace scenefile {

namespace {

using glm::dvec3;

constexpr std::uint64_t work_for_several = 14'000'000;  // rays
constexpr std::size_t very_few_points = 40;             // for a first, rough score
constexpr std::size_t max_starts = 32;

// The picture with some mistakes, and with each single mistake in addition.
struct Additions {
  Combination made;
  std::size_t count = 0;
  Colors colors;
  std::vector<std::uint16_t> members;  // mistakes that change these colors
  std::vector<Colors> with;            // by mistake; empty: not a member
};

Colors first_of(const Colors& colors, std::size_t count) {
  return Colors(colors.begin(), colors.begin() + std::ptrdiff_t(count));
}

// With `min_merit`, a mistake is first tried at a few points, and dropped if it has less.
Additions additions_to(Simulation& sim, const Combination& made, std::size_t count,
                       std::optional<double> min_merit = std::nullopt) {
  Additions f;
  f.made = made;
  f.count = std::min(count, sim.points.size());
  const Turn turn = sim.turn_of(made);
  f.colors = sim.drawn(made, f.count, turn).value_or(first_of(sim.clean(turn).drawn, f.count));
  f.with.resize(sim.list.size());
  const std::size_t glance = std::min(f.count, very_few_points);
  const Simulation::Base b = sim.base(glance);
  for_each_task(sim.list.size(), [&](std::size_t i) {
    const auto other = static_cast<std::uint16_t>(i);
    if (sim.list[i].stage == Stage::picture || shows_at_edges(sim.list[i]) ||
        !fits(sim, made, other)) {
      return;
    }
    const Combination mistakes = joined(made, {other});
    if (min_merit) {
      const std::optional<Colors> colors = sim.drawn(mistakes, glance, turn);
      if (!colors ||
          sim.rated(mistakes, score(sim.points, glance, sim.finished(mistakes, *colors)), b)
                  .merit() < *min_merit) {
        return;
      }
    }
    std::optional<Colors> colors = sim.drawn(mistakes, f.count, turn);
    if (colors && any_differs(*colors, f.colors, tolerance)) {
      f.with[i] = *std::move(colors);
    }
  });
  for (std::uint16_t i = 0; i < sim.list.size(); ++i) {
    if (!f.with[i].empty()) {
      f.members.push_back(i);
    }
  }
  return f;
}

// Combinations to extend, in the order of add(), without those that look the same as an earlier
// one.
class Starts {
 public:
  explicit Starts(const Simulation& sim) : sim_(sim), count_(std::min(screen, sim.points.size())) {}

  void add(const Combination& mistakes) {
    const Colors colors = sim_.predicted(mistakes, count_);
    if (std::all_of(seen_.begin(), seen_.end(),
                    [&](const Colors& other) { return any_differs(colors, other, tolerance); })) {
      seen_.push_back(colors);
      items.push_back(mistakes);
    }
  }
  std::vector<Combination> items;

 private:
  const Simulation& sim_;
  std::size_t count_;
  std::vector<Colors> seen_;
};

// Single mistakes to combine with all others, the most promising first: flips, because nothing else
// is right without them; those that explain most, that are right at most points, that are right
// wherever they change the picture, and those with which it looks most like the test, whatever its
// brightness.
std::vector<Combination> likely_starts(const Simulation& sim, const std::vector<Tried>& ranked) {
  const std::size_t count = std::min(screen, sim.points.size());
  std::array<std::vector<std::pair<double, std::uint16_t>>, 4> orders;
  const Colors clean = first_of(sim.clean({}).drawn, count);
  const double likeness_now = likeness(sim, clean);
  const double differs = sim.weight_that_differs(count);
  Starts starts(sim);
  for (const Tried& t : ranked) {
    const std::uint16_t i = t.mistakes.front();
    const Hypothesis& h = sim.list[i];
    if (h.turn != Turn()) {
      starts.add({i});
      continue;
    }
    if (h.stage == Stage::picture || sim.cache[i].size() < count || shows_at_edges(h)) {
      continue;
    }
    if (t.merit() > 0.1) {
      orders[0].emplace_back(-t.merit(), i);
      orders[1].emplace_back(-t.exact, i);
    }
    const Effect effect = effect_of(sim, sim.cache[i], clean);
    if (effect.changed >= 0.03 * differs && effect.right >= 0.5 * effect.changed) {
      orders[2].emplace_back(-effect.right * effect.right / effect.changed, i);
    }
    if (const double like = likeness(sim, sim.cache[i]); like > likeness_now + 0.003) {
      orders[3].emplace_back(-like, i);
    }
  }
  for (auto& order : orders) {
    std::stable_sort(order.begin(), order.end());
  }
  for (std::size_t rank = 0; rank < 16 && starts.items.size() < max_starts; ++rank) {
    for (const auto& order : orders) {
      if (rank < order.size()) {
        starts.add({order[rank].second});
      }
    }
  }
  return std::move(starts.items);
}

std::vector<std::uint16_t> color_changes(const Simulation& sim) {
  std::vector<std::uint16_t> result;
  for (std::uint16_t i = 0; i < sim.list.size(); ++i) {
    if (sim.list[i].color) {
      result.push_back(i);
    }
  }
  return result;
}

// The mistakes combined with each single one in addition.
std::vector<Tried> with_each_addition(const Simulation& sim, const Additions& f) {
  const Simulation::Base b = sim.base(f.count);
  std::vector<Tried> result;
  const auto rate = [&](std::uint16_t i, const Colors& colors) {
    const Combination mistakes = joined(f.made, {i});
    result.push_back(
        sim.rated(mistakes, score(sim.points, f.count, sim.finished(mistakes, colors)), b));
  };
  for (const std::uint16_t i : f.members) {
    rate(i, f.with[i]);
  }
  for (const std::uint16_t i : color_changes(sim)) {
    if (fits(sim, f.made, i)) {
      rate(i, f.colors);
    }
  }
  sort_by_merit(result);
  result.resize(std::min<std::size_t>(result.size(), 30));
  return result;
}

// Approximates pairs of mistakes, in addition to those made, by adding or multiplying their
// changes.
std::vector<Tried> approximate_pairs(const Simulation& sim, const Additions& f,
                                     std::size_t max_count) {
  const std::size_t count = std::min(f.count, few_points);
  const Simulation::Base b = sim.base(count);
  std::vector<std::vector<Tried>> found(f.members.size());
  for_each_task(f.members.size(), [&](std::size_t i) {
    const std::uint16_t one = f.members[i];
    Colors sum(count);
    Colors product(count);
    for (std::size_t j = i + 1; j < f.members.size(); ++j) {
      const std::uint16_t other = f.members[j];
      if (!fits(sim, joined(f.made, {one}), other)) {
        continue;
      }
      const Colors& x = f.with[one];
      const Colors& y = f.with[other];
      for (std::size_t k = 0; k < count; ++k) {
        const dvec3& c = f.colors[k];
        sum[k] = x[k] + y[k] - c;
        for (int channel = 0; channel < 3; ++channel) {
          product[k][channel] =
              c[channel] > 2 ? x[k][channel] * y[k][channel] / c[channel] : sum[k][channel];
        }
      }
      const Score of_sum = score(sim.points, count, sim.finished(f.made, sum));
      const Score of_product = score(sim.points, count, sim.finished(f.made, product));
      found[i].push_back(sim.rated(joined(f.made, joined({one}, {other})),
                                   of_sum.left <= of_product.left ? of_sum : of_product, b));
    }
    sort_by_merit(found[i]);
    found[i].resize(std::min(found[i].size(), max_count));
  });
  std::vector<Tried> result;
  for (const std::vector<Tried>& list : found) {
    append(result, list);
  }
  sort_by_merit(result);
  result.resize(std::min(result.size(), max_count));
  return result;
}

// Combines each change of the finished picture's colors with each single mistake.
std::vector<Tried> with_picture(const Simulation& sim, const Additions& f) {
  const std::vector<std::uint16_t> changes = color_changes(sim);
  const std::size_t count = std::min(f.count, few_points);
  const Simulation::Base b = sim.base(count);
  std::vector<std::vector<Tried>> found(changes.size());
  for_each_task(changes.size(), [&](std::size_t p) {
    for (const std::uint16_t i : f.members) {
      if (fits(sim, {changes[p]}, i)) {
        const Colors colors(f.with[i].begin(), f.with[i].begin() + std::ptrdiff_t(count));
        const Combination mistakes = joined({changes[p]}, {i});
        found[p].push_back(
            sim.rated(mistakes, score(sim.points, count, sim.finished(mistakes, colors)), b));
      }
    }
    sort_by_merit(found[p]);
    found[p].resize(std::min<std::size_t>(found[p].size(), 60));
  });
  std::vector<Tried> result;
  for (const std::vector<Tried>& list : found) {
    append(result, list);
  }
  for (const std::uint16_t p : changes) {
    for (std::uint16_t i = 0; i < sim.list.size(); ++i) {
      if (sim.list[i].stage == Stage::picture && i != p && fits(sim, {p}, i)) {
        const Combination mistakes = joined({p}, {i});
        result.push_back(sim.rated(mistakes, sim.score_of(mistakes, count), b));
      }
    }
  }
  return result;
}

std::optional<Tried> better(const std::optional<Tried>& a, const std::optional<Tried>& b) {
  return b && (!a || clearly_better(*b, *a)) ? b : a;
}

// `found`, or what a step of the search found, if that is better.
void take_better(Simulation& sim, std::optional<Tried>& found, const std::optional<Tried>& other,
                 const char* route) {
  if (other && (!found || clearly_better(*other, *found))) {
    found = other;
    sim.route = route;
  }
}

// The best of what `search` finds from each start, until it explains nearly everything.
template <typename Search>
std::optional<Tried> best_from(Simulation& sim, const std::vector<Combination>& starts, double from,
                               double to, const Search& search) {
  std::optional<Tried> best;
  double done = 0;
  for (const Combination& start : starts) {
    if (sim.rays > work_for_several ||
        !sim.step(from + (to - from) * done++ / static_cast<double>(starts.size()))) {
      break;
    }
    best = better(best, search(start));
    if (best && reproduces_all(*best)) {
      break;
    }
  }
  return best;
}

// Combines each start with each single mistake. Everything that is tried is appended to `tried`.
std::optional<Tried> search_from(Simulation& sim, const std::vector<Combination>& starts,
                                 double from, double to, std::vector<Tried>& tried) {
  return best_from(sim, starts, from, to, [&](const Combination& start) -> std::optional<Tried> {
    const std::vector<Tried> found =
        with_each_addition(sim, additions_to(sim, start, few_points, 0.3));
    append(tried, found);
    if (found.empty() || found.front().merit() < 0.85) {
      return std::nullopt;
    }
    return first_good(sim, verified(sim, found, 6, from, from));
  });
}

// Whether the curve multiplies all values by one number.
bool is_factor(const Hypothesis& curve) {
  const dvec3 once = curve.color(dvec3(0.2));
  return largest_of(glm::abs(curve.color(dvec3(0.4)) - 2.0 * once)) < 1e-6 &&
         largest_of(glm::abs(once - once.x)) < 1e-6;
}

Colors shown(Colors colors) {
  for (dvec3& c : colors) {
    c = glm::clamp(c, dvec3(0), dvec3(255));
  }
  return colors;
}

// The most merit that the colors have with a curve that is fitted to them. Factors are in the list
// of mistakes already.
double merit_with_curve(const Simulation& sim, const Colors& drawn) {
  const std::vector<Point> points(sim.points.begin(),
                                  sim.points.begin() + std::ptrdiff_t(drawn.size()));
  const Colors colors = shown(drawn);
  double best = 0;
  for (const Hypothesis& curve : fitted_curves(points, colors)) {
    if (!is_factor(curve)) {
      Colors curved = colors;
      for (dvec3& c : curved) {
        c = 255.0 * curve.color(c / 255.0);
      }
      const Score s = score(points, points.size(), curved);
      best = std::max(best, sim.rated({}, s, sim.base(points.size())).merit());
    }
  }
  return best;
}

// The mistakes with a curve that is fitted to the picture with them, if that reproduces the test.
std::optional<Tried> reproduced_with_curve(Simulation& sim, const Combination& mistakes) {
  const Simulation::Base b = sim.base(sim.points.size());
  const Turn turn = sim.turn_of(mistakes);
  const Colors colors =
      shown(sim.drawn(mistakes, sim.points.size(), turn).value_or(sim.clean(turn).drawn));
  for (Hypothesis& curve : fitted_curves(sim.points, colors)) {
    if (is_factor(curve)) {
      continue;
    }
    const auto added = static_cast<std::uint16_t>(sim.list.size());
    sim.list.push_back(std::move(curve));
    const Combination all = joined(mistakes, {added});
    const Tried t = sim.rated(all, sim.score_of(all, sim.points.size()), b);
    if (reproduces_all(t) && good_enough(sim, t) && each_needed(sim, all)) {
      return t;
    }
    sim.list.pop_back();
  }
  return std::nullopt;
}

using Ranked = std::vector<std::pair<double, Combination>>;  // by falling merit

// Adds each mistake to those made, and keeps those that come nearest to the test with a curve.
void add_with_curve(Simulation& sim, const Additions& f, Ranked& ranked) {
  std::vector<double> merits(f.members.size());
  for_each_task(merits.size(),
                [&](std::size_t k) { merits[k] = merit_with_curve(sim, f.with[f.members[k]]); });
  for (std::size_t k = 0; k < merits.size(); ++k) {
    ranked.emplace_back(merits[k], joined(f.made, {f.members[k]}));
  }
  std::stable_sort(ranked.begin(), ranked.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
}

// Combines one or two mistakes in drawing with a curve that is fitted to the picture with them.
std::optional<Tried> with_fitted_curve(Simulation& sim, const Additions& plain) {
  constexpr double min_merit = 0.9;
  constexpr double min_merit_of_one = 0.4;  // of two mistakes
  constexpr std::size_t max_tried = 8;
  constexpr double max_left_by_two = 0.08;  // of what one leaves
  constexpr std::size_t max_first = 3;      // mistakes to add another one to
  Ranked ones;
  add_with_curve(sim, plain, ones);
  for (const Turn turn : {Turn{true, false}, Turn{false, true}, Turn{true, true}}) {
    const Colors& drawn = sim.clean(turn).drawn;
    const double merit = merit_with_curve(sim, first_of(drawn, plain.count));
    for (std::uint16_t i = 0; i < sim.first_fitted && merit >= min_merit; ++i) {
      if (sim.list[i].turn == turn) {
        ones.insert(ones.begin(), {merit, {i}});
      }
    }
  }
  const auto best_of = [&](const Ranked& ranked) {
    std::optional<Tried> best;
    for (std::size_t k = 0; k < std::min(max_tried, ranked.size()); ++k) {
      if (ranked[k].first < min_merit) {
        break;
      }
      // The curve may make up for a mistake that is nearly the right one.
      const std::optional<Tried> t = reproduced_with_curve(sim, ranked[k].second);
      best = t && (!best || t->score.raw < best->score.raw) ? t : best;
    }
    return best;
  };
  std::optional<Tried> found = best_of(ones);
  if (found) {
    return found;
  }
  Ranked twos;
  for (std::size_t k = 0; k < std::min(max_first, ones.size()); ++k) {
    if (ones[k].first >= min_merit_of_one && sim.step(0.7)) {
      add_with_curve(sim, additions_to(sim, ones[k].second, few_points), twos);
    }
  }
  found = best_of(twos);
  // A mistake that changes the brightness may only make up for what another curve would do.
  const double left_by_one = ones.empty() ? 1 : 1 - ones.front().first;
  const bool helps = found && 1 - found->merit() < max_left_by_two * left_by_one;
  return helps ? found : std::nullopt;
}

// Combines the best single mistakes with each mistake in sampling, which changes edges and steep
// shading a little, whatever else is wrong.
std::vector<Tried> with_edge_mistakes(Simulation& sim, const std::vector<Tried>& alone) {
  constexpr std::size_t max_mistakes = 10;
  constexpr double min_merit = 0.15;
  std::vector<Combination> sets;
  for (std::size_t k = 0; k < std::min(max_mistakes, alone.size()); ++k) {
    for (const std::uint16_t i : edge_mistakes(sim)) {
      if (alone[k].merit() >= min_merit && fits(sim, alone[k].mistakes, i)) {
        sets.push_back(joined(alone[k].mistakes, {i}));
      }
    }
  }
  return sim.try_all(sets, few_points, 0.45, 0.45);
}

// Mistakes that are right between the specks of acne.
std::vector<Combination> likely_beside_acne(std::vector<Tried> ranked,
                                            const std::vector<Tried>& pairs) {
  constexpr double min_exact = 0.15;
  sort_by(ranked, [](const Tried& t) { return -t.exact; });
  std::vector<Combination> likely;
  const auto add = [&](const std::vector<Tried>& list, std::size_t max_count) {
    for (const Tried& t : list) {
      if (max_count > 0 && t.exact >= min_exact && t.mistakes.size() < 3) {
        --max_count;
        likely.push_back(t.mistakes);
      }
    }
  };
  add(ranked, 16);
  add(pairs, 4);
  return likely;
}

// The pairs that explain most, and of many, those that look most like the test.
std::vector<Combination> pairs_to_extend(const Simulation& sim, std::vector<Tried> pairs) {
  constexpr double min_merit = 0.3;
  constexpr std::size_t max_by_merit = 14;
  constexpr std::size_t max_by_likeness = 8;
  constexpr std::size_t max_examined = 200;
  sort_by_merit(pairs);
  std::erase_if(pairs, [](const Tried& t) { return t.merit() < min_merit; });
  pairs.resize(std::min(pairs.size(), max_examined));
  const std::size_t count = std::min(few_points, sim.points.size());
  std::vector<std::pair<double, std::size_t>> order(pairs.size());
  for_each_task(pairs.size(), [&](std::size_t i) {
    order[i] = {-likeness(sim, sim.predicted(pairs[i].mistakes, count)), i};
  });
  std::sort(order.begin(), order.end());
  Starts starts(sim);
  for (std::size_t i = 0; i < pairs.size() && starts.items.size() < max_by_merit; ++i) {
    starts.add(pairs[i].mistakes);
  }
  const std::size_t most = starts.items.size() + max_by_likeness;
  for (std::size_t i = 0; i < order.size() && starts.items.size() < most; ++i) {
    starts.add(pairs[order[i].second].mistakes);
  }
  return std::move(starts.items);
}

}  // namespace

std::optional<Tried> find_several(Simulation& sim, const std::vector<Tried>& ranked,
                                  const std::vector<Tried>& alone, std::vector<Claim>& claims,
                                  std::vector<Tried>& pairs) {
  const Additions plain = additions_to(sim, {}, screen);
  pairs = tried_again(sim, approximate_pairs(sim, plain, 120), 120, 0.4, 0.45);
  append(pairs, with_picture(sim, plain));
  append(pairs, with_edge_mistakes(sim, alone));
  sort_by_merit(pairs);
  std::vector<Tried> best = verified(sim, pairs, 16, 0.45, 0.5);
  std::optional<Tried> found;
  take_better(sim, found, first_good(sim, best), "pairs");
  if (!found || !reproduces_all(*found)) {
    take_better(sim, found, search_from(sim, likely_starts(sim, ranked), 0.5, 0.7, pairs),
                "starts");
  }
  if (!found || !sure(*found)) {
    take_better(sim, found, with_fitted_curve(sim, plain), "curve");
  }
  if (found) {
    const Tried before = *found;
    found = completed(sim, *found);
    sim.route += found->mistakes == before.mistakes ? "" : "+completed";
  }
  if (found && sure(*found) && found->mistakes.size() < 3) {
    return found;
  }
  // Three mistakes may imitate one beside acne.
  claims = find_acne_beside(sim, likely_beside_acne(ranked, best)).claims;
  if (!claims.empty()) {
    sim.route = "acne-beside";
    return std::nullopt;
  }
  if (found && sure(*found)) {
    return found;
  }
  std::vector<Tried> triples;
  take_better(sim, found, search_from(sim, pairs_to_extend(sim, pairs), 0.7, 0.9, triples),
              "extended-pairs");
  return found;
}

std::optional<Tried> find_several_of_picture(Simulation& sim, const std::vector<Tried>& ranked) {
  std::vector<Combination> starts;
  for (std::size_t i = 0; i < std::min<std::size_t>(6, ranked.size()); ++i) {
    starts.push_back(ranked[i].mistakes);
  }
  const std::optional<Tried> found =
      first_good(sim, verified(sim, extended(sim, starts, few_points, 0.4, 0.9), 12, 0.9, 1));
  sim.route = "pairs-of-picture";
  return found ? std::optional(completed(sim, *found)) : std::nullopt;
}

}  // namespace scenefile
