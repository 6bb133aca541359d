// Where new objects and copies may stand.

#include "scenefile/base/shape.h"
#include "scenefile/edit/document_state.h"
#include "scenefile/edit/placing.h"
#include "scenefile/scene/transforms.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace scenefile {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

struct Extent {
  glm::dvec3 min{infinity};
  glm::dvec3 max{-infinity};

  bool empty() const { return !(min.x <= max.x); }
  glm::dvec3 size() const { return max - min; }
  glm::dvec3 center() const { return 0.5 * (min + max); }
  void add(const Extent& other) {
    min = glm::min(min, other.min);
    max = glm::max(max, other.max);
  }
  bool holds(const glm::dvec3& p) const { return p == glm::clamp(p, min, max); }
  // More than by rounding.
  bool overlaps(const Extent& other) const {
    const glm::dvec3 slack = 1e-4 * glm::min(size(), other.size());
    return glm::all(glm::lessThan(min + slack, other.max)) &&
           glm::all(glm::lessThan(other.min + slack, max));
  }
};

const Extent unit_extent{glm::dvec3(-0.5), glm::dvec3(0.5)};

Extent extent_of_mesh(const std::string& file, const std::optional<Viewpoint>& view) {
  if (view) {
    if (const auto known = view->meshes.find(file); known != view->meshes.end()) {
      return {known->second[0], known->second[1]};
    }
  }
  return unit_extent;
}

Extent around(const glm::dvec3& center, const glm::dvec3& size) {
  return {center - 0.5 * size, center + 0.5 * size};
}

Extent placed(const DAffine& map, const Extent& extent) {
  Extent all;
  for (int corner = 0; corner < 8 && !extent.empty(); ++corner) {
    const glm::dvec3 p = map.point({(corner & 1) != 0 ? extent.max.x : extent.min.x,
                                    (corner & 2) != 0 ? extent.max.y : extent.min.y,
                                    (corner & 4) != 0 ? extent.max.z : extent.min.z});
    all.add({p, p});
  }
  return all;
}

/// What is drawn, in the space of the scene, or that of the template that contains it. By item.
struct DrawnItems {
  std::vector<DAffine> maps;
  std::vector<Extent> extents;  ///< of each primitive, instance and light; others are empty
  std::vector<ItemId> trees;    ///< the root, template or light that contains it
  std::map<std::string, Extent, std::less<>> templates;  ///< by name, in their own space
  Extent scene;                                          ///< of all objects
  glm::dvec3 light_size{0.5};
};

DrawnItems drawn_items(const Document& document, const std::optional<Viewpoint>& view) {
  const auto items = document.items();
  std::map<PartId, Extent> meshes;
  for (const Node& node : document.scene().nodes) {
    for (const Primitive& primitive : node.primitives) {
      if (primitive.shape == Shape::mesh) {
        meshes.emplace(document.state().syntax.at(primitive.location),
                       extent_of_mesh(primitive.mesh_file, view));
      }
    }
  }
  DrawnItems drawn;
  drawn.maps.resize(items.size());
  drawn.extents.resize(items.size());
  drawn.trees.resize(items.size());
  for (ItemId id = 0; id < items.size(); ++id) {
    const SceneItem& item = items[id];
    const bool inside = item.parent != no_item;
    drawn.trees[id] = inside ? drawn.trees[item.parent] : id;
    DAffine& map = drawn.maps[id];
    map = inside ? drawn.maps[item.parent] : DAffine();
    if (item.kind > ItemKind::root && placed_item(document, id) == id) {
      map = composed(map, document.scene().nodes[item.node].transforms);
    }
    if (item.kind == ItemKind::primitive) {
      const auto mesh = meshes.find(item.element);
      drawn.extents[id] = placed(map, mesh == meshes.end() ? unit_extent : mesh->second);
    } else if (item.kind == ItemKind::instance) {
      drawn.extents[id] = placed(map, drawn.templates[item.name]);
    }
    if (const SceneItem& tree = items[drawn.trees[id]]; tree.kind == ItemKind::master) {
      drawn.templates[tree.name].add(drawn.extents[id]);
    } else {
      drawn.scene.add(drawn.extents[id]);
    }
  }
  if (!drawn.scene.empty()) {
    drawn.light_size = glm::dvec3(0.06 * glm::length(drawn.scene.size()));
  }
  for (ItemId id = 0; id < items.size(); ++id) {
    const bool is_light =
        items[id].kind == ItemKind::light && items[id].name != word_of(LightType::directional);
    if (const std::optional<Handle> handle = is_light ? handle_of(document, id) : std::nullopt) {
      drawn.extents[id] = around(glm::dvec3(handle->world_from_item[3]), drawn.light_size);
    }
  }
  return drawn;
}

