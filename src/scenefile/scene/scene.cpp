#include "scenefile/scene/scene.h"

#include "scenefile/scene/vocabulary.h"

#include <algorithm>
#include <iterator>
#include <tuple>
#include <type_traits>
#include <utility>
#include <variant>

namespace scenefile {

namespace {

constexpr NodeId no_node = 0xffffffffu;

// Compares trees of nodes pair by pair, without recursion. Each node is compared only once, so that
// this ends for scenes with shared children or loops too.
class TreeComparison {
 public:
  TreeComparison(const Scene& a, const Scene& b)
      : a_(a), b_(b), partner_(a.nodes.size(), no_node) {}

  bool equal(NodeId a, NodeId b) {
    if (!push(a, b)) {
      return false;
    }
    while (!pending_.empty()) {
      const auto [na, nb] = pending_.back();
      pending_.pop_back();
      if (!equal_contents(a_.nodes[na], b_.nodes[nb])) {
        return false;
      }
    }
    return true;
  }

 private:
  bool push(NodeId a, NodeId b) {
    if (a >= a_.nodes.size() || b >= b_.nodes.size()) {
      return a >= a_.nodes.size() && b >= b_.nodes.size();
    }
    if (partner_[a] != no_node) {
      return partner_[a] == b;
    }
    partner_[a] = b;
    pending_.emplace_back(a, b);
    return true;
  }

  bool equal_contents(const Node& a, const Node& b) {
    if (std::tie(a.name, a.instance_of, a.transforms, a.lights, a.primitives) !=
            std::tie(b.name, b.instance_of, b.transforms, b.lights, b.primitives) ||
        a.children.size() != b.children.size()) {
      return false;
    }
    for (std::size_t i = 0; i < a.children.size(); ++i) {
      if (!push(a.children[i], b.children[i])) {
        return false;
      }
    }
    return true;
  }

  const Scene& a_;
  const Scene& b_;
  std::vector<NodeId> partner_;  // of each node of a, in b
  std::vector<std::pair<NodeId, NodeId>> pending_;
};

// Everything but the places.
template <typename Owner, std::size_t N>
bool same_values(const ValueRow<Owner> (&rows)[N], const Owner& a, const Owner& b) {
  return std::all_of(std::begin(rows), std::end(rows), [&](const ValueRow<Owner>& row) {
    return std::visit(
        [&](const auto& member) {
          if constexpr (std::is_same_v<decltype(member), const std::monostate&>) {
            return true;
          } else {
            return a.*member == b.*member;
          }
        },
        row.member);
  });
}

NodeId append(Scene& scene) {
  scene.nodes.emplace_back();
  return static_cast<NodeId>(scene.nodes.size() - 1);
}

}  // namespace

bool operator==(const Global& a, const Global& b) {
  return same_values(global_rows, a, b);
}

bool operator==(const Camera& a, const Camera& b) {
  return same_values(camera_rows, a, b);
}

bool operator==(const TextureUse& a, const TextureUse& b) {
  return std::tie(a.file, a.repeat_u, a.repeat_v) == std::tie(b.file, b.repeat_u, b.repeat_v);
}

bool operator==(const Primitive& a, const Primitive& b) {
  return std::tie(a.shape, a.mesh_file, a.material) == std::tie(b.shape, b.mesh_file, b.material);
}

bool operator==(const Light& a, const Light& b) {
  return a.type == b.type && same_values(light_rows, a, b);
}

bool operator==(const Scene& a, const Scene& b) {
  if (std::tie(a.name, a.global, a.camera) != std::tie(b.name, b.global, b.camera) ||
      a.templates.size() != b.templates.size()) {
    return false;
  }
  TreeComparison trees(a, b);
  for (std::size_t i = 0; i < a.templates.size(); ++i) {
    if (!trees.equal(a.templates[i], b.templates[i])) {
      return false;
    }
  }
  return trees.equal(a.root, b.root);
}

NodeId add_child(Scene& scene, NodeId parent) {
  const NodeId child = append(scene);
  scene.nodes[parent].children.push_back(child);
  return child;
}

NodeId add_template(Scene& scene, std::string name) {
  const NodeId node = append(scene);
  scene.nodes[node].name = std::move(name);
  scene.templates.push_back(node);
  return node;
}

}  // namespace scenefile
