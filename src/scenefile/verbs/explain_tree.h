#pragma once
// Explanations as text: a tree of lines.

#include "scenefile/explain/object_names.h"
#include "scenefile/trace/color.h"
#include "scenefile/verbs/explain.h"
#include "scenefile/verbs/json_writer.h"

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace scenefile {

struct ExplainItem {
  std::string text;
  std::vector<ExplainItem> below;

  ExplainItem(std::string line = {}) : text(std::move(line)) {}
  ExplainItem& add(ExplainItem item) { return below.emplace_back(std::move(item)); }
  ExplainItem& add(std::string line) { return add(ExplainItem(std::move(line))); }
};

/// The lines below the item. Recursive over the depth of the tree.
std::string tree_text(const ExplainItem& item);

/// The number of samples of a pixel or light above which they are summarized.
inline constexpr std::size_t max_explained_samples = 16;

std::string bold_text(std::string_view text, const ExplainStyle& style);
/// Three numbers.
std::string vector_text(const glm::dvec3& v);
std::string color_text(const Color& c);
/// The same with a patch of the color, if the style has them.
std::string color_text(const Color& c, const ExplainStyle& style);

/// "root/#2 (line 7)"; instances are separated by " > ".
std::string object_text(const ObjectNames& names, const ObjectRef& object);
/// "object": an array of the nodes on the way to it.
void add_object(Json& json, const ObjectNames& names, const ObjectRef& object);
void add_line(Json& json, std::string_view name, const Ray& ray);
/// " (line 7)"; empty if unknown.
std::string place_text(const Location& location);

/// The text for a pixel of mode path.
std::string explain_path_text(const LoadedScene& scene, const ExplainReport& report,
                              const ExplainStyle& style);
/// Adds the object `pixel` of mode path.
void add_path_pixel(Json& json, const LoadedScene& scene, const ExplainReport& report);

}  // namespace scenefile
