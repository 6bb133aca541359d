#include "scenefile/viewer/handles.h"

#include "scenefile/view/helpers.h"
#include "scenefile/viewer/session.h"

#include <fmt/format.h>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>
#include <span>

namespace scenefile::viewer {

namespace {

constexpr double handle_length = 85;  // pixels of a normal-density screen
constexpr double reach = 8;           // of the pointer
constexpr double ring_share = 0.8;    // radius of rings, of the length
constexpr double pixels_for_e = 150;  // that scale by the factor e, at the middle

using Values = std::vector<std::optional<std::string>>;

const FieldView* find_field(const std::vector<FieldView>& fields, std::string_view name) {
  const auto found = std::find_if(fields.begin(), fields.end(), [&](const FieldView& field) {
    return field.name == name && field.effective;
  });
  return found == fields.end() ? nullptr : &*found;
}

glm::dvec3 vector_of(const FieldView& field) {
  glm::dvec3 v(0);
  for (std::size_t i = 0; i < 3 && i < field.parts.size(); ++i) {
    v[static_cast<int>(i)] = number_of(field.parts[i]);
  }
  return v;
}

std::string number_text(double value) {
  return fmt::format("{}", std::round(value * 1e4) / 1e4 + 0.0);  // not -0
}

Values values_of(const glm::dvec3& v) {
  return {number_text(v.x), number_text(v.y), number_text(v.z)};
}

// How large a pixel of a normal-density screen is at a place.
double pixel_size(const Session& session, const glm::dvec3& at) {
  const RenderCamera camera = render_camera(session.camera);
  const double depth = -glm::dot(at - camera.position, camera.w);
  const double height = whole_picture(session, session.picture).size.y;
  return 2 * std::max(depth, 0.0) * std::tan(camera.fov_y / 2) / height;
}

// The place on the axis that is nearest to the ray, as a distance from `at`.
double along(const Ray& ray, const glm::dvec3& at, const glm::dvec3& axis) {
  const glm::dvec3 direction = glm::normalize(ray.direction);
  const glm::dvec3 to = at - ray.origin;
  const double b = glm::dot(axis, direction);
  return (b * glm::dot(direction, to) - glm::dot(axis, to)) / std::max(1 - b * b, 1e-6);
}

// The point under a place in the window, at the distance of the handles.
glm::dvec3 point_at(const Session& session, const HandleSet& set, const glm::dvec2& place) {
  const Ray ray = ray_in_window(session, place);
  const glm::dvec3 back = render_camera(session.camera).w;
  const double slope = glm::dot(ray.direction, back);
  return ray.origin + ray.direction * (glm::dot(set.at - ray.origin, back) / slope);
}

glm::dvec2 middle_of(const Session& session, const HandleSet& set) {
  return point_in_window(session, set.at).value_or(glm::dvec2(0));
}

// World units that the handle was moved, along its axis or in the plane of the picture.
glm::dvec3 moved_by(const Session& session, const GraspedHandle& grasped) {
  const HandleSet& set = grasped.set;
  const glm::dvec2& now = session.pointer.at;
  if (grasped.number == 3) {
    return point_at(session, set, now) - point_at(session, set, grasped.pressed);
  }
  const glm::dvec3& axis = set.axes[static_cast<std::size_t>(grasped.number)];
  return axis * (along(ray_in_window(session, now), set.at, axis) -
                 along(ray_in_window(session, grasped.pressed), set.at, axis));
}

// How much farther from the middle the pointer is than where it grasped the handle.
double factor_of(const Session& session, const GraspedHandle& grasped) {
  const glm::dvec2 middle = middle_of(session, grasped.set);
  if (grasped.number == 3) {  // grasped at the middle: right or up is larger
    const glm::dvec2 by = session.pointer.at - grasped.pressed;
    return std::exp((by.x - by.y) / pixels_for_e);
  }
  const glm::dvec2 line = grasped.pressed - middle;
  const double whole = std::max(glm::dot(line, line), 1.0);
  return std::max(0.02, glm::dot(session.pointer.at - middle, line) / whole);
}

// A power of ten about as large as a pixel, so that numbers stay short.
double step_of(const Session& session, const GraspedHandle& grasped, bool steps) {
  const double step =
      std::pow(10.0, std::floor(std::log10(2 * pixel_size(session, grasped.set.at))));
  return steps ? 10 * step : step;
}

glm::dvec3 rounded(const glm::dvec3& v, double step) {
  return glm::round(v / step) * step;
}

glm::dvec3 turned(const glm::dvec3& v, const HandleSet& set, int axis, double degrees) {
  return glm::dvec3(
      glm::rotate(glm::dmat4(1), glm::radians(degrees), set.axes[static_cast<std::size_t>(axis)]) *
      glm::dvec4(v, 0));
}

Result<Edit> edit_item(const Session& session, const GraspedHandle& grasped, bool steps,
                       const Document& before) {
  const Handle& handle = *grasped.set.of_item;
  switch (grasped.set.kind) {
    case Handles::move: {
      const glm::dvec3 by =
          glm::inverse(glm::dmat3(handle.world_from_space)) * moved_by(session, grasped);
      const double size = glm::length(glm::dvec3(handle.world_from_space[0]));
      const double step = step_of(session, grasped, steps) / std::max(size, 1e-9);
      glm::dvec3 delta(0);  // exactly 0 along the other axes: they keep their numbers
      for (int i = 0; i < 3; ++i) {
        delta[i] = grasped.number == 3 || grasped.number == i ? by[i] : 0;
      }
      return move_item(before, handle, delta, std::pow(10.0, std::floor(std::log10(step) + 1e-9)));
    }
    case Handles::turn:
      return turn_item(before, handle, grasped.number, grasped.turned_deg);
    default:
      return grasped.number == 3
                 ? place_item(
                       before, handle,
                       glm::scale(handle.world_from_item, glm::dvec3(factor_of(session, grasped))))
                 : scale_item(before, handle, grasped.number, factor_of(session, grasped));
  }
}

// The direction of a light of an XML file.
Result<Edit> turn_light(const GraspedHandle& grasped, const EditInProgress& progress) {
  const std::vector<FieldView> fields = progress.before.fields(progress.item);
  const FieldView* const field = find_field(fields, "direction");
  if (field == nullptr) {
    return Edit{};
  }
  return set_values(
      progress.before, progress.item, *field,
      values_of(turned(vector_of(*field), grasped.set, grasped.number, grasped.turned_deg)));
}

// Which angle of the cone, in degrees, brings the place where its edge was grasped to the pointer.
double cone_angle(const Session& session, const GraspedHandle& grasped, SpotEdge edge,
                  double pressed_deg) {
  const RenderLight& spot = *grasped.set.spot;
  const auto in_window = [&](double degrees, double around) {
    return point_in_window(session, cone_point(spot, edge, session.shown->bounds,
                                               glm::radians(degrees), around))
        .value_or(glm::dvec2(1e9));
  };
  const auto nearest = [](const auto& distance, double from, double to, double step) {
    double best = from;
    for (int i = 0; from + i * step <= to; ++i) {
      best = distance(from + i * step) < distance(best) ? from + i * step : best;
    }
    return best;
  };
  const double around =
      nearest([&](double at) { return glm::distance(in_window(pressed_deg, at), grasped.pressed); },
              0, 2 * glm::pi<double>(), 0.02);
  const glm::dvec2 target = in_window(pressed_deg, around) + session.pointer.at - grasped.pressed;
  const auto missed = [&](double degrees) {  // of two angles, the one nearer to where it was
    return glm::distance(in_window(degrees, around), target) +
           0.01 * std::abs(degrees - pressed_deg);
  };
  const double about = nearest(missed, 0, 180, 1);
  return nearest(missed, std::max(about - 1, 0.0), std::min(about + 1, 180.0), 0.02);
}

// An edge of the cone of a spot light. The inner one follows the outer one.
Result<Edit> edit_cone(const Session& session, const GraspedHandle& grasped, bool steps,
                       const EditInProgress& progress) {
  const bool is_outer = grasped.number == 4;
  const auto degrees = [](double radians) {  // as in the file: a float has fewer digits
    return std::round(glm::degrees(radians) * 1e4) / 1e4;
  };
  const double outer = degrees(grasped.set.spot->outer_angle);
  const double inner = degrees(grasped.set.spot->inner_angle);
  const double angle = cone_angle(session, grasped, is_outer ? SpotEdge::outer : SpotEdge::inner,
                                  is_outer ? outer : inner);
  const double step = steps ? 1 : 0.1;
  const double value = std::round((is_outer ? angle : outer - angle) / step) * step;
  const std::vector<FieldView> fields = progress.before.fields(progress.item);
  const FieldView* const field = find_field(fields, is_outer ? "angle" : "penumbra");
  if (field == nullptr) {
    return Edit{};
  }
  return set_value(progress.before, progress.item, *field, 0,
                   number_text(is_outer ? std::max(value, std::max(outer - inner, step))
                                        : std::clamp(value, 0.0, outer)));
}

Result<Edit> edit_camera(const Session& session, const GraspedHandle& grasped, bool steps,
                         const Document& before) {
  Camera camera = before.scene().camera.value_or(Camera{});
  switch (grasped.set.kind) {
    case Handles::move:
      camera.position +=
          glm::vec3(rounded(moved_by(session, grasped), step_of(session, grasped, steps)));
      break;
    case Handles::turn:
      camera.look = glm::vec3(
          rounded(turned(camera.look, grasped.set, grasped.number, grasped.turned_deg), 1e-4));
      camera.up = glm::vec3(
          rounded(turned(camera.up, grasped.set, grasped.number, grasped.turned_deg), 1e-4));
      break;
    default:
      camera.height_angle_deg = static_cast<float>(std::clamp(
          std::round(camera.height_angle_deg * factor_of(session, grasped) * 10) / 10, 1.0, 175.0));
      break;
  }
  return set_camera(before, camera);
}

// The angle of a place in the window around the handles, counterclockwise.
double angle_at(const Session& session, const HandleSet& set, const glm::dvec2& at) {
  const glm::dvec2 by = at - middle_of(session, set);
  return glm::degrees(std::atan2(-by.y, by.x));
}

// Adds what the pointer has turned since the last time.
void turn_to_pointer(const Session& session, GraspedHandle& grasped) {
  const HandleSet& set = grasped.set;
  const glm::dvec3& axis = set.axes[static_cast<std::size_t>(grasped.number)];
  const double toward = glm::dot(axis, session.camera.position - set.at) < 0 ? -1 : 1;
  const double by =
      angle_at(session, set, session.pointer.at) - angle_at(session, set, grasped.last);
  grasped.turned_deg += toward * std::remainder(by, 360.0);
  grasped.last = session.pointer.at;
}

double distance_to(const std::vector<glm::dvec2>& line, const glm::dvec2& at) {
  double nearest = glm::distance(line.front(), at);
  for (std::size_t i = 1; i < line.size(); ++i) {
    const glm::dvec2 by = line[i] - line[i - 1];
    const double share =
        std::clamp(glm::dot(at - line[i - 1], by) / std::max(glm::dot(by, by), 1e-9), 0.0, 1.0);
    nearest = std::min(nearest, glm::distance(line[i - 1] + share * by, at));
  }
  return nearest;
}

// The points of a handle in world space; of a ring only the half that faces the camera.
std::vector<glm::dvec3> points_of(const Session& session, const HandleSet& set, int number,
                                  double length) {
  if (number == 3) {
    return {set.at};
  }
  const glm::dvec3& axis = set.axes[static_cast<std::size_t>(number)];
  if (set.kind != Handles::turn) {
    return {set.at + 0.2 * length * axis, set.at + length * axis};
  }
  glm::dvec3 toward = session.camera.position - set.at;
  toward -= axis * glm::dot(axis, toward);
  const glm::dvec3 side = glm::length(toward) > 0
                              ? glm::normalize(toward)
                              : set.axes[static_cast<std::size_t>((number + 1) % 3)];
  const glm::dvec3 other = glm::cross(axis, side);
  std::vector<glm::dvec3> points;
  constexpr int parts = 24;
  for (int i = 0; i <= parts; ++i) {
    const double angle = glm::pi<double>() * (static_cast<double>(i) / parts - 0.5);
    points.push_back(set.at +
                     ring_share * length * (std::cos(angle) * side + std::sin(angle) * other));
  }
  return points;
}

// Of the item, or of the copy of a template that was clicked and contains it.
std::optional<Handle> handle_of_selection(const Session& session, const Document& document,
                                          ItemId item) {
  std::optional<Handle> handle = handle_of(document, item);
  if (!handle && !session.selected_copy.empty() && shows_edited_text(session)) {
    const Outline& outline = session.shown->outline;
    const std::uint32_t row = outline.row_of_source[session.selected_copy.front()];
    const std::optional<ItemId> copy =
        row == no_index ? std::nullopt : document.item_of(outline.rows[row].location);
    handle = copy ? handle_of(document, *copy) : std::nullopt;
  }
  return handle;
}

// The handles along or around axes.
std::optional<HandleSet> axes_of(const Session& session, const Document& document, ItemId item) {
  HandleSet set{session.handles};
  set.axes = {glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0), glm::dvec3(0, 0, 1)};
  if (document[item].kind == ItemKind::camera) {
    if (session.camera == session.home) {
      return std::nullopt;  // the handles would be where the eye is
    }
    set.of_camera = true;
    set.at = document.scene().camera.value_or(Camera{}).position;
    return set;
  }
  const std::optional<Handle> handle = handle_of_selection(session, document, item);
  if (handle) {
    set.at = glm::dvec3(handle->world_from_item[3]);
  } else {
    const Bounds& box = session.shown->bounds;
    set.at = box.empty() ? glm::dvec3(0) : (box.min + box.max) * 0.5;
  }
  if (handle && (!handle->is_light || set.kind == Handles::move)) {
    set.of_item = handle;
    const glm::dmat4& space =
        set.kind == Handles::scale ? handle->world_from_item : handle->world_from_space;
    for (int i = 0; i < 3; ++i) {
      const glm::dvec3 axis(space[i]);
      if (!(glm::length(axis) > 0)) {
        return std::nullopt;
      }
      set.axes[static_cast<std::size_t>(i)] = glm::normalize(axis);
    }
    return set;
  }
  const bool turns_light = document[item].kind == ItemKind::light && document.is_xml() &&
                           set.kind == Handles::turn &&
                           find_field(document.fields(item), "direction") != nullptr;
  return turns_light ? std::optional(set) : std::nullopt;
}

// The selected light, if it is a spot light.
const RenderLight* selected_spot(const Session& session) {
  const OutlineRow* const row =
      session.selected ? &session.shown->outline.rows[*session.selected] : nullptr;
  for (const RenderLight& light : session.shown->opened.ready.scene.lights) {
    if (row != nullptr && row->kind == RowKind::light && light.source == row->source &&
        light.type == LightType::spot) {
      return &light;
    }
  }
  return nullptr;
}

}  // namespace

