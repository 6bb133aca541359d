#include "scenefile/scene/flatten.h"

#include "scenefile/scene/transforms.h"
#include "scenefile/scene/walk.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace scenefile {

namespace {

class Flattener {
 public:
  Flattener(const Scene& scene, Spellings& spellings)
      : scene_(scene), spellings_(spellings), seen_(scene.nodes.size()) {
    flat_.global = scene.global;
    flat_.camera = scene.camera;
  }

  std::optional<Scene> run() {
    for (const NodeId head : scene_.templates) {
      add_contents(head, add_template(flat_, scene_.nodes[head].name));
    }
    add_contents(scene_.root, flat_.root);
    return left_ == 0 ? std::nullopt : std::optional(std::move(flat_));
  }

 private:
  using Transforms = std::vector<Transform>;

  void add_contents(NodeId head, NodeId flat_head) {
    flat_.nodes[flat_head].location = scene_.nodes[head].location;
    walk_nodes(scene_, head, Transforms(), seen_, [&](NodeId id, const Transforms& above) {
      const Node& node = scene_.nodes[id];
      if (left_ <= above.size() + node.transforms.size()) {
        left_ = 0;
        return Transforms();
      }
      left_ -= above.size() + node.transforms.size();
      Transforms all = above;
      all.insert(all.end(), node.transforms.begin(), node.transforms.end());
      add_objects(node, flat_head, spelled(all, node.location));
      return all;
    });
  }

  void add_objects(const Node& node, NodeId flat_head, const Transforms& transforms) {
    const auto add = [&](Location location) -> Node& {
      left_ -= std::min(left_, transforms.size() + 1);
      Node& child = flat_.nodes[add_child(flat_, flat_head)];
      child.transforms = transforms;
      child.location = location;
      return child;
    };
    if (!node.instance_of.empty()) {
      add(node.location).instance_of = node.instance_of;
      return;
    }
    for (const Light& light : node.lights) {
      add(light.location).lights.push_back(light);
    }
    for (const Primitive& primitive : node.primitives) {
      add(primitive.location).primitives.push_back(primitive);
    }
  }

  Transforms spelled(const Transforms& transforms, Location location) {
    const std::optional<Affine> map = storable(composed(DAffine(), transforms));
    if (!map) {
      return transforms;
    }
    std::array<float, 12> key{};
    for (std::size_t i = 0; i < key.size(); ++i) {
      const auto row = static_cast<int>(i % 3);
      key[i] = i < 9 ? map->linear[static_cast<int>(i / 3)][row] : map->offset[row];
    }
    Transforms result = spellings_.try_emplace(key, transforms).first->second;
    for (Transform& transform : result) {
      transform.location = location;
    }
    return result;
  }

  const Scene& scene_;
  Spellings& spellings_;
  Scene flat_;
  std::vector<bool> seen_;
  std::size_t left_ = 500'000;  // transforms
};

}  // namespace

std::optional<Scene> flattened(const Scene& scene, Spellings& spellings) {
  return Flattener(scene, spellings).run();
}

}  // namespace scenefile
