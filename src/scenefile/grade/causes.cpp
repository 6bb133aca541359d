#include "scenefile/grade/causes.h"

#include "scenefile/grade/acne.h"
#include "scenefile/grade/claims.h"
#include "scenefile/grade/confined.h"
#include "scenefile/grade/edited_scene.h"
#include "scenefile/grade/fitted_functions.h"
#include "scenefile/grade/fitted_mistakes.h"
#include "scenefile/grade/placed_copy.h"
#include "scenefile/grade/reordered.h"
#include "scenefile/grade/sampling_causes.h"
#include "scenefile/grade/several_mistakes.h"
#include "scenefile/grade/smaller_mistakes.h"
#include "scenefile/grade/undrawn.h"
#include "scenefile/trace/tasks.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <numeric>
#include <set>

namespace scenefile {

namespace {

using glm::dvec3;

constexpr double max_share_for_rounding = 0.05;  // share of pixels that differ by more
constexpr double min_share_for_several = 0.001;  // share of pixels that must differ

// The number of causes that give the same picture as one mistake. If it is large, the picture
// contains almost no evidence.
std::size_t causes_as_good(const Simulation& sim, const Tried& found,
                           const std::vector<Tried>& others) {
  std::set<Cause> causes;
  for (const Tried& t : others) {
    if (found.mistakes.size() == 1 && t.mistakes.size() == 1 && good(t) &&
        t.score.raw <= tie_limit(found.score.raw, sim.base(sim.points.size()).left)) {
      causes.insert(sim.list[t.mistakes.front()].cause);
    }
  }
  return causes.size();
}

// The picture with the mistakes at points that need not be the simulation's.
Colors drawn_at(const Simulation& sim, const Combination& mistakes,
                const std::vector<Point>& points) {
  const Turn turn = sim.turn_of(mistakes);
  Colors colors;
  if (sim.stage_of(mistakes) == Stage::picture) {
    for (const Point& p : points) {
      const glm::ivec2 before(sim.middle(p, turn));
      colors.push_back(at(sim.reference, before.x, before.y));
    }
  } else {
    const Trial trial = sim.trial_of(mistakes);
    colors = sim.draw(trial, *sim.shapes_of(mistakes, trial), points, points.size(), turn, nullptr);
  }
  return sim.finished(mistakes, std::move(colors));
}

// Whether the mistakes show most of what is not dark in the test, which may be little: then, few of
// the points are there.
bool shows_bright_pixels(const Simulation& sim, const Tried& t) {
  constexpr std::size_t max_points = 200;
  std::vector<std::uint32_t> bright;
  for (std::uint32_t i = 0; 3 * i < sim.test.rgb.size(); ++i) {
    const std::uint8_t* p = &sim.test.rgb[3 * i];
    if (std::max({p[0], p[1], p[2]}) > dark_up_to &&
        (sim.noise().empty() || !std::isinf(sim.noise()[i]))) {
      bright.push_back(i);
    }
  }
  // Otherwise, the points say enough.
  constexpr std::size_t very_few = 4;
  if (bright.size() < very_few ||
      10 * bright.size() > std::size_t(sim.test.width) * sim.test.height ||
      sim.stage_of(t.mistakes) == Stage::picture) {
    return true;
  }
  std::mt19937 random(5);
  std::vector<Point> points;
  add_points(sim.reference, sim.test, std::move(bright), max_points, true, false, random, points,
             sim.noise());
  const Colors colors = drawn_at(sim, t.mistakes, points);
  std::size_t right = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const dvec3 c = glm::clamp(colors[i], dvec3(0), dvec3(255));
    right += largest_of(outside(c, points[i].low, points[i].high)) <= right_within ? 1 : 0;
  }
  return 2 * right >= points.size();
}

// Whether pixels with contrast near them are no evidence.
bool leaves_out_contrast(const Simulation& sim) {
  return std::any_of(sim.noise().begin(), sim.noise().end(), [](float n) { return std::isinf(n); });
}

// Whether the mistakes also explain the pixels that are not evidence one by one, because
// compression changed them: it hardly changes the means of its blocks, of at most 16x16 pixels.
bool explains_blocks(const Simulation& sim, const Tried& t) {
  constexpr int side = 16;
  constexpr std::size_t max_blocks = 24;
  constexpr double min_share = 0.7;  // less than `enough`: the means are inexact, too
  if (!leaves_out_contrast(sim)) {
    return true;
  }
  const auto mean_of = [&](const auto& color, const glm::ivec2& corner) {
    dvec3 sum(0);
    for (int i = 0; i < side * side; ++i) {
      sum += color(corner + glm::ivec2(i % side, i / side), i);
    }
    return sum / double(side * side);
  };
  const auto of_picture = [](const Texture& picture) {
    return [&picture](const glm::ivec2& p, int /*index*/) { return at(picture, p.x, p.y); };
  };
  std::vector<glm::ivec2> corners;
  for (int y = 0; y + side <= sim.test.height; y += side) {
    for (int x = 0; x + side <= sim.test.width; x += side) {
      const dvec3 off =
          mean_of(of_picture(sim.test), {x, y}) - mean_of(of_picture(sim.reference), {x, y});
      if (largest_of(glm::abs(off)) > 2 * tolerance) {
        corners.emplace_back(x, y);
      }
    }
  }
  // As in add_points(): std::shuffle() differs between libraries.
  std::mt19937 random(6);
  const std::size_t count = std::min(corners.size(), max_blocks);
  for (std::size_t i = 0; i < count; ++i) {
    std::swap(corners[i], corners[i + random() % (corners.size() - i)]);
  }
  corners.resize(count);
  std::vector<Point> points;
  for (const glm::ivec2& corner : corners) {
    for (int i = 0; i < side * side; ++i) {
      Point& p = points.emplace_back();
      p.x = corner.x + i % side;
      p.y = corner.y + i / side;
    }
  }
  const Colors colors = drawn_at(sim, t.mistakes, points);
  double all = 0;
  double left = 0;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const dvec3 test = mean_of(of_picture(sim.test), corners[k]);
    const dvec3 shown = mean_of(
        [&](const glm::ivec2& /*place*/, int i) {
          return glm::clamp(colors[k * side * side + std::size_t(i)], dvec3(0), dvec3(255));
        },
        corners[k]);
    all += largest_of(glm::abs(mean_of(of_picture(sim.reference), corners[k]) - test));
    left += largest_of(outside(shown, test - tolerance, test + tolerance));
  }
  return left <= (1 - min_share) * all;
}

