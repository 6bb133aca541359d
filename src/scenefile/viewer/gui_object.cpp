// The fields of the selection, and questions.

#include "scenefile/base/number.h"
#include "scenefile/base/text.h"
#include "scenefile/viewer/files_to_choose.h"
#include "scenefile/viewer/gui.h"
#include "scenefile/viewer/gui_colors.h"

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_internal.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <array>
#include <cfloat>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace scenefile::viewer {

namespace {

using Typed = std::vector<std::optional<std::string>>;

// Between widgets side by side.
float gap() {
  return 0.5F * ImGui::GetStyle().ItemSpacing.x;
}

constexpr int float_digits = std::numeric_limits<float>::max_digits10;

bool same_float(double a, double b) {
  return static_cast<float>(a) == static_cast<float>(b);
}

// How much a number changes per pixel that it is dragged. A drag over the panel's width crosses the
// colors from 0 to 1 or a range of angles, and doubles other numbers, whatever their size; near 0,
// where nothing tells their size, it changes them by a few units.
float drag_speed(const FieldPart& part, ValueKind kind, double value) {
  constexpr double drag = 400;  // pixels
  if (kind == ValueKind::color) {
    return static_cast<float>(1 / drag);
  }
  const NumberRange& range = part.range;
  if (std::isfinite(range.low) && std::isfinite(range.high) && range.high <= 360) {
    return static_cast<float>((range.high - range.low) / drag);
  }
  return static_cast<float>(std::max(4.0, std::abs(value)) / drag);
}

// The files of the scene's folder. Returns the one that was chosen; empty: none.
std::string build_files(const Session& session, FileUse use, const std::string& now) {
  std::string chosen;
  const std::vector<std::string> files = files_to_choose(session.path, use);
  if (files.empty()) {
    ImGui::TextDisabled("none in the scene's folder: put %s there",
                        use == FileUse::mesh ? "an .obj file" : "an image");
  }
  for (const std::string& file : files) {
    if (ImGui::MenuItem(escaped(file, 200).c_str(), nullptr, file == now)) {
      chosen = file;
    }
  }
  return chosen;
}

FileUse use_of(const FieldView& field) {
  return field.name == "filename" || field.name == "meshFile" ? FileUse::mesh : FileUse::image;
}

// A menu entry for something that needs a file, which is chosen from a list.
bool build_menu_of_files(const Session& session, const char* title, FileUse use,
                         std::string& file) {
  file.clear();
  if (ImGui::BeginMenu(title)) {
    file = build_files(session, use, {});
    ImGui::EndMenu();
  }
  return !file.empty();
}

/// The widgets of one field. An edit of the selected item begins with the first change and ends
/// when no widget is active.
class FieldRow {
 public:
  /// `label`: the width of the titles.
  FieldRow(Session& session, const FieldView& field, std::size_t index, float label)
      : session_(session), field_(field), index_(index), label_(label) {}

  void build() {
    ImGui::PushID(static_cast<int>(index_));
    ImGui::AlignTextToFramePadding();
    const std::string title = fitting(std::string(field_.title), label_ - gap());
    if (field_.effective) {
      ImGui::TextUnformatted(title.c_str());
    } else {
      dim_text(title);
    }
    if (ImGui::IsItemHovered()) {
      ImGui::SetTooltip("%s (%s)%s", std::string(field_.title).c_str(),
                        std::string(field_.name).c_str(),
                        field_.effective ? "" : ": has no effect on this type of light");
    }
    ImGui::SameLine(label_);
    const bool removable = field_.written && !field_.needed;
    const float cross = removable ? ImGui::GetFrameHeight() + gap() : 0;
    width_ = ImGui::GetContentRegionAvail().x - cross;
    build_value();
    if (removable) {
      ImGui::SameLine(0, gap());
      build_remove();
    }
    ImGui::PopID();
  }

