// The pictures, with the values of their pixels, and the magnifier.

#include "scenefile/viewer/gui.h"
#include "scenefile/viewer/gui_colors.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <vector>

namespace scenefile::viewer {

namespace {

/// A picture that is shown, or a part of its width.
struct View {
  Box box;  ///< the place of its part
  Box whole;
  PixelSource shown;
  Role role = Role::ours;
  bool compares = false;  ///< it shows differences of two pictures
  unsigned texture = 0;
};

unsigned texture_of(const Session& session, const GuiFrame& frame, Role role) {
  return role == Role::reference ? frame.reference
         : role == Role::mine    ? frame.mine
         : shows_traced(session) ? frame.traced
                                 : frame.scene;
}

ImTextureID texture(const View& view) {
  return reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(view.texture));
}

const Comparison* comparison_of(const Session& session) {
  const bool known = session.comparison && session.comparison->sides == sides_of(session);
  return known && is_comparable(session) ? &*session.comparison : nullptr;
}

std::vector<View> views_of(const Session& session, const GuiFrame& frame) {
  std::vector<View> views;
  const auto add = [&](Role role, Box box, double from, double to) {
    const Box whole = whole_picture(session, box);
    box.at.x += from * box.size.x;
    box.size.x *= to - from;
    views.push_back(
        {box, whole, pixels_of(session, role), role, false, texture_of(session, frame, role)});
  };
  const bool both = is_comparable(session);
  const bool split = both && session.compare == CompareView::split;
  add(role_in_front(session), session.picture, 0, split ? session.split : 1);
  if (split) {
    add(sides_of(session).right, session.picture, session.split, 1);
  } else if (both && session.compare == CompareView::side_by_side) {
    add(sides_of(session).right, session.beside, 0, 1);
  } else if (const Comparison* const found = comparison_of(session);
             found != nullptr && session.compare >= CompareView::difference) {
    const bool flip = session.compare == CompareView::flip;
    views[0].shown = {flip ? &found->flip : &found->difference, nullptr};
    views[0].texture = flip ? frame.flip : frame.difference;
    views[0].compares = true;
  }
  std::erase_if(views, [](const View& view) {
    return view.shown.bytes == nullptr || view.texture == 0;  // not there, or not uploaded yet
  });
  return views;
}

// The signed differences of the two pictures, or the error of FLIP.
std::vector<std::string> difference_texts(const Session& session, const glm::ivec2& pixel) {
  const Comparison& found = *session.comparison;
  if (session.compare == CompareView::flip) {
    const std::size_t at =
        std::size_t(found.flip.width) * std::size_t(pixel.y) + std::size_t(pixel.x);
    return {fmt::format("{:.3f}", found.flip_errors[at])};
  }
  const bool exchanged = found.sides.right == Role::reference;
  const std::uint8_t* const left =
      pixels_of(session, found.sides.left).bytes->texel(pixel.x, pixel.y);
  const std::uint8_t* const right =
      pixels_of(session, found.sides.right).bytes->texel(pixel.x, pixel.y);
  std::vector<std::string> texts;
  for (int i = 0; i < 3; ++i) {
    const int by = (right[i] - left[i]) * (exchanged ? -1 : 1);
    texts.push_back(by == 0                          ? "0"
                    : session.settings.linear_values ? fmt::format("{:+.3f}", by / 255.0)
                                                     : fmt::format("{:+}", by));
  }
  return texts;
}

bool same_size(const Session& session, const PixelSource& source) {
  const Sides sides = session.comparison->sides;
  return pixels_of(session, sides.left).size() == source.size() &&
         pixels_of(session, sides.right).size() == source.size();
}

std::vector<std::string> texts_of(const Session& session, const View& view,
                                  const glm::ivec2& pixel) {
  if (view.compares) {
    return same_size(session, view.shown) ? difference_texts(session, pixel)
                                          : std::vector<std::string>();
  }
  const std::array<std::string, 3> texts = value_texts(session, view.shown, pixel);
  return {texts.begin(), texts.end()};
}

// Black on light pixels, white on dark ones.
ImU32 color_on(const std::uint8_t* rgb) {
  const double luminance = 0.299 * rgb[0] + 0.587 * rgb[1] + 0.114 * rgb[2];
  return luminance > 128 ? rgba(0x000000, 235) : rgba(0xffffff, 235);
}

// The place of a pixel in the window.
Box pixel_box(const View& view, const glm::ivec2& pixel) {
  const glm::dvec2 size = view.whole.size / glm::dvec2(view.shown.size());
  return {view.whole.at + glm::dvec2(pixel) * size, size};
}

void paint_frame(const Box& box, double scale) {
  ImDrawList& draw = *ImGui::GetBackgroundDrawList();
  const auto s = static_cast<float>(scale);
  draw.AddRect(vec(box.at), vec(box.at + box.size), rgba(0x000000, 160), 0, 0, 3 * s);
  draw.AddRect(vec(box.at), vec(box.at + box.size), rgba(color_accent), 0, 0, 1.5F * s);
}

void paint_values_of(const Session& session, const GuiFrame& frame, const View& view) {
  if (pixel_width(session, view.shown) < pixels_for_values * frame.scale) {
    return;
  }
  const glm::dvec2 size = view.whole.size;
  const glm::ivec2 first = view.shown.pixel_at((view.box.at - view.whole.at) / size);
  const glm::ivec2 last = view.shown.pixel_at((view.box.at + view.box.size - view.whole.at) / size);
  ImFont* const font = ImGui::GetIO().Fonts->Fonts[1];
  const double height = std::min(0.25 * pixel_width(session, view.shown), 15 * frame.scale);
  ImDrawList& draw = *ImGui::GetBackgroundDrawList();
  draw.PushClipRect(vec(view.box.at), vec(view.box.at + view.box.size));
  for (int y = first.y; y <= last.y; ++y) {
    for (int x = first.x; x <= last.x; ++x) {
      const Box box = pixel_box(view, {x, y});
      const std::vector<std::string> texts = texts_of(session, view, {x, y});
      const double top = (box.size.y - height * static_cast<double>(texts.size())) / 2;
      for (std::size_t i = 0; i < texts.size(); ++i) {
        const float width =
            font->CalcTextSizeA(static_cast<float>(height), 1e4F, 0, texts[i].c_str()).x;
        const glm::dvec2 at = box.at + glm::dvec2((box.size.x - double{width}) / 2,
                                                  top + height * static_cast<double>(i));
        draw.AddText(font, static_cast<float>(height), vec(at),
                     color_on(view.shown.bytes->texel(x, y)), texts[i].c_str());
      }
    }
  }
  paint_frame(pixel_box(view, view.shown.pixel_at(session.looked_at)), frame.scale);
  draw.PopClipRect();
}

// What the lens of a picture says below it.
std::string lens_text(const Session& session, const View& view, const glm::ivec2& pixel) {
  std::string text = view.compares ? "" : std::string(role_word(view.role));
  for (const std::string& value : texts_of(session, view, pixel)) {
    text += (text.empty() ? "" : " ") + value;
  }
  return text;
}

void paint_lens(const Session& session, const View& view, const Box& box, double scale) {
  constexpr int around = 5;
  const glm::ivec2 pixel = view.shown.pixel_at(session.looked_at);
  const glm::dvec2 size(view.shown.size());
  ImDrawList& draw = *ImGui::GetBackgroundDrawList();
  draw.AddImage(texture(view), vec(box.at), vec(box.at + box.size),
                vec(glm::dvec2(pixel - around) / size), vec(glm::dvec2(pixel + around + 1) / size));
  const glm::dvec2 one = box.size / (2.0 * around + 1);
  paint_frame({box.at + one * double{around}, one}, scale);
}

// Beside the place that is magnified, on the side with more room.
void paint_lenses(const Session& session, const GuiFrame& frame, const std::vector<View>& views) {
  const double scale = frame.scale;
  const double lens = 154 * scale;
  const double gap = 8 * scale;
  const double line = ImGui::GetTextLineHeightWithSpacing();
  const auto count = static_cast<double>(views.size());
  const glm::dvec2 size(count * (lens + gap) + gap, lens + 2 * gap + 2 * line);
  const Box whole = whole_picture(session, session.picture);
  const glm::dvec2 at = whole.at + session.looked_at * whole.size;
  const glm::dvec2 end =
      glm::max(session.picture.at + session.picture.size, session.beside.at + session.beside.size);
  glm::dvec2 corner = at + 20 * scale;
  for (int axis = 0; axis < 2; ++axis) {
    if (corner[axis] + size[axis] > end[axis]) {
      corner[axis] = std::max(session.picture.at[axis], at[axis] - 20 * scale - size[axis]);
    }
  }
  ImDrawList& draw = *ImGui::GetBackgroundDrawList();
  draw.AddRectFilled(vec(corner), vec(corner + size), rgba(0x101114, 240),
                     static_cast<float>(6 * scale));
  const glm::ivec2 pixel = views[0].shown.pixel_at(session.looked_at);
  draw.AddText(vec(corner + gap), rgba(color_dim),
               fmt::format("pixel {}, {}", pixel.x, pixel.y).c_str());
  for (std::size_t i = 0; i < views.size(); ++i) {
    const Box box{corner + glm::dvec2(gap + static_cast<double>(i) * (lens + gap), gap + line),
                  glm::dvec2(lens)};
    paint_lens(session, views[i], box, scale);
    draw.AddText(vec(box.at + glm::dvec2(0, lens + gap / 2)), rgba(color_text),
                 lens_text(session, views[i], views[i].shown.pixel_at(session.looked_at)).c_str());
  }
}

}  // namespace

void paint_pictures(const Session& session, const GuiFrame& frame) {
  ImDrawList& draw = *ImGui::GetBackgroundDrawList();
  for (const View& view : views_of(session, frame)) {
    draw.PushClipRect(vec(view.box.at), vec(view.box.at + view.box.size));
    draw.AddImage(texture(view), vec(view.whole.at), vec(view.whole.at + view.whole.size));
    draw.PopClipRect();
  }
}

void paint_values(const Session& session, const GuiFrame& frame) {
  for (const View& view : views_of(session, frame)) {
    paint_values_of(session, frame, view);
  }
}

void paint_magnifier(const Session& session, const GuiFrame& frame) {
  const std::vector<View> views = views_of(session, frame);
  if (session.magnifier && !views.empty()) {
    paint_lenses(session, frame, views);
  }
}

}  // namespace scenefile::viewer
