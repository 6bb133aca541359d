// The panel of the assignment Realtime: its sliders and filters.

#include "scenefile/viewer/gui.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>

namespace scenefile::viewer {

namespace {

// The sliders of the course's program; other values can be typed after Ctrl+click.
constexpr int slider_max = 25;
constexpr double max_near = 10;
constexpr double max_far = 100;

bool depth_slider(const char* name, double& depth, double least, double most) {
  return ImGui::SliderScalar(name, ImGuiDataType_Double, &depth, &least, &most, "%.2f");
}

bool parameter_slider(const char* name, int& parameter) {
  if (!ImGui::SliderInt(name, &parameter, 1, slider_max)) {
    return false;
  }
  parameter = std::clamp(parameter, 1, max_tessellation);
  return true;
}

bool build_controls(RealtimeOptions& panel) {
  bool changed = false;
  int milestone = static_cast<int>(panel.milestone);
  changed |= ImGui::RadioButton("Lights, Camera", &milestone, 0);
  ImGui::SameLine();
  changed |= ImGui::RadioButton("Action", &milestone, 1);
  panel.milestone = static_cast<Milestone>(milestone);
  changed |= parameter_slider("parameter 1", panel.tessellation.parameter1);
  changed |= parameter_slider("parameter 2", panel.tessellation.parameter2);
  changed |= depth_slider("near plane", panel.near, 0.01, max_near);
  changed |= depth_slider("far plane", panel.far, 0.1, max_far);
  static constexpr std::array<const char*, 5> filters{"no filter", "invert", "grayscale", "blur",
                                                      "sharpen"};
  int filter = static_cast<int>(panel.filter);
  changed |= ImGui::Combo("filter", &filter, filters.data(), static_cast<int>(filters.size()));
  panel.filter = static_cast<Filter>(filter);
  return changed;
}

}  // namespace

void build_realtime_panel(Session& session, const GuiFrame& frame) {
  const double margin = 12 * frame.scale;
  const glm::dvec2 at = session.picture.at + margin;
  ImGui::SetNextWindowPos(vec(at), ImGuiCond_Appearing);
  ImGui::SetNextWindowBgAlpha(0.85F);
  ImGui::Begin("Realtime", nullptr,
               ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoFocusOnAppearing);
  ImGui::PushItemWidth(ImGui::GetFontSize() * 11);
  RealtimeOptions panel = session.realtime_panel;
  if (build_controls(panel) && panel.near > 0 && panel.near < panel.far) {
    session.realtime_panel = panel;
    forget_cause(session);
    picture_changed(session);
  }
  ImGui::PopItemWidth();
  ImGui::Checkbox("keys of the assignment", &session.settings.assignment_keys);
  if (ImGui::IsItemHovered()) {
    ImGui::SetTooltip("W A S D, space and control move, dragging looks around");
  }
  dim_text(fmt::format("{} triangles", frame.drawn.triangles));
  ImGui::End();
}

}  // namespace scenefile::viewer