 private:
  void build_value() {
    const float left = ImGui::GetCursorPosX();
    switch (field_.kind) {
      case ValueKind::color:
        build_color();
        break;
      case ValueKind::choice:
        build_choice();
        break;
      case ValueKind::text:
      case ValueKind::id:
        build_text(width_);
        break;
      case ValueKind::file:
        build_file();
        break;
      case ValueKind::image:
        build_file();
        ImGui::SetCursorPosX(left);
        build_numbers(1, 2);
        break;
      case ValueKind::matrix:
        for (std::size_t row = 0; row < 4; ++row) {
          build_numbers(4 * row, 4);
        }
        break;
      case ValueKind::number:
      case ValueKind::vector:
      case ValueKind::coefficients:
      case ValueKind::rotation:
        build_numbers(0, field_.parts.size());
        break;
    }
  }

  // Sets some parts of the field, as part of an edit in several steps by the widget of that number.
  // Parts that have the value from before keep their spelling. What is not accepted changes nothing
  // if it was dragged, and brings the value from before back if it was typed (`is_typed`).
  void change(Typed typed, std::size_t widget = 0, bool is_typed = false) {
    constexpr std::size_t most_parts = 16;
    const EditInProgress* const edit =
        begin_edit(session_, static_cast<int>(index_ * most_parts + widget));
    if (edit == nullptr) {
      return;
    }
    const std::vector<FieldView> fields = edit->before.fields(edit->item);
    if (index_ >= fields.size()) {
      return;
    }
    const FieldView& before = fields[index_];
    for (std::size_t i = 0; i < before.parts.size(); ++i) {
      const FieldPart& part = before.parts[i];
      if (typed[i] && part.is_number) {
        const ParsedNumber now = parse_number(*typed[i]);
        if (now.error == NumberError::none && same_float(now.value, number_of(part))) {
          typed[i].reset();
        }
      }
    }
    const bool none = std::none_of(typed.begin(), typed.end(),
                                   [](const auto& value) { return value.has_value(); });
    const Result<Edit> made =
        none ? Edit{} : edit_of_field(session_, edit->before, edit->item, before, typed);
    if (made || !is_typed) {
      continue_edit(session_, made);
      return;
    }
    continue_edit(session_, Edit{});
    if (ImGui::IsItemDeactivated()) {  // until then, it may be the start of a number
      say(session_, made.error().text, true);
    }
  }

  Typed only(std::size_t part, std::string value) const {
    Typed typed(field_.parts.size());
    typed[part] = std::move(value);
    return typed;
  }

  // Dear ImGui starts typing with the digits that the widget shows. Therefore it gets all digits of
  // a float, and the fewer ones that are shown are painted over it.
  void build_number(std::size_t i, int digits) {
    const FieldPart& part = field_.parts[i];
    const ImGuiID id = ImGui::GetID("##number");
    if (ImGui::TempInputIsActive(id)) {
      std::string text = part.value;
      if (ImGui::InputText("##number", &text)) {
        std::replace(text.begin(), text.end(), ',', '.');
        change(only(i, text), i, true);
      }
      return;
    }
    double value = number_of(part);
    const double low = std::isfinite(part.range.low) ? part.range.low : -1e30;
    const double high = std::isfinite(part.range.high) ? part.range.high : 1e30;
    const bool is_dragged = ImGui::GetActiveID() == id &&
                            ImGui::IsMouseDragging(0, 0.5F * ImGui::GetIO().MouseDragThreshold);
    const std::string format = fmt::format("%.{}g", is_dragged ? digits : float_digits);
    ImGui::PushStyleColor(ImGuiCol_Text, 0U);
    if (ImGui::DragScalar("##number", ImGuiDataType_Double, &value,
                          drag_speed(part, field_.kind, value), &low, &high, format.c_str())) {
      change(only(i, fmt::format("{:.6g}", value)), i);
    }
    ImGui::PopStyleColor();
    if (!ImGui::TempInputIsActive(id)) {
      ImGui::RenderTextClipped(ImGui::GetItemRectMin(), ImGui::GetItemRectMax(),
                               fmt::format("{:.{}g}", value, digits).c_str(), nullptr, nullptr,
                               {0.5F, 0.5F});
    }
  }

