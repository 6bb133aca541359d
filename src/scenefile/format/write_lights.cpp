#include "scenefile/format/write_lights.h"

#include "scenefile/base/affine.h"
#include "scenefile/base/text.h"
#include "scenefile/format/write_codes.h"
#include "scenefile/scene/prepare_parts.h"
#include "scenefile/scene/template_graph.h"
#include "scenefile/scene/transforms.h"
#include "scenefile/scene/walk.h"

#include <fmt/format.h>

#include <cmath>
#include <optional>

namespace scenefile {

namespace {

// A direction that comes out as `wanted`, to the bit, when it is made a unit vector again. The
// wanted one itself may miss by a rounding.
glm::vec3 stable_direction(const Light& light, const RenderLight& wanted) {
  Light trial = light;
  const auto comes_out = [&](const glm::vec3& direction) {
    trial.direction = direction;
    const std::optional<RenderLight> ready = ready_light(trial, DAffine());
    return ready && ready->direction == wanted.direction;
  };
  if (comes_out(light.direction)) {
    return light.direction;
  }
  // Nearly always one of the first few lengths does it.
  constexpr int lengths = 4096;
  for (int i = 0; i < lengths; ++i) {
    const glm::vec3 longer = wanted.direction * (1.0f + static_cast<float>(i) / lengths);
    if (comes_out(longer)) {
      return longer;
    }
  }
  return wanted.direction;
}

bool is_finite(const RenderLight& light) {
  const glm::vec3 sum = glm::abs(light.position) + glm::abs(light.half_u) + glm::abs(light.half_v);
  return std::isfinite(2 * (sum.x + sum.y + sum.z));
}

class WorldLights {
 public:
  WorldLights(const Scene& scene, const Limits& limits, Diagnostics& diagnostics)
      : scene_(scene), limits_(limits), diagnostics_(diagnostics) {
    collect();
    find_lit_trees();
  }

  // Enters trees that lead to lights and no others: the steps are bounded by lights times nesting.
  std::vector<Light> run() {
    enter(root_, DAffine());
    while (!frames_.empty() && !full_) {
      Frame& top = frames_.back();
      const Tree& tree = trees_[top.tree];
      if (top.next == tree.uses.size()) {
        frames_.pop_back();
        continue;
      }
      const Use& use = tree.uses[top.next++];
      if (leads_to_light_[use.tree] > 0 && order_.rank[use.tree] < order_.rank[top.tree]) {
        // A ready scene stores the maps of instances in single precision.
        enter(use.tree, top.world_from_tree * DAffine(Affine(use.tree_from_use)));
      }
    }
    if (moved_ != 0) {
      diagnostics_.report(write_light_moved, first_moved_,
                          fmt::format("{} light{} moved from groups to the top of the file", moved_,
                                      moved_ == 1 ? " is" : "s are"));
    }
    return std::move(lights_);
  }

 private:
  struct Place {
    NodeId node;
    DAffine tree_from_node;
  };
  struct Use {
    std::uint32_t tree;
    DAffine tree_from_use;
  };
  // The root or a template, its nodes folded.
  struct Tree {
    std::vector<Place> lit;
    std::vector<Use> uses;
  };
  struct Frame {
    std::uint32_t tree;
    std::size_t next;
    DAffine world_from_tree;
  };

  void collect() {
    const TemplateNames names = template_names(scene_);
    std::vector<bool> seen(scene_.nodes.size());
    for (const NodeId head : tree_heads(scene_)) {
      Tree& tree = trees_.emplace_back();
      walk_nodes(scene_, head, DAffine(), seen, [&](NodeId id, const DAffine& outer) {
        const Node& node = scene_.nodes[id];
        const DAffine map = composed(outer, node.transforms);
        if (const auto found = names.find(node.instance_of); found != names.end()) {
          tree.uses.push_back({found->second, map});
        } else if (!node.lights.empty()) {
          tree.lit.push_back({id, map});
        }
        return map;
      });
    }
    root_ = static_cast<std::uint32_t>(trees_.size() - 1);
  }

  void find_lit_trees() {
    Graph graph;
    std::vector<double> own;
    for (const Tree& tree : trees_) {
      graph.first.push_back(static_cast<std::uint32_t>(graph.target.size()));
      for (const Use& use : tree.uses) {
        graph.target.push_back(use.tree);
      }
      own.push_back(static_cast<double>(tree.lit.size()));
    }
    graph.first.push_back(static_cast<std::uint32_t>(graph.target.size()));
    order_ = containment_order(graph);
    leads_to_light_ = totals(graph, std::move(own));
  }

  void enter(std::uint32_t tree, const DAffine& world_from_tree) {
    for (const Place& place : trees_[tree].lit) {
      for (const Light& light : scene_.nodes[place.node].lights) {
        if (lights_.size() == limits_.lights) {
          full_ = true;
          diagnostics_.report(
              write_light_limit, light.location,
              fmt::format("the scene has more lights than the limit of {}", limits_.lights));
          return;
        }
        add(light, place, world_from_tree * place.tree_from_node);
      }
    }
    frames_.push_back({tree, 0, world_from_tree});
  }

  void add(const Light& light, const Place& place, const DAffine& world_from_node) {
    if (world_from_node == DAffine() && place.node == scene_.root) {
      lights_.push_back(light);
      return;
    }
    const std::optional<RenderLight> ready = ready_light(light, world_from_node);
    if (!ready || !is_finite(*ready)) {
      diagnostics_.report(
          write_light_dark, light.location,
          fmt::format("the {} light lights nothing and is left out", word_of(light.type)));
      return;
    }
    lights_.push_back(placed(light, *ready));
    if (place.node != scene_.root) {
      first_moved_ = moved_ == 0 ? light.location : first_moved_;
      ++moved_;
    }
  }

  Light placed(const Light& light, const RenderLight& ready) {
    Light result = light;
    if (light.type != LightType::directional) {
      result.position = ready.position;
    }
    if (light.type != LightType::point) {
      result.direction = stable_direction(light, ready);
    }
    if (light.type == LightType::area) {
      place_rectangle(result, light, ready);
    }
    return result;
  }

  void place_rectangle(Light& result, const Light& light, const RenderLight& wanted) {
    const auto same_sides = [&] {
      const std::optional<RenderLight> ready = ready_light(result, DAffine());
      return ready && alike(wanted, *ready);
    };
    if (same_sides()) {
      return;
    }
    result.width = static_cast<float>(2 * glm::length(glm::dvec3(wanted.half_u)));
    result.height = static_cast<float>(2 * glm::length(glm::dvec3(wanted.half_v)));
    if (!same_sides()) {
      diagnostics_.report(write_light_turned, light.location,
                          "the area light is turned or skewed by its group in a way that XML "
                          "cannot say");
    }
  }

  const Scene& scene_;
  const Limits& limits_;
  Diagnostics& diagnostics_;
  std::vector<Tree> trees_;  // in the order of tree_heads()
  std::uint32_t root_ = 0;
  ContainmentOrder order_;
  std::vector<double> leads_to_light_;
  std::vector<Frame> frames_;
  std::vector<Light> lights_;
  std::size_t moved_ = 0;
  Location first_moved_;
  bool full_ = false;
};

}  // namespace

std::vector<Light> lights_in_world(const Scene& scene, const Limits& limits,
                                   Diagnostics& diagnostics) {
  return WorldLights(scene, limits, diagnostics).run();
}

}  // namespace scenefile
