// The panel that opens scenes: recent files on the left, a folder on the right.

#include "scenefile/base/text.h"
#include "scenefile/io/folder.h"
#include "scenefile/viewer/gui.h"
#include "scenefile/viewer/gui_colors.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <array>
#include <cstdlib>

namespace scenefile::viewer {

namespace {

constexpr ImGuiWindowFlags panel_flags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                         ImGuiWindowFlags_NoSavedSettings |
                                         ImGuiWindowFlags_NoBringToFrontOnFocus;

// Returns the chosen path; empty: none.
std::string build_recent(const Session& session) {
  std::string chosen;
  colored_text(color_accent, "Recent files");
  if (session.start.recent.empty()) {
    dim_text("none yet");
  }
  for (const std::string& path : session.start.recent) {
    ImGui::PushID(path.c_str());
    const float room = ImGui::GetContentRegionAvail().x;
    if (ImGui::Selectable(fitting(escaped(file_name_of(path), 200), room).c_str())) {
      chosen = path;
    }
    if (ImGui::IsItemHovered()) {
      ImGui::SetTooltip("%s", escaped(path, 400).c_str());
    }
    dim_text(fitting("  " + escaped(folder_of(path), 400), room));
    ImGui::PopID();
  }
  return chosen;
}

// A field for a path, in which Enter opens it.
std::string build_field(StartPanel& panel) {
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x);
  if (panel.appears) {
    panel.appears = false;
    ImGui::SetKeyboardFocusHere();  // what is typed is for the field
  }
  const bool entered = ImGui::InputTextWithHint("##path", "type a path, and Enter", &panel.typed,
                                                ImGuiInputTextFlags_EnterReturnsTrue);
  return entered && !panel.typed.empty() ? typed_path(panel, std::getenv("HOME")) : std::string();
}

std::string build_choices(const StartPanel& panel) {
  static constexpr std::array<const char*, 3> ends{"/", "", "  (to compare with)"};
  std::string chosen;
  ImGuiListClipper clipper;  // a folder may have many files
  clipper.Begin(static_cast<int>(panel.choices.size()));
  while (clipper.Step()) {
    for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
      const Choice& choice = panel.choices[static_cast<std::size_t>(i)];
      ImGui::PushID(i);
      const std::string name =
          escaped(choice.name, 200) + ends[static_cast<std::size_t>(choice.kind)];
      ImGui::PushStyleColor(ImGuiCol_Text,
                            rgba(choice.kind == ChoiceKind::scene ? color_text : color_dim));
      if (ImGui::Selectable(name.c_str())) {
        chosen = choice.path;
      }
      ImGui::PopStyleColor();
      ImGui::PopID();
    }
  }
  return chosen;
}

std::string build_folder(StartPanel& panel) {
  colored_text(color_accent, "Folder");
  ImGui::SameLine();
  ImGui::TextUnformatted(
      fitting(escaped(panel.folder, 400), ImGui::GetContentRegionAvail().x).c_str());
  std::string chosen = build_field(panel);
  ImGui::BeginChild("choices");
  if (ImGui::Selectable("../")) {
    chosen = folder_of(panel.folder);
  }
  if (const std::string path = build_choices(panel); !path.empty()) {
    chosen = path;
  }
  if (panel.choices.empty()) {
    dim_text("there are no scenes here");
  }
  ImGui::EndChild();
  return chosen;
}

// What is wrong with the last choice, shown next to it.
void build_news(const Session& session) {
  if (session.loading.busy()) {
    dim_text(("reading " + escaped(scene_name(session), 200)));
  } else if (session.broken != nullptr) {
    ImGui::PushStyleColor(ImGuiCol_Text, rgba(color_error));
    const OpenedScene& opened = session.broken->opened;
    ImGui::TextWrapped("%s",
                       escaped(opened.unreadable.empty()
                                   ? scene_name(session) + " has errors; they are listed below"
                                   : opened.unreadable,
                               400)
                           .c_str());
    ImGui::PopStyleColor();
  }
}

}  // namespace

void build_start(Session& session, const GuiFrame& frame, const Box& room) {
  ImGui::SetNextWindowPos(vec(room.at));
  ImGui::SetNextWindowSize(vec(room.size));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, vec(glm::dvec2(16, 12) * frame.scale));
  ImGui::Begin("##start", nullptr, panel_flags);
  ImGui::PopStyleVar();
  build_news(session);
  const auto left = static_cast<float>(std::min(260 * frame.scale, room.size.x * 0.4));
  ImGui::BeginChild("recent", {left, 0});
  std::string chosen = build_recent(session);
  ImGui::EndChild();
  ImGui::SameLine(0, static_cast<float>(16 * frame.scale));
  ImGui::BeginChild("folder");
  if (const std::string path = build_folder(session.start); !path.empty()) {
    chosen = path;
  }
  ImGui::EndChild();
  ImGui::End();
  if (!chosen.empty()) {
    session.start.typed.clear();
    choose(session, chosen);
  }
}

}  // namespace scenefile::viewer
