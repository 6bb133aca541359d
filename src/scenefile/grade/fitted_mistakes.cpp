#include "scenefile/grade/fitted_mistakes.h"

#include "scenefile/grade/candidates.h"
#include "scenefile/trace/tasks.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <map>
#include <numbers>
#include <set>
#include <utility>

namespace scenefile {

namespace {

using glm::dvec3;

// The median of `found`, if at least half of the values agree with it within 4 % or the tolerance.
std::optional<double> common_value(std::vector<double>& found, double tolerance_of_value = 0.01) {
  if (found.size() < 3 * few_pixels) {
    return std::nullopt;
  }
  const auto middle = found.begin() + std::ptrdiff_t(found.size() / 2);
  std::nth_element(found.begin(), middle, found.end());
  const double value = *middle;
  const auto close = std::count_if(found.begin(), found.end(), [&](double x) {
    return std::abs(x - value) <= std::max(0.04 * std::abs(value), tolerance_of_value);
  });
  return 2 * static_cast<std::size_t>(close) >= found.size() ? std::optional(value) : std::nullopt;
}

// Values of a channel in the reference and in the test.
using Pairs = std::vector<std::pair<double, double>>;

std::optional<double> common_step(const Pairs& pairs) {
  std::vector<double> steps;
  for (const auto& [r, t] : pairs) {
    steps.push_back(t - r);
  }
  return common_value(steps);
}

// Whether both values are far enough from 0 and 255 to estimate a factor or an exponent.
bool in_the_middle(double r, double t) {
  return r > 20 && r < 235 && t > 4 && t < 250;
}

std::optional<double> common_factor(const Pairs& pairs, double cut_off) {
  std::vector<double> factors;
  for (const auto& [r, t] : pairs) {
    if (in_the_middle(r, t)) {
      factors.push_back((t + cut_off) / (r + cut_off));
    }
  }
  return common_value(factors);
}

std::optional<double> common_power(const Pairs& pairs, double cut_off) {
  std::vector<double> powers;
  for (const auto& [r, t] : pairs) {
    if (in_the_middle(r, t)) {
      powers.push_back(std::log((t + cut_off) / 255) / std::log((r + cut_off) / 255));
    }
  }
  return common_value(powers);
}

double spread(const dvec3& v) {
  return largest_of(v) - std::min({v.x, v.y, v.z});
}

void add_to_picture(std::vector<Hypothesis>& list, Cause cause, std::string what,
                    std::function<dvec3(const dvec3&)> color) {
  list.push_back({cause, std::move(what), Stage::picture, {}, {}, std::move(color)});
}

// test = factor * reference + offset
struct Line {
  double factor = 1;
  double offset = 0;  // in 1/255
};

// The least-squares fit to the pairs near the line.
Line refined(Line line, const Pairs& pairs) {
  for (const double near : {8.0, 3.0}) {
    double n = 0, x = 0, y = 0, xx = 0, xy = 0;
    for (const auto& [r, t] : pairs) {
      if (t > 0 && t < 255 && std::abs(t - line.factor * r - line.offset) <= near) {
        n += 1;
        x += r;
        y += t;
        xx += r * r;
        xy += r * t;
      }
    }
    const double variance = n * xx - x * x;  // times n^2
    if (variance > 0) {
      line.factor = (n * xy - x * y) / variance;
      line.offset = (y - line.factor * x) / n;
    }
  }
  return line;
}

// The line on which most pairs lie, by the median of the slopes between distant pairs.
std::optional<Line> common_line(const Pairs& pairs) {
  std::vector<double> slopes;
  for (std::size_t gap = pairs.size() / 2;
       gap > pairs.size() / 2 - std::min<std::size_t>(pairs.size() / 2, 3); --gap) {
    for (std::size_t i = 0; i + gap < pairs.size(); ++i) {
      const double distance = pairs[i + gap].first - pairs[i].first;
      if (std::abs(distance) > 30) {
        slopes.push_back((pairs[i + gap].second - pairs[i].second) / distance);
      }
    }
  }
  const std::optional<double> factor = common_value(slopes);
  if (!factor) {
    return std::nullopt;
  }
  std::vector<double> offsets;
  for (const auto& [r, t] : pairs) {
    offsets.push_back(t - *factor * r);
  }
  const std::optional<double> offset = common_value(offsets, 1.5);
  return offset ? std::optional(refined({*factor, *offset}, pairs)) : std::nullopt;
}

// Changes of brightness and contrast: a line for all values, or one for each channel.
void add_lines(const std::array<Pairs, 3>& by_channel, double cut_off,
               std::vector<Hypothesis>& list) {
  Pairs all;
  for (const Pairs& pairs : by_channel) {
    all.insert(all.end(), pairs.begin(), pairs.end());
  }
  const auto is_bent = [](const Line& line) {
    return std::abs(line.offset) > 3 && std::abs(line.factor - 1) > 0.03 && line.factor > 0.03;
  };
  if (const std::optional<Line> line = common_line(all); line && is_bent(*line)) {
    add_to_picture(
        list, Cause::brightness,
        line->offset > 0
            ? fmt::format("values are {:.2f} times those of the reference, plus {:.0f} of 255: "
                          "black is lifted",
                          line->factor, line->offset)
            : fmt::format("values are {:.2f} times those of the reference, minus {:.0f} of 255: "
                          "the contrast is higher",
                          line->factor, -line->offset),
        [line = *line](const dvec3& c) { return line.factor * clamped(c) + line.offset / 255; });
  }
  dvec3 factors(1);
  dvec3 offsets(0);
  bool lines = false;
  for (int channel = 0; channel < 3; ++channel) {
    const Pairs& pairs = by_channel[std::size_t(channel)];
    if (const std::optional<Line> line = common_line(pairs); line && is_bent(*line)) {
      factors[channel] = line->factor;
      offsets[channel] = line->offset;
      lines = true;
    } else if (const std::optional<double> k = common_factor(pairs, cut_off)) {
      factors[channel] = *k;
    }
  }
  const double least = std::min({factors.x, factors.y, factors.z});
  if (least > 0.03 && (spread(factors) > 0.05 || spread(offsets) > 3)) {
    const std::string what = fmt::format(
        "red is {:.2f} times, green {:.2f} times, blue {:.2f} times as bright as in "
        "the reference",
        factors.x, factors.y, factors.z);
    add_to_picture(list, Cause::brightness,
                   lines ? what + fmt::format(", plus {:.0f} {:.0f} {:.0f} of 255", offsets.x,
                                              offsets.y, offsets.z)
                         : what,
                   [=](const dvec3& c) { return factors * clamped(c) + offsets / 255.0; });
    if (!lines) {
      add_to_picture(list, Cause::brightness, what + ", before values over 1 are cut off",
                     [=](const dvec3& c) { return factors * c; });
    }
  }
}

struct Zoom {
  bool across = false;
  bool up = false;
  const char* words = "";  // the mistake; {} is the size of objects
};

// The remaining difference at the first points if the film is scaled by a factor.
double left_with_film(const Simulation& sim, const Zoom& zoom, double factor, std::size_t count) {
  Trial trial = sim.right_trial(false);
  trial.scene.camera.u *= zoom.across ? factor : 1;
  trial.scene.camera.v *= zoom.up ? factor : 1;
  return score(sim.points, count, sim.draw(trial, *sim.shapes, sim.points, count, Turn(), nullptr))
      .left;
}

bool any_texture(const Simulation& sim) {
  return sim.view->options.mode == Mode::ray && sim.view->options.features.texture &&
         std::any_of(sim.view->scene->materials.begin(), sim.view->scene->materials.end(),
                     [](const RenderMaterial& m) { return m.texture.used() && m.blend != 0; });
}

using Factors = std::array<std::vector<double>, 3>;  // by channel

// The factors that a term has at the points that differ. `drop` removes the term from the scene.
Factors factors_of_term(const Simulation& sim, const std::function<void(Trial&)>& drop) {
  Trial without = sim.right_trial(false);
  drop(without);
  const std::size_t count = std::min<std::size_t>(sim.points.size(), 400);
  const Simulation::Clean& right = sim.clean({});
  const Colors dark = sim.draw(without, *sim.shapes, sim.points, count, Turn(), &right.hits);
  Factors found;
  for (std::size_t i = 0; i < count; ++i) {
    const dvec3 term = right.drawn[i] - dark[i];
    for (int channel = 0; sim.points[i].differs && channel < 3; ++channel) {
      const double t = sim.points[i].test[channel];
      if (std::abs(term[channel]) > 12 && t < 254) {
        found[std::size_t(channel)].push_back(1 +
                                              (t + 0.5 - right.drawn[i][channel]) / term[channel]);
      }
    }
  }
  return found;
}

// The color of a light, estimated from the pictures by channel.
void add_color_of_light(Simulation& sim, std::size_t light) {
  Factors found =
      factors_of_term(sim, [&](Trial& t) { t.scene.lights[light].color = glm::vec3(0); });
  dvec3 factors(1);
  for (int channel = 0; channel < 3; ++channel) {
    factors[channel] = common_value(found[std::size_t(channel)]).value_or(1);
  }
  if (spread(factors) < 0.1 || largest_of(factors) > 12) {
    return;
  }
  const glm::vec3 color = glm::max(sim.view->scene->lights[light].color * glm::vec3(factors), 0.0f);
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

Pairs pairs_that_differ(const std::vector<Point>& points, const Colors& reference) {
  Pairs pairs;
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (int channel = 0; channel < 3; ++channel) {
      const double t = points[i].test[channel];
      if (points[i].differs && t > 0 && t < 255) {
        pairs.emplace_back(reference[i][channel], t);
      }
    }
  }
  return pairs;
}

void drop_objects(Trial& t, const std::set<std::uint32_t>& sources) {
  for (RenderGroup& g : t.scene.groups) {
    std::erase_if(g.primitives,
                  [&](const RenderPrimitive& p) { return sources.contains(p.source); });
  }
}

}  // namespace

std::vector<Hypothesis> fitted_curves(const std::vector<Point>& points, const Colors& reference,
                                      double cut_off) {
  std::vector<Hypothesis> list;
  const Pairs all = pairs_that_differ(points, reference);
  std::array<Pairs, 3> by_channel;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const dvec3& t = points[i].test;
    for (int channel = 0; channel < 3; ++channel) {
      if (t[channel] > 0 && t[channel] < 255) {
        by_channel[std::size_t(channel)].emplace_back(reference[i][channel], t[channel]);
      }
    }
  }
  if (const std::optional<double> n = common_step(all); n && std::abs(*n) > 4) {
    add_to_picture(list, Cause::brightness,
                   fmt::format("{:.0f} of 255 was {} all values", std::abs(*n),
                               *n > 0 ? "added to" : "subtracted from"),
                   [n = *n / 255](const dvec3& c) { return n + clamped(c); });
  }
  if (const std::optional<double> k = common_factor(all, cut_off); k && std::abs(*k - 1) > 0.05) {
    add_to_picture(list, Cause::brightness,
                   fmt::format("the picture is {:.2f} times as bright as it should be", *k),
                   [k = *k](const dvec3& c) { return k * clamped(c); });
  }
  if (const std::optional<double> p = common_power(all, cut_off); p && std::abs(*p - 1) > 0.05) {
    add_to_picture(
        list, Cause::gamma,
        *p < 1 ? fmt::format("gamma {:.2f} was applied, but the format has no gamma correction",
                             1 / *p)
               : fmt::format("values were raised to the power of {:.2f}", *p),
        [p = *p](const dvec3& c) { return glm::pow(clamped(c), dvec3(p)); });
  }
  add_lines(by_channel, cut_off, list);
  for (Hypothesis& curve : list) {
    curve.combines = false;
  }
  return list;
}