std::optional<HandleSet> handles_of(Session& session) {
  if (session.handles == Handles::none || session.shown == nullptr) {
    return std::nullopt;
  }
  const std::optional<ItemId> item = selected_item(session);
  if (!item) {
    return std::nullopt;
  }
  std::optional<HandleSet> set = axes_of(session, *session.editing.document, *item);
  if (const RenderLight* const spot = selected_spot(session)) {
    set = set ? set : HandleSet{.kind = Handles::none, .at = glm::dvec3(spot->position)};
    set->spot = *spot;
  }
  return set;
}

std::vector<HandleLine> handle_lines(const Session& session, const HandleSet& set) {
  std::vector<HandleLine> lines;
  const auto add = [&](int number, std::span<const glm::dvec3> points) {
    HandleLine line{number, {}};
    for (const glm::dvec3& point : points) {
      if (const std::optional<glm::dvec2> place = point_in_window(session, point)) {
        line.points.push_back(*place);
      }
    }
    if (!line.points.empty()) {
      lines.push_back(std::move(line));
    }
  };
  for (const SpotEdge edge : {SpotEdge::inner, SpotEdge::outer}) {
    const std::vector<glm::dvec3> ring =
        set.spot ? cone_ring(*set.spot, edge, session.shown->bounds) : std::vector<glm::dvec3>();
    const std::size_t quarter = ring.size() / 4;
    for (std::size_t i = 0; quarter > 0 && i < 4; ++i) {
      add(edge == SpotEdge::outer ? 4 : 5, {ring.data() + i * quarter, quarter + 1});
    }
  }
  const double length = handle_length * session.gui_scale * pixel_size(session, set.at);
  // The camera's angle has no axes; nothing turns about all three.
  const int first = set.kind == Handles::scale && set.of_camera ? 3 : 0;
  const int end = set.kind == Handles::none ? 0 : set.kind == Handles::turn ? 3 : 4;
  for (int number = first; number < end; ++number) {
    add(number, points_of(session, set, number, length));
  }
  return lines;
}

