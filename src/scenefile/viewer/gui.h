#pragma once
// Panels, menus and overlays. Internal to viewer; only gui*.cpp and window.cpp use Dear ImGui.

#include "scenefile/viewer/session.h"

#include <functional>
#include <string>

struct ImFontAtlas;
struct ImVec2;

namespace scenefile::viewer {

/// A place or a size as Dear ImGui takes it.
ImVec2 vec(const glm::dvec2& v);

/// Input of the panels in addition to the session.
struct GuiFrame {
  double scale = 1;          ///< text pixels per pixel of a normal-density screen
  double frame_seconds = 0;  ///< of the last frame
  double scene_seconds = 0;  ///< for drawing the scene's picture, on another thread
  std::uint64_t memory = 0;  ///< used by the process, bytes; 0: unknown
  std::string renderer;
  DrawStats drawn;
  // Names of textures; 0: none.
  unsigned scene = 0;
  unsigned traced = 0;
  unsigned reference = 0;
  unsigned mine = 0;
  unsigned difference = 0;
  unsigned flip = 0;
};

/// Sets colors and spacing for this screen density.
void set_gui_style(double scale);

/// Fills the atlas with the fonts for this screen density. Returns a note if no good font was
/// found; empty otherwise. May run on another thread while there is no context of ImGui.
std::string build_fonts(ImFontAtlas& atlas, double scale);

/// Text in a color of gui_colors.h, and in the dim one.
void colored_text(unsigned rgb, const std::string& text);
void dim_text(const std::string& text);

/// The text, truncated with an ellipsis to a width in pixels. Only while a frame is built.
std::string fitting(const std::string& text, float room);

/// Builds the whole frame; sets session.picture. `window` is its size.
void build_gui(Session& session, const GuiFrame& frame, const glm::dvec2& window);

// The parts of a frame, each in a separate file.
void build_menu(Session& session);
void build_drawing_menu(Session& session);
void build_outline(Session& session);
void build_object(Session& session);
/// In their place while nothing is selected.
void build_no_object(Session& session);
void build_question(Session& session, const GuiFrame& frame);
void build_messages(const Session& session);
void build_status(const Session& session, const GuiFrame& frame);
void build_overlay(Session& session, const GuiFrame& frame);
void build_realtime_panel(Session& session, const GuiFrame& frame);
void build_readout(Session& session);
void paint_pictures(const Session& session, const GuiFrame& frame);
/// The values of the pixels, where these are large enough.
void paint_values(const Session& session, const GuiFrame& frame);
void paint_magnifier(const Session& session, const GuiFrame& frame);
void paint_mark(const Session& session, const GuiFrame& frame);
void build_palette(Session& session, const GuiFrame& frame);
void build_help(const GuiFrame& frame);
/// In this part of the window, over the picture.
void build_start(Session& session, const GuiFrame& frame, const Box& room);

}  // namespace scenefile::viewer
