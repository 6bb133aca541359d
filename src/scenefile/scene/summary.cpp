#include "scenefile/scene/summary.h"

#include "scenefile/scene/prepare_parts.h"
#include "scenefile/scene/template_graph.h"
#include "scenefile/scene/walk.h"

#include <algorithm>
#include <vector>

namespace scenefile {

namespace {

void add_node(SceneSummary& summary, const Node& node, MaterialTable& materials) {
  ++summary.nodes;
  summary.transforms += node.transforms.size();
  if (!node.instance_of.empty()) {
    ++summary.instances;
    return;
  }
  for (const Primitive& primitive : node.primitives) {
    ++summary.primitives[static_cast<std::size_t>(primitive.shape)];
    materials.material(primitive.material);
    if (primitive.shape == Shape::mesh && !primitive.mesh_file.empty()) {
      materials.mesh(primitive.mesh_file, primitive.location);
    }
  }
  for (const Light& light : node.lights) {
    ++summary.lights[static_cast<std::size_t>(light.type)];
  }
}

}  // namespace

SceneSummary summarize(const Scene& scene) {
  SceneSummary summary;
  RenderScene numbered;
  MaterialTable materials(numbered);
  const TemplateGraph graph = template_graph(scene);
  std::vector<double> primitives(graph.heads.size());
  std::vector<double> lights(graph.heads.size());
  std::vector<bool> seen(scene.nodes.size());
  for (std::size_t tree = 0; tree < graph.heads.size(); ++tree) {
    walk_nodes(scene, graph.heads[tree], std::size_t{0}, seen,
               [&](NodeId id, std::size_t depth_above) {
                 const Node& node = scene.nodes[id];
                 add_node(summary, node, materials);
                 summary.depth = std::max(summary.depth, depth_above + 1);
                 if (node.instance_of.empty()) {
                   primitives[tree] += static_cast<double>(node.primitives.size());
                   lights[tree] += static_cast<double>(node.lights.size());
                 }
                 return depth_above + 1;
               });
  }
  summary.templates = scene.templates.size();
  summary.virtual_primitives = totals(graph.uses, std::move(primitives)).back();
  summary.virtual_lights = totals(graph.uses, std::move(lights)).back();
  summary.instance_nesting = heights(graph.uses).back();
  summary.materials = numbered.materials.size();
  summary.textures = numbered.texture_files.size();
  summary.meshes = numbered.mesh_files.size();
  return summary;
}

}  // namespace scenefile
