// Overlays on the picture.

#include "scenefile/base/text.h"
#include "scenefile/view/helpers.h"
#include "scenefile/viewer/gui.h"
#include "scenefile/viewer/gui_colors.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace scenefile::viewer {

namespace {

// Text on a dark background, wrapped to lines of at most `room`; `anchor` is the position of the
// point in the text, from 0 to 1.
void paint_label(const glm::dvec2& at, const std::string& text, const glm::dvec2& anchor,
                 double scale, unsigned color = color_text, double room = 1e4) {
  ImDrawList& draw = *ImGui::GetBackgroundDrawList();
  const auto wrap = static_cast<float>(std::max(room - 18 * scale, 40.0));
  const ImVec2 size = ImGui::CalcTextSize(text.c_str(), nullptr, false, wrap);
  const glm::dvec2 padding = glm::dvec2(9, 5) * scale;
  const glm::dvec2 whole = glm::dvec2(size.x, size.y) + 2.0 * padding;
  const glm::dvec2 begin = glm::floor(at - anchor * whole);
  draw.AddRectFilled(vec(begin), vec(begin + whole), rgba(0x101114, 205),
                     static_cast<float>(6 * scale));
  draw.AddText(nullptr, 0, vec(begin + padding), rgba(color), text.c_str(), nullptr, wrap);
}

// Text at the bottom of all pictures. `above`: so many lines above the lowest one.
void paint_bottom_label(const Session& session, const GuiFrame& frame, const std::string& text,
                        unsigned color, double above = 0) {
  const glm::dvec2 begin = glm::min(session.picture.at, session.beside.at);
  const glm::dvec2 end =
      glm::max(session.picture.at + session.picture.size, session.beside.at + session.beside.size);
  const double up = 12 * frame.scale + above * ImGui::GetTextLineHeight();
  paint_label({(begin.x + end.x) / 2, end.y - up}, text, {0.5, 1}, frame.scale, color,
              end.x - begin.x);
}

void paint_split(const Session& session, const GuiFrame& frame) {
  const Box& box = session.picture;
  ImDrawList& draw = *ImGui::GetBackgroundDrawList();
  const double x = std::round(box.at.x + session.split * box.size.x);
  const double middle = box.at.y + box.size.y / 2;
  const auto s = static_cast<float>(frame.scale);
  draw.AddLine(vec({x, box.at.y}), vec({x, box.at.y + box.size.y}), rgba(0x000000, 140), 4 * s);
  draw.AddLine(vec({x, box.at.y}), vec({x, box.at.y + box.size.y}), rgba(0xffffff), 1.5F * s);
  draw.AddCircleFilled(vec({x, middle}), 11 * s, rgba(0xffffff), 24);
  for (const double side : {-1.0, 1.0}) {
    const double tip = x + side * 7.5 * frame.scale;
    const double back = x + side * 2.5 * frame.scale;
    draw.AddTriangleFilled(vec({tip, middle}), vec({back, middle - 4 * frame.scale}),
                           vec({back, middle + 4 * frame.scale}), rgba(0x222222));
  }
  const double top = box.at.y + 10 * frame.scale;
  const Sides sides = sides_of(session);
  const auto name = [&](Role role, double room) {
    return fitting(role_name(session, role), static_cast<float>(room - 34 * frame.scale));
  };
  paint_label({x - 12 * frame.scale, top}, name(sides.left, x - box.at.x), {1, 0}, frame.scale);
  paint_label({x + 12 * frame.scale, top}, name(sides.right, box.at.x + box.size.x - x), {0, 0},
              frame.scale);
}

// What the pictures are.
void paint_names(const Session& session, const GuiFrame& frame) {
  const glm::dvec2 corner = glm::dvec2(12, 10) * frame.scale;
  const Sides sides = sides_of(session);
  const auto write = [&](const Box& box, const std::string& text) {
    const double room = box.size.x - 34 * frame.scale;
    paint_label(box.at + corner, fitting(text, static_cast<float>(room)), {0, 0}, frame.scale);
  };
  switch (session.compare) {
    case CompareView::split:
      paint_split(session, frame);
      break;
    case CompareView::side_by_side:
      write(session.beside, role_name(session, sides.right));
      [[fallthrough]];
    case CompareView::off:
    case CompareView::flicker:
    case CompareView::other:
      write(session.picture, role_name(session, role_in_front(session)));
      break;
    case CompareView::difference:
      write(session.picture, fmt::format("difference of {} and {}: black is none, yellow is all",
                                         role_word(sides.left), role_word(sides.right)));
      break;
    case CompareView::flip:
      write(session.picture, fmt::format("FLIP of {} and {}: visible differences, black is none",
                                         role_word(sides.left), role_word(sides.right)));
      break;
  }
}

void paint_comparison(const Session& session, const GuiFrame& frame) {
  const Sides sides = sides_of(session);
  if (session.compare == CompareView::off || sides == Sides()) {
    return;
  }
  if (is_comparable(session) || session.compare == CompareView::other) {
    paint_names(session, frame);
  }
  if (!is_comparable(session)) {
    paint_bottom_label(session, frame,
                       fmt::format("{} is not compared: this is not the scene's camera (Home)",
                                   role_word(sides.right)),
                       color_dim);
  } else if (session.comparison && session.comparison->sides == sides) {
    paint_bottom_label(session, frame, measures_text(session.comparison->measures), color_text);
  }
}

/// Projects world points to the window.
class Projection {
 public:
  explicit Projection(const Session& session) : session_(session) {}

