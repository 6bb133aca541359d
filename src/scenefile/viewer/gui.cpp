// The layout of the panels.

#include "scenefile/viewer/gui.h"

#include "scenefile/viewer/gui_colors.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

namespace scenefile::viewer {

namespace {

constexpr ImGuiWindowFlags fixed =
    ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
    ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings |
    ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoBringToFrontOnFocus;

// A panel at a fixed position; the caller calls ImGui::End().
void begin_panel(const char* name, const Box& box, ImGuiWindowFlags more = 0) {
  ImGui::SetNextWindowPos(vec(box.at));
  ImGui::SetNextWindowSize(vec(box.size));
  ImGui::Begin(name, nullptr, fixed | more);
}

// The strip at the right edge of the outline that resizes it.
void build_grip(Session& session, const Box& panel, double scale) {
  const double width = 6 * scale;
  begin_panel("##grip",
              {{panel.at.x + panel.size.x - width / 2, panel.at.y}, {width, panel.size.y}},
              ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoScrollbar);
  ImGui::SetCursorPos({0, 0});
  ImGui::InvisibleButton("grip", vec({width, panel.size.y}));
  if (ImGui::IsItemHovered() || ImGui::IsItemActive()) {
    ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
  }
  if (ImGui::IsItemActive()) {
    const double wanted = session.settings.panel_width + ImGui::GetIO().MouseDelta.x / scale;
    session.settings.panel_width = static_cast<float>(std::clamp(wanted, 180.0, 900.0));
  }
  ImGui::End();
}

// Takes space for the outline from the available space.
void build_left(Session& session, const GuiFrame& frame, Box& room) {
  const double width = std::min(session.settings.panel_width * frame.scale, room.size.x * 0.45);
  const Box panel{room.at, {width, room.size.y}};
  begin_panel("##left", panel, ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
  build_outline(session);
  ImGui::End();
  build_grip(session, panel, frame.scale);
  room.at.x += width;
  room.size.x -= width;
}

// Takes space for the explained pixel from the available space.
void build_right(Session& session, const GuiFrame& frame, Box& room) {
  const double width = std::floor(std::min(460 * frame.scale, room.size.x * 0.45));
  room.size.x -= width;
  begin_panel("##right", {{room.at.x + room.size.x, room.at.y}, {width, room.size.y}});
  build_readout(session);
  ImGui::End();
}

bool has_messages(const Session& session) {
  if (session.broken != nullptr || !session.drawing_notes.empty()) {
    return true;
  }
  return session.shown != nullptr && !session.shown->opened.diagnostics.list().empty();
}

// Takes space for the messages from the available space.
void build_bottom(Session& session, const GuiFrame& frame, Box& room) {
  const double most = session.broken != nullptr ? 0.4 : 0.2;
  const double wanted = session.messages_height == 0 ? 60 * frame.scale : session.messages_height;
  const double height = std::floor(std::min(room.size.y * most, wanted));
  begin_panel("##messages", {{room.at.x, room.at.y + room.size.y - height}, {room.size.x, height}});
  build_messages(session);
  if (session.pointer.drag != Drag::handle) {  // else the picture would move under the pointer
    session.messages_height = ImGui::GetCursorPosY() + ImGui::GetStyle().WindowPadding.y;
  }
  ImGui::End();
  room.size.y -= height;
}

void build_status_line(const Session& session, const GuiFrame& frame, Box& room) {
  const double height = ImGui::GetFrameHeight() + 2 * frame.scale;
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, vec({12 * frame.scale, 4 * frame.scale}));
  begin_panel("##status", {{room.at.x, room.at.y + room.size.y - height}, {room.size.x, height}},
              ImGuiWindowFlags_NoScrollbar);
  ImGui::PopStyleVar();
  build_status(session, frame);
  ImGui::End();
  room.size.y -= height;
}

}  // namespace

ImVec2 vec(const glm::dvec2& v) {
  return {static_cast<float>(v.x), static_cast<float>(v.y)};
}

void build_gui(Session& session, const GuiFrame& frame, const glm::dvec2& window) {
  Box room{{0, 0}, window};
  session.gui_scale = frame.scale;
  if (!session.picture_only) {
    build_menu(session);
    room.at.y = ImGui::GetFrameHeight();
    room.size.y -= room.at.y;
    build_status_line(session, frame, room);
    if (session.settings.outline && session.shown != nullptr) {
      build_left(session, frame, room);
    }
    if (session.pointer.drag != Drag::handle) {
      session.shows_messages = session.settings.messages && has_messages(session);
    }
    if (session.shows_messages) {
      build_bottom(session, frame, room);
    }
    if (session.explaining && session.shown != nullptr && !session.start.open) {
      build_right(session, frame, room);
    }
  }
  room.size = glm::max(room.size, glm::dvec2(1));
  place_pictures(session, room);
  build_overlay(session, frame);
  if (session.start.open) {
    build_start(session, frame, room);
  }
  if (session.help) {
    build_help(frame);
  }
  if (session.palette) {
    build_palette(session, frame);
  }
  if (session.question) {
    build_question(session, frame);
  }
}

}  // namespace scenefile::viewer
