#include "scenefile/scene/diff_drawn.h"

#include "scenefile/base/limits.h"
#include "scenefile/base/shape_traits.h"
#include "scenefile/base/text.h"
#include "scenefile/scene/diff_list.h"
#include "scenefile/scene/transforms.h"
#include "scenefile/scene/walk.h"
#include "scenefile/scene/world_lights.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <optional>
#include <unordered_map>
#include <unordered_set>
#include <utility>

namespace scenefile {

namespace {

// A primitive or an instance in the space of its tree.
struct Drawn {
  const Primitive* primitive = nullptr;  // null: an instance
  std::string label;
  NodeId node = 0;
  Location location;
  Affine map;
};

// A light in world space, without values that have no effect.
struct ShownLight {
  Light light;
  std::string turned;  // area light: its rotation, if different from what its direction implies
  Location location;
};

std::string_view label_of(const ShownLight& world) {
  return scenefile::label_of(world.light);
}

Values values_of(const ShownLight& world) {
  Values values = scenefile::values_of(world.light);
  if (has_rectangle(world.light.type)) {
    values.push_back({"turned", world.turned});
  }
  return values;
}

std::string axis_text(const glm::vec3& side) {
  const glm::vec3 axis = glm::length(side) > 0 ? glm::normalize(side) : side;
  return fmt::format("{:.3g} {:.3g} {:.3g}", axis.x + 0.0f, axis.y + 0.0f, axis.z + 0.0f);
}

// Sets the size that the light has in world space.
void size_rectangle(ShownLight& world, const RenderLight& ready) {
  world.light.width = 2 * glm::length(ready.half_u);
  world.light.height = 2 * glm::length(ready.half_v);
  const std::optional<RenderLight> level = ready_light(world.light, DAffine());
  world.turned = level && alike(ready, *level)
                     ? "no"
                     : fmt::format("width along {}, height along {}", axis_text(ready.half_u),
                                   axis_text(ready.half_v));
}

// Makes values equal that differ only by rounding.
void forget_roundings(const std::vector<ShownLight>& of, std::vector<ShownLight>& in) {
  for (std::size_t i = 0; i < std::min(of.size(), in.size()); ++i) {
    const Light& wanted = of[i].light;
    Light& light = in[i].light;
    const auto settle = [](float from, float& to) {
      to = alike(glm::vec3(from), glm::vec3(to)) ? from : to;
    };
    if (has_rectangle(wanted.type) && has_rectangle(light.type)) {
      settle(wanted.width, light.width);
      settle(wanted.height, light.height);
      light.direction =
          alike(wanted.direction, light.direction) ? wanted.direction : light.direction;
    }
  }
}

std::uint64_t hash_of(const Affine& map) {
  std::uint64_t hash = 0;
  for (int i = 0; i < 12; ++i) {
    // Adding 0.0f makes -0 and 0 equal.
    const float value = (i < 9 ? map.linear[i / 3][i % 3] : map.offset[i - 9]) + 0.0f;
    std::uint32_t bits = 0;
    std::memcpy(&bits, &value, sizeof bits);
    hash = mixed(hash, bits);
  }
  return hash;
}

Values material_of(const Drawn& drawn) {
  return drawn.primitive != nullptr ? values_of(*drawn.primitive) : Values{};
}

class DrawnSide {
 public:
  explicit DrawnSide(const Scene& scene) : scene_(scene), parent_(scene.nodes.size(), 0) {
    for (const NodeId head : scene.templates) {
      if (head < scene.nodes.size()) {
        templates_.emplace(scene.nodes[head].name, head);
      }
    }
  }

  const Scene& scene() const { return scene_; }

  std::optional<NodeId> find_template(const std::string& name) const {
    const auto found = templates_.find(name);
    return found == templates_.end() ? std::nullopt : std::optional(found->second);
  }

  // Everything that the tree draws, in the order of the file.
  std::vector<Drawn> objects(std::optional<NodeId> head) {
    std::vector<Drawn> result;
    if (!head) {
      return result;
    }
    struct Above {
      NodeId node;
      DAffine map;
    };
    std::vector<bool> seen(scene_.nodes.size());
    walk_nodes(scene_, *head, Above{*head, {}}, seen, [&](NodeId id, const Above& above) {
      const Node& node = scene_.nodes[id];
      parent_[id] = above.node;
      const DAffine map = composed(above.map, node.transforms);
      const Affine stored(map);
      for (const Primitive& primitive : node.primitives) {
        result.push_back(
            {&primitive, std::string(label_of(primitive)), id, primitive.location, stored});
      }
      if (!node.instance_of.empty()) {
        result.push_back(
            {nullptr, "instance of " + quoted(node.instance_of), id, node.location, stored});
        used_.push_back(node.instance_of);
      }
      return Above{id, map};
    });
    return result;
  }

  // The transforms from the head of the tree to the object.
  Values transforms_of(const Drawn& drawn) const {
    std::vector<NodeId> way{drawn.node};
    while (parent_[way.back()] != way.back()) {
      way.push_back(parent_[way.back()]);
    }
    Node all;
    std::for_each(way.rbegin(), way.rend(), [&](NodeId id) {
      const std::vector<Transform>& own = scene_.nodes[id].transforms;
      all.transforms.insert(all.transforms.end(), own.begin(), own.end());
    });
    return values_of(all);
  }

