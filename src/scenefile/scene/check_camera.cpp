#include "scenefile/base/number.h"
#include "scenefile/scene/check_parts.h"
#include "scenefile/scene/codes.h"
#include "scenefile/scene/vocabulary.h"

#include <fmt/format.h>

#include <cmath>

namespace scenefile {

namespace {

// Beyond this, adjacent floats are 1 apart.
constexpr float far_away = 1e7f;
// Sine of the angle between look and up. Below `parallel`, the rounding of the file's numbers
// decides.
constexpr double parallel = 1e-6;
constexpr double nearly_parallel = 1e-3;

void check_coefficient(const ValueRow<Global>& row, float value, const Subject& global,
                       Reporter& reporter) {
  if (reporter.finite(global, *row.field, row.xml, value) && !row.range.contains(value)) {
    const bool negative = value < row.range.low;
    reporter.report(negative ? "global.negative"_code : "global.huge"_code, global, *row.field,
                    fmt::format("{} {} is {}", row.xml, number_text(value),
                                negative ? "negative" : "far above 1"));
  }
}

void check_directions(const Camera& camera, const Subject& subject, Reporter& reporter) {
  const bool look_finite = reporter.finite(subject, Field::look, "look", camera.look);
  const bool up_finite = reporter.finite(subject, Field::up, "up", camera.up);
  const bool look_zero = look_finite && camera.look == glm::vec3(0);
  const bool up_zero = up_finite && camera.up == glm::vec3(0);
  if (look_zero) {
    reporter.report("camera.look-zero"_code, subject, Field::look,
                    "look of the camera is 0 0 0, which is not a direction");
  }
  if (up_zero) {
    reporter.report("camera.up-zero"_code, subject, Field::up,
                    "up of the camera is 0 0 0, which is not a direction");
  }
  if (!look_finite || !up_finite || look_zero || up_zero) {
    return;
  }
  const glm::dvec3 look = glm::normalize(glm::dvec3(camera.look));
  const glm::dvec3 up = glm::normalize(glm::dvec3(camera.up));
  const double sine = glm::length(glm::cross(look, up));
  if (sine < nearly_parallel) {
    reporter.report(
        sine < parallel ? "camera.up-parallel-to-look"_code : "camera.up-nearly-parallel"_code,
        subject, Field::up,
        fmt::format("up {} of the camera is {}parallel to look {}", vector_text(camera.up),
                    sine < parallel ? "" : "nearly ", vector_text(camera.look)));
  }
}

void check_lens(const Camera& camera, const Subject& subject, Reporter& reporter) {
  const bool finite =
      reporter.finite(subject, Field::aperture, "aperture", camera.aperture) &&
      reporter.finite(subject, Field::focal_length, "focallength", camera.focal_length);
  if (!finite) {
    return;
  }
  if (camera.aperture < 0) {
    reporter.report("camera.lens-negative"_code, subject, Field::aperture,
                    fmt::format("aperture {} is negative; it counts as 0, a pinhole",
                                number_text(camera.aperture)));
  }
  if (camera.focal_length < 0) {
    reporter.report("camera.lens-negative"_code, subject, Field::focal_length,
                    fmt::format("focallength {} is negative; it counts as 0, a pinhole",
                                number_text(camera.focal_length)));
  }
  if (camera.aperture > 0 && camera.focal_length == 0) {
    reporter.report("camera.lens-incomplete"_code, subject, Field::aperture,
                    fmt::format("aperture {} has no effect without a focallength",
                                number_text(camera.aperture)));
  }
}

}  // namespace

void check_global(const Global& global, Reporter& reporter) {
  const Subject subject{"global data", global.location, no_node, global.unread};
  for (const ValueRow<Global>& row : global_rows) {
    const auto* const number = std::get_if<float Global::*>(&row.member);
    if (const std::optional<float> value = number ? global.**number : global.transparent) {
      check_coefficient(row, *value, subject, reporter);
    }
  }
}

void check_camera(const Camera& camera, Reporter& reporter) {
  const Subject subject{"camera", camera.location, no_node, camera.unread};
  if (reporter.finite(subject, Field::position, "pos", camera.position) &&
      largest(glm::abs(camera.position)) > far_away) {
    reporter.report("camera.far-away"_code, subject, Field::position,
                    fmt::format("pos {} of the camera is too far from the origin to draw from",
                                vector_text(camera.position)));
  }
  check_directions(camera, subject, reporter);
  if (!camera.unread.contains(Field::height_angle_deg) &&
      !row_of(camera_rows, Field::height_angle_deg).range.contains(camera.height_angle_deg)) {
    reporter.report("camera.height-angle"_code, subject, Field::height_angle_deg,
                    fmt::format("heightangle {} is not between 0 and 180 degrees",
                                number_text(camera.height_angle_deg)));
  }
  check_lens(camera, subject, reporter);
}

}  // namespace scenefile
