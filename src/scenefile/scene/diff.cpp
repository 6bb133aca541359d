#include "scenefile/scene/diff.h"

#include "scenefile/base/text.h"
#include "scenefile/scene/diff_align.h"
#include "scenefile/scene/diff_drawn.h"
#include "scenefile/scene/diff_list.h"
#include "scenefile/scene/diff_values.h"
#include "scenefile/scene/node_path.h"
#include "scenefile/scene/prepare.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

namespace scenefile {

namespace {

// The heads of trees and all their descendants, parents first, each once.
std::vector<NodeId> parents_first(const Scene& scene) {
  std::vector<NodeId> order;
  std::vector<bool> seen(scene.nodes.size());
  const auto add = [&](NodeId id) {
    if (id < scene.nodes.size() && !seen[id]) {
      seen[id] = true;
      order.push_back(id);
    }
  };
  for (const NodeId id : scene.templates) {
    add(id);
  }
  add(scene.root);
  for (std::size_t i = 0; i < order.size(); ++i) {
    for (const NodeId child : scene.nodes[order[i]].children) {
      add(child);
    }
  }
  return order;
}

// Whether the nodes are equal except for their children.
bool same_values(const Node& a, const Node& b) {
  return hash_of(values_of(a)) == hash_of(values_of(b)) && a.lights == b.lights &&
         a.primitives == b.primitives;
}

// One of the two scenes, with the hashes of its subtrees.
class Side {
 public:
  explicit Side(const Scene& written)
      : scene(written), paths_(written), hashes_(written.nodes.size()) {
    const std::vector<NodeId> order = parents_first(scene);
    for (std::size_t i = order.size(); i-- > 0;) {
      hashes_[order[i]] = hash_of_tree(scene.nodes[order[i]]);
    }
  }

  bool has(NodeId id) const { return id < scene.nodes.size(); }
  std::uint64_t hash(NodeId id) const { return hashes_[id]; }
  std::string path(NodeId id) const { return paths_.path(id); }

  Location location(NodeId id) const { return scene.nodes[id].location; }

  std::string description(NodeId id) const {
    const Node& node = scene.nodes[id];
    if (!node.instance_of.empty()) {
      return "an instance of " + quoted(node.instance_of);
    }
    return fmt::format("a group of {} primitives, {} lights and {} children",
                       node.primitives.size(), node.lights.size(), node.children.size());
  }

  std::vector<NodeId> existing(const std::vector<NodeId>& nodes) const {
    std::vector<NodeId> result;
    std::copy_if(nodes.begin(), nodes.end(), std::back_inserter(result),
                 [this](NodeId id) { return has(id); });
    return result;
  }

  std::vector<AlignItem> items(const std::vector<NodeId>& nodes) const {
    std::vector<AlignItem> result;
    for (const NodeId id : nodes) {
      const Node& node = scene.nodes[id];
      result.push_back({hashes_[id], !node.name.empty() ? node.name : node.instance_of});
    }
    return result;
  }

  const Scene& scene;

 private:
  std::uint64_t hash_of_tree(const Node& node) const {
    std::uint64_t hash = hash_of(values_of(node));
    const std::uint64_t counts[] = {node.lights.size(), node.primitives.size(),
                                    node.children.size()};
    for (const std::uint64_t count : counts) {
      hash = mixed(hash, count);
    }
    for (const Light& light : node.lights) {
      hash = mixed(hash, hash_of(values_of(light)));
    }
    for (const Primitive& primitive : node.primitives) {
      hash = mixed(hash, hash_of(values_of(primitive)));
    }
    for (const NodeId child : node.children) {
      hash = mixed(hash, has(child) ? hashes_[child] : 0);
    }
    return hash;
  }

  NodePaths paths_;
  std::vector<std::uint64_t> hashes_;
};

class Comparison {
 public:
  Comparison(const Scene& a, const Scene& b, std::size_t most) : a_(a), b_(b), list_(most) {}