// Whether the picture with the mistakes is not just black, because many mistakes make a picture
// black, and explains a JPEG everywhere.
bool shows_much(const Simulation& sim, const Tried& t) {
  if (!shows_bright_pixels(sim, t) || !explains_blocks(sim, t)) {
    return false;
  }
  double bright = 0;
  double matched = 0;
  const Colors colors = sim.predicted(t.mistakes, sim.points.size());
  for (std::size_t i = 0; i < sim.points.size(); ++i) {
    const Point& p = sim.points[i];
    if (p.differs && largest_of(p.test) > dark_up_to) {
      bright += p.weight;
      const dvec3 c = glm::clamp(colors[i], dvec3(0), dvec3(255));
      matched += largest_of(glm::abs(c - p.test)) <= right_within ? p.weight : 0;
    }
  }
  return matched >= 0.5 * bright;
}

// Whether the mistake changes many pixels that are right, or leaves many of an object wrong. Beside
// pixels with noise, any of their colors counts as equal, so that the score does not show it.
bool is_doubtful(const Simulation& sim, const Tried& t) {
  constexpr double much = 0.1;
  const Colors colors = sim.predicted(t.mistakes, sim.points.size());
  double broken = 0;
  std::map<const ModelPart*, Share> right_on;
  for (std::size_t i = 0; i < sim.points.size(); ++i) {
    const Point& p = sim.points[i];
    const dvec3 c = glm::clamp(colors[i], dvec3(0), dvec3(255));
    const bool right = largest_of(glm::abs(c - p.test)) <= right_within + p.noise;
    broken += p.differs || right ? 0 : p.weight;
    if (sim.usable && (p.differs || !right)) {
      right_on[sim.clean({}).hits[i].part].add(right);
    }
  }
  return broken > much * sim.weight_that_differs(sim.points.size()) ||
         std::any_of(right_on.begin(), right_on.end(), [](const auto& one) {
           return one.second.all >= 2 * few_pixels && one.second.value() < 1 - much;
         });
}

// Points anywhere in the picture, in large numbers: of a mistake that changes little, the points of
// the simulation may miss what it breaks.
struct ManyPoints {
  std::vector<Point> points;
  Colors clean;  // without a mistake
};

ManyPoints many_points(const Simulation& sim) {
  constexpr std::size_t max_points = 4000;
  ManyPoints many;
  std::mt19937 random(5);
  std::vector<std::uint32_t> pixels(std::size_t(sim.test.width) * std::size_t(sim.test.height));
  std::iota(pixels.begin(), pixels.end(), 0);
  std::erase_if(
      pixels, [&](std::uint32_t i) { return !sim.noise().empty() && std::isinf(sim.noise()[i]); });
  add_points(sim.reference, sim.test, std::move(pixels), max_points, false, false, random,
             many.points, sim.noise());
  many.clean = drawn_at(sim, {}, many.points);
  return many;
}

// Whether one of the mistakes breaks many pixels, compared with those that differ without it. At
// edges, the neighbors' colors count as equal, because the numbers of mistakes may be approximate;
// but those of edited scenes are exact.
bool breaks_pixels(const Simulation& sim, const ManyPoints& many, const Tried& t) {
  constexpr double much = 0.1;
  const auto shown = [](const dvec3& color) { return glm::clamp(color, dvec3(0), dvec3(255)); };
  const auto off = [&](const Point& p, const dvec3& color) {
    return largest_of(glm::abs(shown(color) - p.test)) - p.noise;
  };
  const auto beyond_edges = [&](const Point& p, const dvec3& color) {
    return largest_of(outside(shown(color), p.low, p.high)) + tolerance;
  };
  const Colors with = drawn_at(sim, t.mistakes, many.points);
  return std::any_of(t.mistakes.begin(), t.mistakes.end(), [&](std::uint16_t mistake) {
    const bool exact = sim.list[mistake].cause == Cause::scene_edited;
    const double within = exact ? sim.rounding() : rounding_of(sim, t.mistakes);
    Combination rest = t.mistakes;
    std::erase(rest, mistake);
    const Colors without = rest.empty() ? many.clean : drawn_at(sim, rest, many.points);
    double broken = 0;
    for (std::size_t i = 0; i < many.points.size(); ++i) {
      const Point& p = many.points[i];
      const double after = exact ? off(p, with[i]) : beyond_edges(p, with[i]);
      broken += off(p, without[i]) <= within && after > 2 * within ? p.weight : 0;
    }
    const Colors before = sim.predicted(rest, sim.points.size());
    double differs = 0;
    for (std::size_t i = 0; i < sim.points.size(); ++i) {
      const Point& p = sim.points[i];
      differs += off(p, before[i]) > 2 * within ? p.weight : 0;
    }
    return broken > much * differs;
  });
}

// Whether a rival of that cause fits by chance: a brightness often does, and in a nearly gray
// picture exchanged channels do.
bool is_chance(Cause rival, Cause found) {
  return (is_about_brightness(rival) && !is_about_brightness(found)) ||
         (rival == Cause::swapped_channels && found != Cause::swapped_channels);
}

bool reproduces_its_part(const Simulation& sim, const Tried& t) {
  const std::size_t count = sim.points.size();
  const Effect e = effect_of(sim, sim.predicted(t.mistakes, count), sim.predicted({}, count));
  return reproduces_its_part(e, sim.weight_that_differs(count));
}

// Equal but for rounding.
bool equal_colors(const Colors& a, const Colors& b) {
  return !any_differs(a, b, 1);
}

// Whether the mistake only leaves out features that the reference does not show.
bool leaves_out_unseen(const Simulation& sim, std::uint16_t i) {
  const std::size_t count = sim.points.size();
  return sim.list[i].cause == Cause::features &&
         !any_differs(sim.predicted({i}, count), sim.predicted({}, count), tolerance);
}

// Whether both draw the same, also where the points are no evidence.
bool draws_same(const Simulation& sim, const Combination& a, const Combination& b) {
  constexpr std::size_t max_points = 400;
  constexpr double few = 0.005;  // of the pixels
  std::vector<std::uint32_t> pixels(std::size_t(sim.test.width) * std::size_t(sim.test.height));
  std::iota(pixels.begin(), pixels.end(), 0);
  std::mt19937 random(7);
  std::vector<Point> points;
  add_points(sim.reference, sim.test, std::move(pixels), max_points, false, false, random, points);
  const Colors one = drawn_at(sim, a, points);
  const Colors other = drawn_at(sim, b, points);
  Share same;
  for (std::size_t i = 0; i < points.size(); ++i) {
    same.add(!any_differs({one[i]}, {other[i]}, right_within));
  }
  return same.value() >= 1 - few;
}