  // Parts [first, first + count), side by side.
  void build_numbers(std::size_t first, std::size_t count) {
    const auto parts = static_cast<float>(count);
    const float each = std::floor((width_ - gap() * (parts - 1)) / parts);
    const float left = ImGui::GetCursorPosX();
    for (std::size_t i = first; i < std::min(first + count, field_.parts.size()); ++i) {
      const FieldPart& part = field_.parts[i];
      ImGui::PushID(static_cast<int>(i));
      ImGui::SetNextItemWidth(each);
      build_number(i, count > 3 || field_.kind == ValueKind::color ? 3 : 5);
      if (ImGui::IsItemHovered() && !ImGui::IsAnyItemActive() && field_.parts.size() > 1) {
        ImGui::SetTooltip("%s: %s", std::string(part.name).c_str(), escaped(part.value).c_str());
      }
      ImGui::PopID();
      if (i + 1 < first + count) {
        ImGui::SameLine(0, gap());
      }
    }
    if (first + count < field_.parts.size()) {
      ImGui::Dummy({0, 0});
      ImGui::SameLine(left);
    }
  }

  void build_color() {
    std::array<float, 3> color{};
    for (std::size_t i = 0; i < 3; ++i) {
      color[i] = static_cast<float>(number_of(field_.parts[i]));
    }
    width_ -= ImGui::GetFrameHeight() + gap();
    build_numbers(0, 3);
    ImGui::SameLine(0, gap());
    if (ImGui::ColorEdit3("##color", color.data(),
                          ImGuiColorEditFlags_Float | ImGuiColorEditFlags_HDR |
                              ImGuiColorEditFlags_NoOptions | ImGuiColorEditFlags_NoInputs)) {
      Typed typed;
      for (std::size_t i = 0; i < 3; ++i) {
        const FieldPart& part = field_.parts[i];
        typed.emplace_back(same_float(color[i], number_of(part))
                               ? part.value
                               : fmt::format("{:.4g}", std::max(color[i], 0.0F)));
      }
      change(std::move(typed), color.size());
    }
  }

  void build_choice() {
    const std::string& now = field_.parts.front().value;
    ImGui::SetNextItemWidth(width_);
    if (ImGui::BeginCombo("##choice", escaped(now, 60).c_str())) {
      for (const std::string& choice : field_.choices) {
        const std::string title = escaped(choice, 60);
        std::string file;
        if (field_.title == "Shape" && choice == word_of(Shape::mesh) && choice != now) {
          if (build_menu_of_files(session_, title.c_str(), FileUse::mesh, file)) {
            change({choice, file});
          }
        } else if (ImGui::Selectable(title.c_str(), choice == now)) {
          change(only(0, choice));
        }
      }
      ImGui::EndCombo();
    }
  }

  void build_text(float width) {
    std::string text = field_.parts.front().value;
    ImGui::SetNextItemWidth(width);
    ImGui::InputText("##text", &text);
    if (ImGui::IsItemDeactivatedAfterEdit() && field_.parts.front().value != text) {
      change(only(0, text));
    }
  }

  void build_file() {
    const float button = ImGui::GetFrameHeight();
    build_text(width_ - button - gap());
    ImGui::SameLine(0, gap());
    if (ImGui::Button("...", {button, 0})) {
      ImGui::OpenPopup("files");
    }
    if (ImGui::IsItemHovered()) {
      ImGui::SetTooltip("%s", "choose a file of the scene's folder");
    }
    if (ImGui::BeginPopup("files")) {
      const std::string chosen = build_files(session_, use_of(field_), field_.parts.front().value);
      if (!chosen.empty()) {
        change(only(0, chosen));
      }
      ImGui::EndPopup();
    }
  }

