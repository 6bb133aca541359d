// The help page with all keys.

#include "scenefile/viewer/gui.h"
#include "scenefile/viewer/gui_colors.h"

#include <imgui.h>

#include <string>
#include <string_view>

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

/// A list of keys that starts at the cursor and grows downward.
class KeyList {
 public:
  /// `keys`: the width of the column of keys, in text heights.
  explicit KeyList(float keys)
      : left_(ImGui::GetCursorPosX()), keys_(left_ + keys * ImGui::GetFontSize()) {}

  void heading(std::string_view text) const {
    ImGui::Dummy({0, ImGui::GetFontSize() * 0.2F});
    ImGui::SetCursorPosX(left_);
    ImGui::PushStyleColor(ImGuiCol_Text, rgba(color_accent));
    ImGui::TextUnformatted(text.data(), text.data() + text.size());
    ImGui::PopStyleColor();
  }
  void line(std::string_view key, std::string_view what) const {
    ImGui::SetCursorPosX(left_);
    key_cap(std::string(key));
    ImGui::SameLine(keys_);
    ImGui::TextUnformatted(what.data(), what.data() + what.size());
  }
  void group(std::string_view name) const {
    heading(name);
    for (const ActionRow& row : actions()) {
      if (row.group == name) {
        line(row.key, row.what);
      }
    }
  }

 private:
  float left_;
  float keys_;
};

void build_first() {
  const KeyList list(12.5F);
  list.heading("Mouse and flying");
  for (const GestureRow& row : gestures()) {
    list.line(row.gesture, row.what);
  }
  list.group("Camera");
  list.group("Scene");
  list.group("Picture");
}

void build_second() {
  const KeyList list(7.5F);
  list.group("Edit");
  list.group("Show");
  list.group("Window");
}

}  // namespace

void build_help(const GuiFrame& frame) {
  const ImVec2 window = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({window.x / 2, window.y / 2}, 0, {0.5F, 0.5F});
  ImGui::SetNextWindowBgAlpha(0.97F);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, static_cast<float>(10 * frame.scale));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding,
                      {static_cast<float>(22 * frame.scale), static_cast<float>(16 * frame.scale)});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1);
  ImGui::SetNextWindowSizeConstraints({0, 0}, window);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing,
                      {static_cast<float>(8 * frame.scale), static_cast<float>(6 * frame.scale)});
  ImGui::Begin("##help", nullptr,
               ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                   ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_HorizontalScrollbar);
  const float top = ImGui::GetCursorPosY();
  const float left = ImGui::GetCursorPosX();
  build_first();
  const float second = left + 34 * ImGui::GetFontSize();
  if (window.x >= second + 26 * ImGui::GetFontSize()) {
    ImGui::SetCursorPos({second, top});
  }
  build_second();
  ImGui::End();
  ImGui::PopStyleVar(4);
}

}  // namespace scenefile::viewer
