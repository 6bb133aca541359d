// The panel that opens scenes: recent files on the left, a folder with thumbnails on the right.

#include "scenefile/base/text.h"
#include "scenefile/io/folder.h"
#include "scenefile/viewer/gui.h"
#include "scenefile/viewer/gui_colors.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cstdlib>

namespace scenefile::viewer {

namespace {

constexpr ImGuiWindowFlags panel_flags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                         ImGuiWindowFlags_NoSavedSettings |
                                         ImGuiWindowFlags_NoBringToFrontOnFocus;

void heading(const char* text) {
  ImGui::PushStyleColor(ImGuiCol_Text, rgba(color_accent));
  ImGui::TextUnformatted(text);
  ImGui::PopStyleColor();
}

/// The picture of a scene with its name below, which can be clicked.
class Tile {
 public:
  Tile(Session& session, const GuiFrame& frame) : session_(session), frame_(frame) {}

  glm::dvec2 picture_size() const {
    return glm::dvec2(thumbnail_width, thumbnail_height) * frame_.scale;
  }
  float width() const { return static_cast<float>(picture_size().x + 2 * margin()); }

  // Returns true if it was clicked.
  bool build(const Choice& choice) const {
    ImGui::PushID(choice.path.c_str());
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float height =
        static_cast<float>(picture_size().y + 3 * margin()) + ImGui::GetTextLineHeight();
    const bool clicked = ImGui::Selectable("##tile", false, 0, {width(), height});
    if (ImGui::IsItemVisible()) {
      paint(choice, at);
    }
    if (ImGui::IsItemHovered()) {
      ImGui::SetTooltip("%s", hint(choice).c_str());
    }
    ImGui::PopID();
    return clicked;
  }

 private:
  double margin() const { return 6 * frame_.scale; }

  std::string hint(const Choice& choice) const {
    const Thumbnail* const thumbnail =
        choice.kind == ChoiceKind::scene ? session_.thumbnails.find(choice.path) : nullptr;
    const std::string name = escaped(choice.path, 400);
    return thumbnail == nullptr || thumbnail->wrong.empty()
               ? name
               : fmt::format("{}\n{}", name, escaped(thumbnail->wrong, 300));
  }

  void paint(const Choice& choice, const ImVec2& at) const {
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const glm::dvec2 begin = glm::dvec2(at.x, at.y) + margin();
    const glm::dvec2 end = begin + picture_size();
    draw.AddRectFilled(vec(begin), vec(end), rgba(0x141518), 3);
    paint_picture(choice, begin, end);
    draw.AddText(vec({begin.x, end.y + margin()}), rgba(color_text),
                 fitting(escaped(choice.name, 200), static_cast<float>(picture_size().x)).c_str());
  }

  void paint_picture(const Choice& choice, const glm::dvec2& begin, const glm::dvec2& end) const {
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const Thumbnail* const thumbnail = session_.thumbnails.find(choice.path);
    const unsigned name = frame_.thumbnail(choice.path);
    if (thumbnail != nullptr && thumbnail->wrong.empty() && name != 0) {
      draw.AddImage(reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(name)), vec(begin),
                    vec(end));
      return;
    }
    const bool wrong = thumbnail != nullptr && !thumbnail->wrong.empty();
    const std::string text = fitting(wrong ? escaped(thumbnail->wrong, 100) : "...",
                                     static_cast<float>(picture_size().x));
    const ImVec2 size = ImGui::CalcTextSize(text.c_str());
    draw.AddText(vec((begin + end - glm::dvec2(size.x, size.y)) * 0.5),
                 rgba(wrong ? color_warning : color_dim), text.c_str());
  }

  Session& session_;
  const GuiFrame& frame_;
};

// Returns the chosen path; empty: none.
std::string build_recent(const Session& session) {
  std::string chosen;
  heading("Recent files");
  if (session.start.recent.empty()) {
    ImGui::TextDisabled("%s", "none yet");
  }
  for (const std::string& path : session.start.recent) {
    ImGui::PushID(path.c_str());
    const float room = ImGui::GetContentRegionAvail().x;
    if (ImGui::Selectable(fitting(escaped(file_name_of(path), 200), room).c_str())) {
      chosen = path;
    }
    if (ImGui::IsItemHovered()) {
      ImGui::SetTooltip("%s", escaped(path, 400).c_str());
    }
    ImGui::TextDisabled("%s", fitting("  " + escaped(folder_of(path), 400), room).c_str());
    ImGui::PopID();
  }
  return chosen;
}

// A field for a path, in which Enter opens it.
std::string build_field(StartPanel& panel) {
  std::array<char, 4096> text{};
  panel.typed.copy(text.data(), text.size() - 1);
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x);
  if (panel.appears) {
    panel.appears = false;
    ImGui::SetKeyboardFocusHere();  // what is typed is for the field
  }
  const bool entered = ImGui::InputTextWithHint("##path", "type a path, and Enter", text.data(),
                                                text.size(), ImGuiInputTextFlags_EnterReturnsTrue);
  panel.typed = text.data();
  return entered && !panel.typed.empty() ? typed_path(panel, std::getenv("HOME")) : std::string();
}