std::optional<Hypothesis> addition_to_objects(const std::vector<Point>& points,
                                              const Colors& reference) {
  const std::optional<double> n = common_step(pairs_that_differ(points, reference));
  if (!n || std::abs(*n) <= 4) {
    return std::nullopt;
  }
  return Hypothesis{
      Cause::brightness,
      fmt::format("{:.0f} of 255 was {} all colors but black", std::abs(*n),
                  *n > 0 ? "added to" : "subtracted from"),
      Stage::picture,
      {},
      {},
      [n = *n / 255](const dvec3& c) { return clamped(c) == dvec3(0) ? dvec3(0) : n + clamped(c); },
      true,
      false};
}

namespace {

struct FoundFactor {
  double value = 1;
  double share = 0;  // of the values that show the factor
};

// Programs use plain numbers, which are estimated too low if values are truncated.
double plain_number(double value) {
  const double plain = std::round(20 * value) / 20;
  return std::abs(plain - value) <= 0.02 * value ? plain : value;
}

// The factor that makes most values of the colors those of the test, within rounding.
FoundFactor factor_of_most(const std::vector<Point>& points, const Colors& colors) {
  constexpr double same = 1.02;      // ratios in this range may have one factor
  constexpr double rounded = 1.1;    // of 255
  constexpr double min_spread = 30;  // of 255: a plain color fits any factor
  Pairs pairs;
  for (std::size_t i = 0; i < colors.size(); ++i) {
    for (int channel = 0; points[i].differs && channel < 3; ++channel) {
      const double c = colors[i][channel];
      const double t = points[i].test[channel];
      if (c > 12 && t > 5 && t < 252) {
        pairs.emplace_back(c, t);
      }
    }
  }
  if (pairs.size() < 3 * few_pixels) {
    return {};
  }
  const auto ratio = [](const auto& pair) { return pair.second / pair.first; };
  std::sort(pairs.begin(), pairs.end(),
            [&](const auto& a, const auto& b) { return ratio(a) < ratio(b); });
  std::size_t most = 0;
  std::size_t middle = 0;
  for (std::size_t first = 0, last = 0; first < pairs.size(); ++first) {
    while (last < pairs.size() && ratio(pairs[last]) <= same * ratio(pairs[first])) {
      ++last;
    }
    if (last - first > most) {
      most = last - first;
      middle = (first + last) / 2;
    }
  }
  FoundFactor found{ratio(pairs[middle]), 0};
  double offset = 0;  // values may be truncated
  for (int round = 0; round < 3; ++round) {
    double n = 0, x = 0, y = 0, xx = 0, xy = 0, least = 255, greatest = 0;
    for (const auto& [c, t] : pairs) {
      if (std::abs(t - found.value * c - offset) <= rounded) {
        n += 1;
        x += c;
        y += t;
        xx += c * c;
        xy += c * t;
        least = std::min(least, t);
        greatest = std::max(greatest, t);
      }
    }
    if (n < 2 * few_pixels || greatest - least < min_spread) {
      return {};
    }
    found = {(n * xy - x * y) / (n * xx - x * x), n / static_cast<double>(pairs.size())};
    offset = std::clamp((y - found.value * x) / n, -1.0, 0.5);
  }
  found.value = plain_number(found.value);
  return found;
}

}  // namespace