// A mistake in features that the reference does not show, if it gives the same picture as `member`
// beside the other mistakes; otherwise nullopt.
std::optional<std::uint16_t> features_left_out(const Simulation& sim, const Combination& mistakes,
                                               std::uint16_t member) {
  const std::size_t count = sim.points.size();
  if (any_differs(sim.predicted({member}, count), sim.predicted({}, count), tolerance)) {
    return std::nullopt;
  }
  std::vector<std::uint16_t> same = same_instead(sim, mistakes, {member});
  same.push_back(member);
  const auto found = std::find_if(same.begin(), same.end(),
                                  [&](std::uint16_t i) { return leaves_out_unseen(sim, i); });
  return found == same.end() ? std::nullopt : std::optional(*found);
}

// Moves claims that are not mistakes to the notes. Each claim is about one of `mistakes`.
void separate_notes(const Simulation& sim, const Combination& mistakes, CauseReport& report) {
  for (std::size_t k = mistakes.size(); k-- > 0;) {
    const std::optional<std::uint16_t> left_out =
        mistakes.size() > 1 ? features_left_out(sim, mistakes, mistakes[k]) : std::nullopt;
    if (left_out) {
      report.claims[k].cause = Cause::features;
      report.claims[k].what =
          sim.list[*left_out].what + "; the reference does not show them, either";
    }
    if (left_out || !sim.list[mistakes[k]].mistake) {
      report.notes.push_back(std::move(report.claims[k]));
      report.claims.erase(report.claims.begin() + std::ptrdiff_t(k));
    }
  }
}

// Names the mistakes that could replace one of several without changing the picture: first one of
// each kind, the likeliest before the others. Then a combination that could replace all of them.
void name_ties(const Simulation& sim, const Tried& found, const std::vector<Tried>& equal,
               CauseReport& report) {
  std::set<std::uint16_t> seen_instead;
  for (std::size_t k = 0; k < found.mistakes.size(); ++k) {
    std::vector<std::uint16_t> same = same_instead(sim, found.mistakes, {found.mistakes[k]});
    std::erase_if(same, [&](std::uint16_t i) {
      Tried other = found;
      other.mistakes[k] = i;
      std::sort(other.mistakes.begin(), other.mistakes.end());
      return !explains_blocks(sim, other) || !draws_same(sim, found.mistakes, other.mistakes);
    });
    if (same.empty() || shows_at_edges(sim.list[found.mistakes[k]]) ||
        features_left_out(sim, found.mistakes, found.mistakes[k])) {
      continue;
    }
    seen_instead.insert(same.begin(), same.end());
    same.push_back(found.mistakes[k]);
    std::sort(same.begin(), same.end());
    std::set<Cause> seen;
    std::set<std::string_view> words;
    std::vector<std::uint16_t> more;
    std::vector<std::uint16_t> named;
    for (const std::uint16_t i : same) {
      if (words.insert(sim.list[i].what).second) {
        (seen.insert(sim.list[i].cause).second ? named : more).push_back(i);
      }
    }
    named.insert(named.end(), more.begin(), more.end());
    named.resize(std::min(max_ties, named.size()));
    Claim& one = report.claims[k];
    one.cause = sim.list[named.front()].cause;
    one.what = sim.list[named.front()].what;
    std::vector<std::string> others;
    for (std::size_t i = 1; i < named.size(); ++i) {
      const Hypothesis& h = sim.list[named[i]];
      others.push_back(h.what);
      if (h.cause != one.cause) {
        report.rivals.push_back(
            {h.cause, h.what, evidence_of_share(found.explained), found.explained, true});
      }
    }
    add_alternatives(one, others);
  }
  const auto other = std::find_if(equal.begin(), equal.end(), [&](const Tried& t) {
    return std::none_of(t.mistakes.begin(), t.mistakes.end(),
                        [&](std::uint16_t i) { return seen_instead.contains(i); });
  });
  if (other == equal.end()) {
    return;
  }
  std::string all;
  for (const std::uint16_t i : other->mistakes) {
    const Hypothesis& h = sim.list[i];
    all += (all.empty() ? "" : "; and ") + h.what;
    report.rivals.push_back(
        {h.cause, h.what, evidence_of_share(other->explained), other->explained, true});
  }
  const auto last = std::find_if(found.mistakes.rbegin(), found.mistakes.rend(),
                                 [&](std::uint16_t i) { return bool(sim.list[i].mistake); });
  report.claims[last == found.mistakes.rend() ? 0 : std::size_t(found.mistakes.rend() - last) - 1]
      .what += ". In place of all of these, the following give the same picture: " + all;
}

void claim(const Simulation& sim, const Tried& found, const std::vector<Tried>& others,
           const std::vector<Tried>& several, CauseReport& report) {
  const Simulation::Base b = sim.base(sim.points.size());
  const double values = 3.0 * sim.test.width * sim.test.height;
  report.asked = sim.asked(found.mistakes);
  for (const std::uint16_t i : found.mistakes) {
    Claim one{sim.list[i].cause, sim.list[i].what, {}, found.explained};
    if (found.mistakes.size() == 1) {
      one.evidence = evidence_of_one(found.score.left / values, b.left / values, found.exact);
    } else {
      Combination rest = found.mistakes;
      std::erase(rest, i);
      const Tried without = sim.rated(rest, sim.score_of(rest, sim.points.size()), b);
      one.evidence = evidence_of_several(found.explained, without.explained);
    }
    report.claims.push_back(std::move(one));
  }
  if (found.mistakes.size() > 1) {
    name_ties(sim, found, equal_instead(sim, found, several), report);
    return;
  }
  std::vector<std::string> same;
  const Colors shown = sim.predicted(found.mistakes, sim.points.size());
  std::size_t same_cause = 0;
  std::set<std::string_view> words{sim.list[found.mistakes.front()].what};
  for (const Tried& t : others) {
    const Hypothesis& h = sim.list[t.mistakes.front()];
    if (words.contains(h.what)) {
      continue;
    }
    const bool listed = is_chance(h.cause, sim.list[found.mistakes.front()].cause) ||
                        h.cause == sim.list[found.mistakes.front()].cause ||
                        std::any_of(report.rivals.begin(), report.rivals.end(),
                                    [&](const Claim& c) { return c.cause == h.cause; });
    if (t.mistakes.size() == 1 && t.mistakes != found.mistakes && good(t) &&
        same_cause + 1 < max_ties && t.mistakes.front() < sim.first_fitted &&
        h.cause == sim.list[found.mistakes.front()].cause &&
        equal_colors(shown, sim.predicted(t.mistakes, sim.points.size()))) {
      ++same_cause;
      same.push_back(h.what);
      words.insert(h.what);
    }
    if (t.mistakes.size() == 1 && !listed && good(t) && report.rivals.size() < 3 &&
        t.score.raw <= found.score.raw + rival_margin * b.left) {
      report.rivals.push_back({h.cause, h.what, evidence_of_share(t.explained), t.explained});
      if (t.score.raw <= tie_limit(found.score.raw, b.left) &&
          draws_same(sim, found.mistakes, t.mistakes)) {
        report.rivals.back().said = true;
        same.push_back(h.what);
      }
    }
  }
  add_alternatives(report.claims.back(), same);
}

