#pragma once
// Names of nodes for messages. For one name there is node_path() of prepare.h.

#include "scenefile/scene/scene.h"

#include <cstdint>
#include <string>
#include <vector>

namespace scenefile {

/// The way up from each node, found once for many paths.
class NodePaths {
 public:
  explicit NodePaths(const Scene& scene);

  /// As node_path().
  std::string path(NodeId node) const;

 private:
  const Scene& scene_;
  std::vector<NodeId> parent_;        // of itself for a head of a tree
  std::vector<std::uint32_t> place_;  // among its siblings, from 1
};

}  // namespace scenefile
