// The outline: the scene graph and the selection.

#include "scenefile/base/shape_traits.h"
#include "scenefile/base/text.h"
#include "scenefile/viewer/gui.h"
#include "scenefile/viewer/gui_colors.h"

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <cmath>

namespace scenefile::viewer {

namespace {

/// Draws one row; sizes are relative to the text height.
class RowPainter {
 public:
  RowPainter(Session& session, std::uint32_t row)
      : session_(session),
        scene_(*session.shown),
        index_(row),
        row_(scene_.outline.rows[row]),
        height_(ImGui::GetTextLineHeight()) {}

  void build() {
    ImGui::PushID(static_cast<int>(index_));
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x;
    const bool selected = session_.selected == index_;
    const bool clicked = ImGui::Selectable("##row", selected, ImGuiSelectableFlags_AllowItemOverlap,
                                           {width, height_ + 2});
    hovered_ = ImGui::IsItemHovered();
    if (selected && session_.reveal_selected) {
      ImGui::SetScrollHereY(0.4F);
      session_.reveal_selected = false;
    }
    react(clicked, at, width);
    paint(at, width);
    ImGui::PopID();
  }

 private:
  bool holds_rows() const { return row_.end > index_ + 1; }
  float indent() const { return static_cast<float>(row_.depth) * height_ * 0.8F; }
  float arrow_end() const { return indent() + height_ * 1.1F; }

  void toggle_open() {
    if (!session_.open_rows.erase(index_)) {
      session_.open_rows.insert(index_);
    }
  }

  void react(bool clicked, const ImVec2& at, float width) {
    const bool twice = hovered_ && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left);
    const bool on_arrow = clicked && ImGui::GetIO().MousePos.x < at.x + arrow_end();
    if ((twice || on_arrow) && holds_rows()) {
      toggle_open();
    } else if (clicked && ImGui::GetIO().MousePos.x < at.x + width - height_ * 1.3F) {
      select(session_, index_);
      session_.reveal_selected = false;
    }
  }

  void paint(const ImVec2& at, float width) {
    hidden_ = is_hidden(session_, index_);
    const float y = at.y + 1;
    if (holds_rows()) {
      paint_arrow({at.x + indent() + height_ * 0.4F, y + height_ * 0.5F});
    }
    paint_icon({at.x + arrow_end() + height_ * 0.4F, y + height_ * 0.52F});
    const float text_x = at.x + arrow_end() + height_ * 1.05F;
    const float right = paint_right(at, width, y);
    paint_text(text_x, y, right);
  }

  void paint_arrow(const ImVec2& c) const {
    const float r = height_ * 0.24F;
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    if (session_.open_rows.contains(index_)) {
      draw.AddTriangleFilled({c.x - r, c.y - r * 0.6F}, {c.x + r, c.y - r * 0.6F},
                             {c.x, c.y + r * 0.8F}, rgba(color_dim));
    } else {
      draw.AddTriangleFilled({c.x - r * 0.6F, c.y - r}, {c.x + r * 0.8F, c.y},
                             {c.x - r * 0.6F, c.y + r}, rgba(color_dim));
    }
  }

  ImU32 material_color() const {
    if (row_.source == no_index) {
      return rgba(color_dim);
    }
    const glm::vec3& c = scene_.colors[row_.source];
    return ImGui::ColorConvertFloat4ToU32({c.r, c.g, c.b, 1});
  }

  Shape shape() const {
    const auto* const found = std::find(shape_words.begin(), shape_words.end(), row_.label);
    return found == shape_words.end() ? Shape::mesh
                                      : static_cast<Shape>(found - shape_words.begin());
  }

  void paint_shape(const ImVec2& c, float r, ImU32 color) const {
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    switch (shape()) {
      case Shape::sphere:
        draw.AddCircleFilled(c, r, color, 20);
        break;
      case Shape::cube:
        draw.AddRectFilled({c.x - r * 0.9F, c.y - r * 0.9F}, {c.x + r * 0.9F, c.y + r * 0.9F},
                           color, 1);
        break;
      case Shape::cone:
        draw.AddTriangleFilled({c.x, c.y - r}, {c.x - r, c.y + r}, {c.x + r, c.y + r}, color);
        break;
      case Shape::cylinder:
        draw.AddRectFilled({c.x - r * 0.65F, c.y - r}, {c.x + r * 0.65F, c.y + r}, color, r * 0.5F);
        break;
      case Shape::mesh:
        draw.AddQuadFilled({c.x, c.y - r}, {c.x + r, c.y}, {c.x, c.y + r}, {c.x - r, c.y}, color);
        break;
    }
  }

  void paint_icon(const ImVec2& c) const {
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const float r = height_ * 0.32F;
    const float thin = 0.2F * r;
    const ImU32 line = rgba(color_dim);
    switch (row_.kind) {
      case RowKind::primitive:
        paint_shape(c, r + thin, line);  // a rim, for colors as dark as the panel
        paint_shape(c, r, material_color());
        break;
      case RowKind::light:
        draw.AddCircleFilled(c, r * 0.6F, rgba(color_light), 16);
        for (int i = 0; i < 8; ++i) {
          const float a = static_cast<float>(i) * 0.785398F;
          const ImVec2 d{std::cos(a), std::sin(a)};
          draw.AddLine({c.x + d.x * r * 0.85F, c.y + d.y * r * 0.85F},
                       {c.x + d.x * r * 1.3F, c.y + d.y * r * 1.3F}, rgba(color_light), thin);
        }
        break;
      case RowKind::camera:
        draw.AddRectFilled({c.x - r, c.y - r * 0.6F}, {c.x + r * 0.3F, c.y + r * 0.6F}, line, 1);
        draw.AddTriangleFilled({c.x + r * 0.2F, c.y}, {c.x + r, c.y - r * 0.6F},
                               {c.x + r, c.y + r * 0.6F}, line);
        break;
      case RowKind::globals:
        for (const float y : {-0.7F, 0.0F, 0.7F}) {
          draw.AddLine({c.x - r, c.y + r * y}, {c.x + r, c.y + r * y}, line, 1.5F * thin);
        }
        break;
      case RowKind::copy:
        draw.AddRect({c.x - r, c.y - r}, {c.x + r * 0.4F, c.y + r * 0.4F}, line, thin, 0, thin);
        draw.AddRectFilled({c.x - r * 0.4F, c.y - r * 0.4F}, {c.x + r, c.y + r}, line, 1);
        break;
      case RowKind::group:
      case RowKind::templates:
        draw.AddRect({c.x - r, c.y - r * 0.8F}, {c.x + r, c.y + r * 0.8F}, line, 2 * thin, 0, thin);
        break;
    }
  }

