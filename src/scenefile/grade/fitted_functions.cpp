#include "scenefile/grade/fitted_functions.h"

#include "scenefile/base/shape_traits.h"
#include "scenefile/grade/least_squares.h"
#include "scenefile/trace/tasks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <utility>

namespace scenefile {

namespace {

using glm::dvec3;

// How exactly to fit.
struct Detail {
  std::size_t points = 320;
  std::size_t knots_divided_by = 1;
  double min_near = 0.75;  // share of the values that must be near to the test's
};
constexpr Detail exact;
constexpr Detail rough{96, 2, 0.4};
constexpr std::size_t max_groups = 4;  // of lights or materials with the same function
constexpr double jump = 1e-6;          // a function may jump between knots nearer than this
constexpr double right_angle = std::numbers::pi / 2;

// A function that several lights or materials share.
struct Group {
  std::vector<double> knots;                      // rising
  std::function<void(Trial&, const Curve&)> set;  // replaces the function
  std::function<double(double)> written = {};     // the function in the file, of lights
  std::string of_light = {};                      // " of light 1 (point)", if there are others
};

// The scene with mistakes that were made, too.
struct Made {
  const Simulation& sim;
  Detail detail;
  Turn turn;
  Trial trial;
  std::shared_ptr<const ModelShapes> shapes;
  std::vector<ModelHit> hits;  // of the first points
  std::vector<dvec3> places;   // of these hits in the world

