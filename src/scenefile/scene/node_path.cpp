#include "scenefile/scene/node_path.h"

#include "scenefile/scene/prepare.h"

#include <fmt/format.h>

#include <numeric>

namespace scenefile {

NodePaths::NodePaths(const Scene& scene)
    : scene_(scene), parent_(scene.nodes.size()), place_(scene.nodes.size(), 0) {
  std::iota(parent_.begin(), parent_.end(), NodeId{0});
  for (NodeId node = 0; node < scene.nodes.size(); ++node) {
    const std::vector<NodeId>& children = scene.nodes[node].children;
    for (std::size_t i = 0; i < children.size(); ++i) {
      if (children[i] < scene.nodes.size()) {
        parent_[children[i]] = node;
        place_[children[i]] = static_cast<std::uint32_t>(i + 1);
      }
    }
  }
}

std::string NodePaths::path(NodeId node) const {
  std::vector<NodeId> way;
  // The bound on the length ends loops of children.
  while (node < scene_.nodes.size() && way.size() <= scene_.nodes.size()) {
    way.push_back(node);
    if (parent_[node] == node) {
      break;
    }
    node = parent_[node];
  }
  std::string text;
  for (std::size_t i = way.size(); i-- > 0;) {
    const std::string& name = scene_.nodes[way[i]].name;
    if (!text.empty()) {
      text += '/';
    }
    if (!name.empty()) {
      text += name;
    } else if (way[i] == scene_.root) {
      text += "root";
    } else {
      text += fmt::format("#{}", place_[way[i]]);
    }
  }
  return text;
}

std::string node_path(const Scene& scene, NodeId node) {
  return NodePaths(scene).path(node);
}

}  // namespace scenefile
