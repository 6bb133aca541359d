// The menu of profiles and features.

#include "scenefile/trace/features.h"
#include "scenefile/viewer/drawing_choices.h"
#include "scenefile/viewer/gui.h"

#include <imgui.h>

#include <array>
#include <string>

namespace scenefile::viewer {

namespace {

struct DrawnAsRow {
  DrawnAs drawn;
  const char* text;
};
constexpr std::array drawn_as_rows{
    DrawnAsRow{DrawnAs::fine, "Profile fine: with good sampling"},
    DrawnAsRow{DrawnAs::course, "Profile course: as the course's program"},
    DrawnAsRow{DrawnAs::paths, "Mode path: path tracing"},
    DrawnAsRow{DrawnAs::realtime, "Profile realtime: the assignment Realtime"},
};

void build_profiles(Session& session) {
  for (const DrawnAsRow& row : drawn_as_rows) {
    if (ImGui::MenuItem(row.text, nullptr, drawn_as(session) == row.drawn)) {
      draw_as(session, row.drawn);
    }
  }
}

void build_features(Session& session) {
  const bool traced = !session.realtime && !traces_paths(session);
  ImGui::TextDisabled("%s", traced ? "Features" : "Features (of ray tracing)");
  for (const std::string_view word : feature_sets) {
    if (ImGui::MenuItem(std::string(word).c_str(), nullptr, is_feature_set(session, word),
                        traced)) {
      use_feature_set(session, word);
    }
  }
  ImGui::Separator();
  for (const std::string_view word : feature_words()) {
    if (ImGui::MenuItem(std::string(word).c_str(), nullptr, has_feature(session, word), traced)) {
      toggle_feature(session, word);
    }
  }
}

}  // namespace

void build_drawing_menu(Session& session) {
  if (ImGui::BeginMenu("Drawing")) {
    build_profiles(session);
    ImGui::Separator();
    build_features(session);
    ImGui::EndMenu();
  }
}

}  // namespace scenefile::viewer
