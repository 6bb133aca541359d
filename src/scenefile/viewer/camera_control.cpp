#include "scenefile/viewer/camera_control.h"

#include "scenefile/scene/prepare.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace scenefile::viewer {

namespace {

constexpr double degree = std::numbers::pi / 180;
// The minimum angle between the view direction and `up`.
constexpr double pole_deg = 0.5;

// Rodrigues' rotation formula.
glm::dvec3 rotated(const glm::dvec3& v, const glm::dvec3& axis, double angle_deg) {
  const double c = std::cos(angle_deg * degree);
  const double s = std::sin(angle_deg * degree);
  return v * c + glm::cross(axis, v) * s + axis * (glm::dot(axis, v) * (1 - c));
}

glm::dvec3 unit_or(const glm::dvec3& v, const glm::dvec3& otherwise) {
  const double length = glm::length(v);
  return length > 0 && std::isfinite(length) ? v / length : otherwise;
}

// The angle between the direction and `up`, from 0 to 180.
double angle_to_up(const glm::dvec3& ahead, const glm::dvec3& up) {
  return std::acos(std::clamp(glm::dot(ahead, up), -1.0, 1.0)) / degree;
}

// The direction turned right and up, kept away from the poles.
glm::dvec3 turned_direction(const ViewCamera& view, double right_deg, double up_deg) {
  const ViewAxes axes = axes_of(view);
  const double now = angle_to_up(axes.ahead, view.up);
  const double then = std::clamp(now - up_deg, pole_deg, 180 - pole_deg);
  const glm::dvec3 ahead = rotated(axes.ahead, axes.right, now - then);
  return glm::normalize(rotated(ahead, view.up, -right_deg));
}

// A vector rounded to `digits` significant digits of its longest component.
glm::vec3 rounded(const glm::dvec3& v, int digits) {
  const double longest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  if (longest == 0 || !std::isfinite(longest)) {
    return glm::vec3(0);
  }
  const double step = std::pow(10.0, std::floor(std::log10(longest)) - digits + 1);
  const auto part = [&](double x) { return static_cast<float>(std::round(x / step) * step + 0.0); };
  return {part(v.x), part(v.y), part(v.z)};
}

bool alike(const glm::dvec3& a, const glm::dvec3& b) {
  return glm::length(a - b) <= 1e-6 * std::max(glm::length(a), glm::length(b));
}

constexpr int digits_of_file = 6;

}  // namespace

ViewCamera view_of(const Camera& camera, double distance) {
  const RenderCamera ready = ready_camera(camera);
  ViewCamera view;
  view.position = ready.position;
  view.pivot = ready.position - ready.w * std::max(distance, 1e-6);
  view.up = unit_or(glm::dvec3(camera.up), {0, 1, 0});
  if (std::abs(glm::dot(view.up, ready.w)) > 0.99999) {
    view.up = ready.v;
  }
  view.height_angle_deg = ready.fov_y / degree;
  view.aperture = camera.aperture;
  view.focal_length = camera.focal_length;
  return view;
}

double pivot_distance(const Camera& camera, const Bounds& scene) {
  const glm::dvec3 look(camera.look);
  const double length = glm::length(look) > 0 ? glm::length(look) : 1;
  if (scene.empty()) {
    return length;
  }
  const glm::dvec3 middle = (scene.min + scene.max) * 0.5;
  const double ahead = glm::dot(middle - glm::dvec3(camera.position), unit_or(look, {0, 0, -1}));
  const double size = glm::length(scene.max - scene.min);
  return ahead > 1e-3 * size ? ahead : std::max(0.5 * size, 1e-3);
}

Camera camera_of(const ViewCamera& view, const Camera& home) {
  Camera camera = home;
  const ViewCamera at_home = view_of(home, glm::length(view.pivot - view.position));
  if (!alike(view.position, at_home.position)) {
    camera.position = rounded(view.position, digits_of_file);
  }
  if (!alike(axes_of(view).ahead, axes_of(at_home).ahead)) {
    camera.look = rounded(view.pivot - view.position, digits_of_file);
  }
  if (!alike(view.up, at_home.up)) {
    camera.up = rounded(view.up, digits_of_file);
  }
  if (std::abs(view.height_angle_deg - at_home.height_angle_deg) > 1e-5) {
    camera.height_angle_deg = rounded({view.height_angle_deg, 0, 0}, digits_of_file - 1).x;
  }
  return camera;
}