  void build_remove() {
    const float size = ImGui::GetFrameHeight();
    const ImVec2 at = ImGui::GetCursorScreenPos();
    if (ImGui::InvisibleButton("remove", {size, size})) {
      if (const std::optional<ItemId> item = selected_item(session_)) {
        make_edit(session_, remove_value(*session_.editing.document, *item, field_));
      }
    }
    const bool over = ImGui::IsItemHovered();
    if (over) {
      ImGui::SetTooltip("%s", "remove it from the file");
    }
    const float r = size * 0.16F;
    const ImVec2 c{at.x + size / 2, at.y + size / 2};
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const ImU32 color = rgba(over || ImGui::IsItemFocused() ? color_text : color_dim);
    draw.AddLine({c.x - r, c.y - r}, {c.x + r, c.y + r}, color, 0.36F * r);
    draw.AddLine({c.x - r, c.y + r}, {c.x + r, c.y - r}, color, 0.36F * r);
  }

  Session& session_;
  const FieldView& field_;
  std::size_t index_;
  float label_;
  float width_ = 0;
};

// As wide as the longest title, but most of the panel is for values.
float label_width(const std::vector<FieldView>& fields) {
  float width = 0;
  for (const FieldView& field : fields) {
    if (field.written || field.name == "type") {  // is always shown
      width = std::max(width, ImGui::CalcTextSize(std::string(field.title).c_str()).x);
    }
  }
  return std::floor(std::min(width + 3 * gap(), 0.42F * ImGui::GetContentRegionAvail().x));
}

std::string title_of(const NewItem& what) {
  switch (what.kind) {
    case ItemKind::light:
      return what.name + " light";
    case ItemKind::instance:
      return "copy of " + what.name;
    case ItemKind::group:
      return "group";
    case ItemKind::globals:
      return "global data";
    case ItemKind::camera:
      return "camera";
    default:
      return what.name;
  }
}

void build_items_to_add(Session& session, const Document& document, std::optional<ItemId> item) {
  for (NewItem what : kinds_to_add(document, item)) {
    const std::string title = escaped(title_of(what), 80);
    const bool is_mesh = what.kind == ItemKind::primitive && what.name == word_of(Shape::mesh);
    if (is_mesh ? build_menu_of_files(session, title.c_str(), FileUse::mesh, what.file)
                : ImGui::MenuItem(title.c_str())) {
      make_edit(session, add_item(document, item, what, viewpoint_of(session)));
      session.keyboard_in_fields = false;
      return;  // the document has changed
    }
  }
}

// In XML an item may have several transforms of a kind.
void build_transforms_to_add(Session& session, const Document& document, ItemId item) {
  // A translation comes first, so that it is not scaled or turned.
  struct Transform {
    const char* title;
    std::string_view word;
    std::optional<std::size_t> before;
  };
  for (const auto& [title, word, before] :
       {Transform{"Translation", "translate", 0}, Transform{"Rotation", "rotate", std::nullopt},
        Transform{"Scale", "scale", std::nullopt}}) {
    if (ImGui::MenuItem(title)) {
      make_edit(session, add_transform(document, item, word, {}, before));
    }
  }
}

// Fields that the item can have and the file has not, transforms first.
void build_fields_to_add(Session& session, const Document& document, ItemId item,
                         const std::vector<FieldView>& fields) {
  const ItemKind kind = document[item].kind;
  if (document.is_xml() &&
      (kind == ItemKind::primitive || kind == ItemKind::instance || kind == ItemKind::group)) {
    build_transforms_to_add(session, document, item);
    ImGui::Separator();
  }
  for (const FieldView& field : fields) {
    if (field.written || (field.transform && document.is_xml())) {
      continue;
    }
    const std::string title(field.title);
    const bool has_file = field.kind == ValueKind::file || field.kind == ValueKind::image;
    std::string file;
    if (has_file ? build_menu_of_files(session, title.c_str(), use_of(field), file)
                 : ImGui::MenuItem(title.c_str())) {
      std::vector<std::optional<std::string>> start;
      for (const FieldPart& part : field.parts) {
        start.emplace_back(part.value);
      }
      start[0] = has_file ? file : start[0];
      make_edit(session, set_values(document, item, field, start));
      return;
    }
  }
}

// Opens the list of what can be added. Returns whether it is open.
bool build_add_button(Session& session) {
  if (ImGui::Button("Add...") || std::exchange(session.adding, false)) {
    ImGui::OpenPopup("add");
  }
  return ImGui::IsPopupOpen("add");
}

// Below the button; above it where there is more room.
void build_add_list(Session& session, const Document& document, std::optional<ItemId> item,
                    const std::vector<FieldView>& fields) {
  const ImVec2 from = ImGui::GetItemRectMin();
  const ImVec2 to = ImGui::GetItemRectMax();
  const float height = ImGui::GetMainViewport()->Size.y;
  const bool above = from.y > 0.6F * height;
  ImGui::SetNextWindowPos({from.x, above ? from.y : to.y}, 0, {0, above ? 1.0F : 0.0F});
  ImGui::SetNextWindowSizeConstraints({0, 0}, {FLT_MAX, above ? from.y : height - to.y});
  if (!ImGui::BeginPopup("add")) {
    return;
  }
  if (item && document[*item].kind != ItemKind::root && ImGui::BeginMenu("to this")) {
    build_fields_to_add(session, document, *item, fields);
    ImGui::EndMenu();
  }
  build_items_to_add(session, document, item);
  ImGui::EndPopup();
}

void build_button(Session& session, const char* label, Action action) {
  ImGui::SameLine(0, gap());
  if (ImGui::Button(label)) {
    perform(session, action);
  }
  if (ImGui::IsItemHovered()) {
    const ActionRow& row = row_of(action);
    ImGui::SetTooltip("%s (%s)", std::string(row.what).c_str(), std::string(row.key).c_str());
  }
}

// The switch of a light.
void build_light_switch(Session& session, std::uint32_t source) {
  const RenderScene& scene = session.shown->opened.ready.scene;
  const auto found = std::find_if(scene.lights.begin(), scene.lights.end(),
                                  [&](const RenderLight& l) { return l.source == source; });
  if (found == scene.lights.end()) {
    return;
  }
  const auto index = static_cast<std::uint32_t>(found - scene.lights.begin());
  bool alone = session.only_light == index;
  if (ImGui::Checkbox("only this light", &alone)) {
    show_only_light(session, alone ? std::optional(index) : std::nullopt);
  }
}

// What the handles in the picture do.
void build_handle_choice(Session& session) {
  static constexpr std::array<const char*, 4> names{"Move", "Turn", "Scale", "None"};
  ImGui::AlignTextToFramePadding();
  dim_text("Handles");
  for (std::size_t i = 0; i < names.size(); ++i) {
    const bool now = session.handles == static_cast<Handles>(i);
    ImGui::SameLine(0, gap() * (i == 0 ? 3.0F : 1.0F));
    ImGui::PushStyleColor(ImGuiCol_Button, rgba(now ? color_accent : color_field, now ? 120 : 255));
    if (ImGui::Button(names[i])) {
      session.handles = static_cast<Handles>(i);
    }
    ImGui::PopStyleColor();
  }
  if (session.handles != Handles::none && shows_edited_text(session) && !handles_of(session)) {
    ImGui::SameLine();
    dim_text("none here");
  }
}

void build_name(const Session& session, const OutlineRow& row) {
  const float room = 0.6F * ImGui::GetContentRegionAvail().x;
  ImGui::TextUnformatted(fitting(escaped(row.label, 200), room).c_str());
  if (row.location.known()) {
    ImGui::SameLine();
    ImGui::TextDisabled("%s:%u:%u", escaped(shown_name(session), 60).c_str(), row.location.line,
                        row.location.column);
  }
  // Always one line, so that the fields below stay where they are.
  const std::string path = escaped(session.selected_path, 300);
  dim_text(fitting(path, ImGui::GetContentRegionAvail().x));
  if (!path.empty() && ImGui::IsItemHovered()) {
    ImGui::SetTooltip("%s", path.c_str());
  }
}

// Ends an edit in several steps once the widget that made it is released.
void end_field_edit(Session& session) {
  if (session.editing.progress && !ImGui::IsAnyItemActive() &&
      session.pointer.drag != Drag::handle) {
    finish_edit(session);
  }
}

}  // namespace

