#pragma once
// What the window remembers from one time to the next.

#include <cstdint>
#include <string>

namespace scenefile::viewer {

struct Settings {
  int window_width = 1280;  ///< screen coordinates
  int window_height = 800;
  float panel_width = 330;  ///< of the outline, in units of a screen of normal density
  float text_scale = 1;     ///< beside that of the screen
  bool outline = true;      ///< panels that are shown
  bool messages = true;
  bool statistics = false;
  bool shadows = true;
  bool textures = true;
  bool axes = false;             ///< axes, lights and the scene's camera are drawn over the picture
  bool assignment_keys = false;  ///< keys and mouse of the assignment Realtime
  bool ray_tracing = false;
  int samples = 16;  ///< of the ray tracer, a pixel

  friend bool operator==(const Settings&, const Settings&) = default;
};

/// One `name = value` a line.
std::string settings_text(const Settings& settings);

/// False: the text is damaged, and `settings` is as before. Names that are unknown are passed over:
/// they may be a newer version's. Values are cut to what makes sense.
bool parse_settings(const std::string& text, Settings& settings);

/// Below the folder for settings: `xdg_config_home` where it is an absolute path, else .config in
/// `home`; empty where there is neither.
std::string settings_path(const char* xdg_config_home, const char* home);

/// The settings of the file; the defaults where there is none. `note` says, in one line, that a
/// damaged file was passed over.
Settings load_settings(const std::string& path, std::string& note);

/// Whole or not at all. Returns what went wrong; empty: nothing.
std::string save_settings(const std::string& path, const Settings& settings);

}  // namespace scenefile::viewer
