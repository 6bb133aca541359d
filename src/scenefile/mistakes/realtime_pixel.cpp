#include "scenefile/mistakes/realtime_pixel.h"

#include "scenefile/mistakes/realtime_picture.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace scenefile {

namespace {

// The shape at this place in the order of realtime_shapes().
ObjectRef object_at(const RenderScene& scene, double number) {
  std::vector<double> counts;  // by group, which comes after the groups that it contains
  for (const RenderGroup& group : scene.groups) {
    double count = static_cast<double>(group.primitives.size());
    for (const RenderInstance& instance : group.instances) {
      count += counts[instance.group];
    }
    counts.push_back(count);
  }
  ObjectRef object;
  const RenderGroup* group = &scene.groups[scene.root];
  while (number >= static_cast<double>(group->primitives.size())) {
    number -= static_cast<double>(group->primitives.size());
    auto instance = group->instances.begin();
    for (; number >= counts[instance->group]; ++instance) {
      number -= counts[instance->group];
    }
    object.instances.push_back(instance->source);
    group = &scene.groups[instance->group];
  }
  object.source = group->primitives[static_cast<std::size_t>(number)].source;
  return object;
}

// The part of the frame that the pixels lie in.
PixelRegion region_of(const std::vector<FrameShare>& shares) {
  PixelRegion region{shares[0].at.x, shares[0].at.y, shares[0].at.x + 1, shares[0].at.y + 1};
  for (const FrameShare& share : shares) {
    region = {std::min(region.x0, share.at.x), std::min(region.y0, share.at.y),
              std::max(region.x1, share.at.x + 1), std::max(region.y1, share.at.y + 1)};
  }
  return region;
}

// The largest weight first; of equal ones, the nearest to this place in the frame.
void sort_by_importance(std::vector<FrameShare>& shares, const glm::dvec2& place) {
  const auto rank = [&](const FrameShare& share) {
    return std::pair(-std::round(std::abs(share.weight) * 1e6),
                     glm::distance(glm::dvec2(share.at) + 0.5, place));
  };
  std::stable_sort(shares.begin(), shares.end(),
                   [&](const FrameShare& a, const FrameShare& b) { return rank(a) < rank(b); });
}

}  // namespace

std::optional<RealtimePixel> realtime_pixel(const RenderScene& scene, const Assets& assets,
                                            const RealtimeOptions& panel, const glm::ivec2& size,
                                            const glm::ivec2& pixel) {
  const auto shapes = realtime_shapes(scene, max_explained_shapes);
  if (shapes == nullptr) {
    return std::nullopt;
  }
  RealtimeTrial trial;
  trial.scene.scene = scene;
  trial.panel = panel;
  const auto visible_in = [&](const PixelRegion& region) {
    return find_visible(trial, shapes, assets, size.x, size.y, region);
  };
  const auto empty = visible_in({0, 0, 0, 0});  // only its size is used
  std::vector<FrameShare> shares =
      RealtimePicture(trial, empty, assets, size.x, size.y).shares(pixel.x, pixel.y);
  sort_by_importance(shares, glm::dvec2(pixel.x + 0.5, size.y - pixel.y - 0.5) / glm::dvec2(size) *
                                 glm::dvec2(empty->width, empty->height));
  const auto visible = visible_in(region_of(shares));
  const RealtimePicture picture(trial, visible, assets, size.x, size.y);
  RealtimePixel result{
      {visible->width, visible->height}, {}, picture.filter().colors, picture.filter().added};
  for (const FrameShare& share : shares) {
    RealtimeFramePixel& of_frame = result.shares.emplace_back();
    of_frame.at = share.at;
    of_frame.weight = share.weight;
    const std::uint32_t number =
        visible->seen[std::size_t(share.at.y) * visible->width + share.at.x];
    if (number == Visibility::nothing) {
      continue;
    }
    const Visibility::Triangle& t = visible->triangles[number];
    const ModelPart& part = shapes->parts[t.part];
    const Mesh& mesh = visible->mesh_of(t, assets);
    const ShownPoint point = picture.point_at(share.at);
    RealtimeSurface& surface = of_frame.surface.emplace();
    surface.object = object_at(scene, t.part);
    surface.shape = part.shape;
    surface.mesh = part.mesh;
    surface.triangle = t.index;
    surface.material = part.material;
    surface.world_from_object = Affine(part.world_from_object);
    for (std::size_t k = 0; k < 3; ++k) {
      surface.object_corners[k] = glm::dvec3(mesh.positions[mesh.triangles[t.index][k]]);
    }
    surface.object_position = part.object_from_world.point(point.position);
    surface.object_normal = point.object_normal;
  }
  return result;
}

}  // namespace scenefile
