#pragma once
// The window: opens, shows the session, and hands on what the user does.

#include "scenefile/viewer/script.h"
#include "scenefile/viewer/session.h"

#include <optional>
#include <string>
#include <vector>

namespace scenefile::viewer {

struct WindowOptions {
  SessionSetup setup;               ///< `wake` is the window's
  std::string scene;                ///< a file, a folder, or - for standard input
  std::string reference;            ///< a picture to compare with; empty: none
  std::string settings;             ///< the file of the settings; empty: they are not kept
  std::optional<glm::ivec2> size;   ///< of the window; else as remembered
  std::optional<bool> ray_tracing;  ///< at the start; else as remembered
  Script script;                    ///< steps to do instead of a user's; then the window closes
  bool hidden = false;  ///< do not show the window on the screen (it is drawn all the same)
};

enum class WindowStatus : std::uint8_t {
  closed,      ///< by the user, or at the end of the script
  no_display,  ///< there is no screen to open a window on
  failed,      ///< the screen has no OpenGL 4.1, or the script could not be done
};

struct WindowResult {
  WindowStatus status = WindowStatus::closed;
  std::string error;  ///< one line, where it was not closed
  bool shown = true;  ///< whether the last scene that was asked for could be drawn
};

/// Opens the window and returns when it is closed. Call it on the first thread of the program, and
/// not from two places at once.
WindowResult run_window(const WindowOptions& options);

}  // namespace scenefile::viewer
