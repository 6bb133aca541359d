#include "scenefile/verbs/explain_tree.h"

#include "scenefile/asset/image.h"
#include "scenefile/base/text.h"

#include <fmt/format.h>

namespace scenefile {

namespace {

void print_below(const ExplainItem& item, const std::string& indent, std::string& text) {
  for (std::size_t i = 0; i < item.below.size(); ++i) {
    const bool last = i + 1 == item.below.size();
    text += indent + (last ? "└ " : "├ ") + item.below[i].text + "\n";
    print_below(item.below[i], indent + (last ? "  " : "│ "), text);
  }
}

}  // namespace

std::string tree_text(const ExplainItem& item) {
  std::string text;
  print_below(item, "", text);
  return text;
}

std::string bold_text(std::string_view text, const ExplainStyle& style) {
  return style.color ? fmt::format("\033[1m{}\033[0m", text) : std::string(text);
}

// Adding 0.0 turns -0 into 0.
std::string vector_text(const glm::dvec3& v) {
  const glm::dvec3 shown = v + 0.0;
  return fmt::format("{:.6g} {:.6g} {:.6g}", shown.x, shown.y, shown.z);
}

std::string color_text(const Color& c) {
  return fmt::format("{:.4f} {:.4f} {:.4f}", c.x, c.y, c.z);
}

std::string color_text(const Color& c, const ExplainStyle& style) {
  if (!style.swatches) {
    return color_text(c);
  }
  const auto part = [](double v) { return quantize(static_cast<float>(v), Rounding::nearest); };
  return fmt::format("{} \033[48;2;{};{};{}m  \033[0m", color_text(c), part(c.x), part(c.y),
                     part(c.z));
}

std::string object_text(const ObjectNames& names, const ObjectRef& object) {
  const std::vector<WayPoint> way = names.way(object);
  std::string text;
  for (const WayPoint& point : way) {
    text += fmt::format("{}{}", text.empty() ? "" : " > ", escaped(point.path, 80));
  }
  return text + place_text(way.back().location);
}

void add_object(Json& json, const ObjectNames& names, const ObjectRef& object) {
  json.add_objects("object", names.way(object), [&](const WayPoint& point) {
    json.add(
        {{"path", point.path}, {"line", point.location.line}, {"column", point.location.column}});
  });
}

void add_line(Json& json, std::string_view name, const Ray& ray) {
  json.add_object(name, {{"origin", ray.origin}, {"direction", ray.direction}});
}

std::string place_text(const Location& location) {
  return location.known() ? fmt::format(" (line {})", location.line) : "";
}

}  // namespace scenefile