RenderCamera render_camera(const ViewCamera& view) {
  const ViewAxes axes = axes_of(view);
  RenderCamera camera;
  camera.position = view.position;
  camera.u = axes.right;
  camera.v = axes.above;
  camera.w = -axes.ahead;
  camera.fov_y = view.height_angle_deg * degree;
  camera.aperture = std::max(0.0F, view.aperture);
  camera.focal_length = std::max(0.0F, view.focal_length);
  return camera;
}

ViewAxes axes_of(const ViewCamera& view) {
  ViewAxes axes;
  axes.ahead = unit_or(view.pivot - view.position, {0, 0, -1});
  axes.right = unit_or(glm::cross(axes.ahead, view.up), {1, 0, 0});
  axes.above = glm::cross(axes.right, axes.ahead);
  return axes;
}

ViewCamera orbited(const ViewCamera& view, double right_deg, double up_deg) {
  ViewCamera result = view;
  const double distance = glm::length(view.pivot - view.position);
  result.position = view.pivot - turned_direction(view, right_deg, up_deg) * distance;
  return result;
}

ViewCamera turned(const ViewCamera& view, double right_deg, double up_deg) {
  ViewCamera result = view;
  const double distance = glm::length(view.pivot - view.position);
  result.pivot = view.position + turned_direction(view, right_deg, up_deg) * distance;
  return result;
}

ViewCamera panned(const ViewCamera& view, double right, double up) {
  const double distance = glm::length(view.pivot - view.position);
  const double height = 2 * distance * std::tan(view.height_angle_deg * degree / 2);
  return moved(view, {-right * height, -up * height, 0});
}

ViewCamera zoomed(const ViewCamera& view, double factor, const glm::dvec3& target) {
  ViewCamera result = view;
  const glm::dvec3 ahead = axes_of(view).ahead;
  const double distance = glm::length(view.pivot - view.position);
  result.position = target + (view.position - target) * factor;
  result.pivot = result.position + ahead * std::clamp(distance * factor, 1e-6, 1e12);
  return result;
}

ViewCamera moved(const ViewCamera& view, const glm::dvec3& by) {
  const ViewAxes axes = axes_of(view);
  const glm::dvec3 offset = axes.right * by.x + axes.above * by.y + axes.ahead * by.z;
  ViewCamera result = view;
  result.position += offset;
  result.pivot += offset;
  return result;
}

ViewCamera framing(const ViewCamera& view, const Bounds& box, double aspect) {
  if (box.empty()) {
    return view;
  }
  constexpr double margin = 1.1;
  const glm::dvec3 middle = (box.min + box.max) * 0.5;
  const ViewAxes axes = axes_of(view);
  const double tan_y = std::tan(view.height_angle_deg * degree / 2) / margin;
  double distance = 1e-6;
  for (int i = 0; i < 8; ++i) {
    const glm::dvec3 signs((i & 1) != 0 ? 0.5 : -0.5, (i & 2) != 0 ? 0.5 : -0.5,
                           (i & 4) != 0 ? 0.5 : -0.5);
    const glm::dvec3 corner = signs * (box.max - box.min);
    const double across = std::max(std::abs(glm::dot(corner, axes.above)) / tan_y,
                                   std::abs(glm::dot(corner, axes.right)) / (tan_y * aspect));
    distance = std::max(distance, across - glm::dot(corner, axes.ahead));
  }
  ViewCamera result = view;
  result.position = middle - axes.ahead * distance;
  result.pivot = middle;
  return result;
}

ViewCamera seen_from(const ViewCamera& view, Side side) {
  const double distance = glm::length(view.pivot - view.position);
  // A right-handed frame about `up`; that of the world if up is y.
  const glm::dvec3 ahead = unit_or(
      glm::cross(view.up, std::abs(view.up.x) < 0.9 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 0, 1)),
      {0, 0, -1});
  const glm::dvec3 right = glm::cross(ahead, view.up);
  const glm::dvec3 nearly_up = rotated(view.up, right, pole_deg);
  const glm::dvec3 nearly_down = rotated(-view.up, right, -pole_deg);
  const std::array<glm::dvec3, 6> away{-ahead, ahead, right, -right, nearly_up, nearly_down};
  ViewCamera result = view;
  result.position = view.pivot + away[static_cast<std::size_t>(side)] * distance;
  return result;
}

}  // namespace scenefile::viewer