// Whether two claims name the same mistake. A mistake that is made twice imitates another one.
bool claims_one_twice(const CauseReport& report) {
  std::set<std::string_view> seen;
  return std::any_of(report.claims.begin(), report.claims.end(),
                     [&](const Claim& c) { return !seen.insert(c.what).second; });
}

// Fitted numbers can imitate other mistakes; so can exchanged channels in a nearly gray picture.
bool is_unlikely(const Simulation& sim, std::uint16_t mistake) {
  return mistake >= sim.first_fitted || sim.list[mistake].cause == Cause::swapped_channels;
}

// A likelier mistake that gives the same picture, if there is one.
Tried likeliest(const Simulation& sim, const Tried& found, const std::vector<Tried>& alone) {
  if (!(sim.list[found.mistakes.front()].turn == Turn())) {
    // A flipped picture is that exactly; a mistake in drawing may look nearly like it.
    for (const Tried& t : alone) {
      if (sim.list[t.mistakes.front()].stage != Stage::picture && sure(t) &&
          t.explained > found.explained + 0.002) {
        return t;
      }
    }
  }
  if (!is_unlikely(sim, found.mistakes.front())) {
    return found;
  }
  const Colors shown = sim.predicted(found.mistakes, sim.points.size());
  for (const Tried& t : alone) {
    if (!is_unlikely(sim, t.mistakes.front()) && good(t) &&
        equal_colors(shown, sim.predicted(t.mistakes, sim.points.size()))) {
      return t;
    }
  }
  return found;
}

// The mistakes that explain most, without those that look the same as an earlier one.
std::vector<Combination> most_likely(const Simulation& sim, std::vector<Tried> tried) {
  constexpr std::size_t max_count = 5;
  constexpr double min_merit = 0.15;
  sort_by_merit(tried);
  std::vector<Combination> likely;
  double last = 0;
  for (const Tried& t : tried) {
    if (t.merit() < min_merit || likely.size() == max_count) {
      break;
    }
    if (std::abs(t.merit() - last) > 1e-6 && !sim.any_heavy(t.mistakes)) {
      likely.push_back(t.mistakes);
      last = t.merit();
    }
  }
  return likely;
}

// Functions of the lighting equation, beside the mistakes that were made, too. `only`: the term to
// fit; all if there is none.
std::vector<Tried> fitting_functions(Simulation& sim, const Combination& made_too,
                                     std::optional<Term> only = std::nullopt) {
  const Simulation::Base b = sim.base(sim.points.size());
  std::vector<Tried> fitting;
  for (Hypothesis& h : fitted_functions(sim, made_too, only)) {
    sim.list.push_back(std::move(h));
    const Combination all = joined(made_too, {static_cast<std::uint16_t>(sim.list.size() - 1)});
    fitting.push_back(sim.rated(all, sim.score_of(all, sim.points.size()), b));
  }
  return fitting;
}

// Whether a function explains the picture, with the other mistakes.
bool is_cause(const Simulation& sim, const Tried& t) {
  return sure(t) && t.broken <= max_broken && leaves_only_rounding(sim, t.mistakes) &&
         (t.mistakes.size() == 1 || each_needed(sim, t.mistakes));
}

// A function that explains the picture beside one of these mistakes.
std::optional<Tried> function_beside(Simulation& sim, const std::vector<Combination>& likely) {
  for (const Combination& mistakes : likely) {
    const bool drawn = std::none_of(mistakes.begin(), mistakes.end(),
                                    [&](std::uint16_t i) { return bool(sim.list[i].color); });
    if (drawn && !sim.stopped) {
      for (Tried& t : fitting_functions(sim, mistakes)) {
        if (is_cause(sim, t)) {
          return std::move(t);
        }
      }
    }
  }
  return std::nullopt;
}

// Single mistakes beside which a function may explain the picture: those that explain most, and
// those that look most like it.
std::vector<std::uint16_t> likely_beside_functions(const Simulation& sim,
                                                   const std::vector<Tried>& ranked) {
  constexpr std::size_t max_count = 40;  // of each
  std::vector<std::uint16_t> by_merit;
  std::vector<std::pair<double, std::uint16_t>> by_likeness;
  for (const Tried& t : ranked) {
    const std::uint16_t i = t.mistakes.front();
    const Hypothesis& h = sim.list[i];
    if (h.stage != Stage::picture && h.turn == Turn() && i < sim.first_fitted && h.combines &&
        !h.color && !sim.any_heavy({i})) {
      by_merit.push_back(i);
      by_likeness.emplace_back(-likeness(sim, sim.cache[i]), i);
    }
  }
  std::stable_sort(by_likeness.begin(), by_likeness.end());
  by_merit.resize(std::min(by_merit.size(), max_count));
  for (std::size_t k = 0; k < std::min(by_likeness.size(), max_count); ++k) {
    if (const std::uint16_t i = by_likeness[k].second;
        std::find(by_merit.begin(), by_merit.end(), i) == by_merit.end()) {
      by_merit.push_back(i);
    }
  }
  return by_merit;
}

// A function that explains the picture beside one of these mistakes, where it does so roughly.
std::optional<Tried> function_beside_any(Simulation& sim,
                                         const std::vector<std::uint16_t>& mistakes) {
  constexpr std::uint64_t max_rays = 3'000'000;
  constexpr std::size_t max_fitted = 5;
  constexpr std::size_t chunk = 8;
  const std::uint64_t last_ray = sim.rays + max_rays;
  std::vector<std::array<double, term_count>> left(mistakes.size());
  for (std::array<double, term_count>& one : left) {
    one.fill(infinity);
  }
  for (std::size_t first = 0; first < mistakes.size() && sim.rays < last_ray && sim.step(0.95);
       first += chunk) {
    for_each_task(std::min(chunk, mistakes.size() - first), [&](std::size_t i) {
      left[first + i] = left_with_functions(sim, {mistakes[first + i]});
    });
  }
  struct Lead {
    double left;
    std::uint16_t mistake;
    Term term;
  };
  std::vector<Lead> leads;
  for (std::size_t i = 0; i < mistakes.size(); ++i) {
    for (std::size_t k = 0; k < term_count; ++k) {
      if (left[i][k] < infinity && sim.list[mistakes[i]].cause != cause_of(Term(k))) {
        leads.push_back({left[i][k], mistakes[i], Term(k)});
      }
    }
  }
  std::stable_sort(leads.begin(), leads.end(),
                   [](const Lead& a, const Lead& b) { return a.left < b.left; });
  leads.resize(std::min(leads.size(), max_fitted));
  for (const Lead& lead : leads) {
    for (Tried& t : fitting_functions(sim, {lead.mistake}, lead.term)) {
      if (is_cause(sim, t)) {
        return std::move(t);
      }
    }
  }
  return std::nullopt;
}

