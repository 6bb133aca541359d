#include "scenefile/placement/scene_search.h"

#include "scenefile/geometry/ray_box.h"
#include "scenefile/geometry/solid.h"
#include "scenefile/placement/bounds.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace scenefile {

namespace {

// The cost of a triangle relative to a primitive.
constexpr double triangle_work = 0.5;
// Closed meshes wind once around points inside, up to rounding.
constexpr double once = 0.999;

// The map from the unit cube to the box.
DAffine box_from_cube(const Bounds& box) {
  const glm::dvec3 size = box.max - box.min;
  return {glm::dmat3(size.x, 0, 0, 0, size.y, 0, 0, 0, size.z), 0.5 * (box.min + box.max)};
}

// Whether the shape is outside one of the half-spaces, by more than rounding errors.
bool outside(const Region& region, Shape shape, const DAffine& place) {
  return std::any_of(region.begin(), region.end(), [&](const HalfSpace& half) {
    const double nearest = -support(shape, place, -half.outward);
    const double size = glm::length(half.outward) * glm::length(place.offset);
    return nearest > half.distance + 1e-6 * (size + std::abs(half.distance));
  });
}

bool outside(const Region& region, const Bounds& box, const DAffine& place) {
  return box.empty() || outside(region, Shape::cube, place * box_from_cube(box));
}

// Visits the groups in the world, once per instance, containing groups first. `visit(group, state)`
// returns whether to continue; `enter(instance, state)` returns the state of the instance's group,
// or nothing to skip it. Returns whether `visit` never returned false.
template <typename State, typename Visit, typename Enter>
bool walk_groups(const RenderScene& scene, const State& initial, Visit visit, Enter enter) {
  struct Frame {
    const RenderGroup* group;
    State state;
    std::size_t next;
  };
  if (scene.groups.empty()) {
    return true;
  }
  std::vector<Frame> frames;
  const auto push = [&](std::uint32_t group, const State& state) {
    frames.push_back({&scene.groups[group], state, 0});
    return visit(*frames.back().group, state);
  };
  if (!push(scene.root, initial)) {
    return false;
  }
  while (!frames.empty()) {
    Frame& top = frames.back();
    if (top.next == top.group->instances.size()) {
      frames.pop_back();
      continue;
    }
    const RenderInstance& instance = top.group->instances[top.next++];
    const std::optional<State> inner = enter(instance, top.state);
    if (inner && !push(instance.group, *inner)) {
      return false;
    }
  }
  return true;
}

}  // namespace

SceneSearch::SceneSearch(const RenderScene& scene, const Assets& assets)
    : scene_(scene),
      assets_(assets),
      meshes_known_(assets.meshes.size() == scene.mesh_files.size() &&
                    std::none_of(assets.meshes.begin(), assets.meshes.end(),
                                 [](const Mesh& mesh) { return mesh.triangles.empty(); })),
      mesh_boxes_(mesh_bounds(scene, assets)),
      group_boxes_(group_bounds(scene, mesh_boxes_)) {}

bool SceneSearch::spend(double work) {
  budget_ -= work;
  return budget_ >= 0;
}

bool SceneSearch::misses(const Region& region) {
  if (!meshes_known_) {
    return false;
  }
  const auto visit = [&](const RenderGroup& group, const DAffine& place) {
    return spend(static_cast<double>(group.primitives.size())) &&
           std::all_of(group.primitives.begin(), group.primitives.end(),
                       [&](const RenderPrimitive& p) {
                         const DAffine map = place * DAffine(p.group_from_object);
                         return p.shape == Shape::mesh ? outside(region, mesh_boxes_[p.mesh], map)
                                                       : outside(region, p.shape, map);
                       });
  };
  const bool missed_all = walk_groups(
      scene_, DAffine(), visit,
      [&](const RenderInstance& instance, const DAffine& place) -> std::optional<DAffine> {
        const DAffine inner = place * DAffine(instance.group_from_instance);
        const bool missed = outside(region, group_boxes_[instance.group], inner);
        spend(1);
        return missed ? std::nullopt : std::optional(inner);
      });
  return missed_all && budget_ >= 0;
}

bool SceneSearch::encloses(const RenderPrimitive& primitive, const glm::dvec3& point) {
  if (primitive.shape != Shape::mesh) {
    return contains(primitive.shape, point);
  }
  if (!holds(mesh_boxes_[primitive.mesh], point)) {
    return false;
  }
  const Mesh& mesh = assets_.meshes[primitive.mesh];
  return spend(triangle_work * static_cast<double>(mesh.triangles.size())) &&
         winding_number(mesh, point) > once;
}

void SceneSearch::enclosing(const glm::dvec3& point, const glm::dvec3& other,
                            const std::function<bool(const Enclosure&)>& visit) {
  // In the group's space.
  struct Points {
    glm::dvec3 point;
    glm::dvec3 other;
    Points moved(const Affine& to_from) const {
      const DAffine back = inverse(DAffine(to_from));
      return {back.point(point), back.point(other)};
    }
  };
  const auto visit_group = [&](const RenderGroup& group, const Points& at) {
    return spend(static_cast<double>(group.primitives.size())) &&
           std::all_of(group.primitives.begin(), group.primitives.end(),
                       [&](const RenderPrimitive& p) {
                         const Points inner = at.moved(p.group_from_object);
                         return !encloses(p, inner.point) || visit({&p, encloses(p, inner.other)});
                       });
  };
  walk_groups(scene_, Points{point, other}, visit_group,
              [&](const RenderInstance& instance, const Points& at) -> std::optional<Points> {
                const Points inner = at.moved(instance.group_from_instance);
                const Bounds& box = group_boxes_[instance.group];
                return spend(1) && holds(box, inner.point) ? std::optional(inner) : std::nullopt;
              });
}

}  // namespace scenefile
