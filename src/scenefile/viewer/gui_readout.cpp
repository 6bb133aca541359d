// The panel of the clicked pixel, and its mark in the picture.

#include "scenefile/base/text.h"
#include "scenefile/viewer/gui.h"
#include "scenefile/viewer/gui_colors.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <sstream>

namespace scenefile::viewer {

namespace {

// Breaks lines at spaces only. ImGui also breaks them in numbers, after the point.
std::string wrapped_at_spaces(std::string text, float width) {
  std::size_t start = 0;  // of the line
  std::size_t space = text.npos;
  for (std::size_t end = 0; end < text.size(); space = end++) {
    end = std::min(text.find(' ', end), text.size());
    if (space != text.npos &&
        ImGui::CalcTextSize(text.data() + start, text.data() + end).x > width) {
      text[space] = '\n';
      start = space + 1;
    }
  }
  return text;
}

// Wraps each line; what continues it starts where its text does, after the branches of the tree. A
// click on a line that names an object or light selects it.
void build_lines(Session& session, const std::string& text) {
  constexpr std::size_t most = 1000;
  std::istringstream lines(text);
  for (std::string whole; std::getline(lines, whole);) {
    const std::string line = escaped(whole, most);
    std::size_t branches = 0;
    while (branches < line.size() &&
           (line[branches] == ' ' || (static_cast<unsigned char>(line[branches]) & 0x80) != 0)) {
      ++branches;
    }
    ImGui::TextUnformatted(line.c_str(), line.c_str() + branches);
    ImGui::SameLine(0, 0);
    const bool links = line.find(" (line ") != std::string::npos;
    ImGui::PushStyleColor(ImGuiCol_Text, rgba(links ? color_link : color_text));
    ImGui::TextWrapped(
        "%s", wrapped_at_spaces(line.substr(branches), ImGui::GetContentRegionAvail().x).c_str());
    ImGui::PopStyleColor();
    if (links && ImGui::IsItemHovered()) {
      ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
      if (ImGui::IsMouseClicked(ImGuiMouseButton_Left)) {
        if (const std::optional<std::uint32_t> row = row_named_in(session, line)) {
          select(session, row);
        }
      }
    }
  }
}

void build_swatch(const char* name, const PixelValue& value) {
  dim_text(name);
  ImGui::SameLine(9 * ImGui::GetFontSize());
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float size = ImGui::GetTextLineHeight();
  ImGui::GetWindowDrawList()->AddRectFilled(
      at, {at.x + size, at.y + size},
      rgba(unsigned{value[0]} << 16 | unsigned{value[1]} << 8 | value[2]), 3);
  ImGui::Dummy({size, size});
  ImGui::SameLine();
  ImGui::TextUnformatted(fmt::format("{} {} {}", value[0], value[1], value[2]).c_str());
}

void build_answers(Session& session) {
  const PixelReadout& readout = session.readout;
  ImGui::PushFont(ImGui::GetIO().Fonts->Fonts[1]);
  if (session.mine.exists()) {
    ImGui::TextDisabled("why mine differs from %s:", traces_paths(session)        ? "the truth"
                                                     : session.reference.exists() ? "the reference"
                                                                                  : "ours");
    build_lines(session, cause_text(session));
    ImGui::Spacing();
  }
  build_lines(session, readout.terms.empty() ? "computing ..." : readout.terms);
  ImGui::PopFont();
}

}  // namespace

void paint_mark(const Session& session, const GuiFrame& frame) {
  const Box whole = whole_picture(session, session.picture);
  const glm::dvec2 at = whole.at + *session.readout.at * whole.size;
  if (!session.picture.holds(at)) {
    return;
  }
  ImDrawList& draw = *ImGui::GetBackgroundDrawList();
  const auto radius = static_cast<float>(7 * frame.scale);
  draw.AddCircle(vec(at), radius, rgba(0x000000, 180), 24, static_cast<float>(3 * frame.scale));
  draw.AddCircle(vec(at), radius, rgba(color_accent), 24, static_cast<float>(1.5 * frame.scale));
}

void build_readout(Session& session) {
  const PixelReadout& readout = session.readout;
  if (!readout.at) {
    ImGui::TextUnformatted("pixel");
  } else {
    const std::string title = fmt::format("pixel {}, {} of {} x {}", readout.pixel.x,
                                          readout.pixel.y, readout.size.x, readout.size.y);
    const float buttons = 6.5F * ImGui::GetFontSize();
    ImGui::TextUnformatted(fitting(title, ImGui::GetContentRegionAvail().x - buttons).c_str());
    ImGui::SameLine();
    if (ImGui::SmallButton("Copy")) {
      perform(session, Action::copy);
    }
  }
  ImGui::SameLine(ImGui::GetWindowWidth() - 2.2F * ImGui::GetFontSize());
  if (ImGui::SmallButton("x")) {
    perform(session, Action::explain);
    return;
  }
  if (!readout.at) {
    ImGui::TextWrapped("%s", "Click into the picture to see how the color of a pixel is computed.");
    return;
  }
  for (const Role role : {Role::ours, Role::reference, Role::mine}) {
    if (const auto& value = readout.values[static_cast<std::size_t>(role)]) {
      build_swatch(role_word(role).data(), *value);
    }
  }
  if (sides_of(session) != Sides() && !is_comparable(session)) {
    ImGui::TextDisabled("not compared: this is not the scene's camera (Home)");
  }
  ImGui::Spacing();
  build_answers(session);
}

}  // namespace scenefile::viewer
