// The menus, generated from the table of keys, and the status line.

#include "scenefile/base/text.h"
#include "scenefile/viewer/gui.h"
#include "scenefile/viewer/gui_colors.h"

#include <fmt/format.h>
#include <imgui.h>

#include <cctype>
#include <string>

namespace scenefile::viewer {

namespace {

std::string capitalized(std::string_view text) {
  std::string result(text);
  result.front() = static_cast<char>(std::toupper(result.front()));
  return result;
}

void build_group(Session& session, std::string_view group) {
  for (const ActionRow& row : actions()) {
    if (row.group == group &&
        ImGui::MenuItem(capitalized(row.what).c_str(), std::string(row.key).c_str(),
                        row.is_on(session), row.refusal(session).empty())) {
      perform(session, row.action);
    }
  }
}

// At the right end of the menu bar.
void build_title(const Session& session) {
  const float right = ImGui::GetWindowWidth() - 1.6F * ImGui::GetFontSize();
  const float room = right - ImGui::GetCursorPosX() - ImGui::GetFontSize();
  const char* const mark = has_unsaved_edits(session) ? "\u2022 " : "";
  const std::string text = fitting(mark + escaped(scene_name(session), 80), room);
  ImGui::SameLine(right - ImGui::CalcTextSize(text.c_str()).x);
  dim_text(text);
}

// Such as "path tracing: 24 samples, noise 3.1 %".
std::string paths_text(const Session& session) {
  if (!session.traced || session.traced->samples == 0) {
    return "path tracing";
  }
  const TracedPicture& picture = *session.traced;
  std::string text = fmt::format("{} {}", picture.complete ? "path traced:" : "path tracing:",
                                 counted(picture.samples, "sample"));
  if (picture.noise > 0) {
    text += fmt::format(", noise {:.1f} %", 100 * picture.noise);
  }
  return picture.complete ? text + fmt::format(", {:.1f} s", picture.seconds) : text;
}

std::string tracing_text(const Session& session) {
  if (traces_paths(session)) {
    return paths_text(session);
  }
  if (!wants_trace(session)) {
    return "OpenGL";
  }
  if (!session.traced) {
    return "ray tracing when the camera rests";
  }
  const TracedPicture& picture = *session.traced;
  return picture.complete ? fmt::format("ray traced in {:.1f} s", picture.seconds)
                          : fmt::format("ray tracing {:.0f} %", 100 * picture.done);
}

}  // namespace

void build_menu(Session& session) {
  if (!ImGui::BeginMainMenuBar()) {
    return;
  }
  std::string_view group;
  for (const ActionRow& row : actions()) {
    if (row.group != group) {
      group = row.group;
      if (ImGui::BeginMenu(std::string(group).c_str())) {
        build_group(session, group);
        ImGui::EndMenu();
      }
    }
  }
  build_drawing_menu(session);
  build_title(session);
  ImGui::EndMainMenuBar();
}

void build_status(const Session& session, const GuiFrame& frame) {
  if (session.shown == nullptr) {
    const std::string name = escaped(scene_name(session), 80);
    dim_text(session.loading.busy()      ? "reading " + name
             : session.broken != nullptr ? name + " is read again when it changes"
                                         : "choose a scene, or drop one into the window");
    return;
  }
  const glm::dvec3& p = session.camera.position;
  std::string text = fmt::format("{}   {}   camera {:.4g} {:.4g} {:.4g}", mode_text(session),
                                 tracing_text(session), p.x, p.y, p.z);
  if (session.zoom > 1) {
    text += fmt::format("   zoom {:.0f} % (0: all)", 100 * session.zoom);
  }
  if (session.fitting.busy()) {
    text += "   finding out how the picture was drawn";
  } else if (session.comparing.busy()) {
    text += "   comparing";
  }
  const std::string hint = fmt::format("{}F1 help", session.loading.busy() ? "reading   " : "");
  const float hint_at = ImGui::GetWindowWidth() - ImGui::CalcTextSize(hint.c_str()).x -
                        static_cast<float>(14 * frame.scale);
  ImGui::AlignTextToFramePadding();
  dim_text(fitting(text, hint_at - ImGui::GetCursorPosX() - ImGui::GetFontSize()));
  ImGui::SameLine(hint_at);
  dim_text(hint);
}

}  // namespace scenefile::viewer
