#pragma once
// What the window can do: one table, from which menus, help, search and shortcuts follow.

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace scenefile::viewer {

struct Session;

enum class Action : std::uint8_t {
  scene_camera,
  frame,
  side_front,
  side_back,
  side_right,
  side_left,
  side_top,
  side_bottom,
  use_view,
  collect_view,
  drop_view,
  shaded,
  wireframe,
  normals,
  uv,
  depth,
  object_id,
  bounding_boxes,
  toggle_textures,
  toggle_shadows,
  next_light,
  all_lights,
  hide_selected,
  undo,
  redo,
  add,
  duplicate,
  remove,
  earlier,
  later,
  enter_group,
  leave_group,
  wrap,
  handles,
  row_above,
  row_below,
  edit_fields,
  save,
  save_as,
  show_all,
  trace,
  realtime,
  side_by_side,
  split,
  flicker,
  other,
  difference,
  flip,
  next_sides,
  exchange_roles,
  zoom_in,
  zoom_out,
  zoom_all,
  look_left,
  look_right,
  look_up,
  look_down,
  magnifier,
  linear_values,
  reload,
  correct,
  open,
  new_scene,
  next_scene,
  previous_scene,
  screenshot,
  copy,
  explain,
  palette,
  panels,
  outline,
  messages,
  statistics,
  axes,
  larger_text,
  smaller_text,
  full_screen,
  help,
  escape,
  quit,
};

struct ActionRow {
  Action action;
  std::string_view key;    ///< as key_text() writes it
  std::string_view group;  ///< a heading in the help, and a menu
  std::string_view what;   ///< a few words
  void (*act)(Session&);
  /// Why it has no effect now; empty: it has one.
  std::string (*refusal)(const Session&);
  bool (*is_on)(const Session&);  ///< whether the menu marks it
};

/// In the order of the help; each key once, sorted by group. session_actions.cpp has them.
std::span<const ActionRow> actions();
const ActionRow& row_of(Action action);

/// A key with its modifiers.
struct KeyPress {
  std::string name;  ///< "A", "1", "F5", "Home", "Page Up", "?"
  bool control = false;
  bool shift = false;
  bool alt = false;  ///< only for the mouse
};

/// "Ctrl+Shift+S".
std::string key_text(const KeyPress& key);
/// The inverse of key_text(); text that does not name a key is kept as the name.
KeyPress parse_key(std::string_view text);

/// The action of a key; null if there is none.
const ActionRow* action_of(const KeyPress& key);
/// Whether the camera flies while the key is held.
bool is_flying_key(const KeyPress& key);
/// Same with the keys of the assignment Realtime, which include Control.
bool is_assignment_key(const KeyPress& key);

}  // namespace scenefile::viewer