void add_factors_of_picture(Simulation& sim) {
  constexpr std::size_t max_factors = 3;
  constexpr double min_share = 0.2;
  constexpr double equal = 0.04;
  std::vector<FoundFactor> all;
  for (const Simulation::Clean& c : sim.clean_pictures) {
    all.push_back(factor_of_most(sim.points, c.drawn));
  }
  for (const Colors& colors : sim.cache) {
    all.push_back(factor_of_most(sim.points, colors));
  }
  std::stable_sort(all.begin(), all.end(),
                   [](const FoundFactor& a, const FoundFactor& b) { return a.share > b.share; });
  std::vector<double> values;
  for (const FoundFactor& f : all) {
    if (f.share < min_share || values.size() == max_factors) {
      break;
    }
    const auto near = [&](double k) { return std::abs(f.value - k) <= equal * k; };
    if (near(1) || std::any_of(values.begin(), values.end(), near)) {
      continue;
    }
    values.push_back(f.value);
    add_to_picture(sim.list, Cause::brightness,
                   fmt::format("the picture is {:.2f} times as bright as it should be", f.value),
                   [k = f.value](const dvec3& c) { return k * clamped(c); });
    if (f.value < 1) {
      add_to_picture(
          sim.list, Cause::brightness,
          fmt::format("the picture is {:.2f} times as bright as it should be, before values over "
                      "1 are cut off",
                      f.value),
          [k = f.value](const dvec3& c) { return k * c; });
    }
  }
}