// Puts functions that explain the picture before the others. Otherwise, looks for them beside
// `likely` mistakes, beside those that explain what a function leaves, and beside others. Adds the
// best to `likely` if nothing is found.
std::vector<Tried> with_fitted_functions(Simulation& sim, std::vector<Tried> alone,
                                         const std::vector<Tried>& ranked,
                                         std::vector<Combination>& likely,
                                         std::optional<Tried>& found) {
  std::vector<Tried> fitting = fitting_functions(sim, {});
  std::optional<Tried> best;
  for (const Tried& t : fitting) {
    best = t.explained >= min_partial && (!best || t.explained > best->explained) ? t : best;
  }
  std::erase_if(fitting, [&](const Tried& t) { return !is_cause(sim, t); });
  // If several functions fit, the picture does not determine any of them.
  if (std::any_of(fitting.begin(), fitting.end(), [&](const Tried& t) {
        return sim.list[t.mistakes.front()].cause != sim.list[fitting[0].mistakes.front()].cause;
      })) {
    return alone;
  }
  append(fitting, alone);
  if (fitting.size() > alone.size()) {
    // Several mistakes that leave less are not imitated by chance.
    const double limit = found && found->mistakes.size() > 1 ? 1.1 : 0.6;
    const bool better = !found || fitting.front().score.raw < limit * found->score.raw;
    found = better ? fitting.front() : *found;
    sim.route = better ? "function" : sim.route;
    return better ? fitting : alone;
  }
  if (found) {
    return alone;
  }
  std::vector<Combination> beside = likely;
  if (best) {
    constexpr std::size_t max_others = 3;
    const std::uint16_t function = best->mistakes.front();
    std::vector<Tried> additions = likely_additions(sim, best->mistakes);
    additions.resize(std::min(max_others, additions.size()));
    for (Tried& t : additions) {
      std::erase(t.mistakes, function);
      if (t.mistakes.front() < sim.first_fitted) {
        beside.push_back(std::move(t.mistakes));
      }
    }
  }
  found = function_beside(sim, beside);
  sim.route = "function-beside";
  if (!found) {
    found = function_beside_any(sim, likely_beside_functions(sim, ranked));
    sim.route = "function-beside-any";
  }
  if (!found && best) {
    likely.push_back(best->mistakes);
  }
  return fitting;
}

// Claims a shift that explains the edges. `all`: only one by less than a pixel that explains all of
// the picture.
bool claim_shift(Simulation& sim, const Pixels& pixels, bool all, CauseReport& report) {
  if (!sim.shows_edges()) {
    return false;
  }
  const PointsRestored restored(sim);
  const std::optional<Tried> shift = find_shift(sim, pixels);
  if (!shift || (all && !(is_subpixel(sim, *shift) && sure(*shift) &&
                          leaves_only_rounding(sim, shift->mistakes)))) {
    return false;
  }
  sim.route = "shift";
  claim(sim, *shift, {}, {}, report);
  return true;
}

// One of the mistakes that explain nearly everything, with one that shows at edges, if these leave
// nothing but rounding: pixels that are shifted differ a little wherever the shading is not flat.
std::optional<Tried> one_with_edges(Simulation& sim, const std::vector<Tried>& alone) {
  constexpr std::size_t max_tried = 3;
  std::size_t left = max_tried;
  for (const Tried& t : alone) {
    if (t.mistakes.front() >= sim.first_fitted || !good(t) || !sure(t) || left-- == 0) {
      continue;
    }
    Tried whole = with_edges(sim, t);
    if (whole.mistakes != t.mistakes && leaves_only_rounding(sim, whole.mistakes)) {
      return whole;
    }
  }
  return std::nullopt;
}

