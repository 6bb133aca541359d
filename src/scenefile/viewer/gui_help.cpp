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

constexpr std::string_view gesture_group = "Mouse and flying";

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
    if (name == gesture_group) {
      for (const GestureRow& row : gestures()) {
        line(row.gesture, row.what);
      }
    }
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

struct KeyGroup {
  std::string_view name;
  float rows = 0;  ///< with its heading
};

std::vector<KeyGroup> key_groups() {
  constexpr float heading = 1.5F;
  std::vector<KeyGroup> groups{{gesture_group, heading + static_cast<float>(gestures().size())}};
  for (const ActionRow& row : actions()) {
    if (row.group != groups.back().name) {
      groups.push_back({row.group, heading});
    }
    ++groups.back().rows;
  }
  return groups;
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
                      {static_cast<float>(8 * frame.scale), static_cast<float>(4 * frame.scale)});
  ImGui::Begin("##help", nullptr,
               ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                   ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_HorizontalScrollbar);
  // Columns of about the same height, as many as fit; in text heights.
  constexpr float first_keys = 10.8F;
  constexpr float keys = 7.5F;
  constexpr float words = 16.6F;
  const float one = ImGui::GetFontSize();
  const float room = window.x / one - (first_keys - keys) - 3;
  const auto columns = std::clamp(std::floor(room / (keys + words)), 1.0F, 3.0F);
  const std::vector<KeyGroup> groups = key_groups();
  float all = 0;
  for (const KeyGroup& group : groups) {
    all += group.rows;
  }
  const float top = ImGui::GetCursorPosY();
  float left = ImGui::GetCursorPosX();
  float width = first_keys;
  float rows = 0;
  for (const KeyGroup& group : groups) {
    if (rows > 0 && rows + group.rows / 2 > all / columns) {
      left += (width + words) * one;
      width = keys;
      rows = 0;
    }
    if (rows == 0) {
      ImGui::SetCursorPosY(top);
    }
    ImGui::SetCursorPosX(left);
    KeyList(width).group(group.name);
    rows += group.rows;
  }
  ImGui::End();
  ImGui::PopStyleVar(4);
}

}  // namespace scenefile::viewer
