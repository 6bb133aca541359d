#include "app/tree.h"

#include "scenefile/base/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

namespace scenefile::app {

namespace {

constexpr std::size_t max_indent = 100;

struct Visit {
  NodeId node = 0;
  std::size_t depth = 0;
  std::size_t place = 0;  ///< among its siblings, from 1
};

template <typename T, std::size_t n, typename Kind>
void append_kinds(std::vector<std::string>& parts, const std::vector<T>& things,
                  const std::array<std::string_view, n>& names, std::string_view suffix,
                  Kind kind_of) {
  std::array<std::size_t, n> counts{};
  for (const T& thing : things) {
    ++counts[static_cast<std::size_t>(kind_of(thing))];
  }
  for (std::size_t i = 0; i < n; ++i) {
    if (counts[i] != 0) {
      parts.push_back(fmt::format("{} {}{}{}", counts[i], names[i], suffix,
                                  counts[i] == 1       ? ""
                                  : names[i] == "mesh" ? "es"
                                                       : "s"));
    }
  }
}

// "T R S M", in the order of the file.
std::string transforms_text(const Node& node) {
  static constexpr std::string_view letters = "TRSM";
  std::string text;
  for (const Transform& t : node.transforms) {
    text += letters[t.map.index()];
  }
  return text;
}

std::string node_text(const Scene& scene, const Visit& visit) {
  const Node& node = scene.nodes[visit.node];
  std::vector<std::string> parts;
  if (const std::string transforms = transforms_text(node); !transforms.empty()) {
    parts.push_back(transforms);
  }
  if (!node.instance_of.empty()) {
    parts.push_back("copy of " + escaped(node.instance_of));
  }
  append_kinds(parts, node.primitives, shape_words, "", [](const Primitive& p) { return p.shape; });
  append_kinds(parts, node.lights, light_words, " light", [](const Light& l) { return l.type; });
  const std::string name = node.name.empty() ? fmt::format("#{}", visit.place) : escaped(node.name);
  return fmt::format("{}{}{}{}", std::string(2 * std::min(visit.depth, max_indent), ' '), name,
                     parts.empty() ? "" : ": ", fmt::format("{}", fmt::join(parts, ", ")));
}

}  // namespace

std::string tree_text(const Scene& scene) {
  std::vector<Visit> todo{{scene.root, 0, 1}};
  for (std::size_t i = scene.templates.size(); i-- > 0;) {
    todo.push_back({scene.templates[i], 0, i + 1});
  }
  std::string text;
  while (!todo.empty()) {
    const Visit visit = todo.back();
    todo.pop_back();
    text += node_text(scene, visit) + "\n";
    const std::vector<NodeId>& children = scene.nodes[visit.node].children;
    for (std::size_t i = children.size(); i-- > 0;) {
      todo.push_back({children[i], visit.depth + 1, i + 1});
    }
  }
  return text;
}

}  // namespace scenefile::app
