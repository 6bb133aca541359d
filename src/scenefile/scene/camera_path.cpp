#include "scenefile/scene/camera_path.h"

#include "scenefile/scene/vocabulary.h"

#include <fmt/format.h>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <cstddef>
#include <variant>

namespace scenefile {

namespace {

constexpr double full_turn = 6.283185307179586477;

// The slope at an inner knot between two segments that take the times `before` and `after`: that of
// the parabola through the three points.
template <typename T>
T parabola_slope(const T& slope_before, const T& slope_after, double before, double after) {
  return (slope_before * after + slope_after * before) / (before + after);
}

// The same, limited so that the curve does not overshoot.
double monotone_slope(double slope_before, double slope_after, double before, double after) {
  if (slope_before * slope_after <= 0) {
    return 0;
  }
  const double w1 = 2 * after + before;
  const double w2 = after + 2 * before;
  return (w1 + w2) / (w1 / slope_before + w2 / slope_after);
}

// The cubic Hermite curve from a to b with these slopes, at `s` in [0, 1].
template <typename T>
T hermite(const T& a, const T& b, const T& slope_a, const T& slope_b, double length, double s) {
  const double s2 = s * s;
  const double s3 = s2 * s;
  return a * (2 * s3 - 3 * s2 + 1) + b * (3 * s2 - 2 * s3) +
         slope_a * ((s3 - 2 * s2 + s) * length) + slope_b * ((s3 - s2) * length);
}

// A value of views i and i + 1, and of their neighbors.
template <typename T, typename Value, typename Slope>
T interpolated(std::span<const CameraView> views, std::size_t i, double time, const Value& value,
               const Slope& inner_slope) {
  const auto length = [&](std::size_t k) { return views[k + 1].time - views[k].time; };
  const auto slope = [&](std::size_t k) { return (value(k + 1) - value(k)) / length(k); };
  const T slope_a =
      i == 0 ? slope(0) : inner_slope(slope(i - 1), slope(i), length(i - 1), length(i));
  const T slope_b = i + 2 == views.size()
                        ? slope(i)
                        : inner_slope(slope(i), slope(i + 1), length(i), length(i + 1));
  return hermite<T>(value(i), value(i + 1), slope_a, slope_b, length(i),
                    (time - views[i].time) / length(i));
}

glm::dvec4 rotation_of(const Camera& camera) {
  const glm::dvec3 back = glm::normalize(-glm::dvec3(camera.look));
  const glm::dvec3 right = glm::normalize(glm::cross(glm::dvec3(camera.up), back));
  const glm::dquat q = glm::quat_cast(glm::dmat3(right, glm::cross(back, right), back));
  return {q.w, q.x, q.y, q.z};
}

// Both q and -q represent a rotation: chooses the one nearer to the previous view.
glm::dvec4 rotation_in_row(std::span<const CameraView> views, std::size_t first,
                           std::size_t index) {
  glm::dvec4 rotation = rotation_of(views[first].camera);
  for (std::size_t k = first + 1; k <= index; ++k) {
    const glm::dvec4 next = rotation_of(views[k].camera);
    rotation = glm::dot(rotation, next) < 0 ? -next : next;
  }
  return rotation;
}

}  // namespace

Camera camera_at(std::span<const CameraView> views, double time) {
  const auto after = std::find_if(views.begin(), views.end(),
                                  [&](const CameraView& view) { return view.time >= time; });
  if (after == views.end()) {
    return views.back().camera;
  }
  if (after == views.begin() || after->time == time) {
    return after->camera;
  }
  const auto i = static_cast<std::size_t>(after - views.begin()) - 1;
  const auto slope_of_vectors = [](const auto& a, const auto& b, double before, double next) {
    return parabola_slope(a, b, before, next);
  };
  const auto vector = [&](const auto& value) {
    return interpolated<glm::dvec3>(views, i, time, value, slope_of_vectors);
  };
  const auto number = [&](float Camera::*member) {
    return static_cast<float>(interpolated<double>(
        views, i, time, [&](std::size_t k) { return double{views[k].camera.*member}; },
        monotone_slope));
  };
  Camera camera = views[i].camera;
  const glm::dvec3 position =
      vector([&](std::size_t k) { return glm::dvec3(views[k].camera.position); });
  camera.position = position;
  camera.height_angle_deg = number(&Camera::height_angle_deg);
  camera.aperture = number(&Camera::aperture);
  camera.focal_length = number(&Camera::focal_length);
  const std::size_t first = i == 0 ? 0 : i - 1;
  const std::size_t last = std::min(i + 2, views.size() - 1);
  const bool has_focus = std::all_of(views.begin() + first, views.begin() + last + 1,
                                     [](const CameraView& view) { return view.focus.has_value(); });
  if (has_focus) {
    camera.look = vector([&](std::size_t k) { return glm::dvec3(*views[k].focus); }) - position;
    camera.up =
        vector([&](std::size_t k) { return glm::normalize(glm::dvec3(views[k].camera.up)); });
    return camera;
  }
  const glm::dvec4 q = glm::normalize(interpolated<glm::dvec4>(
      views, i, time, [&](std::size_t k) { return rotation_in_row(views, first, k); },
      slope_of_vectors));
  const glm::dquat rotation(q[0], q[1], q[2], q[3]);
  camera.look = rotation * glm::dvec3(0, 0, -1);
  camera.up = rotation * glm::dvec3(0, 1, 0);
  return camera;
}

Camera camera_around(const Camera& camera, const glm::dvec3& center, double turns) {
  if (turns == 0) {
    return camera;
  }
  const glm::dvec3 axis = glm::normalize(glm::dvec3(camera.up));
  const glm::dmat3 turn(glm::rotate(glm::dmat4(1), full_turn * turns, axis));
  Camera turned = camera;
  turned.position = center + turn * (glm::dvec3(camera.position) - center);
  turned.look = turn * glm::dvec3(camera.look);
  return turned;
}

std::string camera_key(const Camera& camera) {
  std::string key;
  const auto add = [&](float number) {
    key += fmt::format("{}{:a}", key.empty() ? "" : ",", number);
  };
  for (const ValueRow<Camera>& row : camera_rows) {
    if (const auto* const number = std::get_if<float Camera::*>(&row.member)) {
      add(camera.**number);
    } else if (const auto* const vector = std::get_if<glm::vec3 Camera::*>(&row.member)) {
      for (int i = 0; i < 3; ++i) {
        add((camera.**vector)[i]);
      }
    }
  }
  return key;
}

}  // namespace scenefile
