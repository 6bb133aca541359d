#include "scenefile/noise/path_meanings.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string_view>
#include <utility>

namespace scenefile {

namespace {

using std::numbers::pi;

struct Constant {
  double value;
  Meaning meaning;
};

// What the factor of all reflected light can mean.
std::vector<Meaning> meanings_of_direct(const PathTruth& truth, double factor, double error) {
  const auto of_samples = [](const char* name, std::string what) {
    return Meaning{Cause::light_samples, name, std::move(what)};
  };
  std::vector<Constant> known;
  const double n = static_cast<double>(truth.lamp_areas.size());
  double area = 0;
  for (const double a : truth.lamp_areas) {
    area += a;
  }
  const bool equal =
      n > 0 && *std::min_element(truth.lamp_areas.begin(), truth.lamp_areas.end()) >
                   0.99 * *std::max_element(truth.lamp_areas.begin(), truth.lamp_areas.end());
  known.push_back(
      {2, of_samples("direct-twice",
                     "direct light counts twice: by light samples and by hits of lamps, or for "
                     "both sides")});
  known.push_back({pi, {Cause::scattering, "pi", "Kd is not divided by pi in direct light"}});
  known.push_back({1 / pi, {Cause::scattering, "pi", "Kd is divided twice by pi in direct light"}});
  if (n > 1) {
    known.push_back({1 / n, of_samples("lamp-sampling",
                                       fmt::format("a lamp triangle is chosen without dividing by "
                                                   "the probability 1/{:.0f}",
                                                   n))});
    known.push_back({n, of_samples("lamp-sampling",
                                   fmt::format("light samples are multiplied once too often by the "
                                               "number of lamp triangles, {:.0f}",
                                               n))});
  }
  if (equal && n > 0) {
    known.push_back(
        {n / area, of_samples("lamp-area", fmt::format("light samples are not multiplied by the "
                                                       "area of the triangle, {:.4g}",
                                                       area / n))});
    known.push_back(
        {n * n / area / area,
         of_samples("lamp-area", fmt::format("light samples are divided by the area of the "
                                             "triangle, {:.4g}",
                                             area / n))});
  }
  if (area > 0) {
    known.push_back(
        {1 / area, of_samples("lamp-area", fmt::format("light samples are not multiplied by the "
                                                       "area of all lamps, {:.4g}",
                                                       area))});
  }
  known.push_back(
      {0.5, of_samples("self-shadow", "half of the shadow rays hit the surface they start on")});
  std::vector<Meaning> found;
  for (Constant& k : known) {
    if (is_number(factor, error, k.value)) {
      found.push_back(std::move(k.meaning));
    }
  }
  if (found.empty() || is_number(factor, error, 2)) {
    for (int count = 2; count <= 16; ++count) {
      if (is_number(factor, error, count)) {
        found.push_back(of_samples("lamp-sampling",
                                   fmt::format("{} light samples are added, not averaged", count)));
      } else if (is_number(factor, error, 1.0 / count) && found.empty()) {
        found.push_back(of_samples(
            "lamp-sampling", fmt::format("light samples are divided by {} once too often", count)));
      }
    }
  }
  return found;
}

std::string factor_words(std::string_view place, double factor) {
  return std::abs(factor) < 0.03 ? fmt::format("{} is missing", place)
                                 : fmt::format("{} has the factor {:.3f}", place, factor);
}

// What the factor `p` of each diffuse or glossy bounce after the first can mean.
std::vector<Meaning> meanings_of_scattering(double p, double error, bool any_direct) {
  constexpr auto page = Cause::scattering;
  const char* const where = any_direct ? ", at least in scattered light" : " in scattered light";
  std::vector<Meaning> found;
  const std::array<Constant, 5> known{{
      {pi, {page, "pi", fmt::format("Kd is not divided by pi{}", where)}},
      {1 / pi, {page, "pi", fmt::format("Kd is divided twice by pi{}", where)}},
      {1 / (2 * pi),
       {page, "direction-density",
        "scattered light is not divided by the density of the direction, 1 / 2 pi"}},
      {0.5,
       {page, "scattered-factor",
        "scattered light has the factor 1/2, as if half of the directions were lost, or the "
        "density were twice as large"}},
      {2, {page, "scattered-factor", "scattered light counts twice at each bounce"}},
  }};
  for (const Constant& k : known) {
    if (is_number(p, error, k.value)) {
      found.push_back(k.meaning);
    }
  }
  return found;
}

// What factors of the light samples of each triangle can mean.
Meaning meaning_of_lamps(const PathModel& m, bool& general) {
  const std::size_t count = m.free.size();
  std::vector<std::string> factors;
  std::vector<std::string> never;
  for (std::size_t i = 0; i < count; ++i) {
    const double f = m.fit.factors[i];
    const double error = m.fit.errors[i];
    factors.push_back(fmt::format("{:.2f}", f));
    if (std::abs(f) < std::max(0.03, 3 * error)) {
      never.push_back(std::to_string(i + 1));
    } else if (!is_number(f, error, 1)) {
      general = true;
    }
  }
  general = general || never.empty() || never.size() == count;
  if (general) {
    return {m.page, "lamp-factors",
            fmt::format("light samples have the factors {} by triangle of the lamps",
                        fmt::join(factors, ", "))};
  }
  return {m.page, "lamp-choice",
          fmt::format("light samples are never on {} of the {} triangles of lamps: number {}",
                      never.size(), count, fmt::join(never, ", "))};
}

}  // namespace

std::vector<Meaning> meanings(const PathTruth& truth, const PathModel& m,
                              std::optional<LampFactor> whole, bool& general) {
  general = false;
  const double f = m.factor();
  const double error = m.fit.errors.empty() ? 0 : m.fit.errors.front();
  const double p = m.parameter;
  const double p_error = 0.01 * p;
  if (m.name == "direct" || m.name == "whole") {
    const bool lamps_too = whole && is_number(whole->value, whole->error, f);
    const bool lamps_tell = whole && !(lamps_too && is_number(whole->value, whole->error, 1));
    if (lamps_too && lamps_tell) {
      return {{Cause::brightness, "brightness",
               fmt::format("everything, lamps too, has the factor {:.3f}", f)}};
    }
    std::vector<Meaning> found = meanings_of_direct(truth, f, error);
    general = found.empty();
    if (general) {
      std::string what = fmt::format(
          "all light that surfaces reflect has the factor {:.3f}: from direct light on", f);
      const double twentieths = std::round(20 / f);
      if (twentieths >= 6 && twentieths < 20 && is_number(f, 0, 20 / twentieths)) {
        what +=
            fmt::format(", as if divided by the probability {:.2f} of going on", twentieths / 20);
      }
      found.push_back({m.page, "direct-factor", std::move(what)});
    }
    if (!lamps_tell) {
      found.push_back(
          {Cause::brightness, "brightness", "the brightness of the picture or the lamps"});
    }
    return found;
  }
  if (m.name == "indirect-color") {
    general = true;
    return {{m.page, "indirect-factor",
             fmt::format("indirect light has the factors {:.3f}, {:.3f} and {:.3f} for red, green "
                         "and blue",
                         f, m.fit.factors[1], m.fit.factors[2])}};
  }
  if (m.name == "direct-color") {
    general = true;
    return {{m.page, "lamp-color",
             fmt::format("light samples have the factors {:.3f}, {:.3f} and {:.3f} for red, green "
                         "and blue",
                         f, m.fit.factors[1], m.fit.factors[2])}};
  }
  if (m.name == "lamps") {
    return {meaning_of_lamps(m, general)};
  }
  if (m.name == "direct-and-scattered" || m.name == "direct-and-bounce") {
    const bool scattered = m.name == "direct-and-scattered";
    if (scattered && is_number(f, error, p) &&
        (is_number(p, p_error, pi) || is_number(p, p_error, 1 / pi))) {
      return {{m.page, "pi", p > 1 ? "Kd is not divided by pi" : "Kd is divided twice by pi"}};
    }
    if (scattered && is_number(f, error, p) && is_number(p, p_error, 0.5)) {
      return {
          {m.page, "pi",
           "each reflection, that of direct light too, has the factor 1/2, as if Kd were divided "
           "by 2 pi, not by pi"}};
    }
    general = true;
    std::string what =
        fmt::format("all light that surfaces reflect has the factor {:.3f}, and ", f);
    if (is_number(f, error, p)) {
      what = fmt::format("each reflection, that of direct light too, has the factor {:.3f}", f);
    } else if (p < 0.05) {
      what += "indirect light is missing";
    } else {
      what += fmt::format("each {} bounce after the first the factor {:.3f}",
                          scattered ? "diffuse or glossy" : "further", p);
    }
    return {{m.page, scattered ? "reflection-factor" : "bounce-factor", what}};
  }
  if (m.name == "scattered" || m.name == "bounce") {
    const bool specular = truth.mirror || truth.glass;
    const bool any_exposure = !m.free.empty();  // which hides the factor of direct light
    std::vector<Meaning> found;
    if (m.name == "scattered" || !specular) {
      found = meanings_of_scattering(p, p_error, any_exposure);
    }
    if (found.empty() && m.name == "scattered" && specular) {
      general = true;
      return {{m.page, "scattered-factor",
               fmt::format(
                   "light has the factor {:.3f} for each diffuse or glossy bounce after the first",
                   p)}};
    }
    if (p < 0.05) {
      general = true;  // another name says that this light is missing
    }
    if (found.empty() || m.name == "bounce") {
      found.push_back({Cause::path_length, "roulette",
                       p < 1 ? fmt::format("paths are not divided by the probability {:.2f} of "
                                           "going on: each bounce has this factor",
                                           p)
                             : fmt::format("each bounce after the first has the factor {:.3f}, as "
                                           "if divided by a wrong probability of going on",
                                           p)});
    }
    return found;
  }
  if (m.name == "glass-step" || m.name == "specular-step") {
    const bool glass = m.name == "glass-step";
    general = true;
    return {{m.page, glass ? "glass-factor" : "specular-factor",
             fmt::format("light has the factor {:.3f} for each reflection or refraction by {}", p,
                         glass ? "glass" : "mirrors and glass")}};
  }
  static constexpr std::array<std::pair<std::string_view, std::string_view>, 6> places{
      {{"first-direct", "direct light, also in mirrors and glass,"},
       {"indirect", "indirect light"},
       {"mirror", "light after a mirror"},
       {"glass", "light after glass"},
       {"caustics", "light of caustics"},
       {"glossy-lobe", "the glossy lobe"}}};
  const auto* const place = std::find_if(places.begin(), places.end(),
                                         [&](const auto& row) { return row.first == m.name; });
  if (place != places.end() && m.what.empty()) {
    if (m.name == "first-direct" && std::abs(f) < 0.03) {
      return {{Cause::light_samples, "direct", factor_words(place->second, f)}};
    }
    general = true;
    return {{m.page, m.name == "glossy-lobe" ? "glossy" : m.name + "-factor",
             factor_words(place->second, f)}};
  }
  if (m.name == "no-reflected-light" && whole && whole->is_black()) {
    return {{Cause::black, "black", "the picture is black, lamps too"}};
  }
  std::string what = m.what;
  if (!m.free.empty() && m.edits == 2) {
    // A factor near 1 need not be there: it takes what the mistake leaves.
    what += std::abs(f - 1) > least_off
                ? fmt::format(", and light samples have the factor {:.3f}", f)
                : std::string("; and something else is wrong");
  }
  return {{m.page, m.name, what}};
}

}  // namespace scenefile