bool curve_holds(const Texture& reference, const std::vector<Point>& points, const Colors& without,
                 const Colors& with) {
  constexpr double visible = 4;       // of 255
  constexpr double max_wrong = 0.1;   // share of the pixels
  constexpr double max_trend = 0.75;  // of 255
  constexpr std::size_t levels = 12;
  std::array<std::array<std::vector<double>, levels>, 3> errors;  // by channel and brightness
  double changed = 0;
  double wrong = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point& p = points[i];
    const dvec3 after = glm::clamp(with[i], dvec3(0), dvec3(255));
    if (largest_of(glm::abs(after - without[i])) <= visible ||
        !around(reference, p.x, p.y).calm()) {
      continue;
    }
    changed += p.weight;
    wrong += largest_of(glm::abs(after - p.test)) > visible ? p.weight : 0;
    for (int channel = 0; channel < 3; ++channel) {
      const double t = p.test[channel];
      if (t > 0 && t < 255 && after[channel] > 0 && after[channel] < 255) {
        const auto level = static_cast<std::size_t>(after[channel] / 256 * levels);
        errors[std::size_t(channel)][level].push_back(after[channel] - t);
      }
    }
  }
  for (auto& of_channel : errors) {
    for (std::vector<double>& level : of_channel) {
      if (level.size() < few_pixels) {
        continue;
      }
      const auto middle = level.begin() + std::ptrdiff_t(level.size() / 2);
      std::nth_element(level.begin(), middle, level.end());
      if (std::abs(*middle) > max_trend) {
        return false;
      }
    }
  }
  return wrong <= max_wrong * changed;
}

