#include "scenefile/grade/fitted_mistakes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace scenefile {

namespace {

using glm::dvec3;

// The value that most of `found` agree on, if they do.
std::optional<double> common_value(std::vector<double>& found) {
  if (found.size() < 3 * few_pixels) {
    return std::nullopt;
  }
  const auto middle = found.begin() + std::ptrdiff_t(found.size() / 2);
  std::nth_element(found.begin(), middle, found.end());
  const double value = *middle;
  const auto close = std::count_if(found.begin(), found.end(), [&](double x) {
    return std::abs(x - value) <= 0.04 * std::max(std::abs(value), 0.25);
  });
  return 2 * static_cast<std::size_t>(close) >= found.size() ? std::optional(value) : std::nullopt;
}

bool any_texture(const Simulation& sim) {
  return sim.view->options.mode == Mode::ray && sim.view->options.features.texture &&
         std::any_of(sim.view->scene->materials.begin(), sim.view->scene->materials.end(),
                     [](const RenderMaterial& m) { return m.texture.used() && m.blend != 0; });
}

// The color of a light, estimated from the pictures by channel.
void add_color_of_light(Simulation& sim, std::size_t light) {
  Trial without = sim.right_trial(false);
  without.scene.lights[light].color = glm::vec3(0);
  const std::size_t count = std::min<std::size_t>(sim.points.size(), 400);
  const Colors dark =
      sim.draw(without, *sim.shapes, sim.points, count, Turn(), &sim.clean({}).hits);
  dvec3 factors(1);
  for (int channel = 0; channel < 3; ++channel) {
    std::vector<double> found;
    for (std::size_t i = 0; i < count; ++i) {
      const double term = sim.clean({}).drawn[i][channel] - dark[i][channel];
      const double t = sim.points[i].test[channel];
      if (sim.points[i].differs && std::abs(term) > 12 && t < 254) {
        found.push_back(1 + (t + 0.5 - sim.clean({}).drawn[i][channel]) / term);
      }
    }
    factors[channel] = common_value(found).value_or(1);
  }
  const glm::vec3 color = glm::max(sim.view->scene->lights[light].color * glm::vec3(factors), 0.0f);
  const double spread = largest_of(factors) - std::min({factors.x, factors.y, factors.z});
  if (spread < 0.1 || largest_of(factors) > 12) {
    return;
  }
  sim.list.push_back(
      {Cause::lights,
       fmt::format("the color of light {} ({}) is {:.2g} {:.2g} {:.2g}", light + 1,
                   word_of(sim.view->scene->lights[light].type), color.x, color.y, color.z),
       Stage::shading,
       [light, color](Trial& t) {
         if (light < t.scene.lights.size()) {
           t.scene.lights[light].color = color;
         }
       },
       {},
       {}});
}

}  // namespace

std::vector<Hypothesis> fitted_curves(const std::vector<Point>& points, const Colors& reference) {
  std::vector<Hypothesis> list;
  std::vector<double> factors;
  std::vector<double> powers;
  std::vector<double> steps;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const dvec3& r = reference[i];
    const dvec3& t = points[i].test;
    for (int channel = 0; points[i].differs && channel < 3; ++channel) {
      if (r[channel] > 20 && r[channel] < 235 && t[channel] > 4 && t[channel] < 250) {
        factors.push_back((t[channel] + 0.5) / (r[channel] + 0.5));
        powers.push_back(std::log((t[channel] + 0.5) / 255) / std::log((r[channel] + 0.5) / 255));
      }
      if (points[i].differs && t[channel] > 0 && t[channel] < 255) {
        steps.push_back(t[channel] - r[channel]);
      }
    }
  }
  if (const std::optional<double> n = common_value(steps); n && std::abs(*n) > 4) {
    list.push_back({Cause::brightness,
                    fmt::format("{:.0f} of 255 was {} all values", std::abs(*n),
                                *n > 0 ? "added to" : "subtracted from"),
                    Stage::picture,
                    {},
                    {},
                    [n = *n / 255](const dvec3& c) { return n + clamped(c); }});
  }
  if (const std::optional<double> k = common_value(factors); k && std::abs(*k - 1) > 0.05) {
    list.push_back({Cause::brightness,
                    fmt::format("the picture is {:.2f} times as bright as it should be", *k),
                    Stage::picture,
                    {},
                    {},
                    [k = *k](const dvec3& c) { return k * glm::clamp(c, dvec3(0), dvec3(1)); }});
  }
  if (const std::optional<double> p = common_value(powers); p && std::abs(*p - 1) > 0.05) {
    list.push_back(
        {Cause::gamma,
         *p < 1 ? fmt::format("gamma {:.2f} was applied, but the format has no gamma correction",
                              1 / *p)
                : fmt::format("values were raised to the power of {:.2f}", *p),
         Stage::picture,
         {},
         {},
         [p = *p](const dvec3& c) {
           return glm::pow(glm::clamp(c, dvec3(0), dvec3(1)), dvec3(p));
         }});
  }
  return list;
}

