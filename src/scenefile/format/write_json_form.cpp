#include "scenefile/base/text.h"
#include "scenefile/format/codes.h"
#include "scenefile/format/write_forms.h"
#include "scenefile/scene/vocabulary.h"
#include "scenefile/scene/walk.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <utility>

namespace scenefile {

namespace {

bool stands_at_origin(const Light& light) {
  return light.position == glm::vec3(0);
}

// Takes the leading transforms that a single group can represent: each kind once, in the fixed
// order. A matrix needs a separate group, because some programs reject it next to other transforms.
std::span<const Transform> take_sayable(std::span<const Transform>& transforms) {
  std::size_t count = 0;
  while (count < transforms.size() &&
         (count == 0 || (transforms[count - 1].map.index() < transforms[count].map.index() &&
                         !std::holds_alternative<Matrix>(transforms[count].map)))) {
    ++count;
  }
  const std::span<const Transform> sayable = transforms.first(count);
  transforms = transforms.subspan(count);
  return sayable;
}

class JsonForm {
 public:
  JsonForm(const Scene& scene, Diagnostics& diagnostics)
      : scene_(tidy_copy(scene)), diagnostics_(diagnostics) {}

  Scene make() {
    if (!scene_.camera) {
      diagnostics_.report(write_default_camera, {},
                          "the scene has no camera; the default is written");
      scene_.camera.emplace();
    }
    shape_lights();
    shape_root();
    is_head_.assign(scene_.nodes.size(), false);
    for (const NodeId head : tree_heads(scene_)) {
      is_head_[head] = true;
    }
    const std::size_t written = scene_.nodes.size();
    for (NodeId id = 0; id < written; ++id) {
      shape_instance(id);
      split_transforms(id);
    }
    if (splits_ != 0) {
      diagnostics_.report(
          write_transforms_nested, {},
          fmt::format("the transforms of {} group{} have an order that needs nested groups in JSON",
                      splits_, splits_ == 1 ? "" : "s"));
    }
    drop_empty_groups(scene_, {}, diagnostics_);
    keep_templates_names();
    return std::move(scene_);
  }

 private:
  void shape_lights() {
    std::size_t ids = 0;
    const std::size_t written = scene_.nodes.size();
    for (NodeId id = 0; id < written; ++id) {
      for (Light& light : scene_.nodes[id].lights) {
        ids += light.id ? 1 : 0;
        light.id.reset();
        clear_unused(light, false);
        if (!course_json_has(light.type)) {
          diagnostics_.report(write_area_light, light.location,
                              "the course's JSON reader does not support area lights");
        }
      }
      const bool is_root = id == scene_.root;
      const auto& lights = scene_.nodes[id].lights;
      if (!std::all_of(lights.begin(), lights.end(), stands_at_origin) ||
          (is_root && !lights.empty())) {
        give_lights_groups(id);
      }
    }
    if (ids != 0) {
      diagnostics_.report(write_light_id, {},
                          fmt::format("the id{} of {} light{} {} left out", ids == 1 ? "" : "s",
                                      ids, ids == 1 ? "" : "s", ids == 1 ? "is" : "are"));
    }
  }

  // Consecutive lights at the same position share a group, to keep their order.
  void give_lights_groups(NodeId id) {
    std::vector<std::vector<Light>> runs;
    for (Light& light : std::exchange(scene_.nodes[id].lights, {})) {
      if (runs.empty() || runs.back().back().position != light.position) {
        runs.emplace_back();
      }
      runs.back().push_back(std::move(light));
    }
    const NodeId first = add_front_children(scene_, id, runs.size());
    for (std::size_t i = 0; i < runs.size(); ++i) {
      Node& group = scene_.nodes[first + i];
      const Light& light = runs[i].front();
      group.location = light.location;
      if (light.position != glm::vec3(0)) {
        group.transforms.push_back({Translate{light.position}, light.location});
      }
      group.lights = std::move(runs[i]);
      for (Light& inside : group.lights) {
        inside.position = glm::vec3(0);
      }
    }
  }

  // The root contains only groups.
  void shape_root() {
    Node& root = scene_.nodes[scene_.root];
    root.name.clear();
    if (!root.transforms.empty() || !root.primitives.empty() || !root.instance_of.empty()) {
      push_down(scene_, scene_.root, true);
    }
  }

  // Moves an instance into a child if it has transforms or a name, or is the head of a template.
  void shape_instance(NodeId id) {
    const Node& node = scene_.nodes[id];
    if (!node.instance_of.empty() &&
        (!node.transforms.empty() || !node.name.empty() || is_head_[id])) {
      push_down(scene_, id, false);
    }
  }

  // Nests groups until each has transforms that it can represent.
  void split_transforms(NodeId id) {
    const std::vector<Transform> all = std::exchange(scene_.nodes[id].transforms, {});
    std::span<const Transform> rest = all;
    while (true) {
      const std::span<const Transform> sayable = take_sayable(rest);
      scene_.nodes[id].transforms.assign(sayable.begin(), sayable.end());
      if (rest.empty()) {
        break;
      }
      id = push_down(scene_, id, false);
    }
    splits_ += scene_.nodes[id].transforms.size() == all.size() ? 0 : 1;
  }

  // A group with the name of a template would be read as an instance of it.
  void keep_templates_names() {
    NameTable names;
    for (const NodeId head : scene_.templates) {
      names.take(scene_.nodes[head].name);
    }
    NameTable templates = names;
    for (NodeId id = 0; id < scene_.nodes.size(); ++id) {
      names.take(scene_.nodes[id].name);
    }
    for (NodeId id = 0; id < scene_.nodes.size(); ++id) {
      Node& node = scene_.nodes[id];
      const bool head = id < is_head_.size() && is_head_[id];
      if (head || node.name.empty() || !templates.is_taken(node.name)) {
        continue;
      }
      std::string free = names.make_free(node.name);
      diagnostics_.report(write_renamed, node.location,
                          fmt::format("the group {} has the name of a template; it is called {}",
                                      quoted(node.name), quoted(free)));
      node.name = std::move(free);
    }
  }

  Scene scene_;
  Diagnostics& diagnostics_;
  std::vector<bool> is_head_;
  std::size_t splits_ = 0;
};

}  // namespace

Scene json_form(const Scene& scene, Diagnostics& diagnostics) {
  return JsonForm(scene, diagnostics).make();
}

}  // namespace scenefile
