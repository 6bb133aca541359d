// The findings about the file, with places and excerpts.

#include "scenefile/base/report.h"
#include "scenefile/base/text.h"
#include "scenefile/viewer/gui.h"
#include "scenefile/viewer/gui_colors.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <string_view>
#include <vector>

namespace scenefile::viewer {

namespace {

unsigned color_of(Severity severity) {
  switch (severity) {
    case Severity::error:
      return color_error;
    case Severity::warning:
      return color_warning;
    case Severity::note:
      return color_dim;
  }
  return color_text;
}

// The line of the file. Tabs count as one column, so they are drawn as one space.
std::string line_of(std::string_view text, std::uint32_t line) {
  for (; line > 1; --line) {
    text.remove_prefix(std::min(text.find('\n'), text.size()));
    text.remove_prefix(text.empty() ? 0 : 1);
  }
  std::string result(text.substr(0, text.find('\n')));
  std::replace(result.begin(), result.end(), '\t', ' ');
  return result;
}

// Leaves the line only if too little of it is left for text.
void continue_line() {
  ImGui::SameLine();
  if (ImGui::GetContentRegionAvail().x < 15 * ImGui::GetFontSize()) {
    ImGui::NewLine();
  }
}

void build_excerpt(const std::string& text, const Location& location) {
  constexpr std::size_t most = 160;
  const std::string line = line_of(text, location.line);
  const std::size_t blanks = std::min(line.find_first_not_of(' '), line.size());
  if (blanks == line.size() || location.column <= blanks || location.column > most) {
    return;
  }
  ImGui::PushFont(ImGui::GetIO().Fonts->Fonts[1]);
  ImGui::PushTextWrapPos(-1);
  ImGui::Indent(ImGui::GetFontSize());
  colored_text(color_dim, escaped(line.substr(blanks), most));
  colored_text(color_accent, std::string(location.column - 1 - blanks, ' ') + "^");
  ImGui::Unindent(ImGui::GetFontSize());
  ImGui::PopTextWrapPos();
  ImGui::PopFont();
}

void build_finding(const OpenedScene& scene, const Diagnostic& finding, bool excerpt) {
  const std::string file = finding.file.empty() ? scene.path : finding.file;
  std::string place = escaped(file_name_of(file), 80);
  if (finding.location.known()) {
    place += fmt::format(":{}:{}", finding.location.line, finding.location.column);
  }
  colored_text(color_of(finding.severity), place);
  continue_line();
  ImGui::TextUnformatted(escaped(finding.message, 600).c_str());
  for (const std::string& note : finding.notes) {
    ImGui::TextDisabled("    %s", escaped(note, 600).c_str());
  }
  if (ImGui::IsItemHovered()) {
    ImGui::SetTooltip("%s", std::string(finding.code->help).c_str());
  }
  if (excerpt && finding.file.empty() && finding.location.known()) {
    build_excerpt(scene.text, finding.location);
  }
}

void build_heading(const Session& session) {
  const SceneOnShow& scene = session.broken != nullptr ? *session.broken : *session.shown;
  const std::string verdict = scene.opened.unreadable.empty()
                                  ? verdict_text(scene.opened.diagnostics, scene_name(session))
                                  : scene.opened.unreadable;
  const std::vector<Diagnostic>& found = scene.opened.diagnostics.list();
  if (session.broken == nullptr && found.empty()) {
    return;
  }
  colored_text(session.broken == nullptr ? color_dim : color_error, escaped(verdict, 400));
  std::string aside;
  if (session.broken != nullptr && session.shown != nullptr) {
    aside = session.shown->opened.path == session.path
                ? "the picture is of the last good version"
                : "the picture still shows " + escaped(shown_name(session), 80);
  }
  if (std::any_of(found.begin(), found.end(),
                  [](const Diagnostic& one) { return one.correction.has_value(); })) {
    aside += (aside.empty() ? "" : "; ") + std::string("Ctrl+E corrects what is certain");
  }
  if (!aside.empty()) {
    continue_line();
    dim_text(aside);
  }
}

}  // namespace

void build_messages(const Session& session) {
  ImGui::PushTextWrapPos(0);
  build_heading(session);
  const OpenedScene& opened =
      session.broken != nullptr ? session.broken->opened : session.shown->opened;
  int excerpts = session.broken != nullptr ? 3 : 0;
  for (const Diagnostic* finding : by_place(opened.diagnostics)) {
    build_finding(opened, *finding, excerpts > 0 && finding->severity == Severity::error);
    excerpts -= finding->severity == Severity::error ? 1 : 0;
  }
  for (const std::string& note : session.drawing_notes) {
    ImGui::TextDisabled("%s", escaped(note, 400).c_str());
  }
  ImGui::PopTextWrapPos();
}

}  // namespace scenefile::viewer
