#include "scenefile/grade/smaller_mistakes.h"

#include "scenefile/grade/candidates.h"
#include "scenefile/grade/edited_scene.h"

#include <algorithm>
#include <array>

namespace scenefile {

namespace {

constexpr std::size_t max_different = 9000;  // pixels to look at
constexpr std::size_t max_same = 3000;
constexpr std::size_t max_rest = 500;  // points to keep, among those that are not explained
constexpr std::size_t max_explained = 1100;

// Of `points`, at most `count`, which then stand for all of them.
std::vector<Point> some_of(const std::vector<Point>& points, std::size_t count) {
  std::vector<Point> some;
  const std::size_t n = std::min(count, points.size());
  for (std::size_t i = 0; i < n; ++i) {
    some.push_back(points[i * points.size() / n]);
    some.back().weight *= double(points.size()) / double(n);
  }
  return some;
}

// Removes the points whose colors change if the lights move a little: where a light lies in the
// plane of a face, rounding decides whether it lights the face.
void drop_unstable(const Simulation& sim, const Combination& mistakes, std::vector<Point>& points) {
  constexpr float step = 1e-4F;  // of the distance from the origin, at least of 1
  std::array<Colors, 3> drawn;
  for (std::size_t k = 0; k < drawn.size(); ++k) {
    Trial trial = sim.trial_of(mistakes);
    for (RenderLight& light : trial.scene.lights) {
      const float way = step * float(int(k) - 1);
      light.position += way * std::max(1.0F, glm::length(light.position));
      light.direction = glm::normalize(light.direction + way);
    }
    drawn[k] = sim.finished(mistakes, sim.draw(trial, *sim.shapes_of(mistakes, trial), points,
                                               points.size(), sim.turn_of(mistakes), nullptr));
  }
  std::size_t kept = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!any_differs({drawn[0][i]}, {drawn[1][i]}, tolerance) &&
        !any_differs({drawn[2][i]}, {drawn[1][i]}, tolerance)) {
      points[kept++] = points[i];
    }
  }
  points.resize(kept);
}

// Replaces the points by those that the mistakes do not explain, with one of the others after each.
// Returns the number of points that are not explained.
std::size_t look_at_rest(Simulation& sim, const Pixels& pixels, const Combination& mistakes) {
  std::mt19937 random(9);
  sim.points.clear();
  add_points(sim.reference, sim.test, pixels.different, max_different, true, false, random,
             sim.points, sim.noise());
  add_points(sim.reference, sim.test, pixels.same, max_same, false, false, random, sim.points,
             sim.noise());
  sim.prepare_clean();
  auto [rest, explained] = wrong_and_right(sim, mistakes);
  drop_unstable(sim, mistakes, rest);
  sim.points = alternating(some_of(rest, max_rest), some_of(explained, max_explained));
  sim.prepare_clean();
  return rest.size();
}

// Whether what a mistake changes is right with it nearly everywhere, mostly within rounding.
bool explains_rest(const Simulation& sim, const Combination& with, const Combination& without) {
  constexpr double mostly = 0.85;
  const std::size_t count = sim.points.size();
  const Effect e = effect_of(sim, sim.predicted(with, count), sim.predicted(without, count));
  return e.points >= few_pixels && e.gained >= double(few_pixels) &&
         e.gained >= min_partial * e.changed && e.right >= nearly_all * e.changed &&
         e.within_rounding >= mostly * e.changed;
}

// The mistakes with the one in addition that explains most of the rest.
std::optional<Tried> with_addition(Simulation& sim, const Tried& found) {
  const Simulation::Base b = sim.base(sim.points.size());
  const double left = sim.score_of(found.mistakes, sim.points.size()).left;
  std::optional<Tried> best;
  for (const Tried& t : likely_additions(sim, found.mistakes)) {
    Tried whole = sim.rated(t.mistakes, sim.score_of(t.mistakes, sim.points.size()), b);
    if (whole.score.left < min_partial * left && (!best || whole.score.left < best->score.left) &&
        explains_rest(sim, whole.mistakes, found.mistakes)) {
      best = std::move(whole);
    }
  }
  return best;
}

}  // namespace

Tried with_smaller_mistakes(Simulation& sim, const Pixels& pixels, Tried found) {
  constexpr std::size_t max_mistakes = 3;
  // A fitted curve may imitate a mistake, but hardly all but a small part of it.
  for (const std::uint16_t i : found.mistakes) {
    sim.list[i].combines = true;
  }
  while (sim.usable && !sim.stopped && found.mistakes.size() < max_mistakes &&
         !sim.any_heavy(found.mistakes)) {
    PointsRestored restored(sim);
    if (look_at_rest(sim, pixels, found.mistakes) < few_pixels) {
      break;
    }
    std::optional<Tried> more = with_addition(sim, found);
    if (!more) {
      more = find_edit_beside(sim, found.mistakes);
    }
    if (!more) {
      break;
    }
    found = *std::move(more);
    restored.keep_new();
  }
  return found;
}

}  // namespace scenefile
