#include "scenefile/base/number.h"
#include "scenefile/scene/check_parts.h"
#include "scenefile/scene/codes.h"
#include "scenefile/scene/vocabulary.h"

#include <fmt/format.h>

#include <cmath>

namespace scenefile {

namespace {

constexpr double huge_steady_color = 16;

bool fades(const Light& light) {
  return light_uses(light.type, Field::attenuation) &&
         (light.attenuation.y > 0 || light.attenuation.z > 0 || light.attenuation.x > 1);
}

void check_color(const Light& light, const Subject& subject, Reporter& reporter) {
  if (!reporter.finite(subject, Field::color, "color", light.color)) {
    return;
  }
  if (smallest(light.color) < 0) {
    reporter.report(
        "light.color-negative"_code, subject, Field::color,
        fmt::format("color {} of the {} is negative", vector_text(light.color), subject.what));
  }
  if (largest(light.color) > (fades(light) ? ranges::light_color.high : huge_steady_color)) {
    reporter.report(
        "light.color-huge"_code, subject, Field::color,
        fmt::format("color {} of the {} is far above 1{}", vector_text(light.color), subject.what,
                    largest(light.color) <= 255 ? "; did you mean a value out of 255?" : ""));
  }
}

void check_attenuation(const Light& light, const Subject& subject, Reporter& reporter) {
  if (!light_uses(light.type, Field::attenuation) ||
      !reporter.finite(subject, Field::attenuation, "function", light.attenuation)) {
    return;
  }
  if (light.attenuation == glm::vec3(0)) {
    reporter.report("light.function-zero"_code, subject, Field::attenuation,
                    fmt::format("function (JSON attenuationCoeff) 0 0 0 of the {} divides by zero; "
                                "it counts as 1 0 0",
                                subject.what));
  } else if (smallest(light.attenuation) < 0) {
    reporter.report("light.function-negative"_code, subject, Field::attenuation,
                    fmt::format("function (JSON attenuationCoeff) {} of the {} has a negative "
                                "coefficient; it counts as 0",
                                vector_text(light.attenuation), subject.what));
  }
}

void check_direction(const Light& light, const Subject& subject, Reporter& reporter) {
  if (reporter.finite(subject, Field::direction, "direction", light.direction) &&
      light.direction == glm::vec3(0)) {
    reporter.report("light.direction-zero"_code, subject, Field::direction,
                    reporter.gives(subject, Field::direction)
                        ? fmt::format("the {} needs a direction other than 0 0 0", subject.what)
                        : fmt::format("the {} has no direction; write the one in which its light "
                                      "travels",
                                      subject.what));
  }
}

void check_angle(const Light& light, const Subject& subject, Reporter& reporter) {
  const float angle = *light.angle_deg;
  if (!reporter.finite(subject, Field::angle_deg, "angle", angle)) {
    return;
  }
  if (!row_of(light_rows, Field::angle_deg).range.contains(angle)) {
    reporter.report(
        "light.angle-range"_code, subject, Field::angle_deg,
        fmt::format("angle {} of the spotlight is not between 0 and 180 degrees{}",
                    number_text(angle), angle <= 0 ? "; it lights nothing" : "; it counts as 180"));
  } else if (light.penumbra_deg > angle) {
    reporter.report(
        "light.penumbra-over-angle"_code, subject, Field::penumbra_deg,
        fmt::format("penumbra {} of the spotlight is larger than its angle {}; it counts as {}",
                    number_text(light.penumbra_deg), number_text(angle), number_text(angle)));
  }
}

void check_cone(const Light& light, const Subject& subject, Reporter& reporter) {
  if (!reporter.finite(subject, Field::penumbra_deg, "penumbra", light.penumbra_deg)) {
    return;
  }
  if (light.penumbra_deg < 0) {
    reporter.report("light.penumbra-negative"_code, subject, Field::penumbra_deg,
                    fmt::format("penumbra {} of the spotlight is negative; it counts as 0",
                                number_text(light.penumbra_deg)));
  }
  if (light.angle_deg) {
    check_angle(light, subject, reporter);
  } else if (!light.unread.contains(Field::angle_deg)) {
    reporter.report("light.spot-without-angle"_code, subject,
                    light.penumbra_deg > 0
                        ? fmt::format("the spotlight has no angle; penumbra {} counts as its "
                                      "half-angle",
                                      number_text(light.penumbra_deg))
                        : "the spotlight has neither an angle nor a penumbra; it lights nothing");
  }
}

void check_rectangle(const Light& light, const Subject& subject, Reporter& reporter) {
  if (reporter.finite(subject, Field::width, "width", light.width) &&
      reporter.finite(subject, Field::height, "height", light.height) &&
      (light.width <= 0 || light.height <= 0)) {
    reporter.report("light.area-without-size"_code, subject,
                    light.width <= 0 ? Field::width : Field::height,
                    fmt::format("width {} and height {} of the area light enclose no area",
                                number_text(light.width), number_text(light.height)));
  }
}

}  // namespace

void check_light(const Light& light, NodeId node, Reporter& reporter) {
  const Subject subject{light_type_name(light.type), light.location, node, light.unread};
  check_color(light, subject, reporter);
  check_attenuation(light, subject, reporter);
  if (light_uses(light.type, Field::position)) {
    reporter.finite(subject, Field::position, "position", light.position);
  }
  if (light_uses(light.type, Field::direction)) {
    check_direction(light, subject, reporter);
  }
  if (light_uses(light.type, Field::angle_deg)) {
    check_cone(light, subject, reporter);
  }
  if (light_uses(light.type, Field::width)) {
    check_rectangle(light, subject, reporter);
  }
}

}  // namespace scenefile
