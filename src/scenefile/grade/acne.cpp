#include "scenefile/grade/acne.h"

#include "scenefile/base/shape_traits.h"
#include "scenefile/grade/claims.h"
#include "scenefile/trace/tasks.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <random>
#include <string_view>

namespace scenefile {

namespace {

using glm::dvec2;
using glm::dvec3;

// Measured: with acne, right and wrong pixels alternate 0.93 to 1.10 times as often as in random
// order, and 0.8 to 1 of the windows contain both. In areas that are wrong as a whole, such as
// shadows, they alternate only at outlines: 0.35 to 0.65 times as often, and at most 0.4 of the
// windows contain both.
constexpr double min_noise = 0.8;
constexpr double min_mixed = 0.7;
constexpr std::size_t few_windows = 5;  // fewer windows are not evidence
// Minimum share of the picture. A correct program in single precision may have specks in a
// thousandth of it.
constexpr double min_area = 0.003;
constexpr double max_by_chance = 0.5;  // of the share of those that acne explains
// Of the pixels on mirrors, half or more lack light in the reflection, too.
constexpr double min_lacking_on_mirrors = 0.2;
constexpr std::size_t few_dull = 5;       // pixels on surfaces without reflections
constexpr std::size_t max_spots = 300;    // pixels to examine
constexpr std::size_t first_spots = 80;   // pixels that must be promising, to examine more
constexpr std::size_t max_windows = 60;   // to judge
constexpr std::size_t max_subsets = 512;  // of lights and reflections
constexpr int window = 2;                 // pixels on each side of the center

constexpr std::string_view shadow_acne =
    "surfaces shadow themselves in spots (shadow acne): offset the start of shadow rays from the "
    "surface";

bool may_show_acne(const Simulation& sim) {
  return sim.usable && sim.view->options.features.shadows && sim.view->options.mode == Mode::ray;
}

RenderScene without_lights(RenderScene scene) {
  scene.lights.clear();
  return scene;
}

// The picture of a program with the mistakes `made`, with and without lights.
class Expected {
 public:
  Expected(const Simulation& sim, const Combination& made)
      : sim_(sim),
        made_(made),
        turn_(sim.turn_of(made)),
        trial_(sim.trial_of(made)),
        shapes_(sim.shapes_of(made, trial_)),
        model_(trial_.scene, *shapes_, *sim.view->assets, trial_.options, trial_.mistakes),
        unlit_scene_(without_lights(trial_.scene)),
        unlit_(unlit_scene_, *shapes_, *sim.view->assets, trial_.options, trial_.mistakes) {
    for (const std::uint16_t i : made) {
      on_picture_ = on_picture_ || sim.list[i].color;
    }
  }
  const Model& model() const { return model_; }
  const Model& unlit() const { return unlit_; }
  const RenderMaterial& material(const ModelHit& hit) const {
    return trial_.scene.materials[hit.part->material];
  }
  ModelRay ray(int x, int y) const {
    const Point pixel{x, y};
    return sim_.ray(model_, sim_.middle(pixel, turn_) + trial_.shift);
  }
  // A color of the model as in the picture, in 1/255.
  dvec3 shown(const dvec3& color) const {
    return glm::clamp(on_picture_ ? sim_.finished(made_, {255.0 * color}).front() : 255.0 * color,
                      dvec3(0), dvec3(255));
  }
  // Whether the test's pixel is wrong.
  bool differs(int x, int y) const {
    const dvec3 expected =
        made_.empty() ? at(sim_.reference, x, y) : shown(model_.color(ray(x, y)));
    return largest_of(glm::abs(expected - at(sim_.test, x, y))) > right_within;
  }

