#pragma once
// Paths of nodes for messages.

#include "scenefile/scene/scene.h"

#include <cstdint>
#include <string>
#include <vector>

namespace scenefile {

/// Names from the root (or template) down to the node, joined by '/'; a nameless node appears as
/// `#k`, its position among its siblings from 1.
std::string node_path(const Scene& scene, NodeId node);

/// The parents of all nodes, computed once for many paths.
class NodePaths {
 public:
  explicit NodePaths(const Scene& scene);

  /// Same as node_path().
  std::string path(NodeId node) const;

 private:
  const Scene& scene_;
  std::vector<NodeId> parent_;        // the head of a tree is its own parent
  std::vector<std::uint32_t> place_;  // among its siblings, from 1
};

}  // namespace scenefile