void build_object(Session& session) {
  const OutlineRow row = session.shown->outline.rows[*session.selected];
  build_name(session, row);
  const std::optional<ItemId> item = selected_item(session);
  if (const std::string refusal = refusal_to_edit(session); !refusal.empty()) {
    ImGui::TextWrapped("%s", escaped("cannot be edited: " + refusal, 300).c_str());
    return;
  }
  if (!session.editing.document) {
    return;
  }
  const Document document = *session.editing.document;  // edits replace it
  const std::vector<FieldView> fields = item ? document.fields(*item) : std::vector<FieldView>();
  if (build_add_button(session)) {
    build_add_list(session, document, item, fields);
  }
  if (row.kind == RowKind::camera) {
    build_button(session, "Use this view", Action::use_view);
  } else if (item && document[*item].kind != ItemKind::globals &&
             document[*item].kind != ItemKind::root) {
    build_button(session, "Duplicate", Action::duplicate);
    build_button(session, "Group", Action::wrap);
    build_button(session, "Delete", Action::remove);
  }
  build_handle_choice(session);
  if (row.kind == RowKind::light) {
    build_light_switch(session, row.source);
  }
  ImGui::Spacing();
  ImGui::PushID(static_cast<int>(item.value_or(no_item)));
  const bool block = session.editing.part && session.editing.part->block;
  const float label = label_width(fields);
  for (std::size_t i = 0; i < fields.size(); ++i) {
    const bool type = fields[i].name == "type" && row.kind == RowKind::light;
    if ((fields[i].written || type) && (fields[i].transform || !block)) {
      FieldRow(session, fields[i], i, label).build();
    }
  }
  ImGui::PopID();
  end_field_edit(session);
}

