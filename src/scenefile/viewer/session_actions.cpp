// Performs the actions of keys and menus.

#include "scenefile/base/text.h"
#include "scenefile/io/folder.h"
#include "scenefile/viewer/collect_views.h"
#include "scenefile/viewer/playlist.h"
#include "scenefile/viewer/save_view.h"
#include "scenefile/viewer/selection_values.h"
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

void save(Session& session) {
  if (session.shown->opened.path != session.path) {
    say(session, fmt::format("cannot save the view: the picture is not of {}", scene_name(session)),
        true);
    return;
  }
  const Camera camera = camera_of(session.camera, session.shown->camera);
  Result<std::string> saved =
      save_view(session.path, session.known_text, camera, session.setup.read);
  const std::string name = scene_name(session);
  if (!saved) {
    say(session, fmt::format("cannot save the view: {}", saved.error().text), true);
  } else if (*saved == session.known_text) {
    say(session, fmt::format("{} already has this view", name));
  } else {
    session.saved_over = {session.path, std::move(session.known_text), session.home};
    session.known_text = *std::move(saved);
    session.home = session.camera;
    say(session, fmt::format("the view is saved: the camera of {}", name));
  }
}

void undo_save(Session& session) {
  if (!session.saved_over || session.saved_over->path != session.path) {
    say(session, "no view has been saved to this scene");
    return;
  }
  Result<std::string> restored =
      restore_text(session.path, session.known_text, session.saved_over->text, session.setup.read);
  if (!restored) {
    say(session, fmt::format("cannot undo the save: {}", restored.error().text), true);
    return;
  }
  session.known_text = *std::move(restored);
  session.home = session.saved_over->home;
  session.saved_over.reset();
  say(session, fmt::format("undone: {} has its old camera", scene_name(session)));
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

// Switches the split view on or off.
void split(Session& session) {
  if (session.reference->empty()) {
    say(session,
        "there is no reference; drop a picture into the window, or name one: "
        "scenefile view SCENE REFERENCE.png",
        true);
    return;
  }
  session.compare = session.compare == CompareView::split ? CompareView::off : CompareView::split;
}

// Cycles through the views of the difference.
void difference(Session& session) {
  if (session.reference->empty()) {
    split(session);
    return;
  }
  switch (session.compare) {
    case CompareView::off:
    case CompareView::split:
      session.compare = CompareView::difference;
      break;
    case CompareView::difference:
      session.compare = CompareView::flip;
      break;
    case CompareView::flip:
      session.compare = CompareView::reference;
      break;
    case CompareView::reference:
      session.compare = CompareView::off;
      break;
  }
}

// The first unused name: chess-view.png, chess-view-2.png, ...
std::string free_name(const Session& session) {
  const bool no_file = session.path.empty() || session.path == "-";
  std::string stem = no_file ? "scene" : file_name_of(session.path);
  stem = stem.substr(0, stem.rfind('.'));
  for (int i = 1;; ++i) {
    const std::string name = i == 1 ? stem + "-view.png" : fmt::format("{}-view-{}.png", stem, i);
    if (!stamp_of(name).exists) {
      return name;
    }
  }
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
  if (session.help) {
    session.help = false;
  } else if (session.start.open) {
    close_start_panel(session);
  } else if (session.full_screen) {
    session.full_screen = false;
  } else if (session.readout.at) {
    read_pixel(session, std::nullopt);
  } else {
    select(session, std::nullopt);
  }
}

bool needs_scene(Action action) {
  return action <= Action::hide_selected && action != Action::toggle_textures &&
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
    case Action::save_view:
      save(session);
      break;
    case Action::undo_save:
      undo_save(session);
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
    default:
      set_mode(session, action);
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
    case Action::split:
      split(session);
      break;
    case Action::difference:
      difference(session);
      break;
    case Action::reload:
      if (!session.path.empty()) {
        open_scene(session, session.path);
      }
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
      session.screenshot = free_name(session);
      break;
    case Action::copy:
      copy(session);
      break;
    case Action::panels:
      session.picture_only = !session.picture_only;
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
    case Action::help:
      session.help = !session.help;
      break;
    case Action::escape:
      escape(session);
      break;
    case Action::quit:
      session.quit = true;
      break;
    default:
      break;
  }
}

}  // namespace

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
