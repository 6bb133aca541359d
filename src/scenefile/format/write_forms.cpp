#include "scenefile/format/write_forms.h"

#include "scenefile/format/codes.h"
#include "scenefile/scene/template_graph.h"
#include "scenefile/scene/vocabulary.h"
#include "scenefile/scene/walk.h"

#include <fmt/format.h>

#include <algorithm>
#include <type_traits>
#include <utility>
#include <variant>

namespace scenefile {

namespace {

// Copies one tree; returns its head in the copy.
NodeId copy_tree(const Scene& from, NodeId head, std::vector<bool>& seen, Scene& to) {
  constexpr NodeId nowhere = 0xffffffffu;
  NodeId copied_head = nowhere;
  walk_nodes(from, head, nowhere, seen, [&](NodeId id, NodeId parent) {
    const auto copy = static_cast<NodeId>(to.nodes.size());
    Node& node = to.nodes.emplace_back(from.nodes[id]);
    node.children.clear();
    if (!node.instance_of.empty()) {
      node.lights.clear();
      node.primitives.clear();
    }
    if (parent == nowhere) {
      copied_head = copy;
    } else {
      to.nodes[parent].children.push_back(copy);
    }
    return copy;
  });
  if (copied_head == nowhere) {
    copied_head = static_cast<NodeId>(to.nodes.size());
    to.nodes.emplace_back();
  }
  return copied_head;
}

// Parents first.
std::vector<NodeId> nodes_in_order(const Scene& scene) {
  std::vector<NodeId> order;
  std::vector<bool> seen(scene.nodes.size());
  for (const NodeId head : tree_heads(scene)) {
    walk_nodes(scene, head, 0, seen, [&](NodeId id, int) {
      order.push_back(id);
      return 0;
    });
  }
  return order;
}

}  // namespace

Scene tidy_copy(const Scene& scene) {
  Scene copy;
  copy.name = scene.name;
  copy.global = scene.global;
  copy.camera = scene.camera;
  copy.nodes.clear();
  copy.nodes.reserve(scene.nodes.size());
  std::vector<bool> seen(scene.nodes.size());
  const TemplateGraph graph = template_graph(scene);
  for (const std::uint32_t tree : containment_order(graph.uses).vertices) {
    if (tree != graph.root()) {
      copy.templates.push_back(copy_tree(scene, scene.templates[tree], seen, copy));
    }
  }
  copy.root = copy_tree(scene, scene.root, seen, copy);
  return copy;
}

void clear_unused(Light& light, bool keep_idle) {
  const Light defaults;
  for (const ValueRow<Light>& row : light_rows) {
    if (!row.used_by_type(light.type) && !(keep_idle && row.idle_in_xml)) {
      std::visit(
          [&](const auto& member) {
            if constexpr (!std::is_same_v<decltype(member), const std::monostate&>) {
              light.*member = defaults.*member;
            }
          },
          row.member);
    }
  }
}

NodeId push_down(Scene& scene, NodeId node, bool with_transforms) {
  const auto child = static_cast<NodeId>(scene.nodes.size());
  scene.nodes.emplace_back();
  Node& outer = scene.nodes[node];
  Node& inner = scene.nodes[child];
  inner.location = outer.location;
  inner.lights = std::exchange(outer.lights, {});
  inner.primitives = std::exchange(outer.primitives, {});
  inner.children = std::exchange(outer.children, {child});
  inner.instance_of = std::exchange(outer.instance_of, {});
  if (with_transforms) {
    inner.transforms = std::exchange(outer.transforms, {});
  }
  return child;
}

NodeId add_front_children(Scene& scene, NodeId node, std::size_t count) {
  const auto first = static_cast<NodeId>(scene.nodes.size());
  std::vector<NodeId> children;
  for (std::size_t i = 0; i < count; ++i) {
    children.push_back(static_cast<NodeId>(scene.nodes.size()));
    scene.nodes.emplace_back();
  }
  std::vector<NodeId>& all = scene.nodes[node].children;
  all.insert(all.begin(), children.begin(), children.end());
  return first;
}

void drop_empty_groups(Scene& scene, std::vector<bool> lit, Diagnostics& diagnostics) {
  lit.resize(scene.nodes.size());
  std::vector<bool> empty(scene.nodes.size());
  std::size_t dropped = 0;
  Location first;
  const std::vector<NodeId> order = nodes_in_order(scene);
  // From the leaves up, so that groups that only contain empty groups are removed too.
  for (std::size_t i = order.size(); i-- > 0;) {
    Node& node = scene.nodes[order[i]];
    for (const NodeId child : node.children) {
      lit[order[i]] = lit[order[i]] || lit[child];
      if (empty[child] && !lit[child]) {
        ++dropped;
        first = scene.nodes[child].location;
      }
    }
    const auto gone = std::remove_if(node.children.begin(), node.children.end(),
                                     [&](NodeId child) { return empty[child]; });
    node.children.erase(gone, node.children.end());
    empty[order[i]] = node.children.empty() && node.primitives.empty() && node.lights.empty() &&
                      node.instance_of.empty();
  }
  if (dropped != 0) {
    diagnostics.report("write.empty-group"_code, first,
                       fmt::format("{} empty group{} left out, the first one here", dropped,
                                   dropped == 1 ? " is" : "s are"));
  }
}

std::string NameTable::make_free(const std::string& name) {
  std::size_t& number = last_number_.try_emplace(name, 1).first->second;
  while (true) {
    std::string candidate = fmt::format("{}-{}", name, ++number);
    if (take(candidate)) {
      return candidate;
    }
  }
}

}  // namespace scenefile
