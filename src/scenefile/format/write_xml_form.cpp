#include "scenefile/base/text.h"
#include "scenefile/format/codes.h"
#include "scenefile/format/write_forms.h"
#include "scenefile/format/write_lights.h"
#include "scenefile/scene/walk.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

namespace scenefile {

namespace {

class XmlForm {
 public:
  XmlForm(const Scene& scene, const Limits& limits, Diagnostics& diagnostics)
      : scene_(tidy_copy(scene)), diagnostics_(diagnostics) {
    move_lights(limits);
  }

  Scene make() {
    if (!scene_.name.empty() && scene_.name != "root") {
      diagnostics_.report(
          write_scene_name, {},
          fmt::format("the name of the scene, {}, is left out", quoted(scene_.name)));
    }
    scene_.name.clear();
    const std::size_t written = scene_.nodes.size();
    is_head_.assign(written, false);
    for (const NodeId head : tree_heads(scene_)) {
      is_head_[head] = true;
    }
    for (NodeId node = 0; node < written; ++node) {
      is_head_[node] ? shape_head(node) : shape_node(node);
      make_affine(node);
    }
    drop_empty_groups(scene_, held_lights_, diagnostics_);
    make_names_unique(written);
    return std::move(scene_);
  }

 private:
  void move_lights(const Limits& limits) {
    std::vector<Light> lights = lights_in_world(scene_, limits, diagnostics_);
    for (Node& node : scene_.nodes) {
      held_lights_.push_back(!node.lights.empty());
      node.lights.clear();
    }
    add_ids(lights);
    for (Light& light : lights) {
      clear_unused(light, true);
      if (!light.name.empty()) {
        diagnostics_.report(
            write_light_name, light.location,
            fmt::format("the name {} of the light is left out", quoted(light.name)));
        light.name.clear();
      }
    }
    scene_.nodes[scene_.root].lights = std::move(lights);
  }

  void add_ids(std::vector<Light>& lights) {
    std::set<int> taken;
    std::size_t without = 0;
    for (const Light& light : lights) {
      light.id ? (void)taken.insert(*light.id) : (void)++without;
    }
    int next = 0;
    for (Light& light : lights) {
      while (!light.id && taken.contains(next)) {
        ++next;
      }
      light.id = light.id.value_or(next);
      taken.insert(*light.id);
    }
    if (without != 0) {
      diagnostics_.report(write_light_id, {},
                          fmt::format("{} light{} got an id", without, without == 1 ? "" : "s"));
    }
  }

  // The root and templates are trees without a transblock around them.
  void shape_head(NodeId id) {
    if (!scene_.nodes[id].transforms.empty() || !scene_.nodes[id].instance_of.empty()) {
      std::vector<Light> lights = std::exchange(scene_.nodes[id].lights, {});
      const NodeId inner = push_down(scene_, id, true);
      scene_.nodes[id].lights = std::move(lights);
      shape_node(inner);
      make_affine(inner);
      return;
    }
    give_primitives_nodes(id);
  }

  // A transblock has one object: a primitive, an instance or a tree. Only trees have names.
  void shape_node(NodeId id) {
    const Node& node = scene_.nodes[id];
    if (!node.instance_of.empty()) {
      if (!node.name.empty()) {
        push_down(scene_, id, false);
      }
      return;
    }
    const bool alone = node.name.empty() && node.children.empty() && node.primitives.size() == 1;
    if (!alone) {
      give_primitives_nodes(id);
    }
  }

  void give_primitives_nodes(NodeId id) {
    std::vector<Primitive> primitives = std::exchange(scene_.nodes[id].primitives, {});
    const NodeId first = add_front_children(scene_, id, primitives.size());
    for (std::size_t i = 0; i < primitives.size(); ++i) {
      Node& child = scene_.nodes[first + i];
      child.location = primitives[i].location;
      child.primitives.push_back(std::move(primitives[i]));
    }
  }

  void make_affine(NodeId id) {
    for (Transform& transform : scene_.nodes[id].transforms) {
      const auto* const matrix = std::get_if<Matrix>(&transform.map);
      if (matrix == nullptr) {
        continue;
      }
      glm::mat4 affine = matrix->m();
      for (int column = 0; column < 4; ++column) {
        affine[column][3] = column == 3 ? 1.0f : 0.0f;
      }
      if (affine != matrix->m()) {
        transform.map = Matrix(affine);
        diagnostics_.report(write_matrix_row, transform.location,
                            "the last row of the matrix is written as 0 0 0 1");
      }
    }
  }

  void make_names_unique(std::size_t written) {
    NameTable names;
    names.take("root");
    scene_.nodes[scene_.root].name = "root";
    for (const NodeId head : scene_.templates) {
      names.take(scene_.nodes[head].name);
    }
    free_the_root(names);
    for (NodeId id = 0; id < written; ++id) {
      RareText& name = scene_.nodes[id].name;
      if (is_head_[id] || name.empty() || scene_.nodes[id].children.empty() || names.take(name)) {
        continue;
      }
      std::string free = names.make_free(name);
      diagnostics_.report(
          write_renamed, scene_.nodes[id].location,
          fmt::format("the name {} is taken; the group is called {}", quoted(name), quoted(free)));
      name = std::move(free);
    }
  }

  // JSON has no reserved names: a template can be called root there.
  void free_the_root(NameTable& names) {
    const auto root =
        std::find_if(scene_.templates.begin(), scene_.templates.end(),
                     [this](NodeId head) { return scene_.nodes[head].name == "root"; });
    if (root == scene_.templates.end()) {
      return;
    }
    const std::string free = names.make_free("root");
    diagnostics_.report(
        write_renamed, scene_.nodes[*root].location,
        fmt::format("root is the scene itself in XML; the template is called {}", quoted(free)));
    scene_.nodes[*root].name = free;
    for (Node& node : scene_.nodes) {
      if (node.instance_of == "root") {
        node.instance_of = free;
      }
    }
  }

  Scene scene_;
  Diagnostics& diagnostics_;
  std::vector<bool> is_head_;  // of the nodes of the tidy copy
  std::vector<bool> held_lights_;
};

}  // namespace

Scene xml_form(const Scene& scene, const Limits& limits, Diagnostics& diagnostics) {
  return XmlForm(scene, limits, diagnostics).make();
}

}  // namespace scenefile
