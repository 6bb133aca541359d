#include "scenefile/mistakes/hypothesis_list.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <set>
#include <utility>

namespace scenefile {

using glm::dvec3;
using std::numbers::pi;

namespace {

void edit_camera(HypothesisList& list, std::string_view what,
                 std::function<void(RenderCamera&)> change) {
  list.add(
      Cause::camera, what, [change = std::move(change)](Trial& t) { change(t.scene.camera); },
      Stage::camera);
}

// Scales the width and height of the film.
void stretch(HypothesisList& list, std::string_view what, double across, double up) {
  if (std::isfinite(across) && std::isfinite(up)) {
    edit_camera(list, what, [=](RenderCamera& c) {
      c.u *= across;
      c.v *= up;
    });
  }
}

}  // namespace

std::span<const std::pair<const char*, PixelFilter>> pixel_filters() {
  static const std::array<std::pair<const char*, PixelFilter>, 6> filters{
      {{"3 by 3 pixels", {{1, 1, 1}, 1}},
       {"5 by 5 pixels", {{1, 1, 1, 1, 1}, 2}},
       {"2 by 2 pixels, to the right and down", {{1, 1}, 0}},
       {"2 by 2 pixels, to the left and up", {{1, 1}, 1}},
       {"3 by 3 pixels, weighted", {{1, 2, 1}, 1}},
       {"5 by 5 pixels, weighted", {{1, 4, 6, 4, 1}, 2}}}};
  return filters;
}

std::string blurred_by(std::string_view size) {
  return fmt::format("the picture is blurred: each pixel is the mean of {}", size);
}

std::string words_of_samples(int side) {
  return fmt::format("pixels are means of {} by {} samples, unlike the reference's", side, side);
}

void add_camera(HypothesisList& list) {
  const double aspect = static_cast<double>(list.width) / list.height;
  const double h = list.scene.camera.fov_y;
  const double right = std::tan(h / 2);
  const double degrees = h * 180 / pi;
  if (std::abs(aspect - 1) > 0.01) {
    stretch(list, "the width angle is computed as aspect times the height angle",
            std::tan(aspect * h / 2) / (aspect * right), 1);
    stretch(list, "the aspect ratio is ignored: width and height are treated as equal", 1 / aspect,
            1);
    stretch(list, "the height angle is used as the width angle", 1 / aspect, 1 / aspect);
    stretch(list, "the aspect ratio is inverted (height by width)", 1 / (aspect * aspect), 1);
    stretch(list, "the height is divided by the aspect ratio, and the width multiplied", 1,
            1 / aspect);
    stretch(list, "the aspect ratio is applied to the height, not to the width", 1 / aspect,
            aspect);
    stretch(list, "the film is as high as it is wide", 1, aspect);
    stretch(list, "the aspect ratio is applied twice", aspect, 1);
    stretch(list, "the height angle is divided by the aspect ratio, and used as the width angle",
            1 / aspect, std::tan(h / aspect / 2) / right);
  }
  stretch(list, "the full field of view is used as the half angle", std::tan(h) / right,
          std::tan(h) / right);
  stretch(list, "a quarter of the field of view is used as the half angle", std::tan(h / 4) / right,
          std::tan(h / 4) / right);
  stretch(list, "the field of view in degrees is passed to a function that takes radians",
          std::tan(degrees / 2) / right, std::tan(degrees / 2) / right);
  stretch(list,
          "the field of view in degrees is passed to a function that takes radians, and not halved",
          std::tan(degrees) / right, std::tan(degrees) / right);
  stretch(list, "the angle itself is used instead of its tangent", h / 2 / right, h / 2 / right);
  stretch(list, "the sine of the angle is used instead of its tangent", std::sin(h / 2) / right,
          std::sin(h / 2) / right);
  stretch(list, "the film is half as large as it should be", 0.5, 0.5);
  stretch(list, "the film is twice as large as it should be", 2, 2);
  stretch(list, "the field of view is ignored: 90 degrees", 1 / right, 1 / right);
  stretch(list, "the field of view is ignored: 45 degrees", std::tan(pi / 8) / right,
          std::tan(pi / 8) / right);
  stretch(list, "the field of view is ignored: 60 degrees", std::tan(pi / 6) / right,
          std::tan(pi / 6) / right);
  stretch(list, "pixel positions are divided by width - 1 and height - 1",
          list.width / (list.width - 1.0), list.height / (list.height - 1.0));
  list.items.back().cause = Cause::half_pixel_shift;
  for (const bool down : {false, true}) {
    edit_camera(list,
                down ? "pixel positions are from 0 to 1, not from -1 to 1, with y down"
                     : "pixel positions are from 0 to 1, not from -1 to 1",
                [=](RenderCamera& c) {
                  c.u *= 0.5;
                  c.v *= down ? -0.5 : 0.5;
                  c.w -= right * (aspect * c.u + (down ? -1.0 : 1.0) * c.v);
                });
  }
  edit_camera(list, "right and up of the camera are exchanged",
              [](RenderCamera& c) { std::swap(c.u, c.v); });
  edit_camera(list, "the camera looks backward", [](RenderCamera& c) { c.w = -c.w; });
  edit_camera(list, "the camera looks backward (turned around)", [](RenderCamera& c) {
    c.w = -c.w;
    c.u = -c.u;
  });
  edit_camera(list, "the camera is at the world's origin",
              [](RenderCamera& c) { c.position = dvec3(0); });
  edit_camera(list, "the camera's position is negated",
              [](RenderCamera& c) { c.position = -c.position; });
  edit_camera(list, "the camera's matrix is transposed: it maps to the camera's space",
              [](RenderCamera& c) {
                const glm::dmat3 axes = glm::transpose(glm::dmat3(c.u, c.v, c.w));
                c.u = axes[0];
                c.v = axes[1];
                c.w = axes[2];
              });
  edit_camera(list, "the view matrix is used instead of its inverse", [](RenderCamera& c) {
    const glm::dmat3 axes = glm::transpose(glm::dmat3(c.u, c.v, c.w));
    c.position = -(axes * c.position);
    c.u = axes[0];
    c.v = axes[1];
    c.w = axes[2];
  });
  edit_camera(list, "directions of camera rays are translated, like points (w = 1)",
              [](RenderCamera& c) { c.w -= c.position; });
  edit_camera(list, "the camera ignores the up vector: up is the world's y", [](RenderCamera& c) {
    const dvec3 u = glm::cross(dvec3(0, 1, 0), c.w);
    if (glm::length(u) > 1e-6) {
      c.u = glm::normalize(u);
      c.v = glm::cross(c.w, c.u);
    }
  });
  edit_camera(list, "the camera's axes are the world axes", [](RenderCamera& c) {
    c.u = {1, 0, 0};
    c.v = {0, 1, 0};
    c.w = {0, 0, 1};
  });
  edit_camera(
      list, "the camera looks at the world's origin, not along its direction", [](RenderCamera& c) {
        const dvec3 w = c.position;
        if (glm::length(w) > 1e-6 && glm::length(glm::cross(c.v, glm::normalize(w))) > 1e-6) {
          c.w = glm::normalize(w);
          c.u = glm::normalize(glm::cross(c.v, c.w));
          c.v = glm::cross(c.w, c.u);
        }
      });
  std::set<double> distances{1, 2, 3, 5, 10, glm::length(list.scene.camera.position)};
  distances.erase(0);
  for (const double distance : distances) {
    list.add(
        Cause::camera,
        fmt::format("camera rays are parallel: there is no perspective, and all is as large as "
                    "at a distance of {:.3g}",
                    distance),
        [distance](Trial& t) { t.mistakes.orthographic = distance; }, Stage::camera);
  }
  if (list.view.written != nullptr && list.view.written->camera) {
    const Camera& written = *list.view.written->camera;
    const dvec3 up(written.up);
    const dvec3 look(written.look);
    if (glm::length(up) > 0 && glm::length(look) > 0) {
      const auto first = static_cast<std::ptrdiff_t>(list.items.size());
      edit_camera(list, "the up vector is not made perpendicular to the view",
                  [up](RenderCamera& c) { c.v = glm::normalize(up); });
      edit_camera(list, "up of the camera is not normalized after it is made perpendicular",
                  [up](RenderCamera& c) {
                    c.v = glm::normalize(up) - glm::dot(glm::normalize(up), c.w) * c.w;
                  });
      edit_camera(list, "neither right nor up of the camera is normalized",
                  [up](RenderCamera& c) { c.u = glm::cross(-c.w, glm::normalize(up)); });
      edit_camera(list, "up is not made perpendicular to the view, and right is not normalized",
                  [up](RenderCamera& c) {
                    c.v = glm::normalize(up);
                    c.u = glm::cross(c.v, c.w);
                  });
      edit_camera(list, "the up vector is neither normalized nor made perpendicular to the view",
                  [up](RenderCamera& c) {
                    c.v = up;
                    c.u = glm::cross(up, c.w);
                  });
      edit_camera(list, "the camera's right axis is not normalized, and up is computed from it",
                  [up](RenderCamera& c) {
                    c.u = glm::cross(-c.w, glm::normalize(up));
                    c.v = glm::cross(c.w, c.u);
                  });
      const auto aim = [](RenderCamera& c, const dvec3& direction, const dvec3& upward) {
        const dvec3 w = -direction;
        if (glm::length(w) > 1e-6 && glm::length(glm::cross(upward, w)) > 1e-6) {
          c.w = glm::normalize(w);
          c.u = glm::normalize(glm::cross(upward, c.w));
          c.v = glm::cross(c.w, c.u);
        }
      };
      edit_camera(list, "the look direction is used as a point to look at",
                  [=](RenderCamera& c) { aim(c, look - c.position, up); });
      edit_camera(list, "the point to look at is used as a direction",
                  [=](RenderCamera& c) { aim(c, look + c.position, up); });
      edit_camera(list, "the look direction is not normalized",
                  [=](RenderCamera& c) { c.w = -look; });
      edit_camera(
          list, "the look direction is not normalized, and up is computed from it",
          [=](RenderCamera& c) {
            c.w = -look;
            c.v = glm::normalize(glm::normalize(up) + glm::dot(glm::normalize(up), look) * -look);
          });
      std::for_each(list.items.begin() + first, list.items.end(),
                    [](Hypothesis& h) { h.axes = true; });
    }
  }
}

void add_shifts(HypothesisList& list) {
  static constexpr std::array<std::pair<glm::dvec2, const char*>, 8> places{
      {{{-0.5, -0.5}, "upper left corners"},
       {{0.5, 0.5}, "lower right corners"},
       {{-0.5, 0.5}, "lower left corners"},
       {{0.5, -0.5}, "upper right corners"},
       {{-0.5, 0}, "left edges"},
       {{0.5, 0}, "right edges"},
       {{0, -0.5}, "upper edges"},
       {{0, 0.5}, "lower edges"}}};
  for (const auto& [shift, where] : places) {
    list.add(
        Cause::half_pixel_shift,
        fmt::format("rays go through the {} of pixels, not their centers", where),
        [by = shift](Trial& t) { t.shift = by; }, Stage::camera);
  }
  static constexpr std::array<std::pair<glm::dvec2, const char*>, 8> neighbors{
      {{{1, 0}, "left"},
       {{-1, 0}, "right"},
       {{0, 1}, "up"},
       {{0, -1}, "down"},
       {{1, 1}, "left and up"},
       {{-1, 1}, "right and up"},
       {{1, -1}, "left and down"},
       {{-1, -1}, "right and down"}}};
  for (const auto& [shift, where] : neighbors) {
    list.add(
        Cause::half_pixel_shift,
        fmt::format("the picture is shifted by one pixel ({}): rows or columns are counted from 1",
                    where),
        [by = shift](Trial& t) { t.shift = by; }, Stage::camera);
  }
  for (const auto& [size, filter] : pixel_filters()) {
    list.add(
        Cause::samples, blurred_by(size), [filter = filter](Trial& t) { t.filter = filter; },
        Stage::hits);
  }
  for (const int samples : {2, 3}) {
    list.add(
        Cause::samples, words_of_samples(samples), [samples](Trial& t) { t.samples = samples; },
        Stage::hits);
    list.items.back().mistake = false;
  }
  for (const int side : {2, 3}) {
    for (const auto& [divisor, what] :
         {std::pair(1, "added, not averaged"), std::pair(side, "divided by the number in a row")}) {
      list.add(
          Cause::brightness, fmt::format("the {} by {} samples of pixels are {}", side, side, what),
          [side, divisor = divisor](Trial& t) {
            t.samples = side;
            t.divisor = divisor;
          },
          Stage::hits);
    }
  }
  list.add(
      Cause::samples, missed_samples,
      [](Trial& t) {
        t.samples = 2;
        t.black_if_missed = true;
      },
      Stage::hits);
}

}  // namespace scenefile
