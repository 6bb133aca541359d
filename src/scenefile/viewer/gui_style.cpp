#include "scenefile/base/text.h"
#include "scenefile/io/folder.h"
#include "scenefile/viewer/gui.h"
#include "scenefile/viewer/gui_colors.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace scenefile::viewer {

namespace {

constexpr float text_height = 16;
constexpr float code_height = 15;

// The first existing file is used; paths of Debian and Ubuntu come first.
constexpr std::array text_fonts{
    "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",
    "/usr/share/fonts/truetype/noto/NotoSans-Regular.ttf",
    "/usr/share/fonts/truetype/liberation2/LiberationSans-Regular.ttf",
    "/usr/share/fonts/dejavu/DejaVuSans.ttf",
    "/usr/share/fonts/TTF/DejaVuSans.ttf",
    "/System/Library/Fonts/Helvetica.ttc",
};
constexpr std::array code_fonts{
    "/usr/share/fonts/truetype/dejavu/DejaVuSansMono.ttf",
    "/usr/share/fonts/truetype/noto/NotoSansMono-Regular.ttf",
    "/usr/share/fonts/truetype/liberation2/LiberationMono-Regular.ttf",
    "/usr/share/fonts/dejavu/DejaVuSansMono.ttf",
    "/usr/share/fonts/TTF/DejaVuSansMono.ttf",
    "/System/Library/Fonts/Menlo.ttc",
};

// Latin with accents, Greek, Cyrillic, arrows, typographic punctuation, and lines.
constexpr std::array<ImWchar, 15> letters{0x20,   0x24F,  0x370,  0x52F,  0x2010,
                                          0x2027, 0x2030, 0x203A, 0x2190, 0x21FF,
                                          0x2200, 0x22FF, 0x2500, 0x257F, 0};

// Returns false if none of them exists.
bool add_font(ImFontAtlas& atlas, std::span<const char* const> paths, float height) {
  const auto found = std::find_if(paths.begin(), paths.end(),
                                  [](const char* path) { return stamp_of(path).exists; });
  return found != paths.end() &&
         atlas.AddFontFromFileTTF(*found, height, nullptr, letters.data()) != nullptr;
}

ImVec4 color(unsigned rgb, unsigned alpha = 255) {
  return ImGui::ColorConvertU32ToFloat4(rgba(rgb, alpha));
}

void set_colors(ImGuiStyle& style) {
  ImVec4* const c = style.Colors;
  c[ImGuiCol_Text] = color(color_text);
  c[ImGuiCol_TextDisabled] = color(color_dim);
  c[ImGuiCol_WindowBg] = color(color_panel);
  c[ImGuiCol_ChildBg] = color(color_panel, 0);
  c[ImGuiCol_PopupBg] = color(0x26292e);
  c[ImGuiCol_MenuBarBg] = color(color_panel);
  c[ImGuiCol_Border] = color(color_line);
  c[ImGuiCol_Separator] = color(color_line);
  c[ImGuiCol_SeparatorHovered] = color(color_accent, 160);
  c[ImGuiCol_SeparatorActive] = color(color_accent);
  c[ImGuiCol_FrameBg] = color(color_field);
  c[ImGuiCol_FrameBgHovered] = color(0x353941);
  c[ImGuiCol_FrameBgActive] = color(0x3d424b);
  c[ImGuiCol_Header] = color(color_accent, 46);
  c[ImGuiCol_HeaderHovered] = color(0xffffff, 18);
  c[ImGuiCol_HeaderActive] = color(color_accent, 70);
  c[ImGuiCol_Button] = color(color_field);
  c[ImGuiCol_ButtonHovered] = color(0x3d424b);
  c[ImGuiCol_ButtonActive] = color(color_accent, 120);
  c[ImGuiCol_CheckMark] = color(color_accent);
  c[ImGuiCol_SliderGrab] = color(color_accent, 160);
  c[ImGuiCol_SliderGrabActive] = color(color_accent);
  c[ImGuiCol_ScrollbarBg] = color(color_panel, 0);
  c[ImGuiCol_ScrollbarGrab] = color(0x464b54);
  c[ImGuiCol_TitleBg] = color(color_panel);
  c[ImGuiCol_TitleBgActive] = color(color_panel);
  c[ImGuiCol_ModalWindowDimBg] = color(0x000000, 120);
}

void set_spacing(ImGuiStyle& style) {
  style.WindowPadding = {12, 10};
  style.FramePadding = {8, 5};
  style.ItemSpacing = {8, 5};
  style.ItemInnerSpacing = {6, 4};
  style.IndentSpacing = 16;
  style.ScrollbarSize = 11;
  style.WindowRounding = 0;
  style.PopupRounding = 6;
  style.FrameRounding = 4;
  style.ScrollbarRounding = 6;
  style.GrabRounding = 4;
  style.WindowBorderSize = 0;
  style.PopupBorderSize = 1;
  style.WindowMinSize = {1, 1};
}

}  // namespace

void set_gui_style(double scale) {
  ImGuiStyle style;
  set_colors(style);
  set_spacing(style);
  style.ScaleAllSizes(static_cast<float>(scale));
  ImGui::GetStyle() = style;
}

std::string build_fonts(ImFontAtlas& atlas, double scale) {
  atlas.Clear();
  const auto s = static_cast<float>(scale);
  std::string note;
  if (!add_font(atlas, text_fonts, std::round(text_height * s)) ||
      !add_font(atlas, code_fonts, std::round(code_height * s))) {
    note = "no font was found: install fonts-dejavu-core for better text";
    atlas.Clear();
    ImFontConfig config;
    config.SizePixels = std::round(13 * s);
    atlas.AddFontDefault(&config);
    atlas.AddFontDefault(&config);
  }
  unsigned char* pixels = nullptr;
  int width = 0;
  int height = 0;
  atlas.GetTexDataAsRGBA32(&pixels, &width, &height);  // what OpenGL will ask for
  return note;
}

void colored_text(unsigned rgb, const std::string& text) {
  ImGui::PushStyleColor(ImGuiCol_Text, rgba(rgb));
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopStyleColor();
}

void dim_text(const std::string& text) {
  colored_text(color_dim, text);
}

std::string fitting(const std::string& text, float room) {
  const auto width = [](const std::string& t) { return ImGui::CalcTextSize(t.c_str()).x; };
  if (width(text) <= room) {
    return text;
  }
  std::string some = text;
  do {
    while (!some.empty() && continues_character(some.back())) {
      some.pop_back();
    }
    if (some.empty()) {
      return some;
    }
    some.pop_back();
  } while (width(some + "...") > room);
  return some + "...";
}

}  // namespace scenefile::viewer
