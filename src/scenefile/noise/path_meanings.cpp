#include "scenefile/noise/path_meanings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace scenefile {

namespace {

using std::numbers::pi;

// What the factor of all reflected light can mean.
std::vector<Meaning> meanings_of_direct(const PathTruth& truth, double factor, double error) {
  std::vector<Meaning> known;
  const double n = static_cast<double>(truth.lamp_areas.size());
  double area = 0;
  for (const double a : truth.lamp_areas) {
    area += a;
  }
  const bool equal =
      n > 0 && *std::min_element(truth.lamp_areas.begin(), truth.lamp_areas.end()) >
                   0.99 * *std::max_element(truth.lamp_areas.begin(), truth.lamp_areas.end());
  known.push_back(
      {2, "direct-twice",
       "direct light counts twice: by light samples and by hits of lamps, or for both sides"});
  known.push_back({pi, "pi", "Kd is not divided by pi in direct light"});
  known.push_back({1 / pi, "pi", "Kd is divided twice by pi in direct light"});
  if (n > 1) {
    known.push_back(
        {1 / n, "lamp-sampling",
         fmt::format("a lamp triangle is chosen without dividing by the probability 1/{:.0f}", n)});
    known.push_back(
        {n, "lamp-sampling",
         fmt::format(
             "light samples are multiplied once too often by the number of lamp triangles, {:.0f}",
             n)});
  }
  if (equal && n > 0) {
    known.push_back(
        {n / area, "lamp-area",
         fmt::format("light samples are not multiplied by the area of the triangle, {:.4g}",
                     area / n)});
    known.push_back(
        {n * n / area / area, "lamp-area",
         fmt::format("light samples are divided by the area of the triangle, {:.4g}", area / n)});
  }
  if (area > 0) {
    known.push_back(
        {1 / area, "lamp-area",
         fmt::format("light samples are not multiplied by the area of all lamps, {:.4g}", area)});
  }
  known.push_back({0.5, "self-shadow", "half of the shadow rays hit the surface they start on"});
  std::vector<Meaning> found;
  for (Meaning& k : known) {
    if (is_number(factor, error, k.value)) {
      found.push_back(std::move(k));
    }
  }
  if (found.empty() || is_number(factor, error, 2)) {
    for (int count = 2; count <= 16; ++count) {
      if (is_number(factor, error, count)) {
        found.push_back({double(count), "lamp-sampling",
                         fmt::format("{} light samples are added, not averaged", count)});
      } else if (is_number(factor, error, 1.0 / count) && found.empty()) {
        found.push_back({1.0 / count, "lamp-sampling",
                         fmt::format("light samples are divided by {} once too often", count)});
      }
    }
  }
  return found;
}

}  // namespace

bool is_number(double value, double error, double constant) {
  return std::abs(value / constant - 1) < std::max(0.012, 3 * error / constant);
}

std::vector<Meaning> meanings(const PathTruth& truth, const PathModel& m,
                              std::optional<double> whole, bool& general) {
  general = false;
  const double f = m.factor();
  const double error = m.fit.errors.empty() ? 0 : m.fit.errors.front();
  const double p = m.parameter;
  const double p_error = 0.01 * p;
  if (m.name == "direct" || m.name == "whole") {
    if (whole && is_number(*whole, 0.01, f)) {
      return {{f, "brightness", fmt::format("everything, lamps too, has the factor {:.3f}", f)}};
    }
    std::vector<Meaning> found = meanings_of_direct(truth, f, error);
    general = found.empty();
    if (general) {
      found.push_back(
          {f, "direct-factor",
           fmt::format(
               "all light that surfaces reflect has the factor {:.3f}: from direct light on", f)});
    } else if (!whole) {
      found.push_back({f, "brightness", "the brightness of the picture or the lamps"});
    }
    return found;
  }
  if (m.name == "direct-and-scattered" || m.name == "direct-and-bounce") {
    if (m.name == "direct-and-scattered" && is_number(f, error, p)) {
      if (is_number(p, p_error, pi)) {
        return {{p, "pi", "Kd is not divided by pi"}};
      }
      if (is_number(p, p_error, 1 / pi)) {
        return {{p, "pi", "Kd is divided twice by pi"}};
      }
    }
    general = true;  // two free numbers fit much
    return {};
  }
  if (m.name == "scattered" || m.name == "bounce") {
    std::vector<Meaning> found;
    const bool specular = truth.mirror || truth.glass;
    if (m.name == "scattered" || !specular) {
      if (is_number(p, p_error, pi)) {
        found.push_back({p, "pi", "Kd is not divided by pi in scattered light"});
      }
      if (is_number(p, p_error, 1 / pi)) {
        found.push_back({p, "pi", "Kd is divided twice by pi in scattered light"});
      }
      if (is_number(p, p_error, 1 / (2 * pi))) {
        found.push_back(
            {p, "direction-density",
             "scattered light is not divided by the density of the direction, 1 / 2 pi"});
      }
      if (is_number(p, p_error, 0.5)) {
        found.push_back(
            {p, "scattered-factor",
             "scattered light has the factor 1/2, as if half of the directions were lost"});
      }
      if (is_number(p, p_error, 2)) {
        found.push_back({p, "scattered-factor", "scattered light counts twice at each bounce"});
      }
    }
    if (found.empty() && m.name == "scattered" && specular) {
      general = true;
      return {{p, "scattered-factor",
               fmt::format(
                   "light has the factor {:.3f} for each diffuse or glossy bounce after the first",
                   p)}};
    }
    if (p < 0.05) {
      general = true;  // another name says that this light is missing
    }
    if (found.empty() || m.name == "bounce") {
      found.push_back({p, "roulette",
                       p < 1 ? fmt::format("paths are not divided by the probability {:.2f} of "
                                           "going on: each bounce has this factor",
                                           p)
                             : fmt::format("each bounce after the first has the factor {:.3f}, as "
                                           "if divided by a wrong probability of going on",
                                           p)});
    }
    return found;
  }
  if (m.name == "first-direct" || m.name == "indirect" || m.name == "mirror" || m.name == "glass" ||
      m.name == "caustics") {
    if (!m.free.empty()) {
      general = true;
      const char* const place = m.name == "first-direct"
                                    ? "direct light, also in mirrors and glass,"
                                : m.name == "indirect" ? "indirect light"
                                : m.name == "mirror"   ? "light after a mirror"
                                : m.name == "glass"    ? "light after glass"
                                                       : "light of caustics";
      return {{f, m.name + "-factor", fmt::format("{} has the factor {:.3f}", place, f)}};
    }
  }
  std::string what = m.what;
  if (!m.free.empty() && m.edits == 2) {
    what += fmt::format(", and light samples have the factor {:.3f}", f);
  }
  return {{f, m.name, what}};
}

}  // namespace scenefile
