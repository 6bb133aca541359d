#include "scenefile/view/framing.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace scenefile {

namespace {

glm::dvec3 center(const WorldObject& object) {
  return 0.5 * (glm::dvec3(object.box_min) + glm::dvec3(object.box_max));
}

double radius(const WorldObject& object) {
  return 0.5 * glm::length(glm::dvec3(object.box_max) - glm::dvec3(object.box_min));
}

double distance_to_box(const glm::dvec3& p, const WorldObject& object) {
  const glm::dvec3 low = glm::dvec3(object.box_min) - p;
  const glm::dvec3 high = p - glm::dvec3(object.box_max);
  return glm::length(glm::max(glm::max(low, high), glm::dvec3(0)));
}

// The ratio of the distance to the depth at the corners of the picture.
double obliquity(const Frame& frame) {
  return std::sqrt(1 + frame.tan_x * frame.tan_x + frame.tan_y * frame.tan_y);
}

}  // namespace

Frame frame_of(const RenderCamera& camera, int width, int height,
               const std::vector<WorldObject>& objects) {
  Frame frame{camera, 1, std::tan(camera.fov_y / 2), height, 0, 0, false};
  frame.tan_x = frame.tan_y * width / height;
  double nearest = std::numeric_limits<double>::infinity();
  for (const WorldObject& object : objects) {
    const double depth = -glm::dot(center(object) - camera.position, camera.w);
    frame.far = std::max(frame.far, depth + radius(object));
    if (depth + radius(object) > 0 && may_be_seen(frame, object)) {
      nearest = std::min(nearest, distance_to_box(camera.position, object));
    }
  }
  // Depth is smaller than distance in the corners of the picture. A 24-bit depth buffer needs near
  // to be not much smaller than far.
  frame.far = std::max(frame.far * 1.001, 1e-6);
  frame.near = std::clamp(0.99 * nearest / obliquity(frame), 1e-4 * frame.far, 0.5 * frame.far);
  return frame;
}

glm::mat4 clip_from_world(const Frame& frame) {
  const RenderCamera& c = frame.camera;
  const double n = frame.near;
  const double f = frame.far;
  const double scale = (f + n) / (f - n);
  const glm::dvec3 x = c.u / frame.tan_x;
  const glm::dvec3 y = c.v / frame.tan_y;
  if (frame.parallel) {
    const glm::dvec3 along = -2 / (f - n) * c.w;
    return {glm::vec4(x.x, y.x, along.x, 0), glm::vec4(x.y, y.y, along.y, 0),
            glm::vec4(x.z, y.z, along.z, 0), glm::vec4(0, 0, -(f + n) / (f - n), 1)};
  }
  const glm::dvec3 z = -scale * c.w;
  const glm::dvec3 w = -c.w;
  return {glm::vec4(x.x, y.x, z.x, w.x), glm::vec4(x.y, y.y, z.y, w.y),
          glm::vec4(x.z, y.z, z.z, w.z), glm::vec4(0, 0, -2 * f * n / (f - n), 0)};
}

bool may_be_seen(const Frame& frame, const WorldObject& object) {
  const glm::dvec3 from_eye = center(object) - frame.camera.position;
  const double r = radius(object);
  const double depth = -glm::dot(from_eye, frame.camera.w);
  if (frame.parallel) {
    return true;
  }
  if (depth + r <= 0) {
    return false;
  }
  const auto within = [&](double across, double tan) {
    return std::abs(across) - tan * depth <= r * std::sqrt(1 + tan * tan);
  };
  return within(glm::dot(from_eye, frame.camera.u), frame.tan_x) &&
         within(glm::dot(from_eye, frame.camera.v), frame.tan_y);
}

bool is_behind_near(const Frame& frame, const WorldObject& object) {
  if (frame.parallel) {
    return true;
  }
  const double corner = frame.near * obliquity(frame);
  return distance_to_box(frame.camera.position, object) > corner;
}

double radius_in_pixels(const Frame& frame, const WorldObject& object) {
  const double distance = frame.parallel ? 1 : distance_to_box(frame.camera.position, object);
  return radius(object) / distance * frame.height / (2 * frame.tan_y);
}

int segments_for(double radius_in_pixels) {
  using std::numbers::pi;
  const double segments = pi * std::sqrt(5 * radius_in_pixels);
  return static_cast<int>(std::clamp(segments, 3.0, 1024.0));
}

int wires_for(double radius_in_pixels) {
  using std::numbers::pi;
  constexpr double gap = 12;  // pixels between lines
  return static_cast<int>(std::clamp(2 * pi * radius_in_pixels / gap, 6.0, 28.0));
}

}  // namespace scenefile
