#include "scenefile/grade/acne.h"

#include "scenefile/grade/claims.h"

#include <fmt/format.h>

#include <algorithm>

namespace scenefile {

namespace {

using glm::dvec2;
using glm::dvec3;

// Share of the pixels with acne that lie between right ones. Seen: 0.45 to 0.88 with acne, and at
// most 0.18 for shadows in the wrong places.
constexpr double min_scattered = 0.2;

// Whether the test's color is `full` without some of the lights, after applying `shown`.
template <typename Shown>
bool lacks_lights(const dvec3& test, const dvec3& full, const std::vector<dvec3>& shares,
                  const Shown& shown) {
  const std::size_t count = std::min<std::size_t>(shares.size(), 5);
  for (unsigned subset = 1; subset < 1u << count; ++subset) {
    dvec3 c = full;
    for (std::size_t i = 0; i < count; ++i) {
      c -= (subset >> i & 1) != 0 ? shares[i] : dvec3(0);
    }
    if (largest_of(glm::abs(shown(c) - test)) <= 4) {
      return true;
    }
  }
  return false;
}

// Whether the pixel has right ones on two opposite sides, at most two pixels away. Pixels with acne
// do; most of those inside of an area, such as a shadow, do not. `right`: for neighbors.
template <typename Right>
bool is_between_right(const Simulation& sim, const Point& p, const Right& right) {
  const auto on_side = [&](int dx, int dy) {
    for (const int step : {1, 2}) {
      const glm::ivec2 at_step(p.x + step * dx, p.y + step * dy);
      if (at_step.x >= 0 && at_step.y >= 0 && at_step.x < sim.test.width &&
          at_step.y < sim.test.height && right(at_step.x, at_step.y)) {
        return true;
      }
    }
    return false;
  };
  return (on_side(-1, 0) && on_side(1, 0)) || (on_side(0, -1) && on_side(0, 1));
}

}  // namespace

bool is_scattered(const Simulation& sim) {
  std::size_t differing = 0;
  std::size_t scattered = 0;
  for (const Point& p : sim.points) {
    if (p.differs) {
      ++differing;
      scattered += is_between_right(sim, p, [&](int x, int y) {
        return largest_of(glm::abs(at(sim.test, x, y) - at(sim.reference, x, y))) <= exact_within;
      });
    }
  }
  return static_cast<double>(scattered) >= min_scattered * static_cast<double>(differing);
}

std::vector<Claim> claims_of_acne(Simulation& sim, const Combination& made, double least) {
  std::vector<Claim> claims;
  if (!sim.usable || !sim.view->options.features.shadows || sim.view->options.mode != Mode::ray ||
      sim.turn_of(made) != Turn() || (made.empty() && !is_scattered(sim))) {
    return {};
  }
  const Trial trial = sim.trial_of(made);
  const std::shared_ptr<const ModelShapes> shapes = sim.shapes_of(trial, sim.stage_of(made));
  const Model model(trial.scene, *shapes, *sim.view->assets, trial.options, trial.mistakes);
  Trial unlit = trial;
  unlit.scene.lights.clear();
  const Model dark(unlit.scene, *shapes, *sim.view->assets, unlit.options, unlit.mistakes);
  const auto shown = [&](const dvec3& c) {
    return glm::clamp(sim.finished(made, {255.0 * c}).front(), dvec3(0), dvec3(255));
  };
  std::size_t looked_at = 0;
  std::size_t differing = 0;
  std::size_t between = 0;
  std::size_t scattered = 0;
  std::size_t dull = 0;
  std::size_t lacking = 0;
  std::size_t mirrors = 0;
  std::size_t seeing_themselves = 0;
  std::size_t beside_right = 0;
  for (std::size_t i = 0; i < sim.points.size() && looked_at < 400; ++i) {
    const Point& p = sim.points[i];
    if (!p.differs) {
      continue;
    }
    const ModelRay ray =
        model.camera_ray(sim.middle(p, {}) + trial.shift, sim.test.width, sim.test.height);
    const ModelHit hit = made.empty() ? sim.clean({}).hits[i] : model.first_hit(ray);
    ++differing;
    const dvec3 full = made.empty() ? sim.clean({}).drawn[i] / 255.0 : model.color(ray, &hit);
    if (hit.part == nullptr ||
        (!made.empty() && largest_of(outside(shown(full), p.low, p.high)) <= exact_within)) {
      continue;
    }
    ++looked_at;
    const dvec3 a = shown(dark.color(ray));
    const dvec3 b = shown(full);
    between += largest_of(outside(p.test, glm::min(a, b) - 4.0, glm::max(a, b) + 4.0)) <= 0;
    const bool beside = is_between_right(sim, p, [&](int x, int y) {
      const dvec3 expected =
          made.empty() ? at(sim.reference, x, y)
                       : shown(model.color(model.camera_ray(dvec2(x + 0.5, y + 0.5) + trial.shift,
                                                            sim.test.width, sim.test.height)));
      return largest_of(glm::abs(expected - at(sim.test, x, y))) <= exact_within;
    });
    scattered += beside ? 1 : 0;
    const RenderMaterial& m = trial.scene.materials[hit.part->material];
    // Mirrors with self-intersections may show anything.
    if (m.reflective == glm::vec3(0) && m.transparent == glm::vec3(0)) {
      ++dull;
      // If little light is missing, some set of lights always fits.
      lacking += largest_of(glm::abs(b - p.test)) > 8 &&
                         lacks_lights(p.test, full, model.light_shares(ray), shown)
                     ? 1
                     : 0;
    } else if (m.transparent == glm::vec3(0) && mirrors < 150) {
      ++mirrors;
      const std::vector<dvec3> seen = model.self_mirrored(ray, 16);
      seeing_themselves += std::any_of(seen.begin(), seen.end(), [&](const dvec3& c) {
        return largest_of(glm::abs(shown(c) - p.test)) <= 3;
      });
      beside_right += beside ? 1 : 0;
    }
  }
  const auto share = [](std::size_t part_of, std::size_t whole) {
    return static_cast<double>(part_of) / static_cast<double>(std::max<std::size_t>(1, whole));
  };
  // The other mistakes must explain the pixels outside the spots.
  if (!made.empty() && (share(looked_at, differing) > 0.75 ||
                        share(scattered, looked_at) < min_scattered || !each_needed(sim, made))) {
    return {};
  }
  if (made.empty() && mirrors >= 3 * few_pixels && share(seeing_themselves, mirrors) >= 0.85 &&
      share(beside_right, mirrors) >= 0.25 && 4 * mirrors > 3 * (mirrors + dull) &&
      share(seeing_themselves, mirrors) >= least) {
    claims.push_back(
        {Cause::acne,
         "reflected rays hit the surface that they start from, in spots (acne): offset their "
         "start from the surface",
         fmt::format("{} of the pixels that differ on mirrors show the mirror itself",
                     percent(share(seeing_themselves, mirrors))),
         share(seeing_themselves, mirrors)});
    return claims;
  }
  // On mirrors, the reflection may show acne, too, so that no set of lights need fit.
  const bool all_mirrors = 10 * dull < looked_at;
  if (looked_at < few_pixels || share(scattered, looked_at) < min_scattered) {
    return {};
  }
  if (all_mirrors ? share(between, looked_at) < 0.95 || share(scattered, looked_at) < 0.6
                  : dull < few_pixels || share(lacking, dull) < std::max(0.85, least) ||
                        share(between, looked_at) < (share(lacking, dull) < 0.95 ? 0.85 : 0.5)) {
    return {};
  }
  for (const std::uint16_t i : made) {
    claims.push_back(
        {sim.list[i].cause, sim.list[i].what,
         fmt::format(
             "simulating this mistake explains {} of the pixels that differ; the others are "
             "specks",
             percent(1 - share(looked_at, differing))),
         1 - share(looked_at, differing)});
  }
  claims.push_back(
      {Cause::acne,
       "surfaces shadow themselves in spots (shadow acne): offset the start of shadow rays from "
       "the surface",
       all_mirrors
           ? fmt::format("{} of the pixels that differ are darker by at most the lights' "
                         "contribution, and correct pixels lie between them",
                         percent(share(between, looked_at)))
           : fmt::format("{} of the pixels that differ{} on surfaces without reflections lack "
                         "exactly the contribution of one or more lights, and correct pixels lie "
                         "between them",
                         percent(share(lacking, dull)), made.empty() ? "" : " still"),
       share(between, looked_at)});
  return claims;
}
}  // namespace scenefile
