#pragma once
// The graph of which template instantiates which. Internal to scene.

#include "scenefile/scene/scene.h"

#include <cstdint>
#include <span>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace scenefile {

/// Templates by name, as indices into Scene::templates; the first one if several share a name. The
/// keys refer to strings in the scene.
using TemplateNames = std::unordered_map<std::string_view, std::uint32_t>;
TemplateNames template_names(const Scene& scene);

/// The edges of a directed graph, sorted by source vertex.
struct Graph {
  std::vector<std::uint32_t> first;  ///< of each vertex: index into `target`; one extra at the end
  std::vector<std::uint32_t> target;

  std::uint32_t size() const { return static_cast<std::uint32_t>(first.size() - 1); }
  std::span<const std::uint32_t> targets(std::uint32_t vertex) const {
    return std::span(target).subspan(first[vertex], first[vertex + 1] - first[vertex]);
  }
};

/// Depth-first search from `starts`, with targets in order. Calls `leave(vertex)` once for each
/// vertex, after all its targets, and `loop(way, edge)` for each back edge (an index into `target`)
/// with the part of the current path that it closes, its first vertex first.
template <typename Leave, typename Loop>
void visit_depth_first(const Graph& graph, std::span<const std::uint32_t> starts, Leave leave,
                       Loop loop) {
  constexpr std::uint32_t unseen = 0xffffffffu;
  constexpr std::uint32_t done = 0xfffffffeu;
  std::vector<std::uint32_t> depth(graph.size(),
                                   unseen);  // on the current path, or one of the above
  std::vector<std::uint32_t> way;
  std::vector<std::uint32_t>
      next;  // of each vertex on the path: the next edge, an index into `target`
  const auto enter = [&](std::uint32_t vertex) {
    depth[vertex] = static_cast<std::uint32_t>(way.size());
    way.push_back(vertex);
    next.push_back(graph.first[vertex]);
  };
  for (const std::uint32_t start : starts) {
    if (depth[start] == unseen) {
      enter(start);
    }
    while (!way.empty()) {
      const std::uint32_t vertex = way.back();
      if (next.back() == graph.first[vertex + 1]) {
        depth[vertex] = done;
        leave(vertex);
        way.pop_back();
        next.pop_back();
        continue;
      }
      const std::uint32_t target = graph.target[next.back()++];
      if (depth[target] == unseen) {
        enter(target);
      } else if (depth[target] != done) {
        loop(std::span<const std::uint32_t>(way).subspan(depth[target]), next.back() - 1);
      }
    }
  }
}

/// The trees of a scene (in the order of tree_heads(), so the root is last) and the instances in
/// them.
struct TemplateGraph {
  std::vector<NodeId> heads;
  std::vector<NodeId> instances;  ///< all, also those whose template does not exist
  Graph uses;                     ///< an edge from a tree to the template of each of its instances
  std::vector<NodeId> use_node;   ///< the node of the instance, for each edge of `uses`

  std::uint32_t root() const { return uses.size() - 1; }
};
TemplateGraph template_graph(const Scene& scene);

/// Vertices in topological order: each after all its targets, with its rank in that order. A back
/// edge leads to the same or a higher rank.
struct ContainmentOrder {
  std::vector<std::uint32_t> vertices;
  std::vector<std::uint32_t> rank;
};
ContainmentOrder containment_order(const Graph& graph);

/// Sums a value over each vertex with all instances: its own plus the total of each target.
/// Saturates at infinity; back edges are ignored.
std::vector<double> totals(const Graph& graph, std::vector<double> own);

/// The length of the longest path from each vertex; back edges are ignored.
std::vector<std::uint32_t> heights(const Graph& graph);

}  // namespace scenefile
