#include "scenefile/grade/acne.h"

#include "scenefile/grade/claims.h"

#include <fmt/format.h>

#include <algorithm>

namespace scenefile {

namespace {

using glm::dvec2;
using glm::dvec3;

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

// Whether a neighboring pixel has the color drawn with the mistakes.
template <typename Shown>
bool drawn_beside(const Simulation& sim, const Point& p, const Model& model, const Trial& trial,
                  const Shown& shown) {
  for (int y = std::max(p.y - 1, 0); y <= std::min(p.y + 1, sim.test.height - 1); ++y) {
    for (int x = std::max(p.x - 1, 0); x <= std::min(p.x + 1, sim.test.width - 1); ++x) {
      const dvec3 c = shown(model.color(model.camera_ray(dvec2(x + 0.5, y + 0.5) + trial.shift,
                                                         sim.test.width, sim.test.height)));
      if (largest_of(glm::abs(c - at(sim.test, x, y))) <= 3) {
        return true;
      }
    }
  }
  return false;
}

bool right_beside(const Simulation& sim, const Point& p) {
  int right = 0;
  for (int y = std::max(p.y - 1, 0); y <= std::min(p.y + 1, sim.test.height - 1); ++y) {
    for (int x = std::max(p.x - 1, 0); x <= std::min(p.x + 1, sim.test.width - 1); ++x) {
      right += largest_of(glm::abs(at(sim.test, x, y) - at(sim.reference, x, y))) <= 3 ? 1 : 0;
    }
  }
  return right >= 1;
}

// Whether nearly all pixels that differ are inside of a few solid areas, such as a missing shadow
// or a rectangle that was painted over. Acne is scattered.
bool is_solid(const Simulation& sim) {
  const int width = sim.test.width;
  const int height = sim.test.height;
  std::vector<std::uint8_t> off(std::size_t(width) * std::size_t(height));
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      off[std::size_t(y) * std::size_t(width) + std::size_t(x)] =
          largest_of(glm::abs(at(sim.test, x, y) - at(sim.reference, x, y))) > right_within;
    }
  }
  std::size_t differing = 0;
  std::size_t in_solid = 0;
  std::vector<std::size_t> area;
  for (std::size_t start = 0; start < off.size(); ++start) {
    if (off[start] != 1) {
      continue;
    }
    // The area of neighboring pixels that differ; visited ones become 2.
    area.assign(1, start);
    off[start] = 2;
    std::size_t inner = 0;
    for (std::size_t i = 0; i < area.size(); ++i) {
      const int cx = int(area[i] % std::size_t(width));
      const int cy = int(area[i] / std::size_t(width));
      int around_it = 0;
      for (int y = std::max(cy - 1, 0); y <= std::min(cy + 1, height - 1); ++y) {
        for (int x = std::max(cx - 1, 0); x <= std::min(cx + 1, width - 1); ++x) {
          const std::size_t other = std::size_t(y) * std::size_t(width) + std::size_t(x);
          around_it += off[other] != 0 ? 1 : 0;
          if (off[other] == 1) {
            off[other] = 2;
            area.push_back(other);
          }
        }
      }
      inner += around_it == 9 ? 1 : 0;
    }
    differing += area.size();
    in_solid += 5 * inner >= 2 * area.size() ? area.size() : 0;
  }
  return 10 * in_solid >= 7 * differing;
}

}  // namespace

std::vector<Claim> claims_of_acne(Simulation& sim, const Combination& made, double least) {
  std::vector<Claim> claims;
  if (!sim.usable || !sim.view->options.features.shadows || sim.view->options.mode != Mode::ray ||
      sim.turn_of(made) != Turn() || (made.empty() && is_solid(sim))) {
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
    const bool beside =
        made.empty() ? right_beside(sim, p) : drawn_beside(sim, p, model, trial, shown);
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
  if (!made.empty() && (share(looked_at, differing) > 0.75 || share(scattered, looked_at) < 0.4 ||
                        !each_needed(sim, made))) {
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
  if (looked_at < few_pixels || dull < few_pixels ||
      share(scattered, looked_at) < (share(lacking, dull) < 0.97 ? 0.4 : 0.25) ||
      share(lacking, dull) < std::max(0.85, least) ||
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
       fmt::format("{} of the pixels that differ{} on surfaces without reflections lack exactly "
                   "the contribution of one or more lights, and correct pixels lie between them",
                   percent(share(lacking, dull)), made.empty() ? "" : " still"),
       share(between, looked_at)});
  return claims;
}
}  // namespace scenefile
