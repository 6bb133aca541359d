// The help page with all keys.

#include "scenefile/viewer/gui.h"
#include "scenefile/viewer/gui_colors.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

namespace scenefile::viewer {

namespace {

void key_cap(const std::string& key) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const ImVec2 size = ImGui::CalcTextSize(key.c_str());
  const float pad = ImGui::GetFontSize() * 0.35F;
  ImGui::GetWindowDrawList()->AddRectFilled({at.x, at.y - 1},
                                            {at.x + size.x + 2 * pad, at.y + size.y + 2},
                                            rgba(0x3a3f47), 0.25F * ImGui::GetFontSize());
  ImGui::GetWindowDrawList()->AddText({at.x + pad, at.y}, rgba(color_text), key.c_str());
  ImGui::Dummy({size.x + 2 * pad, size.y});
}

struct HelpLine {
  std::string_view key;  ///< empty: a heading
  std::string_view what;
};

std::vector<HelpLine> help_lines() {
  std::vector<HelpLine> lines{
      {"", "Mouse and flying"},
      {"drag", "turn the scene"},
      {"Shift or middle drag", "move the picture"},
      {"Ctrl + drag", "look around"},
      {"wheel, right drag", "zoom in or out"},
      {"Ctrl + wheel", "zoom into the picture; then drag it"},
      {"W A S D Q E", "fly; with Shift faster"},
      {"click", "select an object"},
      {"Alt + click", "select, and explain the pixel"},
      {"drag a handle", "move, turn or scale the selection"},
      {"drop a scene or folder", "open it"},
      {"drop a picture", "compare with it"},
  };
  std::string_view group;
  for (const ActionRow& row : actions()) {
    if (row.group != group) {
      group = row.group;
      lines.push_back({"", group});
    }
    lines.push_back({row.key, row.what});
  }
  return lines;
}

// `left` and `keys`: where the keys and what they do begin.
void build_line(const HelpLine& line, float left, float keys) {
  ImGui::SetCursorPosX(left);
  if (line.key.empty()) {
    colored_text(color_accent, std::string(line.what));
  } else {
    key_cap(std::string(line.key));
    ImGui::SameLine(keys);
    ImGui::TextUnformatted(line.what.data(), line.what.data() + line.what.size());
  }
}

}  // namespace

void build_help(const GuiFrame& frame) {
  const ImVec2 window = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({window.x / 2, window.y / 2}, 0, {0.5F, 0.5F});
  ImGui::SetNextWindowBgAlpha(0.97F);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, static_cast<float>(10 * frame.scale));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, vec(glm::dvec2(22, 16) * frame.scale));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1);
  ImGui::SetNextWindowSizeConstraints({0, 0}, window);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, vec(glm::dvec2(8, 4) * frame.scale));
  ImGui::Begin("##help", nullptr,
               ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                   ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_HorizontalScrollbar);
  // Columns of the same number of lines, as many as fit; in text heights.
  constexpr float first_keys = 10.8F;
  constexpr float keys = 7.5F;
  constexpr float words = 16.6F;
  const float one = ImGui::GetFontSize();
  const float room = window.x / one - (first_keys - keys) - 3;
  const auto columns = std::clamp(std::floor(room / (keys + words)), 1.0F, 3.0F);
  const std::vector<HelpLine> lines = help_lines();
  const auto most = static_cast<std::size_t>(std::ceil(static_cast<float>(lines.size()) / columns));
  const float top = ImGui::GetCursorPosY();
  float left = ImGui::GetCursorPosX();
  float width = first_keys;
  std::size_t rows = 0;
  for (const HelpLine& line : lines) {
    // A heading does not end a column.
    if (rows + (line.key.empty() ? 1 : 0) >= most) {
      left += (width + words) * one;
      width = keys;
      rows = 0;
      ImGui::SetCursorPosY(top);
    }
    if (line.key.empty() && rows > 0) {
      ImGui::Dummy({0, 0.2F * one});
    }
    build_line(line, left, left + width * one);
    ++rows;
  }
  ImGui::End();
  ImGui::PopStyleVar(4);
}

}  // namespace scenefile::viewer