 private:
  const Simulation& sim_;
  const Combination& made_;
  Turn turn_;
  Trial trial_;
  std::shared_ptr<const ModelShapes> shapes_;
  Model model_;
  RenderScene unlit_scene_;
  Model unlit_;
  bool on_picture_ = false;
};

// Whether the test's color is `full` without some of the lights that arrive.
bool lacks_lights(const Expected& picture, const dvec3& test, const dvec3& full,
                  std::vector<dvec3> arriving) {
  std::erase_if(arriving, [](const dvec3& c) { return largest_of(c) < 0.5 / 255; });
  std::sort(arriving.begin(), arriving.end(),
            [](const dvec3& a, const dvec3& b) { return largest_of(a) > largest_of(b); });
  for (std::size_t subset = 1; subset < std::min(max_subsets, std::size_t(1) << arriving.size());
       ++subset) {
    dvec3 c = full;
    for (std::size_t i = 0; subset >> i != 0; ++i) {
      c -= (subset >> i & 1) != 0 ? arriving[i] : dvec3(0);
    }
    if (largest_of(glm::abs(picture.shown(c) - test)) <= 4) {
      return true;
    }
  }
  return false;
}

bool is_flat(const ModelHit& hit) {
  const Shape shape = hit.part->shape;
  return shape != Shape::mesh && (hit.face != 0 || !has_curved_side(shape));
}

// Right and wrong pixels in windows around some pixels. Only windows within one surface count, and
// in them only pixels that light reaches.
struct Alternation {
  std::size_t windows = 0;
  std::size_t inside = 0;  // windows within one surface
  // ... and that tell something: rounding may be the same all over a flat face, which then shadows
  // itself as a whole.
  std::size_t telling = 0;
  std::size_t mixed = 0;  // ... with right and wrong pixels
  double changes = 0;     // from right to wrong between neighbors in these windows
  double expected = 0;    // the same for as many right and wrong pixels in random order
};

void look_around(const Simulation& sim, const Expected& picture, const Point& p, Alternation& a) {
  constexpr int side = 2 * window + 1;
  constexpr int few = 3;
  if (p.x < window || p.y < window || p.x + window >= sim.test.width ||
      p.y + window >= sim.test.height) {
    return;
  }
  ++a.windows;
  const ModelHit center = picture.model().first_hit(picture.ray(p.x, p.y));
  enum class State { dark, right, wrong };
  std::array<std::array<State, side>, side> states;
  int right = 0, wrong = 0;
  for (int v = 0; v < side; ++v) {
    for (int u = 0; u < side; ++u) {
      const int x = p.x + u - window, y = p.y + v - window;
      const ModelRay ray = picture.ray(x, y);
      const ModelHit hit = picture.model().first_hit(ray);
      if (hit.part == nullptr || hit.part != center.part || hit.face != center.face) {
        return;
      }
      State& state = states[v][u];
      state = picture.differs(x, y) ? State::wrong : State::right;
      if (state == State::right && largest_of(glm::abs(picture.shown(picture.unlit().color(ray)) -
                                                       at(sim.test, x, y))) <= right_within) {
        state = State::dark;
      }
      right += state == State::right ? 1 : 0;
      wrong += state == State::wrong ? 1 : 0;
    }
  }
  ++a.inside;
  if (right == 0 && is_flat(center)) {
    return;
  }
  ++a.telling;
  a.mixed += right >= few && wrong >= few ? 1 : 0;
  const double density = double(wrong) / std::max(1, right + wrong);
  const auto compare = [&](State one, State other) {
    if (one != State::dark && other != State::dark) {
      a.expected += 2 * density * (1 - density);
      a.changes += one != other ? 1 : 0;
    }
  };
  for (int v = 0; v < side; ++v) {
    for (int u = 0; u + 1 < side; ++u) {
      compare(states[v][u], states[v][u + 1]);
      compare(states[u][v], states[u + 1][v]);
    }
  }
}

double brightest(const std::vector<dvec3>& lights) {
  double most = 0;
  for (const dvec3& c : lights) {
    most = std::max(most, largest_of(c));
  }
  return most;
}

double share(std::size_t part_of, std::size_t whole) {
  return static_cast<double>(part_of) / static_cast<double>(std::max<std::size_t>(1, whole));
}

// Whether the spots are noise: they alternate with right pixels, and lie anywhere on surfaces,
// unlike lines along silhouettes.
bool is_noise(const Simulation& sim, const Expected& picture,
              const std::vector<const Point*>& spots) {
  Alternation wrong;
  for (std::size_t i = 0; i < spots.size() && wrong.telling < max_windows; ++i) {
    look_around(sim, picture, *spots[i], wrong);
  }
  Alternation right;
  for (std::size_t i = 0; i < sim.points.size() && right.windows < max_windows; ++i) {
    const Point& p = sim.points[i];
    if (!p.differs && picture.model().first_hit(picture.ray(p.x, p.y)).part != nullptr) {
      look_around(sim, picture, p, right);
    }
  }
  return wrong.telling >= few_windows &&
         share(wrong.inside, wrong.windows) >= 0.5 * share(right.inside, right.windows) &&
         share(wrong.mixed, wrong.telling) >= min_mixed &&
         wrong.changes >= min_noise * wrong.expected;
}

// How much of the light a pixel shows, in a picture with inexact colors: 0 without lights, 1 with
// all. Nullopt where lights change it too little to tell.
std::optional<double> light_shown(const Simulation& sim, const Expected& picture,
                                  const glm::ivec2& p, const ModelHit& hit) {
  constexpr dvec3 luma(0.299, 0.587, 0.114);  // which compression changes the least
  constexpr double enough_light = 32;  // of 255: beside less, errors of compression are large
  const ModelRay ray = picture.ray(p.x, p.y);
  const double without = glm::dot(luma, picture.shown(picture.unlit().color(ray, &hit)));
  const double all = glm::dot(luma, picture.shown(picture.model().color(ray, &hit)));
  if (all - without < enough_light) {
    return std::nullopt;
  }
  return (glm::dot(luma, at(sim.test, p.x, p.y)) - without) / (all - without);
}

// As look_around(), in a picture with inexact colors: a pixel is right here if it shows more of the
// light than the window on average. A window is mixed if its pixels show either much or little of
// it.
void look_around_inexactly(const Simulation& sim, const Expected& picture, const glm::ivec2& middle,
                           Alternation& a) {
  constexpr int side = 2 * window + 1;
  constexpr double count = side * side;
  constexpr double inexact = 0.25;       // by how much light_shown() may be below 0 or above 1
  constexpr double enough_inside = 0.8;  // of the pixels: beside edges, compression errs by more
  constexpr double all_dark = 0.1;       // of the light
  constexpr double few = 3 / count;
  // Of the variance of pixels that show either no light or all of it. Measured in JPEGs with acne:
  // 0.53 to 0.99 in nine of ten windows.
  constexpr double min_variance = 0.25;
  const ModelHit center = picture.model().first_hit(picture.ray(middle.x, middle.y));
  if (center.part == nullptr) {
    return;
  }
  const RenderMaterial& m = picture.material(center);
  if (m.reflective != glm::vec3(0) || m.transparent != glm::vec3(0) || m.blend > 0) {
    return;
  }
  std::array<std::array<double, side>, side> shown;
  double mean = 0;
  double squares = 0;
  double inside = 0;
  for (int v = 0; v < side; ++v) {
    for (int u = 0; u < side; ++u) {
      const glm::ivec2 p = middle + glm::ivec2(u - window, v - window);
      const ModelHit hit = picture.model().first_hit(picture.ray(p.x, p.y));
      if (hit.part != center.part || hit.face != center.face) {
        return;
      }
      const std::optional<double> light = light_shown(sim, picture, p, hit);
      if (!light) {
        return;
      }
      shown[v][u] = std::clamp(*light, 0.0, 1.0);
      inside += std::abs(*light - shown[v][u]) <= inexact ? 1 / count : 0;
      mean += shown[v][u] / count;
      squares += shown[v][u] * shown[v][u] / count;
    }
  }
  if (mean < all_dark && is_flat(center)) {
    return;  // the same all over the face, perhaps
  }
  ++a.telling;
  double lighter = 0;
  double changes = 0;
  for (int v = 0; v < side; ++v) {
    for (int u = 0; u < side; ++u) {
      lighter += shown[v][u] > mean ? 1 / count : 0;
      changes += u > 0 && (shown[v][u] > mean) != (shown[v][u - 1] > mean) ? 1 : 0;
      changes += v > 0 && (shown[v][u] > mean) != (shown[v - 1][u] > mean) ? 1 : 0;
    }
  }
  if (inside >= enough_inside && lighter >= few && lighter <= 1 - few &&
      squares - mean * mean >= min_variance * mean * (1 - mean)) {
    ++a.mixed;
    a.changes += changes;
    a.expected += 4 * side * (side - 1) * lighter * (1 - lighter);
  }
}

// Whether pixels between the specks need each of the mistakes.
bool each_makes_right(const Simulation& sim, const Combination& made) {
  constexpr double min_share = 0.02;  // of the weight that differs
  const std::size_t count = sim.points.size();
  const double least = std::max(double(few_pixels), min_share * sim.weight_that_differs(count));
  return std::all_of(made.begin(), made.end(), [&](std::uint16_t i) {
    Combination others = made;
    others.erase(std::find(others.begin(), others.end(), i));
    return effect_of(sim, sim.predicted(made, count), sim.predicted(others, count)).gained_all >=
           least;
  });
}

}  // namespace

Acne find_acne(const Simulation& sim, const Combination& made, double least) {
  if (!may_show_acne(sim)) {
    return {};
  }
  const Expected picture(sim, made);
  const Trial right_trial = sim.right_trial(false);
  const Model right(right_trial.scene, *sim.shapes, *sim.view->assets, right_trial.options,
                    right_trial.mistakes);
  std::vector<const Point*> spots;
  std::vector<const Point*> evidence;  // those that acne explains, or that cannot be checked
  std::size_t differing = 0;
  std::size_t between = 0;  // between unlit and fully lit
  std::size_t dull = 0;
  std::size_t lacking = 0;  // the color is exactly that without some lights
  std::size_t lacking_on_mirrors = 0;
  // The same for colors that acne does not give: several lights fit many colors by chance, but all
  // of them only one.
  std::size_t controls = 0;
  std::size_t lacking_by_chance = 0;
  std::size_t mirrors = 0;
  std::size_t seeing_themselves = 0;
  // Whether what was seen so far is far from what each of the claims below needs.
  const auto hopeless = [&] {
    return share(seeing_themselves, mirrors) < 0.5 &&
           (share(between, dull + mirrors) < 0.6 ||
            (share(lacking, dull) < 0.5 &&
             share(lacking_on_mirrors, mirrors) < 0.4 * min_lacking_on_mirrors));
  };
  for (std::size_t i = 0; i < sim.points.size() && spots.size() < max_spots; ++i) {
    const Point& p = sim.points[i];
    if (!p.differs) {
      continue;
    }
    if (dull + mirrors == first_spots && hopeless()) {
      return {};
    }
    ++differing;
    const ModelRay ray = picture.ray(p.x, p.y);
    const ModelHit hit = made.empty() ? sim.clean({}).hits[i] : picture.model().first_hit(ray);
    const dvec3 full =
        made.empty() ? sim.clean({}).drawn[i] / 255.0 : picture.model().color(ray, &hit);
    const dvec3 lit = picture.shown(full);
    if (hit.part == nullptr || largest_of(glm::abs(lit - p.test)) <= right_within) {
      continue;
    }
    spots.push_back(&p);
    const RenderMaterial& m = picture.material(hit);
    if (m.transparent != glm::vec3(0)) {
      evidence.push_back(&p);
      continue;  // shows other surfaces with acne
    }
    const std::vector<dvec3> arriving = picture.model().light_shares(ray);
    // Skips light that only arrives because of the mistakes: at grazing angles, it may look like
    // acne.
    if (!made.empty() && sim.stage_of(made) <= Stage::shading &&
        brightest(right.light_shares(ray)) < 0.1 * brightest(arriving)) {
      continue;
    }
    const dvec3 unlit_color = picture.shown(picture.unlit().color(ray));
    between += largest_of(outside(p.test, glm::min(unlit_color, lit) - 4.0,
                                  glm::max(unlit_color, lit) + 4.0)) <= 0
                   ? 1
                   : 0;
    const bool lacks = lacks_lights(picture, p.test, full, arriving);
    const bool lacks_all = largest_of(glm::abs(unlit_color - p.test)) <= right_within;
    if (const dvec3 lack = lit - p.test; largest_of(glm::abs(lack)) > 24) {
      ++controls;
      lacking_by_chance +=
          !lacks_all && lacks_lights(picture, lit - 0.7 * lack, full, arriving) ? 1 : 0;
    }
    if (lacks || m.reflective != glm::vec3(0)) {
      evidence.push_back(&p);
    }
    if (m.reflective == glm::vec3(0)) {
      ++dull;
      lacking += lacks ? 1 : 0;
      continue;
    }
    lacking_on_mirrors += lacks ? 1 : 0;
    ++mirrors;
    const std::vector<dvec3> seen = picture.model().self_mirrored(ray, 16);
    seeing_themselves += std::any_of(seen.begin(), seen.end(), [&](const dvec3& c) {
      return largest_of(glm::abs(picture.shown(c) - p.test)) <= 3;
    });
  }
  // Glass cannot be checked, so it must not be the main evidence. The other mistakes must explain
  // the pixels outside the spots.
  const double area = share(spots.size(), differing) * sim.weight_that_differs(sim.points.size());
  if (area < min_area * sim.test.width * sim.test.height || dull + mirrors < few_pixels ||
      2 * (dull + mirrors) < spots.size() || !each_makes_right(sim, made)) {
    return {};
  }
  Acne acne;
  std::vector<Claim>& claims = acne.claims;
  const double explained = 1 - share(spots.size(), differing);
  for (const std::uint16_t i : made) {
    claims.push_back({sim.list[i].cause, sim.list[i].what,
                      fmt::format("simulating this mistake explains {} of the pixels that differ; "
                                  "the others are specks",
                                  percent(explained)),
                      explained});
  }
  const double mirrored = share(seeing_themselves, mirrors);
  if (mirrors >= 3 * few_pixels && mirrored >= std::max(min_explained, least) &&
      mirrors > 3 * dull) {
    acne.unexplained = 1 - mirrored;
    claims.push_back(
        {Cause::acne,
         "reflected rays hit the surface that they start from, in spots (acne): offset their "
         "start from the surface",
         fmt::format("{} of the pixels that differ on mirrors show the mirror itself",
                     percent(mirrored)),
         mirrored});
    return is_noise(sim, picture, evidence) ? acne : Acne();
  }
  // On mirrors, the reflection may show acne, too, so the missing light may fit no set of lights.
  const bool all_mirrors = 10 * dull < dull + mirrors;
  const double darker = share(between, dull + mirrors);
  const double lack = share(lacking, dull);
  const double lack_on_mirrors = share(lacking_on_mirrors, mirrors);
  const bool exactly = dull >= few_dull && lack >= std::max(min_explained, least);
  const bool enough_lacks = all_mirrors ? exactly || lack_on_mirrors >= min_lacking_on_mirrors
                                        : exactly && dull >= few_pixels;
  if (!enough_lacks || darker < (all_mirrors ? 0.95 : min_explained) ||
      share(lacking_by_chance, controls) > max_by_chance * std::max(lack, lack_on_mirrors)) {
    return {};
  }
  if (!is_noise(sim, picture, evidence)) {
    return {};
  }
  acne.unexplained = 1 - share(lacking + lacking_on_mirrors, dull + mirrors);
  claims.push_back(
      {Cause::acne, std::string(shadow_acne),
       all_mirrors
           ? fmt::format("{} of the pixels that differ are darker by at most the lights' "
                         "contribution, and correct pixels lie between them",
                         percent(darker))
           : fmt::format("{} of the pixels that differ{} on surfaces without reflections lack "
                         "exactly the contribution of one or more lights, and correct pixels lie "
                         "between them",
                         percent(lack), made.empty() ? "" : " still"),
       darker});
  return acne;
}

std::optional<Claim> claim_of_inexact_acne(const Simulation& sim) {
  constexpr std::size_t max_tries = 2000;
  constexpr double darker = 12;  // than the reference
  // Measured: with acne, at least 0.8 of the windows are mixed, and pixels alternate 0.91 to 1.11
  // times as often as in random order. With 157 other mistakes, at most 0.77 times as often where
  // half of the windows are mixed.
  constexpr double min_share = 0.5;
  constexpr double min_changes = 0.85;
  if (!may_show_acne(sim)) {
    return std::nullopt;
  }
  const Expected picture(sim, {});
  std::vector<glm::ivec2> wrong;
  for (int y = window; y + window < sim.test.height; ++y) {
    for (int x = window; x + window < sim.test.width; ++x) {
      if (largest_of(at(sim.reference, x, y) - at(sim.test, x, y)) >= darker) {
        wrong.emplace_back(x, y);
      }
    }
  }
  // As in add_points(): std::shuffle() differs between libraries.
  std::mt19937 random(11);
  Alternation acne;
  for (std::size_t i = 0; i < std::min(max_tries, wrong.size()) && acne.telling < max_windows;
       ++i) {
    std::swap(wrong[i], wrong[i + random() % (wrong.size() - i)]);
    look_around_inexactly(sim, picture, wrong[i], acne);
  }
  const double mixed = share(acne.mixed, acne.telling);
  if (acne.telling < few_windows || mixed < min_share ||
      acne.changes < min_changes * acne.expected) {
    return std::nullopt;
  }
  return Claim{Cause::acne, std::string(shadow_acne),
               fmt::format("in {} of the dark places that were examined, pixels with light and "
                           "without it alternate",
                           percent(mixed)),
               mixed};
}

Acne with_camera(const Simulation& sim, Acne acne) {
  constexpr double much = 0.03;    // unexplained
  constexpr double most_of = 0.4;  // of that, the rest with a camera
  if (acne.claims.empty() || acne.unexplained < much) {
    return acne;
  }
  std::vector<Combination> cameras;
  for (std::uint16_t i = 0; i < sim.list.size(); ++i) {
    const Hypothesis& h = sim.list[i];
    if (h.stage == Stage::camera || h.cause == Cause::samples) {
      cameras.push_back({i});
    }
  }
  Acne best = find_acne_beside(sim, cameras);
  return best.unexplained <= most_of * acne.unexplained ? best : acne;
}

Acne find_acne_beside(const Simulation& sim, const std::vector<Combination>& mistakes) {
  std::vector<Acne> found(mistakes.size());
  for_each_task(mistakes.size(), [&](std::size_t i) {
    if (!sim.any_heavy(mistakes[i])) {
      found[i] = find_acne(sim, mistakes[i], 0);
    }
  });
  Acne best;
  for (Acne& one : found) {
    if (!one.claims.empty() && one.unexplained < best.unexplained) {
      best = std::move(one);
    }
  }
  return best;
}

}  // namespace scenefile