std::optional<int> handle_at(const Session& session, const HandleSet& set, const glm::dvec2& at) {
  std::optional<int> nearest;
  double distance = reach * session.gui_scale;
  for (const HandleLine& line : handle_lines(session, set)) {
    if (const double own = distance_to(line.points, at); own <= distance) {
      distance = own;
      nearest = line.number;
    }
  }
  return nearest;
}

bool grasp_handle(Session& session) {
  const std::optional<HandleSet> set = handles_of(session);
  const std::optional<int> number = set && session.compare <= CompareView::split
                                        ? handle_at(session, *set, session.pointer.at)
                                        : std::nullopt;
  if (number) {
    session.grasped = {*set, *number, session.pointer.at, session.pointer.at};
  }
  return number.has_value();
}

void drag_handle(Session& session, bool steps) {
  const std::optional<GraspedHandle> held = session.grasped;  // gone if another edit ended it
  const EditInProgress* const progress = held ? begin_edit(session, edit_by_handle) : nullptr;
  if (progress == nullptr) {
    return;
  }
  session.grasped = held;
  GraspedHandle& grasped = *session.grasped;
  const bool of_cone = grasped.number > 3;
  if (grasped.set.kind == Handles::turn && !of_cone) {
    turn_to_pointer(session, grasped);
  }
  GraspedHandle now = grasped;
  const double unit = steps ? 15 : 1;
  now.turned_deg = std::round(grasped.turned_deg / unit) * unit;
  continue_edit(session, of_cone             ? edit_cone(session, now, steps, *progress)
                         : now.set.of_camera ? edit_camera(session, now, steps, progress->before)
                         : now.set.of_item   ? edit_item(session, now, steps, progress->before)
                                             : turn_light(now, *progress));
}

}  // namespace scenefile::viewer
