// The palette: all commands, to search in.

#include "scenefile/base/text.h"
#include "scenefile/viewer/gui.h"
#include "scenefile/viewer/gui_colors.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

namespace scenefile::viewer {

namespace {

// Commands whose group, description or key contains every word.
std::vector<const ActionRow*> matches(const std::string& typed) {
  std::vector<const ActionRow*> rows;
  for (const ActionRow& row : actions()) {
    const std::string text = lower_case(std::string(row.group) + " " + std::string(row.what) + " " +
                                        std::string(row.key));
    bool all = row.action != Action::palette;
    std::istringstream words(lower_case(typed));
    for (std::string word; all && words >> word;) {
      all = text.find(word) != std::string::npos;
    }
    if (all) {
      rows.push_back(&row);
    }
  }
  return rows;
}

}  // namespace

void build_palette(Session& session, const GuiFrame& frame) {
  const ImVec2 window = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({window.x / 2, window.y * 0.12F}, 0, {0.5F, 0});
  ImGui::SetNextWindowSize(vec({std::min(520 * frame.scale, double{window.x}),
                                std::min(420 * frame.scale, 0.8 * double{window.y})}));
  ImGui::SetNextWindowFocus();
  ImGui::Begin("##palette", nullptr,
               ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                   ImGuiWindowFlags_NoSavedSettings);
  if (ImGui::IsWindowAppearing()) {
    session.palette_typed.clear();
    session.palette_row = 0;
    ImGui::SetKeyboardFocusHere();
  }
  ImGui::SetNextItemWidth(-1);
  const bool entered =
      ImGui::InputTextWithHint("##typed", "type a word of a command", &session.palette_typed,
                               ImGuiInputTextFlags_EnterReturnsTrue);
  if (ImGui::IsItemEdited()) {
    session.palette_row = 0;
  }
  const std::vector<const ActionRow*> rows = matches(session.palette_typed);
  const int step = (ImGui::IsKeyPressed(ImGuiKey_DownArrow) ? 1 : 0) -
                   (ImGui::IsKeyPressed(ImGuiKey_UpArrow) ? 1 : 0);
  session.palette_row =
      std::clamp(session.palette_row + step, 0, std::max(0, static_cast<int>(rows.size()) - 1));
  const ActionRow* chosen = nullptr;
  ImGui::BeginChild("rows");
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const bool now = static_cast<int>(i) == session.palette_row;
    ImGui::PushID(static_cast<int>(i));
    const std::string text = std::string(rows[i]->group) + ": " + std::string(rows[i]->what);
    if (ImGui::Selectable(text.c_str(), now) || (now && entered)) {
      chosen = rows[i];
    }
    if (now && step != 0) {
      ImGui::SetScrollHereY();
    }
    const std::string key(rows[i]->key);
    ImGui::SameLine(ImGui::GetWindowWidth() - ImGui::CalcTextSize(key.c_str()).x -
                    2 * ImGui::GetFontSize());
    dim_text(key);
    ImGui::PopID();
  }
  ImGui::EndChild();
  ImGui::End();
  if (chosen != nullptr) {
    session.palette = false;
    perform(session, chosen->action);
  }
}

}  // namespace scenefile::viewer