// The color of most points that differ where the turned scene shows nothing.
std::optional<std::array<int, 3>> color_of_nothing(const Simulation& sim, const Turn& turn) {
  std::map<std::array<int, 3>, double> colors;
  double all = 0;
  for (std::size_t i = 0; i < sim.points.size(); ++i) {
    if (sim.clean(turn).hits[i].part == nullptr && sim.points[i].differs) {
      const dvec3& t = sim.points[i].test;
      colors[{int(t.x), int(t.y), int(t.z)}] += sim.points[i].weight;
      all += sim.points[i].weight;
    }
  }
  const auto most =
      std::max_element(colors.begin(), colors.end(),
                       [](const auto& a, const auto& b) { return a.second < b.second; });
  return all > 0 && most->second >= 0.7 * all ? std::optional(most->first) : std::nullopt;
}

void add_background(Simulation& sim) {
  std::set<std::array<int, 3>> colors;
  for (const Turn turn :
       {Turn{false, false}, Turn{true, false}, Turn{false, true}, Turn{true, true}}) {
    if (const auto color = color_of_nothing(sim, turn)) {
      colors.insert(*color);
    }
  }
  for (const auto& [r, g, b] : colors) {
    const dvec3 color = dvec3(r, g, b) / 255.0;
    for (const bool in_reflections : {false, true}) {
      sim.list.push_back({Cause::background,
                          fmt::format("the background is {} {} {}, not black{}", r, g, b,
                                      in_reflections ? ", and reflections show it" : ""),
                          Stage::shading,
                          [=](Trial& t) {
                            t.mistakes.background = color;
                            t.mistakes.background_in_reflections = in_reflections;
                          },
                          {},
                          {}});
    }
  }
}

