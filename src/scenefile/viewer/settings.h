#pragma once
// Settings that the window keeps between runs.

#include <cstdint>
#include <string>
#include <string_view>

namespace scenefile::viewer {

struct Settings {
  int window_width = 1280;  ///< screen coordinates
  int window_height = 800;
  float panel_width = 390;  ///< of the outline, in pixels of a normal-density screen
  float text_scale = 1;     ///< in addition to the screen's scale
  bool outline = true;      ///< visible panels
  bool messages = true;
  bool statistics = false;
  bool shadows = true;
  bool textures = true;
  bool axes = false;             ///< draw axes, lights and the scene's camera over the picture
  bool assignment_keys = false;  ///< use keys and mouse of the assignment Realtime
  bool ray_tracing = false;
  bool linear_values = false;  ///< pixels have values from 0 to 1, not from 0 to 255
  int samples = 16;            ///< per pixel, for the ray tracer

  friend bool operator==(const Settings&, const Settings&) = default;
};

/// One `name = value` per line.
std::string settings_text(const Settings& settings);

/// Returns false, and leaves `settings` unchanged, if the text is damaged. Ignores unknown names,
/// which a newer version may have written. Clamps values to valid ranges.
bool parse_settings(const std::string& text, Settings& settings);

/// Where the window keeps files of the user, by the XDG base directory specification: the path of
/// the file `name` in the folder scenefile of `xdg`, the value of a variable such as
/// XDG_CONFIG_HOME, if that is an absolute path; otherwise in `usual` (such as ".config") of
/// `home`. Empty if neither is given.
std::string user_path(const char* xdg, const char* home, std::string_view usual,
                      std::string_view name);

/// Reads the settings from the file; defaults if it does not exist. `note`, one line, says if the
/// file was damaged and ignored.
Settings load_settings(const std::string& path, std::string& note);

/// Writes atomically. Returns an error text; empty on success.
std::string save_settings(const std::string& path, const Settings& settings);

}  // namespace scenefile::viewer