  // The names of templates that objects() found in use.
  std::vector<std::string> take_used() { return std::exchange(used_, {}); }

  std::vector<ShownLight> lights() const {
    std::vector<ShownLight> result;
    world_lights(scene_, [&](const WorldLight& at) {
      Light light = scene_.nodes[at.node].lights[at.index];
      const std::optional<RenderLight> found = ready_light(light, at.world_from_node);
      if (!found) {
        return true;
      }
      const RenderLight& ready = *found;
      const Location location = light.location;
      light.type = ready.type;
      light.color = ready.color;
      light.position = ready.position;
      light.direction = has_direction(light.type) ? ready.direction : glm::vec3(0);
      light.attenuation = ready.attenuation;
      light.id.reset();
      light.name.clear();
      ShownLight world{std::move(light), "no", location};
      if (has_rectangle(ready.type)) {
        size_rectangle(world, ready);
      }
      result.push_back(std::move(world));
      return result.size() < Limits().lights;
    });
    return result;
  }

 private:
  const Scene& scene_;
  std::vector<NodeId> parent_;
  std::unordered_map<std::string, NodeId> templates_;
  std::vector<std::string> used_;
};

class DrawnComparison {
 public:
  DrawnComparison(const Scene& a, const Scene& b, std::size_t most) : a_(a), b_(b), list_(most) {}

  std::vector<SceneDifference> run() {
    const Scene& a = a_.scene();
    const Scene& b = b_.scene();
    list_.compare_values("global data: ", values_of(a.global), values_of(b.global),
                         a.global.location, b.global.location);
    const Camera camera_a = a.camera.value_or(Camera());
    const Camera camera_b = b.camera.value_or(Camera());
    list_.compare_values("camera: ", values_of(camera_a), values_of(camera_b), camera_a.location,
                         camera_b.location);
    const std::vector<ShownLight> lights = a_.lights();
    std::vector<ShownLight> other_lights = b_.lights();
    forget_roundings(lights, other_lights);
    list_.compare_items("", lights, other_lights);
    compare_trees("root", a.root, b.root);
    while (!pending_.empty() && !list_.full()) {
      const std::string name = std::move(pending_.back());
      pending_.pop_back();
      compare_trees(name, a_.find_template(name), b_.find_template(name));
    }
    return list_.take();
  }

 private:
  void compare_trees(const std::string& name, std::optional<NodeId> head_a,
                     std::optional<NodeId> head_b) {
    compare_objects(escaped(name, 200) + ": ", a_.objects(head_a), b_.objects(head_b));
    for (DrawnSide* const side : {&a_, &b_}) {
      for (std::string& used : side->take_used()) {
        if (seen_.insert(used).second) {
          pending_.push_back(std::move(used));
        }
      }
    }
  }

  void compare_objects(const std::string& where, const std::vector<Drawn>& a,
                       const std::vector<Drawn>& b) {
    const std::vector<std::string> names_a = names(a);
    const std::vector<std::string> names_b = names(b);
    for (const AlignedPair& pair : align(align_items(a), align_items(b))) {
      if (!pair.b) {
        const Drawn& only = a[*pair.a];
        list_.add(where + names_a[*pair.a], description(a_, only), "", only.location, {});
      } else if (!pair.a) {
        const Drawn& only = b[*pair.b];
        list_.add(where + names_b[*pair.b], "", description(b_, only), {}, only.location);
      } else if (!pair.equal) {
        compare_pair(where + names_a[*pair.a] + ": ", a[*pair.a], b[*pair.b]);
      } else if (pair.moved) {
        list_.add(where + names_a[*pair.a], place_text(*pair.a), place_text(*pair.b),
                  a[*pair.a].location, b[*pair.b].location);
      }
    }
  }

  void compare_pair(const std::string& where, const Drawn& a, const Drawn& b) {
    if (!(a.map == b.map)) {
      list_.compare_values(where, a_.transforms_of(a), b_.transforms_of(b), a.location, b.location);
    }
    list_.compare_values(where, material_of(a), material_of(b), a.location, b.location);
  }

  static std::string description(const DrawnSide& side, const Drawn& drawn) {
    Values values = side.transforms_of(drawn);
    const Values material = material_of(drawn);
    values.insert(values.end(), material.begin(), material.end());
    return described(drawn.label, values);
  }

  static std::vector<AlignItem> align_items(const std::vector<Drawn>& objects) {
    std::vector<AlignItem> result;
    for (const Drawn& drawn : objects) {
      const std::uint64_t material = scenefile::hash_of(material_of(drawn));
      result.push_back({mixed(hash_of(drawn.map), material), drawn.label});
    }
    return result;
  }

  static std::vector<std::string> names(const std::vector<Drawn>& objects) {
    std::vector<std::string_view> labels;
    for (const Drawn& drawn : objects) {
      labels.push_back(drawn.label);
    }
    return numbered(labels);
  }

  DrawnSide a_;
  DrawnSide b_;
  DifferenceList list_;
  std::vector<std::string> pending_;
  std::unordered_set<std::string> seen_;
};

}  // namespace

std::vector<SceneDifference> diff_drawn(const Scene& a, const Scene& b, std::size_t most) {
  return DrawnComparison(a, b, most).run();
}

}  // namespace scenefile