// `asked`: what find_causes() was asked to look for. `likely`: set to what explains most, without
// claims.
void search(Simulation& sim, const Pixels& pixels, LookFor look_for, LookFor asked,
            CauseReport& report, std::vector<Combination>& likely) {
  if (sim.usable) {
    sim.fill_cache(screen, asked);
  }
  std::vector<Combination> singles;
  for (std::uint16_t i = 0; i < sim.list.size(); ++i) {
    // Other samples of pixels show at edges, where sampling_causes.cpp looks.
    const bool drawn = !sim.usable || sim.list[i].stage == Stage::picture || !sim.cache[i].empty();
    if (drawn && !shows_at_edges(sim.list[i])) {
      singles.push_back({i});
    }
  }
  std::vector<Tried> ranked = sim.try_all(singles, screen, 0, 0.3);
  sort_by_merit(ranked);
  if (asked == LookFor::single_mistakes) {
    std::erase_if(ranked, [](const Tried& t) { return t.merit() < min_partial; });
  }
  std::vector<Tried> alone = verified(sim, ranked, 16, 0.3, 0.4);
  const ManyPoints many = sim.usable ? many_points(sim) : ManyPoints();
  std::erase_if(alone, [&](const Tried& t) {
    return good(t) && (!explains_blocks(sim, t) || breaks_pixels(sim, many, t));
  });
  if (sim.stopped && alone.empty()) {
    return;
  }
  std::optional<Tried> found;
  // A fitted number or another brightness must explain more than other mistakes, because it can
  // imitate them.
  const auto imitates = [&](std::uint16_t i) {
    return i >= sim.first_fitted || is_about_brightness(sim.list[i].cause);
  };
  const auto first = std::find_if(alone.begin(), alone.end(), [&](const Tried& t) {
    return good(t) && (!imitates(t.mistakes.front()) || sure(t)) &&
           leaves_only_rounding(sim, t.mistakes);
  });
  const bool single = first != alone.end();
  const bool doubtful = single && is_doubtful(sim, *first);
  if (!single || doubtful || first->exact < nearly_all) {
    const double least = single && !doubtful ? first->exact : 0;
    report.claims = with_camera(sim, find_acne(sim, {}, least)).claims;
  }
  if (!report.claims.empty()) {
    sim.route = report.claims.size() == 1 ? "acne" : "acne+camera";
    return;
  }
  if (!single && look_for == LookFor::several_at_once && sim.usable &&
      claim_shift(sim, pixels, true, report)) {
    return;
  }
  if (single) {
    found = completed(sim, *first);
    sim.route = found->mistakes == first->mistakes ? "single" : "single+completed";
  } else if (look_for == LookFor::several_at_once) {
    found = one_with_edges(sim, alone);
    sim.route = found ? "single+edges" : "";
  }
  std::vector<Tried> several;
  const std::string route_of_single = sim.route;
  if (look_for == LookFor::several_at_once && !(found && sure(*found)) &&
      report.share_different >= min_share_for_several) {
    std::optional<Tried> more = sim.usable
                                    ? find_several(sim, ranked, alone, report.claims, several)
                                    : find_several_of_picture(sim, ranked);
    if (!report.claims.empty()) {
      return;
    }
    if (more && more->mistakes.size() == 1 && shows_at_edges(sim.list[more->mistakes.front()])) {
      more.reset();  // sampling_causes.cpp knows better
    }
    if (more && (!found || clearly_better(*more, *found))) {
      found = more;
    } else {
      sim.route = route_of_single;
    }
  }
  if (look_for == LookFor::several_at_once && !sim.stopped) {
    // A function is likelier than several mistakes with a number that is fitted to the picture.
    if (!found || std::any_of(found->mistakes.begin(), found->mistakes.end(), imitates)) {
      likely = found ? std::vector<Combination>() : most_likely(sim, ranked);
      alone = with_fitted_functions(sim, std::move(alone), ranked, likely, found);
    }
  }
  if (found && found->mistakes.size() == 1) {
    const Tried likelier = likeliest(sim, *found, alone);
    sim.route += likelier.mistakes == found->mistakes ? "" : "+likeliest";
    found = likelier;
  }
  if (found && sim.usable && !sim.stopped && breaks_pixels(sim, many, *found)) {
    found.reset();
  }
  if (found && shows_much(sim, *found) &&
      (sure(*found) || causes_as_good(sim, *found, alone) < 3)) {
    Tried all = with_fewer(sim, *found);
    sim.route += all.mistakes == found->mistakes ? "" : "+fewer";
    found = all;
    if (look_for == LookFor::several_at_once) {
      PointsRestored restored(sim);
      Tried more = with_smaller_mistakes(sim, pixels, all);
      if (more.mistakes != all.mistakes && !breaks_pixels(sim, many, more)) {
        restored.keep_new();
        all = std::move(more);
      }
    }
    sim.route += all.mistakes == found->mistakes ? "" : "+smaller";
    const Tried inside = all;
    all = with_edges(sim, inside);
    sim.route += all.mistakes == inside.mistakes ? "" : "+edges";
    claim(sim, all, alone, several, report);
    if (!claims_one_twice(report)) {
      separate_notes(sim, all.mistakes, report);
      return;
    }
    report.claims.clear();
    report.rivals.clear();
    report.asked.reset();
  }
  if (look_for == LookFor::several_at_once && !sim.stopped) {
    report.confined = confined_to(sim);
    if (likely.empty()) {
      likely = most_likely(sim, std::move(ranked));
    }
  }
  for (const Tried& t : alone) {
    if (t.explained >= min_partial && t.broken <= max_broken &&
        t.mistakes.front() < sim.first_fitted && shows_much(sim, t) &&
        reproduces_its_part(sim, t) && !breaks_pixels(sim, many, t)) {
      const Hypothesis& h = sim.list[t.mistakes.front()];
      report.partial.push_back(
          {h.cause, h.what,
           evidence_of_share(t.explained) +
               "; something else is wrong, too, or this mistake has another form",
           t.explained});
      report.asked = sim.asked(t.mistakes);
      return;
    }
  }
}

// Whether the picture was drawn from an edited scene.
// `likely`: what may be wrong, too.
bool claim_edited_scene(Simulation& sim, const std::vector<Combination>& likely,
                        CauseReport& report) {
  if (!sim.usable || !sim.significant() || sim.stopped) {
    return false;
  }
  const std::optional<Tried> found = find_edited_scene(sim, likely);
  if (found && shows_much(sim, *found) && !breaks_pixels(sim, many_points(sim), *found)) {
    sim.route = found->mistakes.size() == 1 ? "edited" : "edited-beside";
    claim(sim, *found, {}, {}, report);
    return true;
  }
  return false;
}

// Claims an edited scene, or other samples. A subpixel shift is likelier than a camera that was
// moved a little.
void claim_small_changes(Simulation& sim, const Pixels& pixels, bool edited,
                         const std::vector<Combination>& likely, CauseReport& report) {
  CauseReport shifted = report;
  claim_shift(sim, pixels, false, shifted);
  const bool subpixel =
      !shifted.claims.empty() && shifted.claims.front().cause == Cause::half_pixel_shift;
  if (!edited || subpixel || !claim_edited_scene(sim, likely, report)) {
    report = std::move(shifted);
  }
}

// The share of the differing points where the test has the copy's colors.
double exact_share(const Simulation& sim, const PlacedCopy& copy) {
  Colors colors;
  for (const Point& p : sim.points) {
    colors.push_back(copy.color(p.x, p.y));
  }
  return score(sim.points, sim.points.size(), colors).exact /
         std::max(1.0, sim.weight_that_differs(sim.points.size()));
}

// The pixels that differ, also where the contrast is high if they differ by more than compression
// changes them.
std::vector<std::uint32_t> different_by_much(const Simulation& sim) {
  // Compression at quality 75 changes 2 % of the pixels of twelve test scenes by more.
  constexpr float much = 32;
  std::vector<float> noise = sim.noise();
  for (float& n : noise) {
    n = std::min(n, much);
  }
  return sorted_pixels(sim.reference, sim.test, noise).different;
}