  // Draws the line between two world points, clipped to the front of the camera.
  void paint(glm::dvec3 a, glm::dvec3 b, ImU32 color, float width) const {
    const double near = 1e-4 * glm::length(a - camera_.position) + 1e-9;
    double depth_a = depth(a);
    double depth_b = depth(b);
    if (depth_a < near && depth_b < near) {
      return;
    }
    if (depth_a < near) {
      a += (b - a) * ((near - depth_a) / (depth_b - depth_a));
    } else if (depth_b < near) {
      b += (a - b) * ((near - depth_b) / (depth_a - depth_b));
    }
    ImGui::GetBackgroundDrawList()->AddLine(vec(point(a)), vec(point(b)), color, width);
  }

  // Writes text next to a point in front of the camera.
  void write(const glm::dvec3& at, const char* text, ImU32 color) const {
    if (depth(at) > 0) {
      const float gap = 0.3F * ImGui::GetFontSize();
      const ImVec2 p = vec(point(at));
      ImGui::GetBackgroundDrawList()->AddText({p.x + gap, p.y - ImGui::GetFontSize()}, color, text);
    }
  }

 private:
  double depth(const glm::dvec3& p) const { return -glm::dot(p - camera_.position, camera_.w); }
  glm::dvec2 point(const glm::dvec3& p) const {
    return point_in_window(session_, p).value_or(glm::dvec2(-1e5));
  }