std::string build_tiles(Session& session, const GuiFrame& frame) {
  const Tile tile(session, frame);
  const float right = ImGui::GetCursorScreenPos().x + ImGui::GetContentRegionAvail().x;
  std::string chosen;
  float next = 0;  // where the next tile would end
  for (const Choice& choice : session.start.choices) {
    if (choice.kind != ChoiceKind::scene) {
      continue;
    }
    if (next != 0 && next < right) {
      ImGui::SameLine();
    }
    if (tile.build(choice)) {
      chosen = choice.path;
    }
    next = ImGui::GetItemRectMax().x + ImGui::GetStyle().ItemSpacing.x + tile.width();
  }
  return chosen;
}

std::string build_lines(const StartPanel& panel, ChoiceKind kind) {
  std::string chosen;
  for (const Choice& choice : panel.choices) {
    if (choice.kind == kind) {
      ImGui::PushID(choice.path.c_str());
      const std::string name =
          escaped(choice.name, 200) + (kind == ChoiceKind::folder ? "/" : "  (to compare with)");
      if (ImGui::Selectable(name.c_str())) {
        chosen = choice.path;
      }
      ImGui::PopID();
    }
  }
  return chosen;
}

std::string build_folder(Session& session, const GuiFrame& frame) {
  StartPanel& panel = session.start;
  heading("Folder");
  ImGui::SameLine();
  ImGui::TextUnformatted(
      fitting(escaped(panel.folder, 400), ImGui::GetContentRegionAvail().x).c_str());
  std::string chosen = build_field(panel);
  ImGui::BeginChild("choices");
  if (ImGui::Selectable("../")) {
    chosen = folder_of(panel.folder);
  }
  for (const std::string& path :
       {build_lines(panel, ChoiceKind::folder), build_tiles(session, frame),
        build_lines(panel, ChoiceKind::picture)}) {
    chosen = path.empty() ? chosen : path;
  }
  if (panel.choices.empty()) {
    ImGui::TextDisabled("%s", "there are no scenes here");
  } else if (panel.cut_off) {
    ImGui::TextDisabled("%s", fmt::format("only the first {} are listed", max_choices).c_str());
  }
  ImGui::EndChild();
  return chosen;
}

// What is wrong with the last choice, shown next to it.
void build_news(const Session& session) {
  if (session.loading.busy()) {
    ImGui::TextDisabled("%s", ("reading " + escaped(scene_name(session), 200)).c_str());
  } else if (session.broken != nullptr) {
    ImGui::PushStyleColor(ImGuiCol_Text, rgba(color_error));
    const OpenedScene& opened = session.broken->opened;
    ImGui::TextWrapped("%s",
                       escaped(opened.unreadable.empty()
                                   ? scene_name(session) + " has errors; they are listed below"
                                   : opened.unreadable,
                               400)
                           .c_str());
    ImGui::PopStyleColor();
  }
}

}  // namespace

void build_start(Session& session, const GuiFrame& frame, const Box& room) {
  ImGui::SetNextWindowPos(vec(room.at));
  ImGui::SetNextWindowSize(vec(room.size));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, vec(glm::dvec2(16, 12) * frame.scale));
  ImGui::Begin("##start", nullptr, panel_flags);
  ImGui::PopStyleVar();
  build_news(session);
  const auto left = static_cast<float>(std::min(260 * frame.scale, room.size.x * 0.4));
  ImGui::BeginChild("recent", {left, 0});
  std::string chosen = build_recent(session);
  ImGui::EndChild();
  ImGui::SameLine(0, static_cast<float>(16 * frame.scale));
  ImGui::BeginChild("folder");
  if (const std::string path = build_folder(session, frame); !path.empty()) {
    chosen = path;
  }
  ImGui::EndChild();
  ImGui::End();
  if (!chosen.empty()) {
    session.start.typed.clear();
    choose(session, chosen);
  }
}

}  // namespace scenefile::viewer
