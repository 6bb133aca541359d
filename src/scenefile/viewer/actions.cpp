#include "scenefile/viewer/actions.h"

#include <algorithm>
#include <array>

namespace scenefile::viewer {

namespace {

constexpr std::array action_rows{
    ActionRow{Action::scene_camera, "Home", "Camera", "the scene's own camera"},
    ActionRow{Action::frame, "F", "Camera", "frame the selection, or everything"},
    ActionRow{Action::side_front, "Ctrl+1", "Camera", "from the front (Shift: from behind)"},
    ActionRow{Action::side_right, "Ctrl+3", "Camera", "from the right (Shift: left)"},
    ActionRow{Action::side_top, "Ctrl+7", "Camera", "from above (Shift: below)"},
    ActionRow{Action::use_view, "C", "Camera", "make this view the scene's camera"},
    ActionRow{Action::collect_view, "V", "Camera", "add the view to a path for frames"},
    ActionRow{Action::drop_view, "Shift+V", "Camera", "remove the last view of the path"},
    ActionRow{Action::undo, "Ctrl+Z", "Edit", "undo the last edit"},
    ActionRow{Action::redo, "Ctrl+Shift+Z", "Edit", "redo it"},
    ActionRow{Action::add, "Insert", "Edit", "add an object, a light, or a field"},
    ActionRow{Action::duplicate, "Ctrl+D", "Edit", "duplicate the selection"},
    ActionRow{Action::wrap, "Ctrl+G", "Edit", "put the selection into a new group"},
    ActionRow{Action::earlier, "Ctrl+Up", "Edit", "move the selection up in its group"},
    ActionRow{Action::later, "Ctrl+Down", "Edit", "move it down"},
    ActionRow{Action::enter_group, "Ctrl+Right", "Edit", "move it into a group beside it"},
    ActionRow{Action::leave_group, "Ctrl+Left", "Edit", "move it out of its group"},
    ActionRow{Action::remove, "Delete", "Edit", "delete the selection"},
    ActionRow{Action::correct, "Ctrl+E", "Edit", "correct what is misspelled, if it is certain"},
    ActionRow{Action::handles, "B", "Edit", "handles: move, turn, scale, none"},
    ActionRow{Action::row_above, "Up", "Edit", "select the row above in the outline"},
    ActionRow{Action::row_below, "Down", "Edit", "select the row below"},
    ActionRow{Action::edit_fields, "Enter", "Edit", "go to the fields with the keyboard"},
    ActionRow{Action::shaded, "1", "Show", "shaded"},
    ActionRow{Action::wireframe, "2", "Show", "wireframe"},
    ActionRow{Action::normals, "3", "Show", "normals"},
    ActionRow{Action::uv, "4", "Show", "texture coordinates"},
    ActionRow{Action::depth, "5", "Show", "depth"},
    ActionRow{Action::object_id, "6", "Show", "objects, each in a color"},
    ActionRow{Action::bounding_boxes, "7", "Show", "overdraw of bounding boxes"},
    ActionRow{Action::toggle_textures, "T", "Show", "textures"},
    ActionRow{Action::toggle_shadows, "K", "Show", "shadows"},
    ActionRow{Action::next_light, "L", "Show", "one light at a time"},
    ActionRow{Action::all_lights, "Shift+L", "Show", "all lights"},
    ActionRow{Action::axes, "N", "Show", "axes, lights and the scene's camera"},
    ActionRow{Action::hide_selected, "H", "Show", "hide the selection, or show it again"},
    ActionRow{Action::show_all, "Shift+H", "Show", "show everything"},
    ActionRow{Action::trace, "R", "Picture", "ray tracing when the camera rests"},
    ActionRow{Action::realtime, "G", "Picture", "the assignment Realtime"},
    ActionRow{Action::zoom_in, "+", "Picture", "zoom in, up to the values of pixels"},
    ActionRow{Action::zoom_out, "-", "Picture", "zoom out"},
    ActionRow{Action::zoom_all, "0", "Picture", "all of the picture"},
    ActionRow{Action::look_left, "Shift+Left", "Picture", "a pixel to the left"},
    ActionRow{Action::look_right, "Shift+Right", "Picture", "a pixel to the right"},
    ActionRow{Action::look_up, "Shift+Up", "Picture", "a pixel up"},
    ActionRow{Action::look_down, "Shift+Down", "Picture", "a pixel down"},
    ActionRow{Action::magnifier, "U", "Picture", "magnifier at the pointer"},
    ActionRow{Action::linear_values, "Shift+U", "Picture", "values from 0 to 1, not to 255"},
    ActionRow{Action::explain, "Y", "Picture", "explain the pixels that are clicked"},
    ActionRow{Action::screenshot, "F12", "Picture", "screenshot of the window"},
    ActionRow{Action::split, "X", "Compare", "left and right of a line"},
    ActionRow{Action::side_by_side, "Shift+X", "Compare", "side by side"},
    ActionRow{Action::other, "Z", "Compare", "the other picture in place of the first"},
    ActionRow{Action::flicker, "Shift+Z", "Compare", "flicker: both by turns"},
    ActionRow{Action::difference, "M", "Compare", "heat map of the differences"},
    ActionRow{Action::flip, "Shift+M", "Compare", "FLIP: visible differences"},
    ActionRow{Action::next_sides, "J", "Compare", "another two of ours, reference and mine"},
    ActionRow{Action::exchange_roles, "Shift+J", "Compare", "exchange reference and mine"},
    ActionRow{Action::open, "Ctrl+O", "Scene", "open a scene: recent files, folders"},
    ActionRow{Action::new_scene, "Ctrl+N", "Scene", "start a new scene"},
    ActionRow{Action::save, "Ctrl+S", "Scene", "save the scene"},
    ActionRow{Action::save_as, "Ctrl+Shift+S", "Scene", "save it under another name"},
    ActionRow{Action::reload, "F5", "Scene", "read the file again"},
    ActionRow{Action::next_scene, "Page Down", "Scene", "the next scene in the folder"},
    ActionRow{Action::previous_scene, "Page Up", "Scene", "the previous scene in the folder"},
    ActionRow{Action::copy, "Ctrl+C", "Window", "copy pixel, selection or camera"},
    ActionRow{Action::outline, "O", "Window", "outline"},
    ActionRow{Action::messages, "P", "Window", "messages"},
    ActionRow{Action::statistics, "I", "Window", "figures"},
    ActionRow{Action::panels, "Tab", "Window", "show only the picture"},
    ActionRow{Action::larger_text, "Ctrl++", "Window", "larger text"},
    ActionRow{Action::smaller_text, "Ctrl+-", "Window", "smaller text"},
    ActionRow{Action::full_screen, "F11", "Window", "full screen"},
    ActionRow{Action::palette, "Ctrl+Shift+P", "Window", "search in all commands"},
    ActionRow{Action::help, "F1", "Window", "this help"},
    ActionRow{Action::escape, "Escape", "Window", "close a panel, or clear the selection"},
    ActionRow{Action::quit, "Ctrl+Q", "Window", "quit"},
};

constexpr std::array gesture_table{
    GestureRow{"drag", "turn the scene"},
    GestureRow{"Shift or middle drag", "move the picture"},
    GestureRow{"Ctrl + drag", "look around"},
    GestureRow{"wheel, right drag", "zoom in or out"},
    GestureRow{"Ctrl + wheel", "zoom into the picture; then drag it"},
    GestureRow{"W A S D Q E", "fly; with Shift faster"},
    GestureRow{"click", "select an object"},
    GestureRow{"Alt + click", "select, and explain the pixel"},
    GestureRow{"drag a handle", "move, turn or scale the selection"},
    GestureRow{"drop a scene or folder", "open it"},
    GestureRow{"drop a picture", "compare with it"},
};

}  // namespace

std::span<const ActionRow> actions() {
  return action_rows;
}

std::span<const GestureRow> gestures() {
  return gesture_table;
}

const ActionRow& row_of(Action action) {
  return *std::find_if(action_rows.begin(), action_rows.end(),
                       [&](const ActionRow& row) { return row.action == action; });
}

std::string key_text(const KeyPress& key) {
  std::string text(key.control ? "Ctrl+" : "");
  text.append(key.shift ? "Shift+" : "").append(key.name);
  return text;
}

KeyPress parse_key(std::string_view text) {
  KeyPress key;
  const auto take = [&](std::string_view prefix, bool& flag) {
    // "Ctrl++" means the key +.
    if (text.size() > prefix.size() && text.starts_with(prefix)) {
      flag = true;
      text.remove_prefix(prefix.size());
    }
  };
  take("Ctrl+", key.control);
  take("Shift+", key.shift);
  key.name = text;
  return key;
}

bool is_flying_key(const KeyPress& key) {
  constexpr std::array<std::string_view, 6> keys{"W", "A", "S", "D", "Q", "E"};
  return !key.control && std::find(keys.begin(), keys.end(), key.name) != keys.end();
}

bool is_assignment_key(const KeyPress& key) {
  constexpr std::array<std::string_view, 6> keys{"W", "A", "S", "D", "Space", "Control"};
  return std::find(keys.begin(), keys.end(), key.name) != keys.end();
}

const ActionRow* action_of(const KeyPress& key) {
  const auto find = [](const std::string& text) {
    const auto found = std::find_if(action_rows.begin(), action_rows.end(),
                                    [&](const ActionRow& row) { return row.key == text; });
    return found == action_rows.end() ? nullptr : &*found;
  };
  if (const ActionRow* const row = find(key_text(key)); row != nullptr) {
    return row;
  }
  if (key.name == "?") {
    return find("F1");
  }
  // With Shift, the keys for views from the front, right and top show the opposite side.
  const ActionRow* const row = find(key_text({key.name, key.control, false}));
  const bool side =
      row != nullptr && row->action >= Action::side_front && row->action <= Action::side_top;
  return side ? row : nullptr;
}

}  // namespace scenefile::viewer
