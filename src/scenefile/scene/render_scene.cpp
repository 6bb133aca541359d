#include "scenefile/scene/render_scene.h"

#include <algorithm>
#include <tuple>

namespace scenefile {

// Scenes have millions of primitives, so their size matters.
static_assert(sizeof(RenderPrimitive) == 64);

namespace {

bool same_names(const std::vector<FileReference>& a, const std::vector<FileReference>& b) {
  return std::equal(
      a.begin(), a.end(), b.begin(), b.end(),
      [](const FileReference& x, const FileReference& y) { return x.name == y.name; });
}

}  // namespace

bool operator==(const RenderPrimitive& a, const RenderPrimitive& b) {
  return std::tie(a.group_from_object, a.shape, a.mesh, a.material) ==
         std::tie(b.group_from_object, b.shape, b.mesh, b.material);
}

bool operator==(const RenderInstance& a, const RenderInstance& b) {
  return std::tie(a.group_from_instance, a.group) == std::tie(b.group_from_instance, b.group);
}

bool operator==(const RenderLight& a, const RenderLight& b) {
  const auto values = [](const RenderLight& l) {
    // Names all members, so that a new one cannot be forgotten.
    const auto& [type, color, position, direction, attenuation, inner_angle, outer_angle, half_u,
                 half_v, source] = l;
    (void)source;
    return std::tie(type, color, position, direction, attenuation, inner_angle, outer_angle, half_u,
                    half_v);
  };
  return values(a) == values(b);
}

bool operator==(const RenderScene& a, const RenderScene& b) {
  return std::tie(a.global, a.camera, a.lights, a.materials, a.groups, a.root) ==
             std::tie(b.global, b.camera, b.lights, b.materials, b.groups, b.root) &&
         same_names(a.texture_files, b.texture_files) && same_names(a.mesh_files, b.mesh_files);
}

double count_virtual_primitives(const RenderScene& scene) {
  std::vector<double> counts(scene.groups.size());
  for (std::size_t g = 0; g < scene.groups.size(); ++g) {
    counts[g] = static_cast<double>(scene.groups[g].primitives.size());
    for (const RenderInstance& instance : scene.groups[g].instances) {
      counts[g] += counts[instance.group];
    }
  }
  return counts.empty() ? 0 : counts[scene.root];
}

std::uint32_t instance_nesting(const RenderScene& scene) {
  std::vector<std::uint32_t> heights(scene.groups.size());
  for (std::size_t g = 0; g < scene.groups.size(); ++g) {
    for (const RenderInstance& instance : scene.groups[g].instances) {
      heights[g] = std::max(heights[g], heights[instance.group] + 1);
    }
  }
  return heights.empty() ? 0 : heights[scene.root];
}

}  // namespace scenefile
