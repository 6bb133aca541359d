#pragma once
// What the keys of the window do: one table, of which the menus, the help and the dispatch are
// made.

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace scenefile::viewer {

enum class Action : std::uint8_t {
  scene_camera,
  frame,
  side_front,
  side_right,
  side_top,
  save_view,
  undo_save,
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
  show_all,
  trace,
  realtime,
  split,
  difference,
  reload,
  next_scene,
  previous_scene,
  screenshot,
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
  std::string_view group;  ///< a heading of the help, and a menu
  std::string_view what;   ///< a few words
};

/// In the order of the help; each key once, groups together.
std::span<const ActionRow> actions();
const ActionRow& row_of(Action action);

/// What else can be done, for the help.
struct GestureRow {
  std::string_view gesture;
  std::string_view what;
};
std::span<const GestureRow> gestures();

/// A key with what is held beside it.
struct KeyPress {
  std::string name;  ///< "A", "1", "F5", "Home", "Page Up", "?"
  bool control = false;
  bool shift = false;
};

/// "Ctrl+Shift+S".
std::string key_text(const KeyPress& key);
/// The inverse; what is no name of a key stands as it is.
KeyPress parse_key(std::string_view text);

/// The row of a key; null: the key does nothing.
const ActionRow* action_of(const KeyPress& key);
/// Whether the camera flies while the key is held.
bool is_flying_key(const KeyPress& key);
/// The same with the keys of the assignment Realtime, of which control is one.
bool is_assignment_key(const KeyPress& key);

}  // namespace scenefile::viewer