void add_background(Simulation& sim) {
  std::map<std::array<int, 3>, double> colors;
  double all = 0;
  for (std::size_t i = 0; i < sim.points.size(); ++i) {
    if (sim.clean({}).hits[i].part == nullptr && sim.points[i].differs) {
      const dvec3& t = sim.points[i].test;
      colors[{int(t.x), int(t.y), int(t.z)}] += sim.points[i].weight;
      all += sim.points[i].weight;
    }
  }
  if (all == 0) {
    return;
  }
  const auto most =
      std::max_element(colors.begin(), colors.end(),
                       [](const auto& a, const auto& b) { return a.second < b.second; });
  if (most->second < 0.7 * all) {
    return;
  }
  const dvec3 color = dvec3(most->first[0], most->first[1], most->first[2]) / 255.0;
  for (const bool in_reflections : {false, true}) {
    sim.list.push_back(
        {Cause::background,
         fmt::format("the background is {} {} {}, not black{}", most->first[0], most->first[1],
                     most->first[2], in_reflections ? ", and reflections show it" : ""),
         Stage::shading,
         [=](Trial& t) {
           t.mistakes.background = color;
           t.mistakes.background_in_reflections = in_reflections;
         },
         {},
         {}});
  }
}

void add_factors(Simulation& sim) {
  using Change = std::function<void(Trial&, double)>;
  const auto try_factor = [&](Cause cause, const std::string& what, const Change& change) {
    Trial without = sim.right_trial(false);
    change(without, 0);
    const std::size_t count = std::min<std::size_t>(sim.points.size(), 300);
    const Colors dark =
        sim.draw(without, *sim.shapes, sim.points, count, Turn(), &sim.clean({}).hits);
    std::vector<double> found;
    for (std::size_t i = 0; i < count; ++i) {
      const dvec3 term = sim.clean({}).drawn[i] - dark[i];
      for (int channel = 0; sim.points[i].differs && channel < 3; ++channel) {
        const double t = sim.points[i].test[channel];
        if (std::abs(term[channel]) > 12 && t > 1 && t < 254) {
          found.push_back(1 + (t + 0.5 - sim.clean({}).drawn[i][channel]) / term[channel]);
        }
      }
    }
    const std::optional<double> k = common_value(found);
    if (k && *k > 0.03 && *k < 12 && std::abs(*k - 1) > 0.05 && std::abs(*k - 0.5) > 0.01 &&
        std::abs(*k - 2) > 0.03) {
      sim.list.push_back({cause,
                          fmt::format("{} {:.2f} times as bright as in the reference", what, *k),
                          Stage::shading,
                          [change, k = *k](Trial& t) { change(t, k); },
                          {},
                          {}});
    }
  };
  if (sim.view->options.mode == Mode::normals) {
    return;
  }
  try_factor(Cause::ambient, "the ambient term is",
             [](Trial& t, double k) { t.scene.global.ambient *= static_cast<float>(k); });
  try_factor(Cause::diffuse, "the diffuse term is",
             [](Trial& t, double k) { t.mistakes.diffuse_factor *= k; });
  if (any_texture(sim)) {
    try_factor(Cause::diffuse, "the diffuse term, but for textures, is",
               [](Trial& t, double k) { t.scene.global.diffuse *= static_cast<float>(k); });
  }
  try_factor(Cause::specular, "the specular term is", [](Trial& t, double k) {
    for (RenderMaterial& m : t.scene.materials) {
      m.specular *= static_cast<float>(k);
    }
  });
  try_factor(Cause::reflection, "reflections are",
             [](Trial& t, double k) { t.mistakes.mirror_factor *= k; });
  try_factor(Cause::refraction, "refraction is",
             [](Trial& t, double k) { t.mistakes.glass_factor *= k; });
  const std::size_t lights = sim.view->scene->lights.size();
  try_factor(Cause::lights, "the light from all lights is", [](Trial& t, double k) {
    for (RenderLight& light : t.scene.lights) {
      light.color *= static_cast<float>(k);
    }
  });
  for (std::size_t i = 0; lights > 1 && i < std::min<std::size_t>(lights, 8); ++i) {
    try_factor(Cause::lights,
               fmt::format("light {} ({}) is", i + 1, word_of(sim.view->scene->lights[i].type)),
               [i](Trial& t, double k) {
                 if (i < t.scene.lights.size()) {
                   t.scene.lights[i].color *= static_cast<float>(k);
                 }
               });
  }
  for (std::size_t i = 0; i < std::min<std::size_t>(lights, 8); ++i) {
    add_color_of_light(sim, i);
  }
}
}  // namespace scenefile