  std::vector<SceneDifference> run() {
    const Scene& a = a_.scene;
    const Scene& b = b_.scene;
    if (a.name != b.name) {
      list_.add("scene name", quoted(a.name), quoted(b.name), {}, {});
    }
    list_.compare_values("global data: ", values_of(a.global), values_of(b.global),
                         a.global.location, b.global.location);
    compare_cameras(a.camera, b.camera);
    if (a_.has(a.root) && b_.has(b.root)) {
      pending_.emplace_back(a.root, b.root);
    }
    compare_nodes(a.templates, b.templates);
    while (!pending_.empty() && !list_.full()) {
      const auto [in_a, in_b] = pending_.back();
      pending_.pop_back();
      if (a_.hash(in_a) != b_.hash(in_b)) {
        compare(in_a, in_b);
      }
    }
    return list_.take();
  }

 private:
  void compare_cameras(const std::optional<Camera>& a, const std::optional<Camera>& b) {
    const Location in_a = a.value_or(Camera{}).location;
    const Location in_b = b.value_or(Camera{}).location;
    if (a && b) {
      list_.compare_values("camera: ", values_of(*a), values_of(*b), in_a, in_b);
    } else if (a || b) {
      list_.add("camera", a ? "given" : "not given", b ? "given" : "not given", in_a, in_b);
    }
  }

  void compare(NodeId in_a, NodeId in_b) {
    const Node& a = a_.scene.nodes[in_a];
    const Node& b = b_.scene.nodes[in_b];
    // Most nodes on a path are equal, and building a path takes time proportional to its depth.
    if (!same_values(a, b)) {
      const std::string where = a_.path(in_a) + ": ";
      list_.compare_values(where, values_of(a), values_of(b), a.location, b.location);
      list_.compare_items(where, a.lights, b.lights);
      list_.compare_items(where, a.primitives, b.primitives);
    }
    compare_nodes(a.children, b.children);
  }

  void compare_nodes(const std::vector<NodeId>& all_of_a, const std::vector<NodeId>& all_of_b) {
    const std::vector<NodeId> a = a_.existing(all_of_a);
    const std::vector<NodeId> b = b_.existing(all_of_b);
    const std::size_t first_added = pending_.size();
    for (const AlignedPair& pair : align(a_.items(a), b_.items(b))) {
      if (!pair.b) {
        const NodeId id = a[*pair.a];
        list_.add(a_.path(id), a_.description(id), "", a_.location(id), {});
      } else if (!pair.a) {
        const NodeId id = b[*pair.b];
        list_.add(b_.path(id), "", b_.description(id), {}, b_.location(id));
      } else if (!pair.equal) {
        pending_.emplace_back(a[*pair.a], b[*pair.b]);
      } else if (pair.moved) {
        list_.add(a_.path(a[*pair.a]), place_text(*pair.a), place_text(*pair.b),
                  a_.location(a[*pair.a]), b_.location(b[*pair.b]));
      }
    }
    // Reversed, so that the first child is compared first.
    std::reverse(pending_.begin() + static_cast<std::ptrdiff_t>(first_added), pending_.end());
  }

  Side a_;
  Side b_;
  DifferenceList list_;
  std::vector<std::pair<NodeId, NodeId>> pending_;
};

}  // namespace

std::vector<SceneDifference> diff(const Scene& a, const Scene& b, std::size_t most) {
  if (a == b) {
    return {};
  }
  return Comparison(a, b, most).run();
}

SceneDiff diff_meaning(const Scene& a, const Scene& b, std::size_t most) {
  SceneDiff result;
  result.equal = a == b;
  result.same_meaning = result.equal || same_meaning(a, b);
  if (!result.same_meaning) {
    // Use the shorter of the two descriptions: scenes with the same grouping differ in few nodes;
    // others (for example in another dialect) only in what they draw.
    result.differences = diff(a, b, most);
    std::vector<SceneDifference> drawn = diff_drawn(a, b, most);
    if (!drawn.empty() && drawn.size() < result.differences.size()) {
      result.differences = std::move(drawn);
    }
  }
  return result;
}

std::string difference_text(const SceneDifference& difference) {
  if (difference.b.empty()) {
    return fmt::format("{}: only in the first: {}", difference.where, difference.a);
  }
  if (difference.a.empty()) {
    return fmt::format("{}: only in the second: {}", difference.where, difference.b);
  }
  return fmt::format("{}: {} -> {}", difference.where, difference.a, difference.b);
}

}  // namespace scenefile
