#include "scenefile/export/gltf_light.h"

#include "scenefile/base/components.h"
#include "scenefile/base/shape_traits.h"
#include "scenefile/export/codes.h"
#include "scenefile/export/report_once.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace scenefile {

namespace {

using std::numbers::pi;

// Candela for a color of 1. Lights in glTF always have inverse-square falloff.
double candela(const RenderLight& light, const Bounds& box) {
  double distance = 1;
  if (!box.empty()) {
    const glm::dvec3 middle = 0.5 * (box.min + box.max);
    const double radius = 0.5 * glm::distance(box.min, box.max);
    distance = std::max(glm::distance(glm::dvec3(light.position), middle), 0.1 * radius);
  }
  const glm::dvec3 a(light.attenuation);
  const double fade = a.x + a.y * distance + a.z * distance * distance;
  return pi * distance * distance * (fade > 0 ? std::min(1.0, 1 / fade) : 1.0);
}

std::string attenuation(const RenderLight& light) {
  const glm::vec3& a = light.attenuation;
  return fmt::format("[{},{},{}]", a.x, a.y, a.z);
}

std::string cone(const RenderLight& light) {
  const double outer = std::clamp(double(light.outer_angle), 1e-4, pi / 2 - 1e-6);
  const double inner = std::clamp(double(light.inner_angle), 0.0, 0.999 * outer);
  return fmt::format(R"(,"spot":{{"innerConeAngle":{},"outerConeAngle":{}}})", inner, outer);
}

}  // namespace

std::string gltf_light(const RenderLight& light, const Bounds& box, Diagnostics& diagnostics) {
  const auto note = [&](std::string_view text) {
    report_once("export.approximate"_code, text, diagnostics);
  };
  const glm::vec3 color = glm::max(light.color, glm::vec3(0));
  const double strongest = largest(color);
  const glm::dvec3 hue = strongest > 0 ? glm::dvec3(color) / strongest : glm::dvec3(1);
  double factor = pi;
  std::string_view type = "point";
  std::string more;
  std::string own;
  switch (light.type) {
    case LightType::directional:
      type = "directional";
      break;
    case LightType::spot:
      type = "spot";
      more = cone(light);
      note("the edge of a spotlight falls off by the cosine of the angle, not by the angle");
      if (double(light.outer_angle) > pi / 2) {
        report_once("export.lost"_code,
                    "a spotlight wider than 180 degrees becomes one of 180 degrees", diagnostics);
      }
      break;
    case LightType::area:
      report_once("export.lost"_code,
                  "glTF has no area lights: each becomes a point light at its center", diagnostics);
      own = fmt::format(R"(,"width":{},"height":{})", 2 * glm::length(light.half_u),
                        2 * glm::length(light.half_v));
      break;
    case LightType::point:
      break;
  }
  if (has_position(light.type)) {
    factor = candela(light, box);
    note(
        "lights in glTF have inverse-square falloff: their intensity matches at the center of the "
        "scene");
    own = fmt::format(R"(,"extras":{{"scenefile":{{"attenuation":{},"candela":{}{}}}}})",
                      attenuation(light), factor, own);
  }
  return fmt::format(R"({{"type":"{}","color":[{},{},{}],"intensity":{}{}{}}})", type, hue.x, hue.y,
                     hue.z, strongest * factor, more, own);
}

}  // namespace scenefile
