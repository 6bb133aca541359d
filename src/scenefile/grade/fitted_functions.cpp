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
#include <tuple>
#include <utility>

namespace scenefile {

namespace {

using glm::dvec3;

constexpr std::size_t max_points_to_fit = 320;
constexpr std::size_t max_groups = 4;  // of lights or materials with the same function
constexpr double right_angle = std::numbers::pi / 2;

// A function that several lights or materials share.
struct Group {
  std::vector<double> knots;                      // rising
  std::function<void(Trial&, const Curve&)> set;  // replaces the function
};

// The scene with mistakes that were made, too.
struct Made {
  const Simulation& sim;
  Turn turn;
  Trial trial;
  std::shared_ptr<const ModelShapes> shapes;
  std::vector<ModelHit> hits;  // of the first points
  std::vector<dvec3> places;   // of these hits in the world

  Made(const Simulation& simulation, const Combination& mistakes)
      : sim(simulation),
        turn(sim.turn_of(mistakes)),
        trial(sim.trial_of(mistakes)),
        shapes(sim.shapes_of(mistakes, trial)) {
    const Model model(trial.scene, *shapes, *sim.view->assets, trial.options, trial.mistakes);
    for (std::size_t i = 0; i < std::min(max_points_to_fit, sim.points.size()); ++i) {
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

// The functions of the groups that make the scene look most like the test; nullopt if none comes
// near to it, or if the points show few of the functions' values.
std::optional<std::vector<Curve>> fitted(const Made& made, const std::vector<Group>& groups) {
  constexpr std::size_t min_knots = 8;
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
  // Points at edges and other outliers are left out step by step.
  for (const double limit : {1e9, 40.0, 12.0, 4.0}) {
    std::vector<std::vector<double>> a(n, std::vector<double>(n, 0));
    std::vector<double> b(n, 0);
    near = used = 0;
    for (std::size_t i = 0; i < count; ++i) {
      for (int channel = 0; channel < 3; ++channel) {
        const double t = sim.points[i].test[channel];
        double now = none[i][channel];
        for (std::size_t u = 0; u < n; ++u) {
          now += values[u] * bases[u][i][channel];
        }
        if (t <= 0 || t >= 255) {
          continue;
        }
        ++used;
        if (std::abs(now - t) > limit) {
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
    if (!(trace > 0) || 2 * near < used) {
      return std::nullopt;
    }
    // Values without evidence follow those next to them.
    const double stiffness = 1e-4 * trace / double(n);
    for (std::size_t u = 0; u < n; ++u) {
      a[u][u] += 1e-3 * stiffness;
      if (u + 1 < n && unknowns[u].first == unknowns[u + 1].first) {
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
  if (4 * near < 3 * used) {
    return std::nullopt;
  }
  std::vector<Curve> curves;
  for (const Group& group : groups) {
    curves.push_back({group.knots, std::vector<double>(group.knots.size(), 0)});
  }
  for (std::size_t u = 0; u < n; ++u) {
    curves[unknowns[u].first].values[unknowns[u].second] = values[u];
  }
  return curves;
}

// `words`: says what the functions are; empty if they are not plausible.
void add_function(const Made& made, Cause cause, const std::vector<Group>& groups,
                  const std::function<std::string(const std::vector<Curve>&)>& words,
                  std::vector<Hypothesis>& list) {
  if (groups.empty() || groups.size() > max_groups) {
    return;
  }
  const std::optional<std::vector<Curve>> curves = fitted(made, groups);
  if (!curves) {
    return;
  }
  std::string what = words(*curves);
  if (what.empty()) {
    return;
  }
  list.push_back({cause,
                  std::move(what),
                  Stage::shading,
                  [groups, curves = *curves](Trial& t) {
                    for (std::size_t g = 0; g < groups.size(); ++g) {
                      groups[g].set(t, curves[g]);
                    }
                  },
                  {},
                  {}});
}

void set_by_light(std::vector<Curve>& curves, const std::vector<std::size_t>& lights,
                  const Curve& curve, std::size_t count) {
  curves.resize(count);
  for (const std::size_t light : lights) {
    curves[light] = curve;
  }
}

// A function of each group of lights that have the same numbers. `of_point`: its argument.
template <typename Key>
std::vector<Group> groups_of_lights(
    const Made& made, std::vector<Curve> ModelMistakes::*member,
    const std::function<std::optional<Key>(const RenderLight&)>& key,
    const std::function<double(const RenderLight&, const dvec3&)>& argument,
    const std::function<std::vector<double>(std::vector<double>)>& knots) {
  const std::vector<RenderLight>& lights = made.trial.scene.lights;
  std::map<Key, std::vector<std::size_t>> members;
  for (std::size_t i = 0; i < lights.size(); ++i) {
    if (const std::optional<Key> k = key(lights[i])) {
      members[*k].push_back(i);
    }
  }
  std::vector<Group> groups;
  for (const auto& one : members) {
    const std::vector<std::size_t>& of_group = one.second;
    std::vector<double> arguments;
    for (const std::size_t i : of_group) {
      for (const dvec3& p : made.places) {
        arguments.push_back(argument(lights[i], p));
      }
    }
    groups.push_back(
        {knots(std::move(arguments)), [=, count = lights.size()](Trial& t, const Curve& curve) {
           set_by_light(t.mistakes.*member, of_group, curve, count);
         }});
  }
  return groups;
}

void add_fading(const Made& made, std::vector<Hypothesis>& list) {
  using Key = std::tuple<float, float, float>;
  const std::vector<Group> groups = groups_of_lights<Key>(
      made, &ModelMistakes::fading,
      [](const RenderLight& light) {
        const glm::vec3& a = light.attenuation;
        return has_position(light.type) ? std::optional(Key(a.x, a.y, a.z)) : std::nullopt;
      },
      [](const RenderLight& light, const dvec3& point) {
        return glm::length(dvec3(light.position) - point);
      },
      [](std::vector<double> distances) { return quantiles(std::move(distances), 16); });
  add_function(
      made, Cause::attenuation, groups,
      [&](const std::vector<Curve>& curves) {
        const Curve& c = curves.front();
        const double near = c.knots[c.knots.size() / 4];
        const double far = c.knots[3 * c.knots.size() / 4];
        if (c.at(far) > c.at(near)) {
          return std::string();  // no program makes distant lights brighter
        }
        return fmt::format(
            "lights fade with distance in another way than the file says: the factor is {:.2g} at "
            "a distance of {:.2g}, and {:.2g} at {:.2g}",
            c.at(near), near, std::max(0.0, c.at(far)), far);  // not -0.0001
      },
      list);
}

void add_cones(const Made& made, std::vector<Hypothesis>& list) {
  using Key = std::tuple<float, float>;
  const std::vector<Group> groups = groups_of_lights<Key>(
      made, &ModelMistakes::cone,
      [](const RenderLight& light) {
        return has_cone(light.type) ? std::optional(Key(light.inner_angle, light.outer_angle))
                                    : std::nullopt;
      },
      [](const RenderLight& light, const dvec3& point) {
        const dvec3 way = glm::normalize(point - dvec3(light.position));
        return std::acos(std::clamp(glm::dot(way, dvec3(light.direction)), -1.0, 1.0));
      },
      [](const std::vector<double>& angles) {
        return evenly(*std::min_element(angles.begin(), angles.end()),
                      *std::max_element(angles.begin(), angles.end()), 32);
      });
  add_function(
      made, Cause::spot_falloff, groups,
      [&](const std::vector<Curve>& curves) {
        const Curve& c = curves.front();
        const double most = *std::max_element(c.values.begin(), c.values.end());
        double half = 0;
        for (std::size_t k = 0; k < c.knots.size(); ++k) {
          half = c.values[k] >= most / 2 ? c.knots[k] : half;
        }
        return fmt::format(
            "spotlights fall off with the angle in another way than the file says: half of their "
            "light is left at about {:.0f} degrees from the axis",
            half * 180 / std::numbers::pi);
      },
      list);
}

void add_diffuse_response(const Made& made, std::vector<Hypothesis>& list) {
  const std::vector<Group> groups{{evenly(-1, 1, 24), [](Trial& t, const Curve& curve) {
                                     t.mistakes.diffuse_response = curve;
                                   }}};
  add_function(
      made, Cause::diffuse, groups,
      [](const std::vector<Curve>& curves) {
        const Curve& c = curves.front();
        return fmt::format(
            "the diffuse term depends on N.L in another way: its factor is {:.2g} where N.L is "
            "0.3, and {:.2g} where N.L is 0.8",
            c.at(0.3), c.at(0.8));
      },
      list);
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

void add_highlights(const Made& made, std::vector<Hypothesis>& list) {
  std::map<float, std::size_t> exponents;  // with the number of points
  for (const ModelHit& hit : made.hits) {
    if (hit.part != nullptr) {
      const RenderMaterial& m = made.trial.scene.materials[hit.part->material];
      if (m.shininess > 0 && m.specular != glm::vec3(0)) {
        ++exponents[m.shininess];
      }
    }
  }
  std::vector<double> angles;  // between R and V
  for (const double x : evenly(0, 1, 20)) {
    angles.push_back(right_angle * x * x);
  }
  std::vector<Group> groups;
  for (const auto& one : exponents) {
    groups.push_back({angles, [exponent = one.first](Trial& t, const Curve& curve) {
                        t.mistakes.highlights.emplace_back(exponent, curve);
                      }});
  }
  add_function(
      made, Cause::specular, groups,
      [&](const std::vector<Curve>& curves) {
        const auto most =
            std::max_element(exponents.begin(), exponents.end(),
                             [](const auto& x, const auto& y) { return x.second < y.second; });
        return fmt::format(
            "highlights have another size or brightness: those of exponent {:g} are like those of "
            "exponent {:.2g}",
            most->first,
            exponent_like(curves[std::size_t(std::distance(exponents.begin(), most))]));
      },
      list);
}

}  // namespace

std::vector<Hypothesis> fitted_functions(const Simulation& sim, const Combination& made_too) {
  std::vector<Hypothesis> list;
  if (!sim.usable || sim.view->options.mode == Mode::normals || sim.view->scene->lights.empty()) {
    return list;
  }
  const Made made(sim, made_too);
  if (made.places.size() < few_pixels) {
    return list;
  }
  add_fading(made, list);
  add_highlights(made, list);
  add_cones(made, list);
  add_diffuse_response(made, list);
  return list;
}

}  // namespace scenefile