void add_factors(Simulation& sim) {
  using Change = std::function<void(Trial&, double)>;
  // `listed`: factors that are mistakes of their own.
  const auto try_factor = [&](Cause cause, const std::string& what,
                              std::initializer_list<double> listed, const Change& change) {
    constexpr double near = 0.02;
    std::vector<double> found;
    for (const std::vector<double>& of_channel :
         factors_of_term(sim, [&](Trial& t) { change(t, 0); })) {
      found.insert(found.end(), of_channel.begin(), of_channel.end());
    }
    std::optional<double> k = common_value(found);
    if (k) {
      k = plain_number(*k);
    }
    if (k && *k > 0.03 && *k < 12 && std::abs(*k - 1) > 0.05 &&
        std::none_of(listed.begin(), listed.end(),
                     [&](double other) { return std::abs(*k - other) <= near * other; })) {
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
  try_factor(Cause::ambient, "the ambient term is", {2},
             [](Trial& t, double k) { t.scene.global.ambient *= static_cast<float>(k); });
  try_factor(Cause::diffuse, "the diffuse term is", {0.5, 2},
             [](Trial& t, double k) { t.mistakes.diffuse_factor *= k; });
  if (any_texture(sim)) {
    try_factor(Cause::diffuse, "the diffuse term, except for textures, is", {},
               [](Trial& t, double k) { t.scene.global.diffuse *= static_cast<float>(k); });
  }
  try_factor(Cause::specular, "the specular term is", {0.5, 2}, [](Trial& t, double k) {
    for (RenderMaterial& m : t.scene.materials) {
      m.specular *= static_cast<float>(k);
    }
  });
  try_factor(Cause::reflection, "reflections are", {0.5, 2},
             [](Trial& t, double k) { t.mistakes.mirror_factor *= k; });
  try_factor(Cause::refraction, "refraction is", {0.5},
             [](Trial& t, double k) { t.mistakes.glass_factor *= k; });
  const std::size_t lights = sim.view->scene->lights.size();
  try_factor(Cause::lights, "the light from all lights is", {}, [](Trial& t, double k) {
    for (RenderLight& light : t.scene.lights) {
      light.color *= static_cast<float>(k);
    }
  });
  for (std::size_t i = 0; lights > 1 && i < std::min<std::size_t>(lights, 8); ++i) {
    try_factor(Cause::lights,
               fmt::format("light {} ({}) is", i + 1, word_of(sim.view->scene->lights[i].type)), {},
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

namespace {

// A mistake in the exponents of highlights: all are `number`, or `number` times that of the file.
struct Exponent {
  bool times = false;
  double number = 1;

  void change(Trial& t) const {
    if (!times) {
      t.mistakes.exponent = number;
      return;
    }
    for (RenderMaterial& m : t.scene.materials) {
      m.shininess *= static_cast<float>(number);
    }
  }
};

// How far the changes of the right picture are from those of the reference. Truncation moves both
// pictures by half a step, which the changes do not show.
double left_of_changes(const Simulation& sim, const Colors& colors) {
  const Simulation::Clean& right = sim.clean({});
  double left = 0;
  for (std::size_t i = 0; i < colors.size(); ++i) {
    const Point& p = sim.points[i];
    const dvec3 change = glm::min(colors[i], 255.0) - glm::min(right.drawn[i], 255.0);
    left += p.weight * largest_of(glm::abs(change - (p.test - right.reference[i])));
  }
  return left;
}

Colors drawn_with(const Simulation& sim, const Exponent& e, std::size_t count) {
  Trial trial = sim.right_trial(false);
  e.change(trial);
  return sim.draw(trial, *sim.shapes, sim.points, count, Turn(), &sim.clean({}).hits);
}

// Whether most of the points that differ show the exponents.
bool show_exponents(const Simulation& sim, const Exponent& file, std::size_t count) {
  const Colors larger = drawn_with(sim, {file.times, 2 * file.number}, count);
  const Colors smaller = drawn_with(sim, {file.times, file.number / 2}, count);
  double all = 0;
  double shown = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const double weight = sim.points[i].differs ? sim.points[i].weight : 0;
    all += weight;
    shown += largest_of(glm::abs(larger[i] - smaller[i])) > tolerance ? weight : 0;
  }
  return shown > 0.5 * all;
}

// The exponent that leaves the least difference.
Exponent fitted_exponent(const Simulation& sim, const Exponent& file, std::size_t count) {
  constexpr double largest = 16;  // factor: highlights of larger exponents nearly vanish
  Exponent best = file;
  double least = infinity;
  const auto try_exponent = [&](double number) {
    if (number > largest * file.number || number < file.number / largest) {
      return;
    }
    const Exponent e{file.times, number};
    if (const double left = left_of_changes(sim, drawn_with(sim, e, count)); left < least) {
      least = left;
      best = e;
    }
  };
  for (double times = 1 / largest; times <= largest; times *= 2) {
    try_exponent(file.number * times);
  }
  for (const double step : {0.4, 0.2, 0.1, 0.05, 0.02, 0.01, 0.005}) {
    const double middle = best.number;
    try_exponent(middle * std::exp(step));
    try_exponent(middle * std::exp(-step));
  }
  return best;
}

}  // namespace

void add_exponents(Simulation& sim) {
  constexpr std::array known_factors{0.25, 0.5, 1.0, 2.0, 4.0};  // which have their own words
  constexpr double as_known = 0.02;
  std::set<float> written;
  for (const RenderMaterial& m : sim.view->scene->materials) {
    if (m.shininess > 0 && m.specular != glm::vec3(0)) {
      written.insert(m.shininess);
    }
  }
  const std::size_t count = std::min<std::size_t>(sim.points.size(), screen);
  for (const bool times : {false, true}) {
    // With one exponent in the file, a factor gives the same picture as a number.
    if (written.empty() || (times && written.size() == 1)) {
      continue;
    }
    const Exponent file{times, times ? 1 : *written.begin()};
    if (!show_exponents(sim, file, count)) {
      continue;
    }
    const Exponent e = fitted_exponent(sim, file, count);
    const double factor = e.number / file.number;
    if (std::any_of(known_factors.begin(), known_factors.end(),
                    [&](double k) { return std::abs(factor / k - 1) <= as_known; })) {
      continue;
    }
    const double shown = e.number >= 10 ? std::round(e.number) : e.number;
    sim.list.push_back(
        {Cause::specular,
         e.times
             ? fmt::format("the exponents of highlights are {:.2g} times those of the file", shown)
         : written.size() == 1
             ? fmt::format("the exponent of highlights is about {:.3g}, but in the file it is {:g}",
                           shown, *written.begin())
             : fmt::format("the exponent of highlights is always about {:.3g}", shown),
         Stage::shading,
         [e](Trial& t) { e.change(t); },
         {},
         {}});
  }
}

void add_missing_objects(Simulation& sim) {
  constexpr std::size_t max_objects = 2000;
  constexpr std::size_t max_tried = 12;
  constexpr std::size_t few_points_of_object = 3;
  std::size_t objects = 0;
  for (const RenderGroup& g : sim.view->scene->groups) {
    objects += g.primitives.size();
  }
  if (objects < 2 || sim.shapes->parts.size() > max_objects) {
    return;
  }
  const std::size_t count = std::min<std::size_t>(sim.points.size(), 400);
  std::set<std::uint32_t> missing;
  Shape shape = Shape::cube;
  Colors colors(sim.clean({}).drawn.begin(), sim.clean({}).drawn.begin() + std::ptrdiff_t(count));
  double left = score(sim.points, count, colors).left;
  std::shared_ptr<const ModelShapes> shapes = sim.shapes;
  std::size_t tried = 0;
  for (bool found = true; found && missing.size() + 1 < objects;) {
    found = false;
    // Objects whose pixels are nearly all wrong.
    const Trial trial = sim.right_trial(false);
    const Model model(trial.scene, *shapes, *sim.view->assets, trial.options, trial.mistakes);
    struct Seen {
      std::size_t wrong = 0;
      std::size_t all = 0;
      Shape shape = Shape::cube;
    };
    std::map<std::uint32_t, Seen> seen;
    for (std::size_t i = 0; i < count; ++i) {
      const Point& p = sim.points[i];
      const ModelHit hit = model.first_hit(sim.ray(model, sim.middle(p, {})));
      if (hit.part != nullptr) {
        Seen& object = seen[hit.part->source];
        const dvec3 c = glm::clamp(colors[i], dvec3(0), dvec3(255));
        object.wrong += largest_of(outside(c, p.low, p.high)) > exact_within ? 1 : 0;
        object.shape = hit.part->shape;
        ++object.all;
      }
    }
    for (const auto& [source, object] : seen) {
      if (object.all < few_points_of_object || 10 * object.wrong < 9 * object.all ||
          ++tried > max_tried) {
        continue;
      }
      std::set<std::uint32_t> more = missing;
      more.insert(source);
      Trial without = sim.right_trial(true);
      drop_objects(without, more);
      const std::shared_ptr<const ModelShapes> rest =
          flatten(without.scene, *sim.view->assets, sim.shapes.get());
      Colors drawn = sim.draw(without, *rest, sim.points, count, Turn(), nullptr);
      if (const double now = score(sim.points, count, drawn).left; now < 0.98 * left) {
        left = now;
        missing = std::move(more);
        shapes = rest;
        colors = std::move(drawn);
        shape = object.shape;
        found = true;
        break;
      }
    }
  }
  if (missing.empty()) {
    return;
  }
  sim.list.push_back(
      {Cause::shapes,
       missing.size() == 1
           ? fmt::format("one of {} objects is not drawn, a {}", objects, word_of(shape))
           : fmt::format("{} of {} objects are not drawn", missing.size(), objects),
       Stage::shapes,
       [missing](Trial& t) { drop_objects(t, missing); },
       {},
       {}});
}

void add_zooms(Simulation& sim) {
  static constexpr std::array<Zoom, 3> zooms{
      {{true, true, "the picture is zoomed: objects are {:.3g} times as large as they should be"},
       {true, false, "objects are {:.3g} times as wide as they should be; their height is right"},
       {false, true, "objects are {:.3g} times as high as they should be; their width is right"}}};
  const std::size_t coarse = std::min<std::size_t>(sim.points.size(), 100);
  const std::size_t fine = std::min<std::size_t>(sim.points.size(), 300);
  const double as_it_is = left_with_film(sim, zooms[0], 1, coarse);
  constexpr int steps = 30;  // smaller, and larger
  constexpr std::size_t factors = 2 * steps + 1;
  const auto factor_at = [](std::size_t k) { return std::exp(0.04 * (double(k) - steps)); };
  std::array<std::array<double, factors>, zooms.size()> left_at;
  for_each_task(zooms.size() * factors, [&](std::size_t i) {
    left_at[i / factors][i % factors] =
        left_with_film(sim, zooms[i / factors], factor_at(i % factors), coarse);
  });
  for (std::size_t z = 0; z < zooms.size(); ++z) {
    const Zoom& zoom = zooms[z];
    const auto first = std::min_element(left_at[z].begin(), left_at[z].end());
    double least = *first;
    double best = factor_at(static_cast<std::size_t>(first - left_at[z].begin()));
    if (least > 0.75 * as_it_is || least >= as_it_is) {
      continue;
    }
    least = left_with_film(sim, zoom, best, fine);
    for (const double step : {0.02, 0.01, 0.005, 0.0025, 0.001}) {
      for (const double factor : {best * std::exp(step), best * std::exp(-step)}) {
        if (const double left = left_with_film(sim, zoom, factor, fine); left < least) {
          least = left;
          best = factor;
        }
      }
    }
    std::string what = fmt::format(fmt::runtime(zoom.words), 1 / best);
    if (zoom.across && zoom.up) {
      const double half = sim.view->scene->camera.fov_y / 2;
      const double degrees = 180 / std::numbers::pi;
      what += fmt::format(" (a height angle of {:.1f} degrees, not {:.1f})",
                          2 * degrees * std::atan(best * std::tan(half)), 2 * degrees * half);
    }
    sim.list.push_back({Cause::camera,
                        std::move(what),
                        Stage::camera,
                        [zoom, best](Trial& t) {
                          t.scene.camera.u *= zoom.across ? best : 1;
                          t.scene.camera.v *= zoom.up ? best : 1;
                        },
                        {},
                        {}});
  }
}

}  // namespace scenefile
