#pragma once
// Paths of nodes for messages. For a single path, use node_path() of prepare.h.

#include "scenefile/scene/scene.h"

#include <cstdint>
#include <string>
#include <vector>

namespace scenefile {

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
