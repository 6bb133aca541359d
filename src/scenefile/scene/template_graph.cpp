#include "scenefile/scene/template_graph.h"

#include "scenefile/scene/walk.h"

#include <algorithm>
#include <numeric>

namespace scenefile {

namespace {

// Calls `add(source, target)` for each edge that is not a back edge, once `target` is complete.
template <typename Add>
void accumulate(const Graph& graph, Add add) {
  const ContainmentOrder order = containment_order(graph);
  for (const std::uint32_t vertex : order.vertices) {
    for (const std::uint32_t target : graph.targets(vertex)) {
      if (order.rank[target] < order.rank[vertex]) {
        add(vertex, target);
      }
    }
  }
}

}  // namespace

ContainmentOrder containment_order(const Graph& graph) {
  ContainmentOrder order;
  order.rank.resize(graph.size());
  std::vector<std::uint32_t> all(graph.size());
  std::iota(all.begin(), all.end(), 0u);
  visit_depth_first(
      graph, all,
      [&](std::uint32_t vertex) {
        order.rank[vertex] = static_cast<std::uint32_t>(order.vertices.size());
        order.vertices.push_back(vertex);
      },
      [](std::span<const std::uint32_t>, std::uint32_t) {});
  return order;
}

TemplateNames template_names(const Scene& scene) {
  TemplateNames names;
  for (std::uint32_t i = 0; i < scene.templates.size(); ++i) {
    const NodeId node = scene.templates[i];
    if (node < scene.nodes.size() && !scene.nodes[node].name.empty()) {
      names.emplace(scene.nodes[node].name, i);
    }
  }
  return names;
}

TemplateGraph template_graph(const Scene& scene) {
  TemplateGraph graph;
  graph.heads = tree_heads(scene);
  const TemplateNames names = template_names(scene);
  std::vector<bool> seen(scene.nodes.size());
  for (const NodeId head : graph.heads) {
    graph.uses.first.push_back(static_cast<std::uint32_t>(graph.uses.target.size()));
    walk_nodes(scene, head, 0, seen, [&](NodeId id, int) {
      if (scene.nodes[id].instance_of.empty()) {
        return 0;
      }
      graph.instances.push_back(id);
      const auto found = names.find(scene.nodes[id].instance_of);
      if (found != names.end()) {
        graph.uses.target.push_back(found->second);
        graph.use_node.push_back(id);
      }
      return 0;
    });
  }
  graph.uses.first.push_back(static_cast<std::uint32_t>(graph.uses.target.size()));
  return graph;
}

std::vector<double> totals(const Graph& graph, std::vector<double> own) {
  accumulate(graph, [&](std::uint32_t holder, std::uint32_t held) { own[holder] += own[held]; });
  return own;
}

std::vector<std::uint32_t> heights(const Graph& graph) {
  std::vector<std::uint32_t> height(graph.size());
  accumulate(graph, [&](std::uint32_t holder, std::uint32_t held) {
    height[holder] = std::max(height[holder], height[held] + 1);
  });
  return height;
}

}  // namespace scenefile
