#include "scenefile/format/xml_references.h"

#include "scenefile/base/suggest.h"
#include "scenefile/base/text.h"
#include "scenefile/format/codes.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <unordered_set>
#include <utility>

namespace scenefile {

namespace {

// Nested trees by name; `ambiguous` if several have the same name.
constexpr NodeId ambiguous = std::numeric_limits<NodeId>::max();
using NestedTrees = std::unordered_map<std::string, NodeId>;

NestedTrees find_nested_trees(const Scene& scene) {
  NestedTrees trees;
  for (NodeId i = 0; i < scene.nodes.size(); ++i) {
    const Node& node = scene.nodes[i];
    if (!node.name.empty() && !node.children.empty() && node.primitives.empty()) {
      const auto [entry, added] = trees.emplace(node.name, i);
      entry->second = added ? i : ambiguous;
    }
  }
  return trees;
}

// Enough for handwritten scenes; comparing all pairs of names would be quadratic.
constexpr std::size_t max_suggestions = 100;

std::vector<std::string_view> some_masters(const Scene& scene) {
  std::vector<std::string_view> names;
  for (const NodeId master : scene.templates) {
    if (names.size() < max_suggestions) {
      names.push_back(scene.nodes[master].name);
    }
  }
  return names;
}

// Turns the contents of a node into a template with its name, and the node into an instance of it.
void make_template(Scene& scene, NodeId nested) {
  const NodeId added = add_template(scene, scene.nodes[nested].name);
  scene.nodes[added].location = scene.nodes[nested].location;
  scene.nodes[added].children = std::exchange(scene.nodes[nested].children, {});
  scene.nodes[nested].instance_of = scene.nodes[nested].name;
}

// Of the trees that no other uses the only one, or the one whose name is nearest to root; empty if
// there is none.
std::string_view probable_root(const Scene& scene) {
  std::unordered_set<std::string_view> used;
  for (const Node& node : scene.nodes) {
    used.insert(node.instance_of);
  }
  std::vector<std::string_view> unused;
  for (const NodeId id : scene.templates) {
    if (!used.contains(scene.nodes[id].name)) {
      unused.push_back(scene.nodes[id].name);
    }
  }
  return unused.size() == 1 ? unused[0] : nearest_name("root", unused);
}

}  // namespace

bool XmlReferences::declare(const XmlContext& context, std::string_view name, Location place) {
  const auto [entry, added] = declared_.emplace(name, place);
  if (!added) {
    context.diagnostics.report("xml.duplicate-name"_code, place,
                               fmt::format("a second tree named {}; the first one is at line {}",
                                           quoted(name), entry->second.line));
  }
  return added;
}

void XmlReferences::use(Scene& scene, NodeId node, std::string_view name, Location place,
                        bool is_tree) {
  scene.nodes[node].instance_of = name;
  scene.field_places.push_back({scene.nodes[node].location, Field::instance_of, place});
  if (!declared_.contains(std::string(name))) {
    early_uses_.push_back({node, place, is_tree});
    first_early_uses_.emplace(name, place);
  }
}

Location XmlReferences::early_use(const std::string& name) const {
  const auto found = first_early_uses_.find(name);
  return found == first_early_uses_.end() ? Location{} : found->second;
}

void XmlReferences::move_last_use(NodeId from, NodeId to) {
  if (!early_uses_.empty() && early_uses_.back().node == from) {
    early_uses_.back().node = to;
  }
}

void XmlReferences::forget_unknown(Scene& scene) const {
  for (const Use& use : early_uses_) {
    if (!declared_.contains(scene.nodes[use.node].instance_of)) {
      scene.nodes[use.node].instance_of.clear();
    }
  }
}

void XmlReferences::resolve(const XmlContext& context, Scene& scene, Location scenefile) {
  const auto is_declared = [&](const Use& use) {
    return declared_.contains(scene.nodes[use.node].instance_of);
  };
  std::erase_if(early_uses_, is_declared);
  if (!early_uses_.empty()) {
    resolve_nested(context, scene, early_uses_);
    std::erase_if(early_uses_, is_declared);
    resolve_empty(context, scene, early_uses_);
  }
  if (!declared_.contains("root")) {
    resolve_root(context, scene, scenefile);
  }
}

// A tree whose name has no other meaning is just empty.
void XmlReferences::resolve_empty(const XmlContext& context, Scene& scene,
                                  const std::vector<Use>& uses) {
  const std::vector<std::string_view> masters = some_masters(scene);
  std::size_t suggestions = 0;
  for (const Use& use : uses) {
    if (!use.is_tree) {
      continue;
    }
    Node& node = scene.nodes[use.node];
    node.name = std::exchange(node.instance_of, {});
    const std::string_view near =
        ++suggestions <= max_suggestions ? nearest_name(node.name, masters) : std::string_view();
    context.diagnostics.report(
        "xml.empty-tree"_code, use.place,
        fmt::format("the tree {} is empty, and no master has that name{}", quoted(node.name),
                    near.empty() ? "" : did_you_mean(quoted(near))),
        correction(node.name, near, masters));
  }
}

// Masters that are not at the top of the file. Names that no tree has are left for check() to
// report.
void XmlReferences::resolve_nested(const XmlContext& context, Scene& scene,
                                   const std::vector<Use>& uses) {
  const NestedTrees nested = find_nested_trees(scene);
  for (const Use& use : uses) {
    const std::string name = scene.nodes[use.node].instance_of;
    const auto found = nested.find(name);
    if (found == nested.end() || found->second == ambiguous) {
      continue;
    }
    const Location place = scene.nodes[found->second].location;
    context.diagnostics.report("xml.nested-master"_code, use.place,
                               fmt::format("{} is a tree inside another tree, at line {}; most "
                                           "programs only find those at the top level of the file",
                                           quoted(name), place.line));
    if (declared_.emplace(name, place).second) {
      make_template(scene, found->second);
    }
  }
}

void XmlReferences::resolve_root(const XmlContext& context, Scene& scene,
                                 Location scenefile) const {
  const auto is_root = [&](NodeId id) { return equal_ignoring_case(scene.nodes[id].name, "root"); };
  auto& templates = scene.templates;
  const auto found = std::find_if(templates.begin(), templates.end(), is_root);
  if (found != templates.end()) {
    Node& node = scene.nodes[*found];
    context.diagnostics.report("xml.name-case"_code, node.location,
                               fmt::format("the tree {} was read as root", quoted(node.name)),
                               correction(node.name, "root"));
    scene.nodes[scene.root].children = std::exchange(node.children, {});
    scene.nodes[scene.root].name = "root";
    scene.nodes[scene.root].location = node.location;
    templates.erase(found);
    return;
  }
  std::string message = "the scene has no tree named root, so the picture is empty";
  std::optional<Correction> meant;
  if (const std::string name(probable_root(scene)); !name.empty()) {
    message += fmt::format("; is {} meant as root?", quoted(name));
    meant = Correction{name, "root", false, declared_.at(name)};
  }
  context.diagnostics.report("xml.no-root"_code, scenefile, std::move(message), std::move(meant));
}

}  // namespace scenefile
