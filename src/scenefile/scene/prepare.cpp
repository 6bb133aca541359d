#include "scenefile/scene/prepare.h"

#include "scenefile/scene/field_places.h"
#include "scenefile/scene/prepare_parts.h"
#include "scenefile/scene/template_graph.h"
#include "scenefile/scene/transforms.h"
#include "scenefile/scene/walk.h"

#include <utility>

namespace scenefile {

namespace {

// Folds the trees of a scene into parts: the root first, then each template that can be drawn, then
// those that are reached through flattened space alone, where only their lights matter.
class PartBuilder {
 public:
  PartBuilder(const Scene& scene, Prepared& prepared)
      : scene_(scene),
        sources_(prepared.sources),
        materials_(prepared.scene),
        places_(scene.field_places),
        names_(template_names(scene)),
        part_of_template_(scene.templates.size(), no_index),
        seen_(scene.nodes.size()) {}

  std::vector<Part> build() {
    add_part(scene_.root, true);
    std::size_t next = 0;
    for (const bool drawn : {true, false}) {
      std::vector<Waiting>& waiting = drawn ? drawn_ : undrawn_;
      // Grows as parts are filled.
      for (std::size_t w = 0; w < waiting.size() || next < parts_.size();) {
        if (next < parts_.size()) {
          fill(static_cast<std::uint32_t>(next++));
        } else {
          connect(waiting[w++], drawn);
        }
      }
    }
    return std::move(parts_);
  }

 private:
  // An instance whose part has no number yet.
  struct Waiting {
    std::uint32_t holder;
    std::uint32_t instance;
    std::uint32_t target;  // into Scene::templates
  };

  void add_part(NodeId head, bool drawn) {
    parts_.emplace_back();
    parts_.back().head = head;
    parts_.back().drawn = drawn;
  }

  void connect(const Waiting& waiting, bool drawn) {
    std::uint32_t& part = part_of_template_[waiting.target];
    if (part == no_index) {
      part = static_cast<std::uint32_t>(parts_.size());
      add_part(scene_.templates[waiting.target], drawn);
    }
    parts_[waiting.holder].instances[waiting.instance].part = part;
  }

  void fill(std::uint32_t index) {
    walk_nodes(scene_, parts_[index].head, DAffine(), seen_,
               [&](NodeId id, const DAffine& part_from_parent) {
                 const DAffine map = composed(part_from_parent, scene_.nodes[id].transforms);
                 if (scene_.nodes[id].instance_of.empty()) {
                   add_contents(parts_[index], id, map);
                 } else {
                   add_instance(index, id, map);
                 }
                 return map;
               });
  }

  void add_contents(Part& part, NodeId id, const DAffine& part_from_node) {
    const Node& node = scene_.nodes[id];
    for (const Light& light : node.lights) {
      part.lights.push_back({&light, part_from_node, add_source(id, light.location)});
    }
    if (!part.drawn || node.primitives.empty()) {
      return;
    }
    const std::optional<Affine> stored = storable(part_from_node);
    if (!stored) {
      return;
    }
    for (const Primitive& primitive : node.primitives) {
      add_primitive(part, primitive, id, *stored);
    }
  }

  void add_primitive(Part& part, const Primitive& primitive, NodeId id, const Affine& map) {
    const bool mesh = primitive.shape == Shape::mesh;
    if (mesh && primitive.mesh_file.empty()) {
      return;
    }
    RenderPrimitive ready;
    ready.group_from_object = map;
    ready.shape = primitive.shape;
    if (mesh) {
      ready.mesh =
          materials_.mesh(primitive.mesh_file, places_.find(primitive.location, Field::mesh_file));
    }
    ready.material = materials_.material(primitive.material);
    ready.source = add_source(id, primitive.location);
    part.primitives.push_back(ready);
  }

  void add_instance(std::uint32_t index, NodeId id, const DAffine& map) {
    const auto target = names_.find(scene_.nodes[id].instance_of);
    if (target == names_.end()) {
      return;
    }
    Part& part = parts_[index];
    const std::optional<Affine> stored = storable(map);
    const bool drawn = part.drawn && stored;
    const auto place = static_cast<std::uint32_t>(part.instances.size());
    part.instances.push_back(
        {stored.value_or(Affine(map)), no_index, add_source(id, scene_.nodes[id].location), drawn});
    (drawn ? drawn_ : undrawn_).push_back({index, place, target->second});
  }

  std::uint32_t add_source(NodeId node, Location location) {
    sources_.push_back({node, location});
    return static_cast<std::uint32_t>(sources_.size() - 1);
  }

  const Scene& scene_;
  std::vector<Source>& sources_;
  MaterialTable materials_;
  FieldPlaces places_;
  TemplateNames names_;
  std::vector<std::uint32_t> part_of_template_;
  std::vector<bool> seen_;
  std::vector<Part> parts_;
  std::vector<Waiting> drawn_;
  std::vector<Waiting> undrawn_;
};

Graph drawn_graph(const std::vector<Part>& parts) {
  Graph graph;
  for (const Part& part : parts) {
    graph.first.push_back(static_cast<std::uint32_t>(graph.target.size()));
    for (const PartInstance& instance : part.instances) {
      if (instance.drawn) {
        graph.target.push_back(instance.part);
      }
    }
  }
  graph.first.push_back(static_cast<std::uint32_t>(graph.target.size()));
  return graph;
}

// Turns parts into groups, contained before holders. A part that draws nothing becomes no group,
// and an instance of it, or one that closes a loop, nothing either.
void add_groups(std::vector<Part>& parts, RenderScene& scene) {
  constexpr std::uint32_t root_part = 0;
  std::vector<std::uint32_t> group_of(parts.size(), no_index);
  const auto leave = [&](std::uint32_t index) {
    Part& part = parts[index];
    RenderGroup group;
    group.primitives = std::move(part.primitives);
    for (const PartInstance& instance : part.instances) {
      if (instance.drawn && group_of[instance.part] != no_index) {
        group.instances.push_back(
            {instance.part_from_instance, group_of[instance.part], instance.source});
      }
    }
    if (index == root_part || !group.primitives.empty() || !group.instances.empty()) {
      group_of[index] = static_cast<std::uint32_t>(scene.groups.size());
      scene.groups.push_back(std::move(group));
    }
  };
  visit_depth_first(drawn_graph(parts), std::span(&root_part, 1), leave,
                    [](std::span<const std::uint32_t>, std::uint32_t) {});
  scene.root = group_of[root_part];
}

RenderGlobal ready_global(const Global& global) {
  return {global.ambient, global.diffuse, global.specular, global.transparent};
}

}  // namespace

Prepared prepare(const Scene& scene, const Limits& limits) {
  Prepared prepared;
  prepared.scene.global = ready_global(scene.global);
  prepared.scene.camera = ready_camera(scene.camera.value_or(Camera{}));
  std::vector<Part> parts = PartBuilder(scene, prepared).build();
  prepared.scene.lights = world_lights(parts, limits.lights);
  add_groups(parts, prepared.scene);
  return prepared;
}

bool same_meaning(const Scene& a, const Scene& b) {
  const RenderScene ready_a = prepare(a, Limits{}).scene;
  RenderScene ready_b = prepare(b, Limits{}).scene;
  const std::vector<RenderLight>& lights = ready_a.lights;
  if (std::equal(lights.begin(), lights.end(), ready_b.lights.begin(), ready_b.lights.end(),
                 [](const RenderLight& x, const RenderLight& y) { return alike(x, y); })) {
    ready_b.lights = lights;
  }
  return ready_a == ready_b;
}

}  // namespace scenefile
