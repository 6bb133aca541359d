#include "scenefile/scene/world_lights.h"

#include "scenefile/base/shape_traits.h"
#include "scenefile/scene/template_graph.h"
#include "scenefile/scene/transforms.h"
#include "scenefile/scene/vocabulary.h"
#include "scenefile/scene/walk.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace scenefile {

namespace {

bool finite(const glm::dvec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

std::optional<glm::dvec3> unit(const glm::dvec3& v) {
  const double length = glm::length(v);
  if (!(length > 0) || !std::isfinite(length)) {
    return std::nullopt;
  }
  return v / length;
}

// All zeros would divide by zero; the limit of the formula is no attenuation.
glm::vec3 safe_attenuation(const glm::vec3& written) {
  const glm::vec3 coefficients = glm::max(written, glm::vec3(0));
  return coefficients == glm::vec3(0) ? glm::vec3(1, 0, 0) : coefficients;
}

void set_cone(RenderLight& ready, const Light& light) {
  const double penumbra = std::max(0.0, static_cast<double>(light.penumbra_deg));
  const double outer = std::clamp<double>(light.angle_deg.value_or(light.penumbra_deg), 0, 180);
  ready.outer_angle = static_cast<float>(outer * std::numbers::pi / 180);
  ready.inner_angle = static_cast<float>(std::max(0.0, outer - penumbra) * std::numbers::pi / 180);
}

// The format does not define how the rectangle is rotated about its direction: `width` is level and
// `height` upright, like a picture on a wall.
void set_rectangle(RenderLight& ready, const Light& light, const glm::dvec3& direction,
                   const DAffine& space_from_node) {
  const glm::dvec3 up(0, 1, 0);
  const glm::dvec3 side = glm::cross(direction, up);
  const glm::dvec3 u = glm::length(side) > 1e-6 ? glm::normalize(side) : glm::dvec3(1, 0, 0);
  const glm::dvec3 v = glm::normalize(glm::cross(u, direction));
  const glm::dvec3 half_u = space_from_node.vector(u * (std::max(0.0f, light.width) / 2.0));
  const glm::dvec3 half_v = space_from_node.vector(v * (std::max(0.0f, light.height) / 2.0));
  ready.half_u = glm::vec3(half_u);
  ready.half_v = glm::vec3(half_v);
  // Under a shear, the normal of the rectangle is not the image of the old normal.
  if (const std::optional<glm::dvec3> normal = unit(glm::cross(half_u, half_v))) {
    const bool front = glm::dot(*normal, glm::dvec3(ready.direction)) >= 0;
    ready.direction = glm::vec3(front ? *normal : -*normal);
  }
}

// Marks the nodes that contain lights, their ancestors, and the instances of templates with lights.
class LitNodes {
 public:
  LitNodes(const Scene& scene, const TemplateNames& names)
      : parent_(scene.nodes.size(), none),
        instances_(scene.templates.size()),
        template_of_(scene.nodes.size(), none),
        lit_(scene.nodes.size()) {
    for (NodeId id = 0; id < scene.nodes.size(); ++id) {
      const Node& node = scene.nodes[id];
      if (!node.instance_of.empty()) {
        if (const auto found = names.find(node.instance_of); found != names.end()) {
          instances_[found->second].push_back(id);
        }
        continue;
      }
      for (const NodeId child : node.children) {
        if (child < parent_.size()) {
          parent_[child] = id;
        }
      }
      if (!node.lights.empty()) {
        pending_.push_back(id);
      }
    }
    for (const auto& [name, index] : names) {
      template_of_[scene.templates[index]] = index;
    }
  }

  std::vector<bool> take() {
    while (!pending_.empty()) {
      NodeId id = pending_.back();
      pending_.pop_back();
      for (; id != none && !lit_[id]; id = parent_[id]) {
        lit_[id] = true;
        if (template_of_[id] != none) {
          const std::vector<NodeId>& instances = instances_[template_of_[id]];
          pending_.insert(pending_.end(), instances.begin(), instances.end());
        }
      }
    }
    return std::move(lit_);
  }

 private:
  static constexpr std::uint32_t none = 0xffffffffu;

  std::vector<NodeId> parent_;
  std::vector<std::vector<NodeId>> instances_;  // of each template
  std::vector<std::uint32_t> template_of_;      // of each node that is the head of a template
  std::vector<bool> lit_;
  std::vector<NodeId> pending_;
};

// The root or a template with its nodes folded, keeping only nodes that contain lights.
struct LitTree {
  struct Use {
    std::uint32_t tree;
    DAffine tree_from_use;
  };
  std::vector<WorldLight> lights;  // in the space of the tree
  std::vector<Use> uses;
};

// One for each template, then one for the root.
std::vector<LitTree> lit_trees(const Scene& scene) {
  const TemplateNames names = template_names(scene);
  std::vector<bool> seen = LitNodes(scene, names).take();
  seen.flip();
  std::vector<LitTree> trees;
  for (const NodeId head : tree_heads(scene)) {
    LitTree& tree = trees.emplace_back();
    walk_nodes(scene, head, DAffine(), seen, [&](NodeId id, const DAffine& outer) {
      const Node& node = scene.nodes[id];
      const DAffine map = composed(outer, node.transforms);
      if (!node.instance_of.empty()) {
        tree.uses.push_back({names.find(node.instance_of)->second, map});
        return map;
      }
      for (std::uint32_t i = 0; i < node.lights.size(); ++i) {
        tree.lights.push_back({id, i, map});
      }
      return map;
    });
  }
  return trees;
}

std::vector<std::uint32_t> containment_rank(const std::vector<LitTree>& trees) {
  Graph graph;
  for (const LitTree& tree : trees) {
    graph.first.push_back(static_cast<std::uint32_t>(graph.target.size()));
    for (const LitTree::Use& use : tree.uses) {
      graph.target.push_back(use.tree);
    }
  }
  graph.first.push_back(static_cast<std::uint32_t>(graph.target.size()));
  return containment_order(graph).rank;
}

}  // namespace

std::optional<RenderLight> ready_light(const Light& light, const DAffine& space_from_node) {
  RenderLight ready;
  ready.type = light.type;
  ready.color = light.color;
  if (light_uses(light.type, Field::position)) {
    const glm::dvec3 position = space_from_node.point(glm::dvec3(light.position));
    if (!finite(position)) {
      return std::nullopt;
    }
    ready.position = glm::vec3(position);
    ready.attenuation = safe_attenuation(light.attenuation);
  }
  if (!light_uses(light.type, Field::direction)) {
    return ready;
  }
  const std::optional<glm::dvec3> local = unit(glm::dvec3(light.direction));
  const std::optional<glm::dvec3> world =
      local ? unit(space_from_node.vector(*local)) : std::nullopt;
  if (!world) {
    return std::nullopt;
  }
  ready.direction = glm::vec3(*world);
  if (light_uses(light.type, Field::angle_deg)) {
    set_cone(ready, light);
  } else if (light_uses(light.type, Field::width)) {
    set_rectangle(ready, light, *local, space_from_node);
  }
  return ready;
}

bool alike(const glm::vec3& a, const glm::vec3& b) {
  return glm::length(glm::dvec3(a) - glm::dvec3(b)) <= 1e-5 * glm::length(glm::dvec3(a));
}

bool alike(const RenderLight& a, const RenderLight& b) {
  const auto same_side = [](const glm::vec3& x, const glm::vec3& y) {
    return alike(x, y) || alike(x, -y);
  };
  RenderLight moved = b;
  if (has_rectangle(a.type) && alike(a.direction, b.direction) && same_side(a.half_u, b.half_u) &&
      same_side(a.half_v, b.half_v)) {
    moved.direction = a.direction;
    moved.half_u = a.half_u;
    moved.half_v = a.half_v;
  }
  return a == moved;
}

void world_lights(const Scene& scene, const std::function<bool(const WorldLight&)>& visit) {
  const std::vector<LitTree> trees = lit_trees(scene);
  const std::vector<std::uint32_t> rank = containment_rank(trees);
  struct Frame {
    std::uint32_t tree;
    std::size_t next;
    DAffine world_from_tree;
  };
  std::vector<Frame> frames;
  // Returns false if the visitor wants no more lights.
  const auto enter = [&](std::uint32_t tree, const DAffine& world_from_tree) {
    for (const WorldLight& light : trees[tree].lights) {
      if (!visit({light.node, light.index, world_from_tree * light.world_from_node})) {
        return false;
      }
    }
    frames.push_back({tree, 0, world_from_tree});
    return true;
  };
  bool wanted = enter(static_cast<std::uint32_t>(trees.size() - 1), DAffine());
  while (wanted && !frames.empty()) {
    Frame& top = frames.back();
    const LitTree& tree = trees[top.tree];
    if (top.next == tree.uses.size()) {
      frames.pop_back();
      continue;
    }
    const LitTree::Use& use = tree.uses[top.next++];
    if (rank[use.tree] < rank[top.tree]) {
      // Rounded like the maps of instances in a render scene, which are single precision.
      wanted = enter(use.tree, top.world_from_tree * DAffine(Affine(use.tree_from_use)));
    }
  }
}

}  // namespace scenefile
