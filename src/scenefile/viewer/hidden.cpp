#include "scenefile/viewer/hidden.h"

#include "scenefile/geometry/mesh.h"

#include <algorithm>
#include <vector>

namespace scenefile::viewer {

namespace {

template <typename Item>
void remove_hidden(std::vector<Item>& items, const Hidden& hidden) {
  std::erase_if(items, [&](const Item& item) { return hidden.contains(item.source); });
}

Bounds primitive_bounds(const RenderPrimitive& primitive, const Assets& assets) {
  const DAffine group_from_object(primitive.group_from_object);
  if (primitive.shape != Shape::mesh) {
    return shape_bounds(primitive.shape, group_from_object);
  }
  return primitive.mesh < assets.meshes.size()
             ? transform(group_from_object, bounds(assets.meshes[primitive.mesh]))
             : Bounds{};
}

}  // namespace

RenderScene without_hidden(const RenderScene& scene, const Hidden& hidden,
                           std::optional<std::uint32_t> only_light) {
  RenderScene shown = scene;
  if (only_light && *only_light < scene.lights.size()) {
    shown.lights = {scene.lights[*only_light]};
  }
  if (hidden.empty()) {
    return shown;
  }
  remove_hidden(shown.lights, hidden);
  for (RenderGroup& group : shown.groups) {
    remove_hidden(group.primitives, hidden);
    remove_hidden(group.instances, hidden);
  }
  return shown;
}

Bounds bounds_of(const RenderScene& scene, const Assets& assets,
                 const std::set<std::uint32_t>& sources) {
  // By group, in its space; a group comes after all that it contains. A selected instance counts
  // with everything in it.
  std::vector<Bounds> chosen(scene.groups.size());
  std::vector<Bounds> all(scene.groups.size());
  for (std::size_t g = 0; g < scene.groups.size(); ++g) {
    for (const RenderPrimitive& primitive : scene.groups[g].primitives) {
      const Bounds box = primitive_bounds(primitive, assets);
      all[g] = unite(all[g], box);
      if (sources.contains(primitive.source)) {
        chosen[g] = unite(chosen[g], box);
      }
    }
    for (const RenderInstance& instance : scene.groups[g].instances) {
      const DAffine map(instance.group_from_instance);
      const Bounds inside = transform(map, all[instance.group]);
      all[g] = unite(all[g], inside);
      chosen[g] = unite(chosen[g], sources.contains(instance.source)
                                       ? inside
                                       : transform(map, chosen[instance.group]));
    }
  }
  return scene.root < chosen.size() ? chosen[scene.root] : Bounds{};
}

Bounds bounds_of_copy(const RenderScene& scene, const Assets& assets, std::uint32_t source,
                      const std::vector<std::uint32_t>& instances) {
  DAffine world_from_group;
  std::uint32_t group = scene.root;
  for (const std::uint32_t instance_source : instances) {
    const std::vector<RenderInstance>& all = scene.groups[group].instances;
    const auto found = std::find_if(all.begin(), all.end(), [&](const RenderInstance& i) {
      return i.source == instance_source;
    });
    if (found == all.end()) {
      return {};
    }
    world_from_group = world_from_group * DAffine(found->group_from_instance);
    group = found->group;
  }
  for (const RenderPrimitive& primitive : scene.groups[group].primitives) {
    if (primitive.source == source) {
      return transform(world_from_group, primitive_bounds(primitive, assets));
    }
  }
  return {};
}

}  // namespace scenefile::viewer