// The template that contains an item; no_item: none.
ItemId master_of(const Document& document, const DrawnItems& drawn, std::optional<ItemId> item) {
  const ItemId tree = item ? drawn.trees[*item] : no_item;
  return item && document[tree].kind == ItemKind::master ? tree : no_item;
}

// The objects and lights of a template; no_item: of the scene.
std::vector<Extent> obstacles_in(const Document& document, const DrawnItems& drawn, ItemId master) {
  std::vector<Extent> obstacles;
  for (ItemId id = 0; id < drawn.extents.size(); ++id) {
    if (master_of(document, drawn, id) == master && !drawn.extents[id].empty()) {
      obstacles.push_back(drawn.extents[id]);
    }
  }
  return obstacles;
}

// That of the scene's camera: what it focuses on, or what is at the depth of the scene.
Viewpoint viewpoint_of(const Document& document, const Extent& scene) {
  constexpr ItemId camera_item = 1;
  const Camera camera = document.scene().camera.value_or(Camera{});
  const glm::dvec3 eye(camera.position);
  const glm::dvec3 look(camera.look);
  for (const FieldView& field : document.fields(camera_item)) {
    if (field.name == "focus" && field.written) {
      return {eye, eye + look};
    }
  }
  const double depth =
      scene.empty() ? 0
                    : glm::dot(scene.center() - eye, look) / std::max(glm::dot(look, look), 1e-30);
  return {eye, depth > 0 ? eye + depth * look : eye + look};
}

// The axis of the world, of x and z, that is most across the view, to the right.
glm::dvec3 right_of(const Viewpoint& view) {
  const glm::dvec3 right = glm::cross(view.at - view.eye, glm::dvec3(0, 1, 0));
  return std::abs(right.x) >= std::abs(right.z) ? glm::dvec3(right.x < 0 ? -1 : 1, 0, 0)
                                                : glm::dvec3(0, 0, right.z < 0 ? -1 : 1);
}

// At least as much, apart from rounding errors, with two digits.
double rounded_up(double number) {
  const double unit = std::pow(10.0, std::floor(std::log10(std::max(number, 1e-30))) - 1);
  return std::ceil(number / unit - 1e-4) * unit;
}

// How far something has to move along an axis of the world until it overlaps no obstacle.
double distance_along(const glm::dvec3& way, const Extent& from,
                      const std::vector<Extent>& obstacles) {
  constexpr std::size_t most_looks = 4'000'000;
  const int axis = way.x != 0 ? 0 : 2;
  const double gap = 0.2 * from.size()[axis];
  double distance = 0;
  for (std::size_t looks = 0; looks <= most_looks; looks += obstacles.size()) {
    const Extent now = around(from.center() + distance * way, from.size());
    double blocked = 0;
    for (const Extent& obstacle : obstacles) {
      if (now.overlaps(obstacle)) {
        blocked = std::max(blocked, gap + (way[axis] > 0 ? obstacle.max[axis] - now.min[axis]
                                                         : now.max[axis] - obstacle.min[axis]));
      }
    }
    if (blocked == 0) {
      return distance;
    }
    const double next = rounded_up(distance + blocked);
    distance = next > distance ? next : distance + blocked;
  }
  return infinity;
}

// The shortest way that ends where nothing is, if going up counts double; 0 if all are too long.
// `levels`: how far up it may begin.
glm::dvec3 shortest(std::span<const glm::dvec3> ways, std::span<const double> levels,
                    const Extent& from, const std::vector<Extent>& obstacles) {
  glm::dvec3 best(0);
  double cost = infinity;
  for (const double level : levels) {
    const glm::dvec3 up(0, level, 0);
    for (const glm::dvec3& way : ways) {
      const double distance =
          distance_along(way, around(from.center() + up, from.size()), obstacles);
      if (2 * level + distance < cost * (1 - 1e-9)) {
        cost = 2 * level + distance;
        best = up + distance * way;
      }
    }
  }
  return best;
}

