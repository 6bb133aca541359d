// Mouse input.

#include "scenefile/viewer/session.h"

#include <algorithm>
#include <cmath>

namespace scenefile::viewer {

namespace {

constexpr double degrees_per_height = 180;  // for dragging over the height of the picture
constexpr double click_slack = 4;           // pixels
constexpr double split_slack = 8;

bool near_split(const Session& session, const glm::dvec2& at) {
  const Box& box = session.picture;
  return session.compare == CompareView::split && is_comparable(session) && at.y >= box.at.y &&
         at.y < box.at.y + box.size.y &&
         std::abs(at.x - (box.at.x + session.split * box.size.x)) <= split_slack;
}

std::optional<Pick> pick_under(const Session& session, const Ray& ray) {
  std::optional<PickPlanes> planes;
  if (session.realtime) {
    planes = {-render_camera(session.camera).w, session.realtime_panel.near,
              session.realtime_panel.far};
  }
  return session.shown->picker->pick(ray, session.hidden, planes);
}

// The same place in our picture, for one in the picture beside it.
glm::dvec2 place_in_ours(const Session& session, const glm::dvec2& at) {
  return session.beside.holds(at) ? at + session.picture.at - session.beside.at : at;
}

// The point of the scene under the pointer, or one at the pivot's distance.
glm::dvec3 point_under(const Session& session) {
  const Ray ray = ray_in_window(session, place_in_ours(session, session.pointer.at));
  if (const std::optional<Pick> pick = pick_under(session, ray)) {
    return pick->point;
  }
  return ray.origin + ray.direction * glm::length(session.camera.pivot - session.camera.position);
}

// Selects the object under the pointer, and reads its pixel.
void select_under(Session& session) {
  const SceneOnShow& scene = *session.shown;
  const Ray ray = ray_in_window(session, place_in_ours(session, session.pointer.at));
  const std::optional<Pick> pick = pick_under(session, ray);
  if (session.explaining || session.pointer.explains) {
    read_pixel(session, place_in_picture(session, session.pointer.at));
  }
  if (!pick || pick->source >= scene.outline.row_of_source.size()) {
    select(session, std::nullopt);
    return;
  }
  const std::uint32_t row = scene.outline.row_of_source[pick->source];
  select(session, row != no_index ? std::optional(row) : std::nullopt, pick->instances);
}

Drag drag_of(Session& session, int button, const KeyPress& with) {
  if (button == 0 && near_split(session, session.pointer.at)) {
    return Drag::split;
  }
  if (button == 0 && grasp_handle(session)) {
    return Drag::handle;
  }
  if (session.zoom > 1) {
    return Drag::scroll;
  }
  switch (button) {
    case 0:
      if (uses_assignment_keys(session)) {
        return Drag::look;
      }
      return with.shift ? Drag::pan : with.control ? Drag::look : Drag::orbit;
    case 1:
      return Drag::zoom;
    default:
      return Drag::pan;
  }
}

void drag_by(Session& session, const glm::dvec2& by) {
  const glm::dvec2 share = by / session.picture.size.y;
  const glm::dvec2 degrees = share * degrees_per_height;
  switch (session.pointer.drag) {
    case Drag::none:
      break;
    case Drag::orbit:
      set_camera(session, orbited(session.camera, degrees.x, -degrees.y));
      break;
    case Drag::look:
      set_camera(session, turned(session.camera, -degrees.x / 2, degrees.y / 2));
      break;
    case Drag::pan:
      set_camera(session, panned(session.camera, share.x, -share.y));
      break;
    case Drag::zoom:
      set_camera(session, zoomed(session.camera, std::exp(3 * share.y), session.pointer.grasped));
      break;
    case Drag::scroll:
      scroll_picture(session, -by / session.picture.size / session.zoom);
      break;
    case Drag::split:
      session.split = std::clamp(
          (session.pointer.at.x - session.picture.at.x) / session.picture.size.x, 0.0, 1.0);
      break;
    case Drag::handle:
      drag_handle(session, session.fast);
      break;
  }
}

}  // namespace

bool key_pressed(Session& session, const KeyPress& key) {
  session.fast = key.shift || key.name == "Shift";
  if (session.question) {
    // The answers are numbered. A digit alone may have been meant for a field.
    const std::size_t answer = key.name == "Escape" ? session.question->answers.size() - 1
                               : key.control && key.name.size() == 1
                                   ? static_cast<std::size_t>(key.name[0] - '1')
                                   : session.question->answers.size();
    if (answer < session.question->answers.size()) {
      answer_question(session, answer);
    }
    return true;
  }
  if (uses_assignment_keys(session) ? is_assignment_key(key) : is_flying_key(key)) {
    session.held.insert(key.name);
    return true;
  }
  if (const ActionRow* const row = action_of(key); row != nullptr) {
    perform(session, row->action);
    return true;
  }
  return false;
}

void key_released(Session& session, const std::string& name) {
  if (name == "Shift") {
    session.fast = false;
  }
  session.held.erase(name);
}

void pointer_pressed(Session& session, int button, const KeyPress& with) {
  Pointer& pointer = session.pointer;
  if (session.shown == nullptr || pointer.drag != Drag::none || session.question) {
    return;
  }
  pointer.drag = drag_of(session, button, with);
  pointer.pressed_at = pointer.at;
  pointer.explains = with.alt;
  pointer.moved = false;
  if (pointer.drag == Drag::zoom) {
    pointer.grasped = point_under(session);
  }
}

void pointer_moved(Session& session, const glm::dvec2& to) {
  Pointer& pointer = session.pointer;
  const glm::dvec2 by = to - pointer.at;
  if (pointer.drag != Drag::none && !pointer.moved) {
    // Small movements still count as a click; a drag starts where the button was pressed.
    if (glm::length(to - pointer.pressed_at) < click_slack && pointer.drag != Drag::split) {
      return;
    }
    pointer.moved = true;
  }
  pointer.at = to;
  if (session.picture.holds(place_in_ours(session, to))) {
    session.looked_at = place_in_picture(session, to);
  }
  if (pointer.drag != Drag::none) {
    drag_by(session, by);
  }
}

void pointer_released(Session& session) {
  Pointer& pointer = session.pointer;
  const bool click = (pointer.drag == Drag::orbit || pointer.drag == Drag::look ||
                      pointer.drag == Drag::scroll || pointer.drag == Drag::handle) &&
                     !pointer.moved;
  if (pointer.drag == Drag::handle) {
    finish_edit(session);
  }
  pointer.drag = Drag::none;
  if (click && session.picture.holds(place_in_ours(session, pointer.at))) {
    select_under(session);
  }
}

void wheel_turned(Session& session, double steps, bool into_picture) {
  constexpr double step = 0.88;
  if (session.shown == nullptr) {
    return;
  }
  if (into_picture || session.zoom > 1) {
    zoom_picture(session, std::pow(step, -steps), place_in_picture(session, session.pointer.at));
  } else {
    set_camera(session, zoomed(session.camera, std::pow(step, steps), point_under(session)));
  }
}

}  // namespace scenefile::viewer