CauseReport look_for_causes(Simulation& sim, LookFor asked) {
  // Compression and scaling lose details that could show that an edit is wrong.
  const bool edited = asked == LookFor::several_at_once && sim.view != nullptr && !sim.has_noise();
  LookFor look_for = asked;
  CauseReport report;
  const Pixels pixels = sim.sorted();
  const double all = static_cast<double>(sim.test.width) * sim.test.height;
  report.share_different = static_cast<double>(pixels.different.size()) / all;
  report.only_details = only_details(pixels, sim.test);
  report.share_scene_unlike = sim.look_at_scene();
  if (leaves_out_contrast(sim)) {
    // Acne has much contrast, so the pixels that are evidence do not show it.
    if (std::optional<Claim> acne = claim_of_inexact_acne(sim)) {
      report.only_details = false;
      report.claims.push_back(*std::move(acne));
      sim.route = "acne";
      return report;
    }
  }
  if (pixels.off.size() < few_pixels && pixels.different.size() < few_pixels) {
    return report;
  }
  std::optional<Claim> undrawn = claim_of_undrawn_part(
      sim.reference, sim.test, sim.shows_edges() ? pixels.different : different_by_much(sim));
  if (undrawn) {
    // A color other than black may be an object that fills the view, and small things may be shown.
    const bool black = std::all_of(sim.test.rgb.begin(), sim.test.rgb.end(),
                                   [](std::uint8_t value) { return value <= 2; });
    if (!sim.usable || black || !only_color(sim.test)) {
      report.claims.push_back(*std::move(undrawn));
      sim.route = "undrawn";
      return report;
    }
    look_for = LookFor::single_mistakes;
  }
  std::optional<PlacedCopy> copy;
  if (!undrawn) {
    copy = find_placed_copy(sim.reference, sim.test, pixels.different);
    if (copy && !sim.usable) {
      report.claims.push_back(std::move(copy->claim));
      sim.route = "copy";
      return report;
    }
    // A mistake in the camera may look like a shift.
    look_for = copy ? LookFor::single_mistakes : look_for;
  }
  sim.list = picture_hypotheses();
  if (sim.usable) {
    std::vector<Hypothesis> drawn =
        drawing_hypotheses(*sim.view, static_cast<int>(std::lround(sim.whole().x)),
                           static_cast<int>(std::lround(sim.whole().y)));
    std::move(drawn.begin(), drawn.end(), std::back_inserter(sim.list));
  }
  std::mt19937 random(1);
  add_differing_points(sim.reference, sim.test, pixels.different, 1200, random, sim.points,
                       sim.noise());
  if (!undrawn && !copy) {
    if (std::optional<Claim> note = drop_other_samples(sim, pixels.different)) {
      report.notes.push_back(*std::move(note));
      sim.route = "other-samples";
      return report;
    }
  }
  sim.drop_what_samples_explain(true);
  const std::size_t different = sim.points.size();
  add_points(sim.reference, sim.test, pixels.same, 400, false, false, random, sim.points,
             sim.noise());
  sim.interleave(different);
  sim.prepare_clean();
  sim.first_fitted = sim.list.size();
  if (sim.usable) {
    sim.fill_cache(screen, asked);
    add_factors_of_picture(sim);
  }
  for (Hypothesis& curve : fitted_curves(sim.points, sim.clean({}).reference)) {
    sim.list.push_back(std::move(curve));
  }
  if (sim.usable) {
    if (std::optional<Hypothesis> added =
            addition_to_objects(sim.points, sim.clean({}).reference)) {
      sim.list.push_back(*std::move(added));
    }
    add_background(sim);
    add_zooms(sim);
    add_factors(sim);
    add_exponents(sim);
    add_missing_objects(sim);
  }
  std::vector<Combination> likely;
  if (sim.significant()) {
    search(sim, pixels, look_for, asked, report, likely);
  }
  if (undrawn) {
    if (report.claims.empty()) {
      report.asked.reset();
      report.claims.push_back(*std::move(undrawn));
      sim.route = "undrawn";
    }
    return report;
  }
  if (copy) {
    if (report.claims.empty() || report.claims.front().explained < 0.98) {
      report.claims.clear();
      report.rivals.clear();
      report.asked.reset();
      // A camera that is turned a little shifts the picture, but not by whole pixels everywhere.
      if (!edited || exact_share(sim, *copy) >= nearly_all ||
          !claim_edited_scene(sim, {}, report)) {
        report.claims = {std::move(copy->claim)};
        if (sim.view != nullptr && sim.view->asked) {
          const glm::ivec2 place(*sim.view->asked);
          report.asked.emplace().color = copy->color(place.x, place.y);
        }
        sim.route = "copy";
      }
    }
    return report;
  }
  if (report.claims.empty() && report.notes.empty() && !sim.stopped) {
    std::optional<Claim> found = claim_of_blur(sim, pixels);
    sim.route = "blur";
    if (!found && sim.usable) {
      found = claim_of_missed_samples(sim);
      sim.route = "missed-samples";
    }
    if (found) {
      report.asked.reset();
      report.claims.push_back(*std::move(found));
    } else if (sim.usable) {
      claim_small_changes(sim, pixels, edited, likely, report);
    }
  }
  return report;
}

// The claim of another order of pixels or channels, and of what is wrong beside it, if these
// explain the test.
std::optional<CauseReport> causes_beside_order(const Texture& reference, const Texture& test,
                                               const std::optional<Reordered>& reordered,
                                               const SceneView& view,
                                               const std::function<bool(double)>& go_on) {
  if (!reordered) {
    return std::nullopt;
  }
  SceneView in_order = view;
  in_order.asked.reset();  // a pixel of the test is elsewhere in that picture
  Simulation sim{reference, reordered->picture, &in_order, go_on};
  CauseReport rest = look_for_causes(sim, LookFor::several_at_once);
  rest.route = "order+" + sim.route;
  rest.rays = sim.rays;
  const bool again = std::any_of(rest.claims.begin(), rest.claims.end(),
                                 [&](const Claim& c) { return c.cause == reordered->claim.cause; });
  if (rest.claims.empty() || again) {
    return std::nullopt;
  }
  Claim order = reordered->claim;
  order.explained = rest.claims.front().explained;
  order.evidence = evidence_of_share(order.explained);
  rest.claims.insert(rest.claims.begin(), std::move(order));
  const Pixels pixels = sorted_pixels(reference, test);
  rest.share_different = double(pixels.different.size()) / (double(test.width) * test.height);
  rest.only_details = only_details(pixels, test);
  return rest;
}

// Counts of values that are one higher, one lower, or differ by more.
struct Steps {
  std::size_t up = 0;
  std::size_t down = 0;
  std::size_t far = 0;
  std::size_t far_from_edges = 0;  // where other samples of the pixel explain nothing
};

Steps count_steps(const Texture& reference, const Texture& test) {
  // Measured: of right programs that round and take other samples, 0.93 to 1 of the differing
  // values are off by one, not counting those at such edges; of blurred pictures in which something
  // else is wrong, 0.85 and 0.92.
  constexpr double edge = 16;  // difference of pixels side by side
  Steps steps;
  for (int y = 0; y < test.height; ++y) {
    for (int x = 0; x < test.width; ++x) {
      const auto is_flat = [&](const Texture& picture) {
        const Range range = around(picture, x, y);
        return largest_of(range.high - range.low) <= edge;
      };
      const bool flat = is_flat(reference) && is_flat(test);
      for (int c = 0; c < 3; ++c) {
        const int step = int{test.texel(x, y)[c]} - reference.texel(x, y)[c];
        (step == 1 ? steps.up : step == -1 ? steps.down : steps.far) += step != 0 ? 1 : 0;
        steps.far_from_edges += flat && std::abs(step) > 1 ? 1 : 0;
      }
    }
  }
  return steps;
}

