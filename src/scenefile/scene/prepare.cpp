#include "scenefile/scene/prepare.h"

#include "scenefile/scene/field_places.h"
#include "scenefile/scene/prepare_parts.h"
#include "scenefile/scene/template_graph.h"
#include "scenefile/scene/transforms.h"
#include "scenefile/scene/walk.h"
#include "scenefile/scene/world_lights.h"

#include <map>
#include <utility>

namespace scenefile {

namespace {

std::uint32_t add_source(std::vector<Source>& sources, const Source& source) {
  sources.push_back(source);
  return static_cast<std::uint32_t>(sources.size() - 1);
}

// Folds the trees of a scene into parts: the root first, then each template that can be drawn.
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

  std::vector<PreparedPart> build() {
    add_part(scene_.root);
    std::size_t next = 0;
    // Both lists grow while parts are filled.
    for (std::size_t w = 0; w < waiting_.size() || next < parts_.size();) {
      if (next < parts_.size()) {
        fill(static_cast<std::uint32_t>(next++));
      } else {
        connect(waiting_[w++]);
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

  void add_part(NodeId head) { parts_.emplace_back().head = head; }

  void connect(const Waiting& waiting) {
    std::uint32_t& part = part_of_template_[waiting.target];
    if (part == no_index) {
      part = static_cast<std::uint32_t>(parts_.size());
      add_part(scene_.templates[waiting.target]);
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

  void add_contents(PreparedPart& part, NodeId id, const DAffine& part_from_node) {
    const Node& node = scene_.nodes[id];
    if (node.primitives.empty()) {
      return;
    }
    const std::optional<Affine> stored = storable(part_from_node);
    if (!stored) {
      return;
    }
    for (std::uint32_t i = 0; i < node.primitives.size(); ++i) {
      add_primitive(part, node.primitives[i], {id, SourceKind::primitive, i}, *stored);
    }
  }

  void add_primitive(PreparedPart& part, const Primitive& primitive, const Source& source,
                     const Affine& map) {
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
    ready.source = add_source(sources_, source);
    part.primitives.push_back(ready);
  }

  void add_instance(std::uint32_t index, NodeId id, const DAffine& map) {
    const auto target = names_.find(scene_.nodes[id].instance_of);
    const std::optional<Affine> stored = storable(map);
    if (target == names_.end() || !stored) {
      return;
    }
    std::vector<PartInstance>& instances = parts_[index].instances;
    const auto place = static_cast<std::uint32_t>(instances.size());
    instances.push_back({*stored, no_index, add_source(sources_, {id, SourceKind::instance, 0})});
    waiting_.push_back({index, place, target->second});
  }

  const Scene& scene_;
  std::vector<Source>& sources_;
  MaterialTable materials_;
  FieldPlaces places_;
  TemplateNames names_;
  std::vector<std::uint32_t> part_of_template_;
  std::vector<bool> seen_;
  std::vector<PreparedPart> parts_;
  std::vector<Waiting> waiting_;
};

Graph graph_of(const std::vector<PreparedPart>& parts) {
  Graph graph;
  for (const PreparedPart& part : parts) {
    graph.first.push_back(static_cast<std::uint32_t>(graph.target.size()));
    for (const PartInstance& instance : part.instances) {
      graph.target.push_back(instance.part);
    }
  }
  graph.first.push_back(static_cast<std::uint32_t>(graph.target.size()));
  return graph;
}

// Turns parts into groups, contained groups first. A part that draws nothing becomes no group;
// instances of it, and instances that close a loop, are dropped.
void add_groups(std::vector<PreparedPart>& parts, RenderScene& scene) {
  constexpr std::uint32_t root_part = 0;
  std::vector<std::uint32_t> group_of(parts.size(), no_index);
  const auto leave = [&](std::uint32_t index) {
    PreparedPart& part = parts[index];
    RenderGroup group;
    group.primitives = std::move(part.primitives);
    for (const PartInstance& instance : part.instances) {
      if (group_of[instance.part] != no_index) {
        group.instances.push_back(
            {instance.part_from_instance, group_of[instance.part], instance.source});
      }
    }
    if (index == root_part || !group.primitives.empty() || !group.instances.empty()) {
      group_of[index] = static_cast<std::uint32_t>(scene.groups.size());
      scene.groups.push_back(std::move(group));
    }
  };
  visit_depth_first(graph_of(parts), std::span(&root_part, 1), leave,
                    [](std::span<const std::uint32_t>, std::uint32_t) {});
  scene.root = group_of[root_part];
}

void add_lights(const Scene& scene, const Limits& limits, Prepared& prepared) {
  std::vector<RenderLight>& lights = prepared.scene.lights;
  std::map<std::pair<NodeId, std::uint32_t>, std::uint32_t> sources;  // one for all instances
  world_lights(scene, [&](const WorldLight& at) {
    if (lights.size() == limits.lights) {
      return false;
    }
    const Light& light = scene.nodes[at.node].lights[at.index];
    std::optional<RenderLight> ready = ready_light(light, at.world_from_node);
    if (ready) {
      const auto [source, added] = sources.try_emplace(
          {at.node, at.index}, static_cast<std::uint32_t>(prepared.sources.size()));
      if (added) {
        prepared.sources.push_back({at.node, SourceKind::light, at.index});
      }
      ready->source = source->second;
      lights.push_back(*ready);
    }
    return true;
  });
}

RenderGlobal ready_global(const Global& global) {
  return {global.ambient, global.diffuse, global.specular, global.transparent};
}

}  // namespace

Location place_of(const Scene& scene, const Source& source) {
  const Node& node = scene.nodes[source.node];
  switch (source.kind) {
    case SourceKind::primitive:
      return node.primitives[source.index].location;
    case SourceKind::instance:
      return node.location;
    case SourceKind::light:
      return node.lights[source.index].location;
  }
  return {};
}

Prepared prepare(const Scene& scene, const Limits& limits) {
  Prepared prepared;
  prepared.scene.global = ready_global(scene.global);
  prepared.scene.camera = ready_camera(scene.camera.value_or(Camera{}));
  std::vector<PreparedPart> parts = PartBuilder(scene, prepared).build();
  add_lights(scene, limits, prepared);
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
