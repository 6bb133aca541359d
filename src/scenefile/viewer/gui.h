#pragma once
// Panels, menus and what lies over the picture. Internal to the room; Dear ImGui is used in the
// files gui*.cpp and window.cpp alone.

#include "scenefile/viewer/session.h"

#include <string>

namespace scenefile::viewer {

/// What the panels show beside the session.
struct GuiFrame {
  double scale = 1;          ///< pixels of text to a pixel of a screen of normal density
  double frame_seconds = 0;  ///< that the last frame took
  std::uint64_t memory = 0;  ///< of the process, bytes; 0: unknown
  std::string renderer;
  DrawStats drawn;
  // Names of textures; 0: none. `scene` stands on its head.
  unsigned scene = 0;
  unsigned traced = 0;
  unsigned reference = 0;
  unsigned difference = 0;
  unsigned flip = 0;
};

/// Colors, spacing and fonts for this density of the screen. Returns a note where no good font was
/// found; empty: all is well.
std::string set_gui_style(double scale);

/// As much of a text as there is room for, in pixels; the end is then three dots. Between the
/// beginning of a frame and its end.
std::string fitting(const std::string& text, float room);

/// Builds all of the frame; sets session.picture. `window`: its size.
void build_gui(Session& session, const GuiFrame& frame, const glm::dvec2& window);

// The parts, in files of their own.
void build_menu(Session& session);
void build_outline(Session& session, const GuiFrame& frame);
void build_messages(const Session& session);
void build_status(const Session& session, const GuiFrame& frame);
void build_overlay(Session& session, const GuiFrame& frame);
void build_realtime_panel(Session& session, const GuiFrame& frame);
void build_help(const GuiFrame& frame);

}  // namespace scenefile::viewer
