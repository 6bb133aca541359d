// All keys on one page.

#include "scenefile/viewer/gui.h"
#include "scenefile/viewer/gui_colors.h"

#include <imgui.h>

#include <string>

namespace scenefile::viewer {

namespace {

void key_cap(const std::string& key) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const ImVec2 size = ImGui::CalcTextSize(key.c_str());
  const float pad = ImGui::GetFontSize() * 0.35F;
  ImGui::GetWindowDrawList()->AddRectFilled(
      {at.x, at.y - 1}, {at.x + size.x + 2 * pad, at.y + size.y + 2}, rgba(0x3a3f47), 4);
  ImGui::GetWindowDrawList()->AddText({at.x + pad, at.y}, rgba(color_text), key.c_str());
  ImGui::Dummy({size.x + 2 * pad, size.y});
}

void help_line(const std::string& key, const std::string& what) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  key_cap(key);
  ImGui::TableNextColumn();
  ImGui::TextUnformatted(what.c_str());
}

void heading(const std::string& text) {
  ImGui::Dummy({0, ImGui::GetFontSize() * 0.25F});
  ImGui::PushStyleColor(ImGuiCol_Text, rgba(color_accent));
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopStyleColor();
}

bool begin_list(const char* name, float keys) {
  if (!ImGui::BeginTable(name, 2, ImGuiTableFlags_SizingFixedFit)) {
    return false;
  }
  ImGui::TableSetupColumn("key", ImGuiTableColumnFlags_WidthFixed, keys);
  ImGui::TableSetupColumn("what");
  return true;
}

void build_keys(std::string_view group) {
  heading(std::string(group));
  if (begin_list(std::string(group).c_str(), ImGui::GetFontSize() * 6.2F)) {
    for (const ActionRow& row : actions()) {
      if (row.group == group) {
        help_line(std::string(row.key), std::string(row.what));
      }
    }
    ImGui::EndTable();
  }
}

void build_gestures() {
  heading("Mouse and flying");
  if (begin_list("mouse", ImGui::GetFontSize() * 13.5F)) {
    for (const GestureRow& row : gestures()) {
      help_line(std::string(row.gesture), std::string(row.what));
    }
    ImGui::EndTable();
  }
}

}  // namespace

void build_help(Session& session, const GuiFrame& frame) {
  const ImVec2 window = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({window.x / 2, window.y / 2}, 0, {0.5F, 0.5F});
  ImGui::SetNextWindowBgAlpha(0.97F);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, static_cast<float>(10 * frame.scale));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding,
                      {static_cast<float>(22 * frame.scale), static_cast<float>(16 * frame.scale)});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1);
  bool open = true;
  ImGui::Begin("##help", &open,
               ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                   ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoSavedSettings);
  if (ImGui::BeginTable("columns", 2,
                        ImGuiTableFlags_SizingFixedFit | ImGuiTableFlags_NoSavedSettings)) {
    ImGui::TableNextColumn();
    build_gestures();
    build_keys("Camera");
    build_keys("Scene");
    build_keys("Picture");
    ImGui::TableNextColumn();
    build_keys("Show");
    build_keys("Window");
    ImGui::EndTable();
  }
  ImGui::End();
  ImGui::PopStyleVar(3);
  session.help = session.help && open;
}

}  // namespace scenefile::viewer