void build_no_object(Session& session) {
  // Large scenes are only read as documents once they are edited.
  if (build_add_button(session)) {
    if (edited_document(session) != nullptr && refusal_to_edit(session).empty()) {
      const Document document = *session.editing.document;  // edits replace it
      build_add_list(session, document, std::nullopt, {});
    } else if (ImGui::BeginPopup("add")) {
      ImGui::TextDisabled("%s",
                          escaped("cannot be edited: " + refusal_to_edit(session), 300).c_str());
      ImGui::EndPopup();
    }
  }
  ImGui::SameLine();
  dim_text("click something to edit it");
}

void build_question(Session& session, const GuiFrame& frame) {
  const Question question = *session.question;
  const ImVec2 middle = ImGui::GetMainViewport()->GetCenter();
  ImGui::OpenPopup("##question");
  ImGui::SetNextWindowPos(middle, ImGuiCond_Always, {0.5F, 0.5F});
  ImGui::SetNextWindowSize(vec({460 * frame.scale, 0}));
  if (!ImGui::BeginPopupModal("##question", nullptr,
                              ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
                                  ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings)) {
    return;
  }
  ImGui::TextWrapped("%s", escaped(question.text, 300).c_str());
  ImGui::Spacing();
  std::optional<std::size_t> answer;
  if (question.path) {
    ImGui::SetNextItemWidth(-1);
    if (!ImGui::IsAnyItemActive()) {  // also after a path that was wrong
      ImGui::SetKeyboardFocusHere();
    }
    if (ImGui::InputText(
            "##path", &*session.question->path,
            ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll)) {
      answer = 0;
    }
    ImGui::Spacing();
  }
  for (std::size_t i = 0; i < question.answers.size(); ++i) {
    const bool last = i + 1 == question.answers.size();
    const std::string key = question.path ? (last ? "Esc" : "Enter")
                            : last        ? "Esc"
                                          : fmt::format("Ctrl+{}", i + 1);
    if (ImGui::Button(fmt::format("{}  ({})", question.answers[i].label, key).c_str())) {
      answer = i;
    }
    if (question.path && !last) {
      ImGui::SameLine();  // other answers are sentences, one below the other
    }
  }
  if (answer) {
    answer_question(session, *answer);
  }
  if (!session.question) {
    ImGui::CloseCurrentPopup();
  }
  ImGui::EndPopup();
}

}  // namespace scenefile::viewer