// Whether about half of the values of most levels of brightness are one step off, as by rounding.
// A light that is a little too bright changes some levels alone.
bool steps_at_all_levels(const Texture& reference, const Texture& test) {
  constexpr std::size_t enough_values = 12;
  constexpr double min_share = 0.2;  // of a level's values
  constexpr double max_share = 0.8;
  constexpr double most_levels = 0.6;
  std::array<std::size_t, 256> all{};
  std::array<std::size_t, 256> off{};
  for (std::size_t i = 0; i < test.rgb.size(); ++i) {
    ++all[reference.rgb[i]];
    off[reference.rgb[i]] += std::abs(int{test.rgb[i]} - reference.rgb[i]) == 1 ? 1 : 0;
  }
  std::size_t levels = 0;
  std::size_t stepping = 0;
  for (std::size_t level = 1; level < 255; ++level) {
    if (all[level] >= enough_values) {
      const double share = static_cast<double>(off[level]) / static_cast<double>(all[level]);
      ++levels;
      stepping += share >= min_share && share <= max_share ? 1 : 0;
    }
  }
  return static_cast<double>(stepping) >= most_levels * static_cast<double>(levels);
}

// The sign is the evidence: rounded values are never below truncated ones.
std::optional<Claim> find_rounding(const Texture& reference, const Texture& test,
                                   double share_different) {
  const Steps steps = count_steps(reference, test);
  const auto values = static_cast<double>(test.rgb.size());
  const auto near = static_cast<double>(steps.up + steps.down);
  const auto larger = static_cast<double>(std::max(steps.up, steps.down));
  if (near < 0.05 * values || larger < 0.9 * near || static_cast<double>(steps.far) > near ||
      share_different > max_share_for_rounding || !steps_at_all_levels(reference, test)) {
    return std::nullopt;
  }
  const bool up = steps.up > steps.down;
  return Claim{Cause::rounding,
               up ? "values are rounded where the reference truncates"
                  : "values are truncated where the reference rounds",
               fmt::format("{} of all values are off by one; {} of those are too {}",
                           percent(near / values), percent(larger / near), up ? "high" : "low"),
               near / (near + static_cast<double>(steps.far_from_edges))};
}

}  // namespace

std::optional<std::uint32_t> source_at(const SceneView& view, const glm::ivec2& pixel,
                                       const glm::ivec2& size) {
  const auto shapes = flatten(*view.scene, *view.assets);
  if (shapes == nullptr) {
    return std::nullopt;
  }
  const ModelMistakes right;
  const Model model(*view.scene, *shapes, *view.assets, view.options, right);
  const glm::dvec2 whole = view.whole.x > 0 ? view.whole : glm::dvec2(size);
  const ModelHit hit =
      model.first_hit(model.camera_ray(glm::dvec2(pixel) + 0.5 + view.corner, whole.x, whole.y));
  return hit.part == nullptr ? std::nullopt : std::optional(hit.part->source);
}

std::vector<AlikeView> alike(const Texture& reference, std::span<const SceneView> views) {
  constexpr double nearly = 1.1;
  const auto shapes = flatten(*views.front().scene, *views.front().assets);
  if (shapes == nullptr || views.size() == 1) {
    return {{0, true}};
  }
  std::mt19937 random(4);
  std::vector<std::uint32_t> pixels(std::size_t(reference.width) * reference.height);
  for (std::uint32_t i = 0; i < pixels.size(); ++i) {
    pixels[i] = i;
  }
  std::vector<Point> points;
  add_points(reference, reference, std::move(pixels), 1200, false, false, random, points);
  std::vector<double> rest(views.size());
  const ThreadLimit limit(views.front().options.threads);
  for_each_task(views.size(), [&](std::size_t i) {
    const SceneView& view = views[i];
    const ModelMistakes right;
    const Model model(*view.scene, *shapes, *view.assets, view.options, right);
    Colors colors;
    for (const Point& p : points) {
      colors.push_back(255.0 * model.pixel({p.x + 0.5, p.y + 0.5}, reference.width,
                                           reference.height, nullptr, {}));
    }
    const Score s = score(points, points.size(), colors);
    rest[i] = s.left + 0.25 * s.raw;  // at edges, any color of the neighbors leaves nothing
  });
  const double least = *std::min_element(rest.begin(), rest.end());
  std::vector<AlikeView> best;
  for (const bool equal : {true, false}) {
    for (std::size_t i = 0; i < rest.size(); ++i) {
      if ((rest[i] <= least) == equal && rest[i] <= nearly * least) {
        best.push_back({i, equal});
      }
    }
  }
  return best;
}

CauseReport find_causes(const Texture& reference, const Texture& test, const SceneView* view,
                        const std::function<bool(double done)>& go_on, LookFor look_for) {
  if (reference.width != test.width || reference.height != test.height || reference.empty()) {
    CauseReport report;
    if (std::optional<Claim> turned = find_turned(reference, test)) {
      report.claims.push_back(*std::move(turned));
    }
    return report;
  }
  const ThreadLimit limit(view != nullptr ? view->options.threads : 0);
  const bool several = view != nullptr && look_for == LookFor::several_at_once;
  std::optional<CauseReport> beside;
  std::optional<Reordered> likelier;
  if (several) {
    beside = causes_beside_order(reference, test, in_right_order(test), *view, go_on);
    likelier = in_likelier_order(reference, test);
  }
  Simulation sim{reference, test, view, go_on};
  CauseReport report;
  if (beside) {
    report = *std::move(beside);
  } else {
    report = look_for_causes(sim, likelier && likelier->sure ? LookFor::single_mistakes : look_for);
    report.route = sim.route;
    report.rays = sim.rays;
  }
  constexpr std::uint64_t max_rays_before = 16'000'000;  // for a second search
  if (likelier && report.claims.empty() && report.notes.empty() && sim.usable && !sim.stopped &&
      sim.rays <= max_rays_before) {
    if (beside = causes_beside_order(reference, test, likelier, *view, go_on); beside) {
      report = *std::move(beside);
    }
  }
  if (report.claims.empty() && report.partial.empty()) {
    if (std::optional<Claim> rounding = find_rounding(reference, test, report.share_different)) {
      report.route = "rounding";
      if (rounding->explained >= nearly_all) {
        rounding->what += " (not a mistake by itself)";
        report.claims.push_back(*std::move(rounding));
      } else {
        report.notes.push_back(*std::move(rounding));
      }
    }
  }
  if (!report.claims.empty()) {
    report.partial.clear();
    report.confined.clear();
  } else if (!report.partial.empty()) {
    report.only_details = false;  // of which one mistake explains much
    report.route = "partial";
  } else if (report.notes.empty()) {
    report.route.clear();
  }
  return report;
}

}  // namespace scenefile