  Made(const Simulation& simulation, const Combination& mistakes, const Detail& how)
      : sim(simulation),
        detail(how),
        turn(sim.turn_of(mistakes)),
        trial(sim.trial_of(mistakes)),
        shapes(sim.shapes_of(mistakes, trial)) {
    const Model model(trial.scene, *shapes, *sim.view->assets, trial.options, trial.mistakes);
    for (std::size_t i = 0; i < std::min(detail.points, sim.points.size()); ++i) {
      const ModelRay ray = sim.ray(model, sim.middle(sim.points[i], turn) + trial.shift);
      hits.push_back(model.first_hit(ray));
      if (hits.back().part != nullptr) {
        places.push_back(ray.origin + hits.back().t * hits.back().stretch * ray.direction);
      }
    }
  }
};

std::vector<double> evenly(double from, double to, std::size_t count) {
  std::vector<double> knots;
  for (std::size_t k = 0; k < count; ++k) {
    knots.push_back(from + (to - from) * double(k) / double(count - 1));
  }
  return knots;
}

// Knots at equal shares of the values.
std::vector<double> quantiles(std::vector<double> values, std::size_t count) {
  std::sort(values.begin(), values.end());
  std::vector<double> knots;
  for (std::size_t k = 0; k < count; ++k) {
    const double value = values[k * (values.size() - 1) / (count - 1)];
    if (knots.empty() || value > knots.back() + 1e-3) {
      knots.push_back(value);
    }
  }
  return knots;
}

Curve hat(const std::vector<double>& knots, std::size_t k) {
  Curve curve{knots, std::vector<double>(knots.size(), 0)};
  curve.values[k] = 1;
  return curve;
}

// The functions of the groups of a term.
struct FittedTerm {
  std::vector<Group> groups;
  std::vector<Curve> curves;  // by group
  double left = 0;  // mean difference from the test; larger ones than `worst` count as that
};

// The functions of the groups that make the scene look most like the test; nullopt if none comes
// near to it, or if the points show few of the functions' values.
std::optional<FittedTerm> fitted(const Made& made, const std::vector<Group>& groups) {
  constexpr double worst = 40;
  const std::size_t min_knots = 8 / made.detail.knots_divided_by;
  const Simulation& sim = made.sim;
  const std::size_t count = made.hits.size();
  const auto drawn = [&](std::size_t group, const Curve& curve) {
    Trial trial = made.trial;
    for (std::size_t g = 0; g < groups.size(); ++g) {
      const std::vector<double>& knots = groups[g].knots;
      groups[g].set(trial, g == group ? curve : Curve{knots, std::vector<double>(knots.size(), 0)});
    }
    return sim.draw(trial, *made.shapes, sim.points, count, made.turn, &made.hits);
  };
  std::vector<std::pair<std::size_t, std::size_t>> unknowns;  // group, knot
  for (std::size_t g = 0; g < groups.size(); ++g) {
    for (std::size_t k = 0; k < groups[g].knots.size(); ++k) {
      unknowns.emplace_back(g, k);
    }
  }
  const std::size_t n = unknowns.size();
  const auto knot = [&](std::size_t u) {
    return groups[unknowns[u].first].knots[unknowns[u].second];
  };
  const Colors none = drawn(groups.size(), {});
  std::vector<Colors> bases(n);
  for_each_task(n, [&](std::size_t u) {
    bases[u] = drawn(unknowns[u].first, hat(groups[unknowns[u].first].knots, unknowns[u].second));
    for (std::size_t i = 0; i < count; ++i) {
      bases[u][i] -= none[i];
    }
  });
  // A few values, as of N.L on a cube, fit anything.
  const auto shown = std::count_if(bases.begin(), bases.end(), [](const Colors& base) {
    return std::count_if(base.begin(), base.end(),
                         [](const dvec3& c) { return largest_of(c) > tolerance; }) >= 2;
  });
  if (static_cast<std::size_t>(shown) < min_knots) {
    return std::nullopt;
  }
  std::vector<double> values(n, 0);
  std::size_t near = 0;
  std::size_t used = 0;
  const auto now_at = [&](std::size_t i, int channel) {
    double now = none[i][channel];
    for (std::size_t u = 0; u < n; ++u) {
      now += values[u] * bases[u][i][channel];
    }
    return now;
  };
  // Points at edges and other outliers are left out step by step.
  for (const double limit : {1e9, 40.0, 12.0, 4.0}) {
    std::vector<std::vector<double>> a(n, std::vector<double>(n, 0));
    std::vector<double> b(n, 0);
    near = used = 0;
    for (std::size_t i = 0; i < count; ++i) {
      for (int channel = 0; channel < 3; ++channel) {
        const double t = sim.points[i].test[channel];
        if (t <= 0 || t >= 255) {
          continue;
        }
        ++used;
        if (std::abs(now_at(i, channel) - t) > limit) {
          continue;
        }
        ++near;
        for (std::size_t u = 0; u < n; ++u) {
          const double x = bases[u][i][channel];
          if (x == 0) {
            continue;
          }
          b[u] += x * (t + 0.25 - none[i][channel]);
          for (std::size_t v = 0; v <= u; ++v) {
            a[u][v] += x * bases[v][i][channel];
          }
        }
      }
    }
    double trace = 0;
    for (std::size_t u = 0; u < n; ++u) {
      trace += a[u][u];
    }
    if (!(trace > 0) || double(near) < std::min(0.5, made.detail.min_near) * double(used)) {
      return std::nullopt;
    }
    // Values without evidence follow those next to them.
    const double stiffness = 1e-4 * trace / double(n);
    for (std::size_t u = 0; u < n; ++u) {
      a[u][u] += 1e-3 * stiffness;
      if (u + 1 < n && unknowns[u].first == unknowns[u + 1].first && knot(u + 1) > knot(u) + jump) {
        a[u][u] += stiffness;
        a[u + 1][u + 1] += stiffness;
        a[u + 1][u] -= stiffness;
      }
    }
    values = solved(std::move(a), std::move(b));
    if (values.empty()) {
      return std::nullopt;
    }
  }
  if (double(near) < made.detail.min_near * double(used)) {
    return std::nullopt;
  }
  FittedTerm fit;
  fit.groups = groups;
  for (const Group& group : groups) {
    fit.curves.push_back({group.knots, std::vector<double>(group.knots.size(), 0)});
  }
  for (std::size_t u = 0; u < n; ++u) {
    fit.curves[unknowns[u].first].values[unknowns[u].second] = values[u];
  }
  for (std::size_t i = 0; i < count; ++i) {
    for (int channel = 0; channel < 3; ++channel) {
      const double now = std::clamp(now_at(i, channel), 0.0, 255.0);
      fit.left += std::min(worst, std::abs(now - sim.points[i].test[channel])) / double(3 * count);
    }
  }
  return fit;
}

// A function of each group of lights with the same key. `argument`: of the function, at a point.
template <typename Key>
std::vector<Group> groups_of_lights(
    const Made& made, std::vector<std::pair<Key, Curve>> ModelMistakes::*member,
    bool (*has_function)(LightType), const std::function<Key(const RenderLight&)>& key_of,
    const std::function<double(const RenderLight&, const dvec3&)>& argument,
    const std::function<double(const Key&, double)>& written,
    const std::function<std::vector<double>(const Key&, std::vector<double>)>& knots) {
  struct OfKey {
    Key key;
    std::string first_light;
    std::vector<double> arguments;
  };
  std::vector<OfKey> keys;
  const std::vector<RenderLight>& lights = made.trial.scene.lights;
  for (std::size_t i = 0; i < lights.size(); ++i) {
    if (!has_function(lights[i].type)) {
      continue;
    }
    const Key key = key_of(lights[i]);
    auto of_key =
        std::find_if(keys.begin(), keys.end(), [&](const OfKey& one) { return one.key == key; });
    if (of_key == keys.end()) {
      of_key = keys.insert(of_key,
                           {key, fmt::format("light {} ({})", i + 1, word_of(lights[i].type)), {}});
    }
    for (const dvec3& p : made.places) {
      of_key->arguments.push_back(argument(lights[i], p));
    }
  }
  std::vector<Group> groups;
  for (OfKey& one : keys) {
    groups.push_back({knots(one.key, std::move(one.arguments)),
                      [=, key = one.key](Trial& t, const Curve& curve) {
                        (t.mistakes.*member).emplace_back(key, curve);
                      },
                      [=, key = one.key](double x) { return written(key, x); },
                      keys.size() > 1 ? " of " + one.first_light : std::string()});
  }
  return groups;
}

std::vector<Group> groups_of_fading(const Made& made) {
  return groups_of_lights<glm::vec3>(
      made, &ModelMistakes::fading, has_position,
      [](const RenderLight& light) { return light.attenuation; },
      [](const RenderLight& light, const dvec3& point) {
        return glm::length(dvec3(light.position) - point);
      },
      [](const glm::vec3& coefficients, double distance) {
        return faded(coefficients, distance, AttenuationMistake::none);
      },
      [&](const glm::vec3& /*coefficients*/, std::vector<double> distances) {
        return quantiles(std::move(distances), 16 / made.detail.knots_divided_by);
      });
}

std::string words_of_fading(const Curve& c, const std::string& of_light) {
  const double near = c.knots[c.knots.size() / 4];
  const double far = c.knots[3 * c.knots.size() / 4];
  if (c.at(far) > c.at(near)) {
    return {};  // no program makes distant lights brighter
  }
  return fmt::format(
      "lights fade with distance in another way than the file says: the factor{} is {:.2g} at a "
      "distance of {:.2g}, and {:.2g} at {:.2g}",
      of_light, c.at(near), near, std::max(0.0, c.at(far)), far);  // not -0.0001
}

// Knots where most falloffs change: in the penumbra, and two at each of its ends, where they may
// jump. The others are spread evenly.
std::vector<double> knots_of_cone(double inner, double outer, double least, double most,
                                  const Detail& detail) {
  const std::size_t in_penumbra = 12 / detail.knots_divided_by;
  std::vector<double> knots;
  const auto add = [&](double knot) {
    if (knots.empty() || knot > knots.back()) {
      knots.push_back(knot);
    }
  };
  const std::vector<double> outside = evenly(least, most, 32 / detail.knots_divided_by);
  for (const double knot : outside) {
    if (knot < inner) {
      add(knot);
    }
  }
  add(inner);
  for (std::size_t k = 0; k <= in_penumbra; ++k) {
    add(std::max(inner + jump / 2, inner + (outer - inner) * double(k) / double(in_penumbra)));
  }
  add(outer + jump / 2);
  for (const double knot : outside) {
    if (knot > outer) {
      add(knot);
    }
  }
  return knots;
}

std::vector<Group> groups_of_cones(const Made& made) {
  return groups_of_lights<glm::vec2>(
      made, &ModelMistakes::cone, has_cone,
      [](const RenderLight& light) { return glm::vec2(light.inner_angle, light.outer_angle); },
      [](const RenderLight& light, const dvec3& point) {
        const dvec3 way = glm::normalize(point - dvec3(light.position));
        return std::acos(std::clamp(glm::dot(way, dvec3(light.direction)), -1.0, 1.0));
      },
      [](const glm::vec2& angles, double angle) {
        RenderLight light;
        light.inner_angle = angles.x;
        light.outer_angle = angles.y;
        return spot_share(light, std::cos(angle), SpotMistake::none);
      },
      [&](const glm::vec2& limits, const std::vector<double>& angles) {
        return knots_of_cone(limits.x, limits.y, *std::min_element(angles.begin(), angles.end()),
                             *std::max_element(angles.begin(), angles.end()), made.detail);
      });
}

std::string words_of_cones(const Curve& c, const std::string& of_light) {
  const double most = *std::max_element(c.values.begin(), c.values.end());
  double half = 0;
  for (std::size_t k = 0; k < c.knots.size(); ++k) {
    half = c.values[k] >= most / 2 ? c.knots[k] : half;
  }
  return fmt::format(
      "spotlights fall off with the angle in another way than the file says: half of the light{} "
      "is left at about {:.0f} degrees from the axis",
      of_light, half * 180 / std::numbers::pi);
}

std::vector<Group> group_of_diffuse(const Made& made) {
  return {{evenly(-1, 1, 24 / made.detail.knots_divided_by),
           [](Trial& t, const Curve& curve) { t.mistakes.diffuse_response = curve; }}};
}

std::string words_of_diffuse(const Curve& c) {
  constexpr double told = 0.005;
  if (std::abs(c.at(0.3) - 0.3) < told && std::abs(c.at(0.8) - 0.8) < told) {
    return {};  // as it should be
  }
  return fmt::format(
      "the diffuse term depends on N.L in another way: its factor is {:.2g} where N.L is 0.3, and "
      "{:.2g} where N.L is 0.8",
      c.at(0.3), c.at(0.8));
}

// The exponent that is most like the shape of a highlight.
double exponent_like(const Curve& curve) {
  double best = 1;
  double least = infinity;
  for (double exponent = 0.25; exponent < 2000; exponent *= 1.02) {
    double ab = 0, bb = 0, aa = 0;
    for (std::size_t k = 0; k < curve.knots.size(); ++k) {
      const double power = std::pow(std::cos(std::min(curve.knots[k], right_angle)), exponent);
      ab += curve.values[k] * power;
      bb += power * power;
      aa += curve.values[k] * curve.values[k];
    }
    if (const double left = aa - ab * ab / bb; left < least) {
      least = left;
      best = exponent;
    }
  }
  return best;
}

// The exponents of highlights, with the numbers of points that show them.
std::map<float, std::size_t> exponents_of(const Made& made) {
  std::map<float, std::size_t> exponents;
  for (const ModelHit& hit : made.hits) {
    if (hit.part != nullptr) {
      const RenderMaterial& m = made.trial.scene.materials[hit.part->material];
      if (m.shininess > 0 && m.specular != glm::vec3(0)) {
        ++exponents[m.shininess];
      }
    }
  }
  return exponents;
}

std::vector<Group> groups_of_highlights(const Made& made) {
  std::vector<double> angles;  // between R and V
  for (const double x : evenly(0, 1, 20 / made.detail.knots_divided_by)) {
    angles.push_back(right_angle * x * x);
  }
  std::vector<Group> groups;
  for (const auto& one : exponents_of(made)) {
    groups.push_back({angles, [exponent = one.first](Trial& t, const Curve& curve) {
                        t.mistakes.highlights.emplace_back(exponent, curve);
                      }});
  }
  return groups;
}

std::string words_of_highlights(const Made& made, const std::vector<Curve>& curves) {
  const std::map<float, std::size_t> exponents = exponents_of(made);
  const auto most =
      std::max_element(exponents.begin(), exponents.end(),
                       [](const auto& x, const auto& y) { return x.second < y.second; });
  return fmt::format(
      "highlights have another size or brightness: those of exponent {:g} are like those of "
      "exponent {:.2g}",
      most->first, exponent_like(curves[std::size_t(std::distance(exponents.begin(), most))]));
}

std::vector<Group> groups_of(const Made& made, Term term) {
  switch (term) {
    case Term::fading:
      return groups_of_fading(made);
    case Term::highlights:
      return groups_of_highlights(made);
    case Term::cones:
      return groups_of_cones(made);
    case Term::diffuse:
      return group_of_diffuse(made);
  }
  return {};
}

// The group whose function differs most from the one in the file.
std::size_t most_different(const FittedTerm& fit) {
  std::size_t most = 0;
  double largest = 0;
  for (std::size_t g = 0; g < fit.groups.size(); ++g) {
    const Curve& curve = fit.curves[g];
    double difference = 0;
    for (std::size_t k = 0; k < curve.knots.size(); ++k) {
      difference += std::abs(curve.values[k] - fit.groups[g].written(curve.knots[k])) /
                    double(curve.knots.size());
    }
    if (difference > largest) {
      largest = difference;
      most = g;
    }
  }
  return most;
}

// Says what the functions are; empty if they are not plausible.
std::string words_of(const Made& made, Term term, const FittedTerm& fit) {
  const auto words_of_lights = [&](auto words) {
    const std::size_t most = most_different(fit);
    return words(fit.curves[most], fit.groups[most].of_light);
  };
  switch (term) {
    case Term::fading:
      return words_of_lights(words_of_fading);
    case Term::highlights:
      return words_of_highlights(made, fit.curves);
    case Term::cones:
      return words_of_lights(words_of_cones);
    case Term::diffuse:
      return words_of_diffuse(fit.curves.front());
  }
  return {};
}

std::optional<FittedTerm> fitted(const Made& made, Term term) {
  const std::vector<Group> groups = groups_of(made, term);
  return groups.empty() || groups.size() > max_groups ? std::nullopt : fitted(made, groups);
}

bool has_functions(const Simulation& sim) {
  return sim.usable && sim.view->options.mode != Mode::normals && !sim.view->scene->lights.empty();
}

}  // namespace

Cause cause_of(Term term) {
  switch (term) {
    case Term::fading:
      return Cause::attenuation;
    case Term::highlights:
      return Cause::specular;
    case Term::cones:
      return Cause::spot_falloff;
    case Term::diffuse:
      return Cause::diffuse;
  }
  return Cause::diffuse;
}

std::vector<Hypothesis> fitted_functions(const Simulation& sim, const Combination& made_too,
                                         std::optional<Term> only) {
  std::vector<Hypothesis> list;
  if (!has_functions(sim)) {
    return list;
  }
  const Made made(sim, made_too, exact);
  if (made.places.size() < few_pixels) {
    return list;
  }
  for (std::size_t k = 0; k < term_count; ++k) {
    const Term term = Term(k);
    // It replaces any other falloff of spotlights.
    const bool made_before =
        term == Term::cones && std::any_of(made_too.begin(), made_too.end(), [&](std::uint16_t i) {
          return sim.list[i].cause == Cause::spot_falloff;
        });
    const std::optional<FittedTerm> fit =
        only.value_or(term) == term && !made_before ? fitted(made, term) : std::nullopt;
    std::string what = fit ? words_of(made, term, *fit) : std::string();
    if (!what.empty()) {
      list.push_back({cause_of(term),
                      std::move(what),
                      Stage::shading,
                      [groups = fit->groups, curves = fit->curves](Trial& t) {
                        for (std::size_t g = 0; g < groups.size(); ++g) {
                          groups[g].set(t, curves[g]);
                        }
                      },
                      {},
                      {}});
    }
  }
  return list;
}

std::array<double, term_count> left_with_functions(const Simulation& sim,
                                                   const Combination& made_too) {
  std::array<double, term_count> left;
  left.fill(infinity);
  if (!has_functions(sim)) {
    return left;
  }
  const Made made(sim, made_too, rough);
  for (std::size_t k = 0; k < term_count && made.places.size() >= few_pixels; ++k) {
    if (const std::optional<FittedTerm> fit = fitted(made, Term(k))) {
      left[k] = fit->left;
    }
  }
  return left;
}

}  // namespace scenefile
