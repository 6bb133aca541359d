#include "scenefile/grade/several_mistakes.h"

#include "scenefile/grade/acne.h"
#include "scenefile/trace/tasks.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace scenefile {

namespace {

using glm::dvec3;

constexpr std::uint64_t work_for_pairs = 12'000'000;  // rays

// The picture with some mistakes, and with each single mistake in addition.
struct Additions {
  Combination made;
  std::size_t count = 0;
  Colors colors;
  std::vector<std::uint16_t> members;  // mistakes that change these colors
  std::vector<Colors> with;            // by mistake; empty: not a member
};

Additions additions_to(Simulation& sim, const Combination& made, std::size_t count) {
  Additions f;
  f.made = made;
  f.count = std::min(count, sim.points.size());
  const Turn turn = sim.turn_of(made);
  const Colors& right = sim.clean(turn).drawn;
  f.colors = sim.drawn(made, f.count, turn)
                 .value_or(Colors(right.begin(), right.begin() + std::ptrdiff_t(f.count)));
  f.with.resize(sim.list.size());
  for_each_task(sim.list.size(), [&](std::size_t i) {
    const auto other = static_cast<std::uint16_t>(i);
    if (sim.list[i].stage != Stage::picture && fits(sim, made, other)) {
      if (std::optional<Colors> colors = sim.drawn(joined(made, {other}), f.count, turn)) {
        f.with[i] = *std::move(colors);
      }
    }
  });
  for (std::uint16_t i = 0; i < sim.list.size(); ++i) {
    bool changes = false;
    for (std::size_t k = 0; k < f.with[i].size() && !changes; ++k) {
      const dvec3 now = glm::clamp(f.with[i][k], dvec3(0), dvec3(255));
      const dvec3 before = glm::clamp(f.colors[k], dvec3(0), dvec3(255));
      changes = largest_of(glm::abs(now - before)) > tolerance;
    }
    if (changes) {
      f.members.push_back(i);
    } else {
      f.with[i].clear();
    }
  }
  return f;
}

// The correlation between the colors and those of the test.
double likeness(const Simulation& sim, const Colors& colors) {
  double n = 0, a = 0, b = 0, aa = 0, bb = 0, ab = 0;
  for (std::size_t i = 0; i < colors.size(); ++i) {
    const dvec3 c = glm::clamp(colors[i], dvec3(0), dvec3(255));
    for (int k = 0; k < 3; ++k) {
      const double x = c[k];
      const double y = sim.points[i].test[k];
      n += 1;
      a += x;
      b += y;
      aa += x * x;
      bb += y * y;
      ab += x * y;
    }
  }
  const double spread = (n * aa - a * a) * (n * bb - b * b);
  return spread > 0 ? (n * ab - a * b) / std::sqrt(spread) : 0;
}

// Mistakes to combine with all others: those that move objects closer to where the test shows
// them, and those that explain most.
std::vector<Combination> likely_places(const Simulation& sim, const std::vector<Tried>& ranked) {
  std::vector<Combination> result;
  std::vector<std::pair<double, std::uint16_t>> places;
  const std::size_t count = std::min(screen, sim.points.size());
  const auto first = [count](const Colors& colors) {
    return Colors(colors.begin(), colors.begin() + std::ptrdiff_t(count));
  };
  const double least = likeness(sim, first(sim.clean({}).drawn)) + 0.003;
  for (std::uint16_t i = 0; i < sim.list.size(); ++i) {
    const Hypothesis& h = sim.list[i];
    const bool turns = h.turn != Turn();
    if (turns || (h.stage >= Stage::hits && sim.cache[i].size() >= count &&
                  h.cause != Cause::half_pixel_shift)) {
      if (turns) {
        result.push_back({i});
      } else if (const double like = likeness(sim, first(sim.cache[i])); like > least) {
        places.emplace_back(-like, i);
      }
    }
  }
  std::stable_sort(places.begin(), places.end());
  for (std::size_t i = 0; i < std::min<std::size_t>(6, places.size()); ++i) {
    result.push_back({places[i].second});
  }
  const auto add_first = [&](const std::vector<Tried>& list, std::size_t max_count) {
    for (std::size_t i = 0; i < std::min(max_count, list.size()); ++i) {
      const Combination& t = list[i].mistakes;
      if (list[i].merit() > 0.1 && sim.list[t.front()].stage != Stage::picture &&
          std::find(result.begin(), result.end(), t) == result.end()) {
        result.push_back(t);
      }
    }
  };
  add_first(ranked, 4);
  std::vector<Tried> by_exact = ranked;
  sort_by(by_exact, [](const Tried& t) { return -t.exact; });
  add_first(by_exact, 2);
  return result;
}

// The frame's mistakes combined with each single one in addition.
std::vector<Tried> with_each_addition(const Simulation& sim, const Additions& f) {
  const Simulation::Base b = sim.base(f.count);
  std::vector<Tried> result;
  for (const std::uint16_t i : f.members) {
    const Combination mistakes = joined(f.made, {i});
    result.push_back(
        sim.rated(mistakes, score(sim.points, f.count, sim.finished(mistakes, f.with[i])), b));
  }
  sort_by_merit(result);
  result.resize(std::min<std::size_t>(result.size(), 30));
  return result;
}

// Approximates pairs of mistakes by adding or multiplying their changes; then applies
// `on_picture`.
std::vector<Tried> approximate_pairs(const Simulation& sim, const Additions& f,
                                     const Combination& on_picture,
                                     const std::vector<std::uint16_t>& members,
                                     std::size_t max_count) {
  const std::size_t count = std::min(f.count, few_points);
  const Simulation::Base b = sim.base(count);
  std::vector<std::vector<Tried>> found(members.size());
  for_each_task(members.size(), [&](std::size_t i) {
    Colors sum(count);
    Colors product(count);
    for (std::size_t j = i + 1; j < members.size(); ++j) {
      if (!fits(sim, {members[i]}, members[j])) {
        continue;
      }
      const Colors& x = f.with[members[i]];
      const Colors& y = f.with[members[j]];
      for (std::size_t k = 0; k < count; ++k) {
        const dvec3& c = f.colors[k];
        sum[k] = x[k] + y[k] - c;
        for (int channel = 0; channel < 3; ++channel) {
          product[k][channel] =
              c[channel] > 2 ? x[k][channel] * y[k][channel] / c[channel] : sum[k][channel];
        }
      }
      const Score of_sum = score(sim.points, count, sim.finished(on_picture, sum));
      const Score of_product = score(sim.points, count, sim.finished(on_picture, product));
      found[i].push_back(
          sim.rated(joined(joined(f.made, on_picture), joined({members[i]}, {members[j]})),
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

std::vector<std::uint16_t> color_changes(const Simulation& sim) {
  std::vector<std::uint16_t> result;
  for (std::uint16_t i = 0; i < sim.list.size(); ++i) {
    if (sim.list[i].color) {
      result.push_back(i);
    }
  }
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

// Combines the most promising changes of the finished picture with two other mistakes.
std::vector<Tried> pairs_with_picture(const Simulation& sim, const Additions& f,
                                      const std::vector<Tried>& pairs) {
  std::vector<Tried> result;
  std::map<std::uint16_t, std::vector<std::uint16_t>> members;
  for (const Tried& t : pairs) {
    if (t.mistakes.size() != 2) {
      continue;
    }
    for (const bool second : {false, true}) {
      const std::uint16_t p = t.mistakes[second ? 1 : 0];
      const std::uint16_t other = t.mistakes[second ? 0 : 1];
      if (sim.list[p].color && !f.with[other].empty() &&
          (members.size() < 3 || members.contains(p)) && members[p].size() < 50) {
        members[p].push_back(other);
      }
    }
  }
  for (const auto& [p, others] : members) {
    append(result, approximate_pairs(sim, f, {p}, others, 40));
  }
  return result;
}

// Approximates the best pairs combined with a third mistake.
std::vector<Tried> approximate_triples(const Simulation& sim, const Additions& f,
                                       const std::vector<Tried>& pairs) {
  std::vector<Combination> starts;
  for (const Tried& t : pairs) {
    const bool on_picture = std::any_of(t.mistakes.begin(), t.mistakes.end(), [&](std::uint16_t i) {
      return sim.list[i].stage == Stage::picture;
    });
    if (t.mistakes.size() == 2 && !on_picture && starts.size() < 24) {
      starts.push_back(t.mistakes);
    }
  }
  const std::size_t count = std::min(f.count, few_points);
  const Simulation::Base b = sim.base(count);
  std::vector<std::vector<Tried>> found(starts.size());
  for_each_task(starts.size(), [&](std::size_t s) {
    const std::optional<Colors> start = sim.drawn(starts[s], count, Turn());
    for (const std::uint16_t i : f.members) {
      if (!start || !fits(sim, starts[s], i) ||
          std::find(starts[s].begin(), starts[s].end(), i) != starts[s].end()) {
        continue;
      }
      Colors colors(count);
      for (std::size_t k = 0; k < count; ++k) {
        colors[k] = (*start)[k] + f.with[i][k] - f.colors[k];
      }
      found[s].push_back(sim.rated(joined(starts[s], {i}), score(sim.points, count, colors), b));
    }
  });
  std::vector<Tried> result;
  for (const std::vector<Tried>& list : found) {
    append(result, list);
  }
  sort_by_merit(result);
  result.resize(std::min<std::size_t>(result.size(), 120));
  return result;
}

}  // namespace

std::optional<Tried> find_several(Simulation& sim, const std::vector<Tried>& ranked,
                                  const std::vector<Tried>& alone, std::vector<Claim>& claims) {
  const Additions plain = additions_to(sim, {}, screen);
  std::vector<Additions> moved;  // after mistakes in the camera or the shapes
  for (const Combination& made : likely_places(sim, ranked)) {
    if (sim.rays < work_for_pairs && sim.step(0.45)) {
      moved.push_back(additions_to(sim, made, few_points));
    }
  }
  std::vector<Tried> pairs = approximate_pairs(sim, plain, Combination(), plain.members, 120);
  pairs = tried_again(sim, pairs, 120, 0.5, 0.55);
  std::vector<std::pair<double, const Additions*>> by_merit;
  for (const Additions& f : moved) {
    const std::vector<Tried> found = with_each_addition(sim, f);
    by_merit.emplace_back(found.empty() ? 0 : -found.front().merit(), &f);
    append(pairs, found);
  }
  std::stable_sort(by_merit.begin(), by_merit.end(),
                   [](const auto& x, const auto& y) { return x.first < y.first; });
  by_merit.resize(std::min<std::size_t>(by_merit.size(), 2));
  append(pairs, with_picture(sim, plain));
  sort_by_merit(pairs);
  std::vector<Tried> best = verified(sim, pairs, 16, 0.6, 0.65);
  const std::optional<Tried> pair = first_good(sim, best);
  if (pair && sure(*pair)) {
    return pair;
  }
  for (const std::vector<Tried>* list : {&alone, &std::as_const(best)}) {
    std::size_t left = 4;
    for (const Tried& t : *list) {
      if (left > 0 && t.merit() > 0.15 && t.mistakes.size() < 3) {
        --left;
        claims = claims_of_acne(sim, t.mistakes, 0);
        if (!claims.empty()) {
          return std::nullopt;
        }
      }
    }
  }
  if (pairs.empty() || pairs.front().merit() < 0.3 || sim.rays > work_for_pairs) {
    return pair;
  }
  std::vector<Tried> triples = approximate_triples(sim, plain, pairs);
  for (const auto& [merit, f] : by_merit) {
    append(triples, approximate_pairs(sim, *f, Combination(), f->members, 40));
  }
  append(triples, pairs_with_picture(sim, plain, pairs));
  sort_by_merit(triples);
  triples = tried_again(sim, triples, 150, 0.7, 0.9);
  best = verified(sim, triples, 12, 0.9, 1);
  const std::optional<Tried> triple = first_good(sim, best);
  return triple && (!pair || triple->score.left < 0.6 * pair->score.left) ? triple : pair;
}

std::optional<Tried> find_several_of_picture(Simulation& sim, const std::vector<Tried>& ranked) {
  std::vector<Combination> starts;
  for (std::size_t i = 0; i < std::min<std::size_t>(6, ranked.size()); ++i) {
    starts.push_back(ranked[i].mistakes);
  }
  return first_good(sim, verified(sim, extended(sim, starts, few_points, 0.4, 0.9), 12, 0.9, 1));
}
}  // namespace scenefile
