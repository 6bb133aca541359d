// Performs the actions of keys and menus.

#include "scenefile/base/text.h"
#include "scenefile/io/folder.h"
#include "scenefile/viewer/collect_views.h"
#include "scenefile/viewer/copied_text.h"
#include "scenefile/viewer/playlist.h"
#include "scenefile/viewer/session.h"

#include <fmt/format.h>

#include <algorithm>

namespace scenefile::viewer {

namespace {

void frame(Session& session) {
  const Bounds& box = session.selected_box;
  const double aspect = session.picture.size.x / session.picture.size.y;
  set_camera(session, framing(session.camera, box.empty() ? session.shown->bounds : box, aspect));
}

// Makes an edit of the selected item.
void edit_selection(Session& session,
                    const std::function<Result<Edit>(const Document&, ItemId)>& edit) {
  if (const std::optional<ItemId> item = selected_item(session)) {
    make_edit(session, edit(*session.editing.document, *item));
  } else if (const std::string& refusal = session.editing.refusal; !refusal.empty()) {
    say(session, "this scene cannot be edited: " + refusal, true);
  } else {
    say(session, "nothing is selected");
  }
}

void use_view(Session& session) {
  const Document* const document = edited_document(session);
  if (document == nullptr) {
    say(session, "this scene cannot be edited: " + session.editing.refusal, true);
    return;
  }
  const Camera camera = camera_of(session.camera, session.shown->camera);
  const Result<Edit> edit = set_camera(*document, camera);
  if (edit && edit->changes.empty()) {
    say(session, scene_name(session) + " already has this camera");
    return;
  }
  session.home = session.camera;  // the view follows the camera of the scene
  make_edit(session, edit);
  if (edit) {
    say(session, "the scene has this camera now; Ctrl+S saves it");
  }
}

void edit_scene(Session& session, Action action) {
  switch (action) {
    case Action::use_view:
      use_view(session);
      break;
    case Action::undo:
      if (!undo_edit(session)) {
        say(session, "there is nothing to undo");
      }
      break;
    case Action::redo:
      if (!redo_edit(session)) {
        say(session, "there is nothing to redo");
      }
      break;
    case Action::add:
      session.adding = true;
      session.settings.outline = true;
      session.picture_only = false;
      session.keyboard_in_fields = true;
      break;
    case Action::duplicate: {
      const bool block = selected_item(session) && session.editing.part->block;
      edit_selection(session, [&](const Document& document, ItemId item) {
        return duplicate_item(document, item, viewpoint_of(session));
      });
      if (block) {
        session.editing.part->block = true;
      }
      break;
    }
    case Action::remove:
      edit_selection(session, remove_item);
      break;
    case Action::wrap:
      edit_selection(session, wrap_in_group);
      break;
    case Action::earlier:
    case Action::later:
      edit_selection(session, [&](const Document& document, ItemId item) {
        return reorder_item(document, item, action == Action::earlier ? -1 : 1);
      });
      break;
    case Action::enter_group:
      edit_selection(session, [](const Document& document, ItemId item) -> Result<Edit> {
        if (const std::optional<ItemId> group = group_to_enter(document, item)) {
          return move_into(document, item, *group);
        }
        const Result<Edit> wrapped = wrap_in_group(document, item);
        return wrapped ? input_error("no group beside it can take it; Ctrl+G makes one") : wrapped;
      });
      break;
    case Action::leave_group:
      edit_selection(session, [](const Document& document, ItemId item) -> Result<Edit> {
        const std::optional<ItemId> group = group_outside(document, item);
        return group ? move_into(document, item, *group)
                     : Result<Edit>(input_error("it is not in a group"));
      });
      break;
    case Action::save:
      save_scene(session);
      break;
    case Action::save_as:
      ask_where_to_save(session, session.path == "-" ? "scene.xml" : session.path);
      break;
    default:
      break;
  }
}

// The visible row of the outline before or after the selected one.
void select_neighbor(Session& session, int step) {
  const std::vector<std::uint32_t> rows = visible_rows(session.shown->outline, session.open_rows);
  const auto now =
      session.selected ? std::find(rows.begin(), rows.end(), *session.selected) : rows.end();
  const auto count = static_cast<std::ptrdiff_t>(rows.size());
  const std::ptrdiff_t next = now == rows.end() ? 0 : now - rows.begin() + step;
  select(session, rows[static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(next, 0, count - 1))]);
}

// Adds the view to the path of the scene's views, or removes the last one.
void change_views(Session& session, Action action) {
  const std::string path = views_file(session.path);
  const Limits& limits = session.setup.read.limits;
  const Result<std::size_t> views =
      action == Action::collect_view
          ? collect_view(path, camera_of(session.camera, session.shown->camera), limits)
          : drop_view(path, limits);
  if (!views) {
    say(session, fmt::format("cannot change the path of views: {}", views.error().text), true);
  } else if (action == Action::collect_view) {
    say(session, fmt::format("view {} is added to {}", *views, escaped(path)));
  } else {
    say(session, fmt::format("view {} is removed from {}", *views + 1, escaped(path)));
  }
}

void go_to_neighbor(Session& session, int steps) {
  const bool no_file = session.path.empty() || session.path == "-";
  const std::string path = no_file ? "" : neighbor_of(session.path, steps);
  if (path.empty() || path == session.path) {
    say(session, "there is no other scene in this folder");
    return;
  }
  session.notice.reset();  // about the previous scene
  open_scene(session, path);
}

void next_light(Session& session) {
  const std::size_t count = session.shown->opened.ready.scene.lights.size();
  const std::uint32_t next = session.only_light ? *session.only_light + 1 : 0;
  show_only_light(session, next < count ? std::optional(next) : std::nullopt);
}

bool can_compare(Session& session) {
  if (sides_of(session) == Sides()) {
    say(session,
        "there is no picture to compare with; drop one into the window, or name one: "
        "scenefile view SCENE PICTURE.png",
        true);
    return false;
  }
  return true;
}

// Shows the pictures this way, or only ours again.
void compare_by(Session& session, Action action) {
  if (can_compare(session)) {
    const CompareView view = compare_view_of(action);
    session.compare = session.compare == view ? CompareView::off : view;
  }
}

void next_sides(Session& session) {
  if (possible_sides(session).size() < 2) {
    say(session, "for this, give two pictures of the same size: --reference A.png --mine B.png");
    return;
  }
  ++session.sides;
  session.comparison.reset();
  session.compare_started = false;
}

// The first unused name: stem.png, stem-2.png, ...
std::string free_name(const std::string& stem, std::string_view extension) {
  std::string name = fmt::format("{}{}", stem, extension);
  for (int i = 2; stamp_of(name).exists; ++i) {
    name = fmt::format("{}-{}{}", stem, i, extension);
  }
  return name;
}

std::string screenshot_name(const Session& session) {
  const bool no_file = session.path.empty() || session.path == "-";
  const std::string name = no_file ? "scene" : file_name_of(session.path);
  return free_name(name.substr(0, name.rfind('.')) + "-view", ".png");
}

void set_mode(Session& session, Action action) {
  session.mode = static_cast<DrawMode>(static_cast<int>(action) - static_cast<int>(Action::shaded));
  picture_changed(session);
}

void set_text_scale(Session& session, double factor) {
  session.settings.text_scale =
      static_cast<float>(std::clamp(session.settings.text_scale * factor, 0.5, 4.0));
}

void copy(Session& session) {
  CopiedText copied = text_to_copy(session);
  if (!copied.text.empty()) {
    session.copied = std::move(copied.text);
    say(session, "copied: " + copied.what);
  }
}

void escape(Session& session) {
  if (session.question) {
    answer_question(session, session.question->answers.size() - 1);
  } else if (session.palette) {
    session.palette = false;
  } else if (session.editing.progress) {
    cancel_edit(session);
    session.pointer.drag = Drag::none;
  } else if (session.keyboard_in_fields) {
    session.keyboard_in_fields = false;
  } else if (session.help) {
    session.help = false;
  } else if (session.start.open) {
    close_start_panel(session);
  } else if (session.full_screen) {
    session.full_screen = false;
  } else if (session.explaining) {
    session.explaining = false;
    read_pixel(session, std::nullopt);
  } else if (session.zoom > 1) {
    zoom_picture(session, 0, session.looked_at);
  } else {
    select(session, std::nullopt);
  }
}

bool needs_scene(Action action) {
  return action <= Action::save_as && action != Action::toggle_textures &&
         action != Action::toggle_shadows;
}

void perform_on_scene(Session& session, Action action, const KeyPress& key) {
  const bool other = key.shift;
  switch (action) {
    case Action::scene_camera:
      set_camera(session, session.home);
      break;
    case Action::frame:
      frame(session);
      break;
    case Action::side_front:
      set_camera(session, seen_from(session.camera, other ? Side::back : Side::front));
      break;
    case Action::side_right:
      set_camera(session, seen_from(session.camera, other ? Side::left : Side::right));
      break;
    case Action::side_top:
      set_camera(session, seen_from(session.camera, other ? Side::bottom : Side::top));
      break;
    case Action::collect_view:
    case Action::drop_view:
      change_views(session, action);
      break;
    case Action::next_light:
      next_light(session);
      break;
    case Action::all_lights:
      show_only_light(session, std::nullopt);
      break;
    case Action::hide_selected:
      if (session.selected) {
        toggle_hidden(session, *session.selected);
      }
      break;
    case Action::handles:
      session.handles = static_cast<Handles>((static_cast<int>(session.handles) + 1) % 4);
      break;
    case Action::row_above:
      select_neighbor(session, -1);
      break;
    case Action::row_below:
      select_neighbor(session, 1);
      break;
    case Action::edit_fields:
      session.keyboard_in_fields = session.selected.has_value();
      break;
    default:
      if (action >= Action::shaded && action <= Action::bounding_boxes) {
        set_mode(session, action);
      } else {
        edit_scene(session, action);
      }
      break;
  }
}

void perform_on_picture(Session& session, Action action) {
  Settings& settings = session.settings;
  switch (action) {
    case Action::toggle_textures:
      settings.textures = !settings.textures;
      forget_cause(session);
      picture_changed(session);
      break;
    case Action::toggle_shadows:
      settings.shadows = !settings.shadows;
      forget_cause(session);
      picture_changed(session);
      break;
    case Action::show_all:
      session.hidden.clear();
      picture_changed(session);
      break;
    case Action::trace:
      settings.ray_tracing = !settings.ray_tracing;
      picture_changed(session);
      break;
    case Action::realtime:
      session.realtime = !session.realtime;
      forget_cause(session);
      picture_changed(session);
      break;
    case Action::side_by_side:
    case Action::split:
    case Action::flicker:
    case Action::other:
    case Action::difference:
    case Action::flip:
      compare_by(session, action);
      break;
    case Action::next_sides:
      next_sides(session);
      break;
    case Action::exchange_roles:
      if (can_compare(session)) {
        exchange_roles(session);
      }
      break;
    case Action::zoom_in:
    case Action::zoom_out:
      zoom_picture(session, action == Action::zoom_in ? 1.5 : 1 / 1.5, session.looked_at);
      break;
    case Action::zoom_all:
      zoom_picture(session, 0, session.looked_at);
      break;
    case Action::look_left:
    case Action::look_right:
      look_beside(session, {action == Action::look_left ? -1 : 1, 0});
      break;
    case Action::look_up:
    case Action::look_down:
      look_beside(session, {0, action == Action::look_up ? -1 : 1});
      break;
    case Action::magnifier:
      session.magnifier = !session.magnifier;
      break;
    case Action::linear_values:
      settings.linear_values = !settings.linear_values;
      break;
    case Action::correct:
      correct_text(session);
      break;
    case Action::reload:
      if (!session.path.empty()) {
        open_scene(session, session.path);
      }
      break;
    case Action::new_scene:
      new_scene(session, free_name("scene", ".xml"), true);
      break;
    case Action::open:
      if (session.start.open) {
        close_start_panel(session);
      } else {
        open_start_panel(session);
      }
      break;
    case Action::next_scene:
      go_to_neighbor(session, 1);
      break;
    case Action::previous_scene:
      go_to_neighbor(session, -1);
      break;
    default:
      break;
  }
}

void perform_on_window(Session& session, Action action) {
  Settings& settings = session.settings;
  switch (action) {
    case Action::screenshot:
      session.screenshot = screenshot_name(session);
      break;
    case Action::copy:
      copy(session);
      break;
    case Action::panels:
      session.picture_only = !session.picture_only;
      session.keyboard_in_fields = false;
      break;
    case Action::outline:
      settings.outline = !settings.outline;
      break;
    case Action::messages:
      settings.messages = !settings.messages;
      break;
    case Action::statistics:
      settings.statistics = !settings.statistics;
      break;
    case Action::axes:
      settings.axes = !settings.axes;
      break;
    case Action::larger_text:
      set_text_scale(session, 1.1);
      break;
    case Action::smaller_text:
      set_text_scale(session, 1 / 1.1);
      break;
    case Action::full_screen:
      session.full_screen = !session.full_screen;
      break;
    case Action::explain:
      session.explaining = !session.explaining;
      if (!session.explaining) {
        read_pixel(session, std::nullopt);
      }
      break;
    case Action::palette:
      session.palette = !session.palette;
      break;
    case Action::help:
      session.help = !session.help;
      break;
    case Action::escape:
      escape(session);
      break;
    case Action::quit:
      before_losing_edits(session, [](Session& s) { s.quit = true; });
      break;
    default:
      break;
  }
}

}  // namespace

CompareView compare_view_of(Action action) {
  switch (action) {
    case Action::side_by_side:
      return CompareView::side_by_side;
    case Action::split:
      return CompareView::split;
    case Action::flicker:
      return CompareView::flicker;
    case Action::other:
      return CompareView::other;
    case Action::difference:
      return CompareView::difference;
    case Action::flip:
      return CompareView::flip;
    default:
      return CompareView::off;
  }
}

void perform(Session& session, Action action, const KeyPress& key) {
  if (needs_scene(action)) {
    if (session.shown != nullptr) {
      perform_on_scene(session, action, key);
    }
  } else if (action < Action::screenshot) {
    perform_on_picture(session, action);
  } else {
    perform_on_window(session, action);
  }
}

}  // namespace scenefile::viewer