// The heights by which to raise it onto what it overlaps: 0, and the lowest few.
std::vector<double> levels_above(const Extent& from, const std::vector<Extent>& obstacles) {
  constexpr std::size_t most_levels = 6;
  std::vector<double> levels{0};
  for (const Extent& obstacle : obstacles) {
    if (from.overlaps(obstacle)) {
      levels.push_back(obstacle.max.y - from.min.y);
    }
  }
  std::sort(levels.begin(), levels.end());
  levels.erase(std::unique(levels.begin(), levels.end()), levels.end());
  levels.resize(std::min(levels.size(), most_levels));
  return levels;
}

// Without -0; 0 if a float cannot hold it.
glm::dvec3 finite(const glm::dvec3& v) {
  return glm::length(v) < 1e30 ? v + 0.0 : glm::dvec3(0);
}

bool is_invertible(const DAffine& map) {
  return std::abs(glm::determinant(map.linear)) > 1e-30;
}

}  // namespace

glm::dvec3 free_place(const Document& document, std::optional<ItemId> group, const NewItem& what,
                      const std::optional<Viewpoint>& view) {
  const bool is_light = what.kind == ItemKind::light;
  DrawnItems drawn = drawn_items(document, view);
  const DAffine map = group ? drawn.maps[*group] : DAffine();
  const ItemId master = master_of(document, drawn, group);
  const Extent own = what.kind == ItemKind::instance ? drawn.templates[what.name]
                                                     : extent_of_mesh(what.file, view);
  if (!is_invertible(map) || own.empty()) {
    return glm::dvec3(0);
  }
  const Viewpoint from = view ? *view : viewpoint_of(document, drawn.scene);
  std::vector<Extent> obstacles = obstacles_in(document, drawn, master);
  // What the camera is in may be a room. Templates have their own space, without a camera.
  std::erase_if(obstacles, [&](const Extent& obstacle) {
    return master == no_item && obstacle.holds(from.eye);
  });
  const DAffine turn(map.linear, glm::dvec3(0));
  Extent start = placed(turn, own);
  if (is_light) {
    start = around(map.point({2, 5, 3}), drawn.light_size);
  } else if (master != no_item) {
    start = placed(map, own);
  } else {
    // Far enough away that all of it is in view.
    const double size = std::max({start.size().x, start.size().y, start.size().z});
    const glm::dvec3 way = from.at - from.eye;
    const glm::dvec3 at = from.eye + way * std::max(1.0, 4 * size / glm::length(way));
    start = around(start.center() + glm::round(at / (0.5 * size)) * (0.5 * size), start.size());
  }
  const glm::dvec3 right = right_of(from);
  const glm::dvec3 ahead = glm::cross(glm::dvec3(0, 1, 0), right);
  const glm::dvec3 ways[] = {right, -right, ahead, -ahead};
  const glm::dvec3 place =
      start.center() + shortest(ways, levels_above(start, obstacles), start, obstacles);
  const glm::dvec3 translation =
      inverse(map).point(place) - (is_light ? glm::dvec3(0) : own.center());
  return finite(glm::round(translation * 1000.0) / 1000.0);
}

glm::dvec3 way_beside(const Document& document, ItemId item, const std::optional<Viewpoint>& view) {
  const DrawnItems drawn = drawn_items(document, view);
  Extent own;
  std::vector<bool> inside(drawn.extents.size());
  for (ItemId id = 0; id < inside.size(); ++id) {
    const ItemId parent = document[id].parent;
    inside[id] = id == item || (parent != no_item && inside[parent]);
    if (inside[id]) {
      own.add(drawn.extents[id]);
    }
  }
  const ItemId parent = document[item].parent;
  const DAffine map = parent == no_item ? DAffine() : drawn.maps[parent];
  if (own.empty() || !is_invertible(map) || document[item].kind == ItemKind::master) {
    return glm::dvec3(0);
  }
  // What the original overlaps, such as the ground, is no obstacle for its copy.
  std::vector<Extent> obstacles = obstacles_in(document, drawn, master_of(document, drawn, item));
  std::erase_if(obstacles, [&](const Extent& obstacle) { return own.overlaps(obstacle); });
  obstacles.push_back(own);
  const glm::dvec3 right = right_of(view ? *view : viewpoint_of(document, drawn.scene));
  const glm::dvec3 ways[] = {right, -right};
  const double levels[] = {0};
  return finite(inverse(map).linear * shortest(ways, levels, own, obstacles));
}

}  // namespace scenefile
