#pragma once
// Walks over the nodes of a scene without recursion, which end for any scene, including broken
// ones. Internal to scene.

#include "scenefile/scene/scene.h"

#include <cstddef>
#include <utility>
#include <vector>

namespace scenefile {

/// Visits `start` and its descendants, parents first and children in order. For each node,
/// `enter(node, state of its parent)` returns the state for its children; `initial` is the state
/// above `start`. Children of an instance are ignored. Skips indices that are out of range and
/// nodes already marked in `seen` (one flag per node), so that all walks that share `seen` together
/// take linear time.
template <typename State, typename Enter>
void walk_nodes(const Scene& scene, NodeId start, const State& initial, std::vector<bool>& seen,
                Enter enter) {
  struct Frame {
    const std::vector<NodeId>* children;
    std::size_t next;
    State state;
  };
  std::vector<Frame> frames;
  const auto visit = [&](NodeId node, const State& above) {
    if (node >= scene.nodes.size() || seen[node]) {
      return;
    }
    seen[node] = true;
    State state = enter(node, above);
    if (!scene.nodes[node].children.empty() && scene.nodes[node].instance_of.empty()) {
      frames.push_back({&scene.nodes[node].children, 0, std::move(state)});
    }
  };
  visit(start, initial);
  while (!frames.empty()) {
    Frame& top = frames.back();
    if (top.next == top.children->size()) {
      frames.pop_back();
    } else {
      const NodeId child = (*top.children)[top.next++];
      visit(child, top.state);
    }
  }
}

/// The heads of the scene's trees: the templates in their order, then the root.
inline std::vector<NodeId> tree_heads(const Scene& scene) {
  std::vector<NodeId> heads = scene.templates;
  heads.push_back(scene.root);
  return heads;
}

}  // namespace scenefile
