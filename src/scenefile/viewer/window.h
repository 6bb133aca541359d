#pragma once
// The window: shows the session and forwards user input.

#include "scenefile/viewer/script.h"
#include "scenefile/viewer/session.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace scenefile::viewer {

enum class WindowStatus : std::uint8_t {
  closed,      ///< by the user, or at the end of the script
  no_display,  ///< there is no screen
  failed,      ///< no OpenGL 4.1, or the script failed
};

struct WindowResult {
  WindowStatus status = WindowStatus::closed;
  std::string error;  ///< one line, unless closed
  bool shown = true;  ///< whether the scene requested last, if any, could be drawn
};

struct WindowOptions {
  SessionSetup setup;  ///< `wake` is set by the window
  /// A file, a folder, - for standard input; empty: a panel to choose one; a file that does not
  /// exist: a new scene.
  std::string scene;
  std::string reference;  ///< pictures to compare with; empty: none
  std::string mine;
  std::string picture;              ///< its role is not known
  std::string settings;             ///< path of the settings file; empty: settings are not kept
  std::optional<glm::ivec2> size;   ///< of the window; default: as remembered
  std::optional<bool> ray_tracing;  ///< at the start; default: as remembered
  Script script;                    ///< runs instead of user input; then the window closes
  bool hidden = false;              ///< draw without showing the window on the screen
  /// Called with the result at once if the window cannot be opened. run_window() returns later,
  /// when the scene has been read.
  std::function<void(const WindowResult&)> failed;
};

/// Opens the window and returns after it is closed. Call it from the main thread, and only once at
/// a time.
WindowResult run_window(const WindowOptions& options);

}  // namespace scenefile::viewer
