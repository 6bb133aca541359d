// The panel of the clicked pixel, and its mark in the picture.

#include "scenefile/base/text.h"
#include "scenefile/viewer/gui.h"
#include "scenefile/viewer/gui_colors.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

namespace scenefile::viewer {

namespace {

// Escapes each line, since line breaks are escaped as well.
void build_lines(const std::string& text) {
  constexpr std::size_t most = 400;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    ImGui::TextUnformatted(escaped(text.substr(begin, end - begin), most).c_str());
    begin = end + 1;
  }
}

void build_swatch(const char* name, const PixelValue& value) {
  ImGui::TextDisabled("%s", name);
  ImGui::SameLine();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float size = ImGui::GetTextLineHeight();
  ImGui::GetWindowDrawList()->AddRectFilled(
      at, {at.x + size, at.y + size},
      rgba(unsigned{value[0]} << 16 | unsigned{value[1]} << 8 | value[2]), 3);
  ImGui::Dummy({size, size});
  ImGui::SameLine();
  ImGui::TextUnformatted(fmt::format("{} {} {}", value[0], value[1], value[2]).c_str());
}

void build_answers(const Session& session) {
  const PixelReadout& readout = session.readout;
  ImGui::PushFont(ImGui::GetIO().Fonts->Fonts[1]);
  if (!session.reference->empty()) {
    ImGui::TextDisabled("%s", "why the other picture differs, with ours as the reference:");
    // Sentences wrap; the terms below are a tree, which scrolls sideways.
    const ImGuiStyle& style = ImGui::GetStyle();
    ImGui::PushTextWrapPos(ImGui::GetWindowWidth() - style.ScrollbarSize - style.WindowPadding.x);
    build_lines(cause_text(session));
    ImGui::PopTextWrapPos();
    ImGui::Spacing();
  }
  build_lines(readout.terms.empty() ? "computing ..." : readout.terms);
  ImGui::PopFont();
}

void paint_mark(const Session& session, double scale) {
  const glm::dvec2 at = session.picture.at + *session.readout.at * session.picture.size;
  ImDrawList& draw = *ImGui::GetBackgroundDrawList();
  const auto radius = static_cast<float>(7 * scale);
  draw.AddCircle(vec(at), radius, rgba(0x000000, 180), 24, static_cast<float>(3 * scale));
  draw.AddCircle(vec(at), radius, rgba(color_accent), 24, static_cast<float>(1.5 * scale));
}

}  // namespace

void build_readout(Session& session, const GuiFrame& frame) {
  paint_mark(session, frame.scale);
  const Box& box = session.picture;
  const double margin = 12 * frame.scale;
  const glm::dvec2 size =
      glm::min(glm::dvec2(620, 380) * frame.scale, box.size * glm::dvec2(0.6, 0.4));
  ImGui::SetNextWindowPos(vec({box.at.x + box.size.x - margin, box.at.y + margin}),
                          ImGuiCond_Appearing, {1, 0});
  ImGui::SetNextWindowSize(vec(size), ImGuiCond_Appearing);
  ImGui::SetNextWindowBgAlpha(0.92F);
  bool open = true;
  ImGui::Begin("Pixel", &open,
               ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoCollapse |
                   ImGuiWindowFlags_HorizontalScrollbar | ImGuiWindowFlags_NoFocusOnAppearing);
  const PixelReadout& readout = session.readout;
  ImGui::TextUnformatted(fmt::format("{}, {} of {} x {}", readout.pixel.x, readout.pixel.y,
                                     readout.size.x, readout.size.y)
                             .c_str());
  if (readout.other) {
    ImGui::SameLine();
    build_swatch("  other picture:", *readout.other);
  }
  ImGui::SameLine();
  if (ImGui::SmallButton("Copy")) {
    perform(session, Action::copy);
  }
  build_answers(session);
  ImGui::End();
  if (!open) {
    read_pixel(session, std::nullopt);
  }
}

}  // namespace scenefile::viewer