  // Draws the line number and the visibility switch; returns their left edge.
  float paint_right(const ImVec2& at, float width, float y) {
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    float x = at.x + width - height_ * 1.2F;
    if (has_sources(scene_.outline, index_)) {
      paint_switch({x + height_ * 0.6F, y + height_ * 0.52F});
    }
    if (row_.location.known()) {
      const std::string line = fmt::format("{}", row_.location.line);
      x -= ImGui::CalcTextSize(line.c_str()).x + height_ * 0.3F;
      draw.AddText({x, y}, rgba(color_dim, 150), line.c_str());
    }
    return x - height_ * 0.4F;
  }

  void paint_switch(const ImVec2& c) {
    const float r = height_ * 0.26F;
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const bool over = hovered_ && std::abs(mouse.x - c.x) < height_ * 0.7F;
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const ImU32 color = rgba(over ? color_accent : color_dim, hidden_ || over ? 255 : 130);
    if (hidden_) {
      draw.AddCircle(c, r, color, 16, 1.3F);
    } else {
      draw.AddCircleFilled(c, r, color, 16);
    }
    if (over) {
      ImGui::SetTooltip(hidden_ ? "show" : "hide");
      if (ImGui::IsMouseReleased(ImGuiMouseButton_Left)) {
        toggle_hidden(session_, index_);
      }
    }
  }

  // Whether the row is hidden, or is a light that is off because another is shown alone.
  bool is_faint() const {
    const std::vector<RenderLight>& lights = scene_.opened.ready.scene.lights;
    return hidden_ || (row_.kind == RowKind::light && session_.only_light &&
                       lights[*session_.only_light].source != row_.source);
  }

  void paint_text(float x, float y, float right) const {
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const bool faint = is_faint();
    const std::string label = fitting(escaped(row_.label, 80), right - x);
    draw.AddText({x, y}, rgba(color_text, faint ? 110 : 255), label.c_str());
    const float after = x + ImGui::CalcTextSize(label.c_str()).x + height_ * 0.5F;
    const std::string detail = fitting(escaped(row_.detail, 80), right - after);
    draw.AddText({after, y}, rgba(color_dim, faint ? 90 : 220), detail.c_str());
  }

  Session& session_;
  const SceneOnShow& scene_;
  std::uint32_t index_;
  const OutlineRow& row_;
  float height_;
  bool hovered_ = false;
  bool hidden_ = false;
};

// The clipper skips invisible rows, but must not skip the row to scroll to.
void scroll_to_selected(Session& session, const std::vector<std::uint32_t>& rows,
                        float row_height) {
  if (!session.reveal_selected || !session.selected) {
    return;
  }
  const auto found = std::find(rows.begin(), rows.end(), *session.selected);
  if (found != rows.end()) {
    const float y = static_cast<float>(found - rows.begin()) * row_height;
    const float top = ImGui::GetScrollY();
    const float height = ImGui::GetWindowHeight();
    if (y < top || y + row_height > top + height) {
      ImGui::SetScrollY(std::max(0.0F, y - height * 0.4F));
    }
  }
  session.reveal_selected = false;
}

void build_rows(Session& session) {
  const std::vector<std::uint32_t>& rows = visible_rows(session);
  const float row_height = ImGui::GetTextLineHeight() + 2 + ImGui::GetStyle().ItemSpacing.y;
  scroll_to_selected(session, rows, row_height);
  ImGuiListClipper clipper;
  clipper.Begin(static_cast<int>(rows.size()), row_height);
  while (clipper.Step()) {
    for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
      RowPainter(session, rows[static_cast<std::size_t>(i)]).build();
    }
  }
}

}  // namespace

void build_outline(Session& session) {
  const float room = ImGui::GetContentRegionAvail().y;
  const float object = session.selected
                           ? std::floor(0.6F * room)
                           : ImGui::GetFrameHeight() + 2 * ImGui::GetStyle().ItemSpacing.y;
  ImGui::BeginChild("rows", {0, -object});
  build_rows(session);
  ImGui::EndChild();
  ImGui::Separator();
  const bool enters = session.keyboard_in_fields && !session.keyboard_was_in_fields;
  session.keyboard_was_in_fields = session.keyboard_in_fields;
  if (enters) {
    ImGui::SetNextWindowFocus();
  }
  ImGui::BeginChild("selected");
  if (enters) {
    ImGui::NavInitWindow(ImGui::GetCurrentWindow(), true);
    ImGui::GetCurrentContext()->NavDisableHighlight = false;
  }
  if (session.selected) {
    build_object(session);
  } else {
    build_no_object(session);
  }
  ImGui::EndChild();
}

}  // namespace scenefile::viewer