  const Session& session_;
  const RenderCamera camera_ = render_camera(session_.camera);
};

void paint_box(const Projection& projection, const Bounds& box, double scale) {
  const auto corner = [&](int i) {
    return glm::dvec3((i & 1) != 0 ? box.max.x : box.min.x, (i & 2) != 0 ? box.max.y : box.min.y,
                      (i & 4) != 0 ? box.max.z : box.min.z);
  };
  for (int i = 0; i < 8; ++i) {
    for (int axis = 1; axis < 8; axis *= 2) {
      if ((i & axis) == 0) {
        projection.paint(corner(i), corner(i | axis), rgba(color_accent, 220),
                         static_cast<float>(1.5 * scale));
      }
    }
  }
}

// A box around the selection, which leaves its colors as they are.
void paint_selection(const Session& session, const GuiFrame& frame) {
  if (session.selected && !session.selected_box.empty()) {
    paint_box(Projection(session), session.selected_box, frame.scale);
  }
}

void paint_lines(const Projection& projection, const std::vector<WorldLine>& lines, ImU32 color,
                 double width) {
  for (const WorldLine& line : lines) {
    projection.paint(line.from, line.to, color, static_cast<float>(width));
  }
}

void paint_axes(const Projection& projection, double length, double scale) {
  static constexpr std::array<unsigned, 3> colors{0xe05050, 0x50c050, 0x5080ff};
  static constexpr std::array<const char*, 3> names{"x", "y", "z"};
  for (int axis = 0; axis < 3; ++axis) {
    const auto i = static_cast<std::size_t>(axis);
    glm::dvec3 end(0);
    end[axis] = length;
    projection.paint(glm::dvec3(0), end, rgba(colors[i]), static_cast<float>(2 * scale));
    projection.write(end, names[i], rgba(colors[i]));
  }
}

// World axes, all lights and the scene's camera, if enabled; always the selected light or camera.
void paint_helpers(const Session& session, const GuiFrame& frame) {
  const Projection projection(session);
  const Bounds& box = session.shown->bounds;
  const double size = box.empty() ? 1 : glm::length(box.max - box.min);
  const OutlineRow* const selected =
      session.selected ? &session.shown->outline.rows[*session.selected] : nullptr;
  const bool all = session.settings.axes;
  if (all) {
    paint_axes(projection, 0.3 * size, frame.scale);
  }
  for (const RenderLight& light : session.shown->opened.ready.scene.lights) {
    const bool chosen =
        selected != nullptr && selected->kind == RowKind::light && selected->source == light.source;
    if (all || chosen) {
      paint_lines(projection, light_helper(light, box), rgba(chosen ? color_accent : 0xffe080),
                  1.5 * frame.scale);
    }
  }
  const bool camera_chosen = selected != nullptr && selected->kind == RowKind::camera;
  if ((all || camera_chosen) && session.camera != session.home) {
    const glm::dvec2& size_of_picture = session.picture.size;
    paint_lines(
        projection,
        camera_helper(render_camera(session.home), size_of_picture.x / size_of_picture.y, box),
        rgba(camera_chosen ? color_accent : 0xd0d0d0), frame.scale);
  }
}

// The handles of the selection; the one under the pointer, or held, is bright.
void paint_handles(Session& session, const GuiFrame& frame) {
  const std::optional<HandleSet> set = handles_of(session);
  if (!set) {
    return;
  }
  static constexpr std::array<unsigned, 6> colors{0xe05050, 0x50c050, 0x5080ff,
                                                  0xe2e4e8, 0xffe080, 0xffa040};
  const bool held = session.pointer.drag == Drag::handle && session.grasped;
  const std::optional<int> bright =
      held ? std::optional(session.grasped->number) : handle_at(session, *set, session.pointer.at);
  const auto s = static_cast<float>(frame.scale);
  ImDrawList& draw = *ImGui::GetBackgroundDrawList();
  for (const HandleLine& line : handle_lines(session, *set)) {
    const bool over = bright == line.number;
    const ImU32 color =
        rgba(over ? 0xffffff : colors[static_cast<std::size_t>(line.number)], over ? 255 : 230);
    std::vector<ImVec2> points;
    for (const glm::dvec2& point : line.points) {
      points.push_back(vec(point));
    }
    const auto count = static_cast<int>(points.size());
    draw.AddPolyline(points.data(), count, rgba(0x000000, 150), 0, 5 * s);
    draw.AddPolyline(points.data(), count, color, 0, 2.5F * s);
    if (set->kind == Handles::turn && line.number < 4) {
      continue;
    }
    const ImVec2 end = points.back();
    const float r = (line.number == 3 ? 6 : 5) * s;
    if (set->kind == Handles::scale && line.number < 4) {
      draw.AddRectFilled({end.x - r, end.y - r}, {end.x + r, end.y + r}, color, 1);
    } else {
      draw.AddCircleFilled(end, r, color, 16);
    }
  }
}

// What lies over our picture.
void paint_over_ours(Session& session, const GuiFrame& frame) {
  if (session.shown == nullptr || session.compare > CompareView::split) {
    return;
  }
  ImDrawList& draw = *ImGui::GetBackgroundDrawList();
  const Box& picture = session.picture;
  const bool split = session.compare == CompareView::split && is_comparable(session);
  draw.PushClipRect(vec(picture.at),
                    vec(picture.at + picture.size * glm::dvec2(split ? session.split : 1, 1)));
  paint_selection(session, frame);
  paint_helpers(session, frame);
  paint_handles(session, frame);
  draw.PopClipRect();
}

std::string size_text(std::uint64_t bytes) {
  return bytes >= 1U << 30 ? fmt::format("{:.2f} GB", static_cast<double>(bytes) / (1U << 30))
                           : fmt::format("{:.0f} MB", static_cast<double>(bytes) / (1U << 20));
}

// Groups digits by three: 25 000.
std::string count_text(std::uint64_t count) {
  std::string text = fmt::format("{}", count);
  for (std::size_t i = text.size(); i > 3;) {
    i -= 3;
    text.insert(i, 1, ' ');
  }
  return text;
}

void build_statistics(const Session& session, const GuiFrame& frame) {
  const Box& box = session.picture;
  const double margin = 12 * frame.scale;
  ImGui::SetNextWindowPos(vec({box.at.x + box.size.x - margin, box.at.y + margin}), 0, {1, 0});
  ImGui::SetNextWindowBgAlpha(0.85F);
  ImGui::SetNextWindowSizeConstraints({0, 0}, vec(glm::max(box.size - 2 * margin, 1.0)));
  ImGui::Begin("##figures", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoInputs |
                   ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav);
  const auto line = [](const char* name, const std::string& value) {
    dim_text(name);
    ImGui::SameLine(ImGui::GetFontSize() * 7.5F);
    ImGui::TextUnformatted(value.c_str());
  };
  line("frame", fmt::format("{:.1f} ms, {:.3g} a second", frame.frame_seconds * 1e3,
                            1 / std::max(frame.frame_seconds, 1e-6)));
  line("picture", fmt::format("{} x {}", session.pixels.x, session.pixels.y));
  line("drawn in", fmt::format("{:.1f} ms", frame.scene_seconds * 1e3));
  line("objects", count_text(frame.drawn.objects));
  if (frame.drawn.left_out != 0) {
    line("left out", count_text(frame.drawn.left_out) + ", the farthest");
  }
  line("triangles", count_text(frame.drawn.triangles));
  line("draw calls",
       fmt::format("{} + {} shadows", frame.drawn.draw_calls, frame.drawn.shadow_calls));
  if (session.shown != nullptr) {
    line("lights", fmt::format("{}", session.shown->opened.ready.scene.lights.size()));
  }
  if (frame.memory != 0) {
    line("memory", size_text(frame.memory));
  }
  line("drawn by", frame.renderer);
  ImGui::End();
}

void paint_welcome(const Session& session, const GuiFrame& frame) {
  if (session.shown != nullptr) {
    return;
  }
  const bool reading = session.loading.busy();
  const std::string text = reading ? "reading " + escaped(scene_name(session))
                           : session.broken != nullptr
                               ? scene_name(session) + " cannot be drawn yet"
                               : "drop a scene here, or open one with Ctrl+O";
  paint_label(session.picture.at + session.picture.size * 0.5, text, {0.5, 0.5}, frame.scale,
              color_dim);
}

// Explains the colors of modes that need it.
void paint_legend(const Session& session, const GuiFrame& frame) {
  if (session.shown != nullptr && session.mode == DrawMode::bounding_boxes &&
      session.compare <= CompareView::split) {
    paint_label(session.picture.at + glm::dvec2(12, 10) * frame.scale,
                "bounding boxes: brighter where more overlap", {0, 0}, frame.scale, color_dim,
                session.picture.size.x);
  }
}

}  // namespace

void build_overlay(Session& session, const GuiFrame& frame) {
  paint_pictures(session, frame);
  paint_over_ours(session, frame);
  paint_values(session, frame);
  paint_comparison(session, frame);
  paint_legend(session, frame);
  paint_welcome(session, frame);
  // The panels float, and would cover the lists of the panel that opens scenes.
  const bool panels = session.shown != nullptr && !session.picture_only && !session.start.open;
  if (session.realtime && panels) {
    build_realtime_panel(session, frame);
  }
  if (session.readout.at && panels) {
    paint_mark(session, frame);
  }
  paint_magnifier(session, frame);
  if (session.settings.statistics && !session.picture_only) {
    build_statistics(session, frame);
  }
  if (session.notice) {
    paint_bottom_label(session, frame, escaped(session.notice->text, 300),
                       session.notice->bad ? color_error : color_good, 3);
  }
}

}  // namespace scenefile::viewer
