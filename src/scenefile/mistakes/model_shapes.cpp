#include "scenefile/mistakes/model.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace scenefile {

namespace {

using glm::dvec3;
using glm::vec3;

constexpr std::uint32_t parts_in_leaf = 1;  // a box is cheaper to test than a part
constexpr std::uint32_t triangles_in_leaf = 4;

using ModelBox = std::array<vec3, 2>;

ModelBox nothing() {
  constexpr float far = std::numeric_limits<float>::infinity();
  return {vec3(far), vec3(-far)};
}
void grow(ModelBox& box, const ModelBox& other) {
  box = {glm::min(box[0], other[0]), glm::max(box[1], other[1])};
}
float half_area(const ModelBox& box) {
  const vec3 d = box[1] - box[0];
  return d.x * d.y + d.y * d.z + d.z * d.x;
}

struct TreeBuilder {
  const std::vector<ModelBox>& bounds;
  ModelTree& tree;
  std::uint32_t leaf_size;

  // Where to split a range in two; its end if it is a leaf. Splits where the halves have the least
  // area, weighted by their numbers of boxes, along the axis on which they spread most; deep in the
  // tree, in the middle.
  std::uint32_t half(std::uint32_t first, std::uint32_t last, int level) const {
    constexpr int max_level = 24;
    constexpr std::size_t bins = 12;
    ModelBox centers = nothing();  // times 2
    const auto center = [&](std::uint32_t item) { return bounds[item][0] + bounds[item][1]; };
    for (std::uint32_t i = first; i < last; ++i) {
      const vec3 c = center(tree.order[i]);
      grow(centers, {c, c});
    }
    const vec3 size = centers[1] - centers[0];
    const int axis = size.x > size.y && size.x > size.z ? 0 : size.y > size.z ? 1 : 2;
    if (last - first <= leaf_size || !(size[axis] > 0 && std::isfinite(size[axis]))) {
      return last;
    }
    if (last - first == 2) {
      return first + 1;
    }
    const auto begin = tree.order.begin() + first;
    const auto end = tree.order.begin() + last;
    if (level > max_level) {
      const auto middle = begin + (last - first) / 2;
      std::nth_element(begin, middle, end, [&](std::uint32_t a, std::uint32_t b) {
        return std::pair(center(a)[axis], a) < std::pair(center(b)[axis], b);
      });
      return first + (last - first) / 2;
    }
    const auto bin_of = [&](std::uint32_t item) {
      const float share = (center(item)[axis] - centers[0][axis]) / size[axis];
      return share > 0 ? std::min(bins - 1, static_cast<std::size_t>(share * bins)) : 0;
    };
    std::array<ModelBox, bins> boxes;
    boxes.fill(nothing());
    std::array<std::uint32_t, bins> counts{};
    for (auto i = begin; i != end; ++i) {
      grow(boxes[bin_of(*i)], bounds[*i]);
      ++counts[bin_of(*i)];
    }
    std::array<float, bins> after{};  // cost of this bin and those after it
    ModelBox box = nothing();
    std::uint32_t count = 0;
    for (std::size_t k = bins; k-- > 1;) {
      grow(box, boxes[k]);
      count += counts[k];
      after[k] = count > 0 ? half_area(box) * static_cast<float>(count) : 0;
    }
    box = nothing();
    count = 0;
    float least = std::numeric_limits<float>::infinity();
    std::size_t split = 1;
    for (std::size_t k = 1; k < bins; ++k) {
      grow(box, boxes[k - 1]);
      count += counts[k - 1];
      const float cost = half_area(box) * static_cast<float>(count) + after[k];
      if (cost < least) {
        least = cost;
        split = k;
      }
    }
    return static_cast<std::uint32_t>(
        std::partition(begin, end, [&](std::uint32_t item) { return bin_of(item) < split; }) -
        tree.order.begin());
  }

  std::uint32_t node(std::uint32_t first, std::uint32_t last, int level) {
    const auto index = static_cast<std::uint32_t>(tree.nodes.size());
    tree.nodes.emplace_back();
    const std::uint32_t middle = half(first, last, level);
    const std::array<std::uint32_t, 5> ends{first, half(first, middle, level), middle,
                                            half(middle, last, level), last};
    for (std::size_t k = 0; k < 4; ++k) {
      ModelBox box = nothing();
      for (std::uint32_t i = ends[k]; i < ends[k + 1]; ++i) {
        grow(box, bounds[tree.order[i]]);
      }
      for (int axis = 0; axis < 3; ++axis) {
        tree.nodes[index].low[axis][k] = box[0][axis];
        tree.nodes[index].high[axis][k] = box[1][axis];
      }
      const std::uint32_t count = ends[k + 1] - ends[k];
      const bool leaf = count <= leaf_size || count == last - first;
      const ModelTree::Child child =
          leaf ? ModelTree::Child{ends[k], count}
               : ModelTree::Child{node(ends[k], ends[k + 1], level + 1), 0};
      tree.nodes[index].children[k] = child;
    }
    return index;
  }
};

ModelTree tree_of(const std::vector<ModelBox>& bounds, std::uint32_t leaf_size) {
  ModelTree tree;
  tree.order.resize(bounds.size());
  for (std::uint32_t i = 0; i < bounds.size(); ++i) {
    tree.order[i] = i;
  }
  TreeBuilder{bounds, tree, leaf_size}.node(0, static_cast<std::uint32_t>(bounds.size()), 0);
  return tree;
}

ModelBox wider(vec3 low, vec3 high) {
  const vec3 room = 1e-5f * glm::max(glm::abs(low), glm::abs(high)) + vec3(1e-6f);
  return {low - room, high + room};
}

ModelBox bounds_of(const ModelPart& part, const Assets& assets) {
  vec3 low(std::numeric_limits<float>::infinity());
  vec3 high = -low;
  dvec3 object_low(-0.5);
  dvec3 object_high(0.5);
  if (part.shape == Shape::mesh) {
    object_low = dvec3(infinity);
    object_high = -object_low;
    for (const vec3& p : assets.meshes[part.mesh].positions) {
      object_low = glm::min(object_low, dvec3(p));
      object_high = glm::max(object_high, dvec3(p));
    }
  }
  for (int corner = 0; corner < 8; ++corner) {
    const vec3 p(part.world_from_object.point({corner & 1 ? object_high.x : object_low.x,
                                               corner & 2 ? object_high.y : object_low.y,
                                               corner & 4 ? object_high.z : object_low.z}));
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  return wider(low, high);
}

void add_parts(const RenderScene& scene, const Assets& assets, std::uint32_t group,
               const DAffine& world_from_group, std::vector<ModelPart>& parts) {
  for (const RenderPrimitive& p : scene.groups[group].primitives) {
    if (p.shape == Shape::mesh &&
        (p.mesh >= assets.meshes.size() || assets.meshes[p.mesh].triangles.empty())) {
      continue;
    }
    ModelPart part;
    part.world_from_object = world_from_group * DAffine(p.group_from_object);
    part.object_from_world = inverse(part.world_from_object);
    part.shape = p.shape;
    part.mesh = p.mesh;
    part.material = p.material;
    part.source = p.source;
    parts.push_back(part);
  }
  for (const RenderInstance& i : scene.groups[group].instances) {
    add_parts(scene, assets, i.group, world_from_group * DAffine(i.group_from_instance), parts);
  }
}

std::shared_ptr<const std::vector<ModelTree>> trees_of(const std::vector<Mesh>& meshes) {
  auto trees = std::make_shared<std::vector<ModelTree>>();
  std::vector<ModelBox> bounds;
  for (const Mesh& mesh : meshes) {
    bounds.clear();
    for (const auto& corners : mesh.triangles) {
      const vec3& a = mesh.positions[corners[0]];
      const vec3& b = mesh.positions[corners[1]];
      const vec3& c = mesh.positions[corners[2]];
      bounds.push_back(wider(glm::min(a, glm::min(b, c)), glm::max(a, glm::max(b, c))));
    }
    trees->push_back(tree_of(bounds, triangles_in_leaf));
  }
  return trees;
}

}  // namespace

std::shared_ptr<const ModelShapes> flatten(const RenderScene& scene, const Assets& assets,
                                           const ModelShapes* same_meshes) {
  if (!(count_virtual_primitives(scene) <= max_model_parts) || scene.groups.empty()) {
    return nullptr;
  }
  auto shapes = std::make_shared<ModelShapes>();
  add_parts(scene, assets, scene.root, DAffine(), shapes->parts);
  std::vector<ModelBox> bounds;
  bounds.reserve(shapes->parts.size());
  for (const ModelPart& part : shapes->parts) {
    bounds.push_back(bounds_of(part, assets));
  }
  shapes->tree = tree_of(bounds, parts_in_leaf);
  shapes->mesh_trees = same_meshes != nullptr ? same_meshes->mesh_trees : trees_of(assets.meshes);
  return shapes;
}

namespace {

struct Crossing {
  double t = 0;
  int face = 0;
};

struct Crossings {
  std::array<Crossing, 6> at;
  int count = 0;
  void add(double t, int face) {
    if (std::isfinite(t) && count < 6) {
      at[count++] = {t, face};
    }
  }
};

void solve(double a, double h, double c, double roots[2], int& count) {
  count = 0;
  if (a == 0) {
    if (h != 0) {
      roots[count++] = -c / (2 * h);
    }
    return;
  }
  const double square = h * h - a * c;
  if (square >= 0) {
    const double root = std::sqrt(square);
    const double q = -(h + (h < 0 ? -root : root));
    roots[count++] = q / a;
    if (q != 0) {
      roots[count++] = c / q;
    }
  }
}

double scale_of_roots(ShapeMistake mistake, double a) {
  return mistake == ShapeMistake::precedence      ? a * a
         : mistake == ShapeMistake::roots_doubled ? 2
                                                  : 1;
}

void sphere(const dvec3& o, const dvec3& d, ShapeMistake mistake, Crossings& found) {
  // Computed from the point on the line closest to the center, to avoid cancellation.
  const double a = glm::dot(d, d);
  const double middle = -glm::dot(o, d) / a;
  const dvec3 p = o + middle * d;
  const double square = (0.25 - glm::dot(p, p)) / a;
  if (square >= 0) {
    const double half = std::sqrt(square);
    const double scale = scale_of_roots(mistake, a);
    found.add(scale * (middle - half), 0);
    found.add(scale * (middle + half), 0);
  }
}

void cube(const dvec3& o, const dvec3& d, int missing_face, Crossings& found) {
  double enter = -infinity;
  double exit = infinity;
  int enter_face = 0;
  int exit_face = 0;
  for (int axis = 0; axis < 3; ++axis) {
    if (d[axis] == 0) {
      if (std::abs(o[axis]) > 0.5) {
        return;
      }
      continue;
    }
    const double low = (-0.5 - o[axis]) / d[axis];
    const double high = (0.5 - o[axis]) / d[axis];
    const int low_face = 2 + 2 * axis;
    const int high_face = 1 + 2 * axis;
    if (std::min(low, high) > enter) {
      enter = std::min(low, high);
      enter_face = low < high ? low_face : high_face;
    }
    if (std::max(low, high) < exit) {
      exit = std::max(low, high);
      exit_face = low < high ? high_face : low_face;
    }
  }
  if (enter <= exit) {
    if (enter_face != missing_face) {
      found.add(enter, enter_face);
    }
    if (exit_face != missing_face) {
      found.add(exit, exit_face);
    }
  }
}

void cap(const dvec3& o, const dvec3& d, double y, int face, ShapeMistake mistake,
         Crossings& found) {
  const double t = (y - o.y) / d.y;
  const double x = o.x + t * d.x;
  const double z = o.z + t * d.z;
  if (mistake == ShapeMistake::square_caps
          ? std::max(std::abs(x), std::abs(z)) <= 0.5
          : x * x + z * z <= (mistake == ShapeMistake::wide_caps          ? 1
                              : mistake == ShapeMistake::caps_square_half ? 0.5
                                                                          : 0.25)) {
    found.add(t, face);
  }
}

// Roots of a t^2 + 2 h t + c where y is at least `low` and at most `high`.
void side_roots(const dvec3& o, const dvec3& d, double a, double h, double c, double low,
                double high, ShapeMistake mistake, Crossings& found) {
  double roots[2];
  int count = 0;
  solve(a, h, c, roots, count);
  const double scale = scale_of_roots(mistake, a);
  for (int i = 0; i < count; ++i) {
    const double t = scale * roots[i];
    const double y = o.y + t * d.y;
    if (y >= low && y <= high) {
      found.add(t, 0);
    }
  }
}

void cylinder(const dvec3& o, const dvec3& d, bool caps, ShapeMistake mistake, ShapeMistake of_caps,
              Crossings& found) {
  const bool ends = mistake != ShapeMistake::endless && mistake != ShapeMistake::endless_cylinder;
  const double high = ends ? 0.5 : infinity;
  const double square = mistake == ShapeMistake::cylinder_square_half  ? 0.5
                        : mistake == ShapeMistake::cylinder_sides_wide ? 1
                                                                       : 0.25;
  side_roots(o, d, d.x * d.x + d.z * d.z, o.x * d.x + o.z * d.z, o.x * o.x + o.z * o.z - square,
             -high, high, mistake, found);
  if (caps && d.y != 0) {
    if (mistake != ShapeMistake::no_top_cap) {
      cap(o, d, 0.5, 1, of_caps, found);
    }
    if (mistake != ShapeMistake::no_bottom_cap && mistake != ShapeMistake::no_cylinder_bottom) {
      cap(o, d, -0.5, 2, of_caps, found);
    }
  }
}

void cone(const dvec3& o, const dvec3& d, bool caps, ShapeMistake mistake, ShapeMistake of_caps,
          Crossings& found) {
  const bool endless = mistake == ShapeMistake::endless || mistake == ShapeMistake::endless_cone;
  const double y = o.y - 0.5;
  const double k = mistake == ShapeMistake::wide_cone ? 1 : 0.25;
  side_roots(o, d, d.x * d.x + d.z * d.z - k * d.y * d.y, o.x * d.x + o.z * d.z - k * y * d.y,
             o.x * o.x + o.z * o.z - k * y * y,
             endless || mistake == ShapeMistake::deep_cone ? -infinity : -0.5,
             endless || mistake == ShapeMistake::double_cone ? infinity : 0.5, mistake, found);
  if (caps && d.y != 0 && mistake != ShapeMistake::no_bottom_cap) {
    cap(o, d, -0.5, 2, of_caps, found);
  }
}

// Whether shapes extend beyond their bounding boxes.
bool is_unbounded(ShapeMistake mistake) {
  return mistake == ShapeMistake::endless_cylinder || mistake == ShapeMistake::endless_cone ||
         mistake == ShapeMistake::double_cone || mistake == ShapeMistake::deep_cone ||
         mistake == ShapeMistake::endless || mistake == ShapeMistake::wide_caps ||
         mistake == ShapeMistake::caps_square_half ||
         mistake == ShapeMistake::cylinder_square_half ||
         mistake == ShapeMistake::cylinder_sides_wide || mistake == ShapeMistake::wide_cone ||
         mistake == ShapeMistake::precedence || mistake == ShapeMistake::roots_doubled;
}

using Four = ModelTree::Four;

Four smaller(Four a, Four b) {
  return a < b ? a : b;
}
Four larger(Four a, Four b) {
  return a > b ? a : b;
}

// A ray prepared for tests in single precision that miss no box that it hits.
struct BoxRay {
  static constexpr float error = 1e-6f;  // of a t, relative
  float inverse[3];
  float before[3];  // the origin, moved back and forth by rounding errors
  float beyond[3];

  BoxRay(const dvec3& origin, const dvec3& direction) {
    for (int axis = 0; axis < 3; ++axis) {
      constexpr double large = 1e30;  // of a zero component
      inverse[axis] = static_cast<float>(std::clamp(1 / direction[axis], -large, large));
      const double off = 3e-7 * std::abs(origin[axis]) * (inverse[axis] < 0 ? -1 : 1);
      before[axis] = static_cast<float>(origin[axis] + off);
      beyond[axis] = static_cast<float>(origin[axis] - off);
    }
  }
  // The t where the ray enters each box; infinity if it misses it between t_min and t_max.
  Four enter(const ModelTree::Node& node, float t_min, float t_max) const {
    Four enter = Four{} + t_min;
    Four leave = Four{} + t_max;
    for (int axis = 0; axis < 3; ++axis) {
      const bool back = inverse[axis] < 0;
      const Four near = (back ? node.high : node.low)[axis];
      const Four far = (back ? node.low : node.high)[axis];
      enter = larger(enter, (near - before[axis]) * inverse[axis]);
      leave = smaller(leave, (far - beyond[axis]) * inverse[axis]);
    }
    const Four none = Four{} + std::numeric_limits<float>::infinity();
    return enter <= leave + error * larger(leave, -leave) ? enter : none;
  }
};

// Calls leaf(index) for candidates between t_min and the current result of `t_max`, the nearer
// boxes first; stops when it returns true. `far_steps`: counts nodes and candidates beyond the
// first few.
template <typename End, typename Leaf>
bool walk(const ModelTree& tree, const dvec3& origin, const dvec3& direction, double t_min,
          const End& t_max, std::uint64_t& far_steps, const Leaf& leaf) {
  constexpr int few_steps = 6;
  struct Entered {
    float at;
    ModelTree::Child child;
  };
  const BoxRay ray(origin, direction);
  const auto end = [&] {
    const double t = t_max();
    return static_cast<float>(t + double(BoxRay::error) * std::abs(t));
  };
  int steps = 0;
  std::array<Entered, 256> stack;
  std::size_t size = 0;
  stack[size++] = {static_cast<float>(t_min), {0, 0}};
  while (size > 0) {
    const Entered now = stack[--size];
    const float last = end();
    if (now.at > last) {
      continue;
    }
    for (std::uint32_t i = now.child.first; i < now.child.first + now.child.count; ++i) {
      far_steps += ++steps > few_steps ? 1 : 0;
      if (leaf(tree.order[i])) {
        return true;
      }
    }
    if (now.child.count > 0 || size + 4 > stack.size()) {
      continue;
    }
    far_steps += ++steps > few_steps ? 1 : 0;
    const ModelTree::Node& node = tree.nodes[now.child.first];
    const Four enter = ray.enter(node, static_cast<float>(t_min), last);
    const std::size_t first = size;
    for (std::size_t k = 0; k < 4; ++k) {
      if (enter[k] < std::numeric_limits<float>::infinity()) {
        std::size_t i = size++;
        for (; i > first && stack[i - 1].at < enter[k]; --i) {
          stack[i] = stack[i - 1];
        }
        stack[i] = {enter[k], node.children[k]};
      }
    }
  }
  return false;
}

bool triangle(const Mesh& mesh, std::uint32_t index, const dvec3& o, const dvec3& d, double& t,
              double& b1, double& b2) {
  const auto& corners = mesh.triangles[index];
  const dvec3 a(mesh.positions[corners[0]]);
  const dvec3 e1 = dvec3(mesh.positions[corners[1]]) - a;
  const dvec3 e2 = dvec3(mesh.positions[corners[2]]) - a;
  const dvec3 p = glm::cross(d, e2);
  const double det = glm::dot(p, e1);
  if (det == 0) {
    return false;
  }
  const dvec3 s = o - a;
  b1 = glm::dot(s, p) / det;
  const dvec3 q = glm::cross(s, e1);
  b2 = glm::dot(d, q) / det;
  t = glm::dot(e2, q) / det;
  return b1 >= 0 && b2 >= 0 && b1 + b2 <= 1;
}

}  // namespace

bool Model::meet(const ModelPart& part, const ModelRay& ray, double t_min, double t_max,
                 bool shadow, ModelHit& hit) const {
  const DAffine& to_object = part.object_from_world;
  const dvec3 o = to_object.point(ray.origin);
  const dvec3 d = m_.directions == DirectionMistake::translated ? to_object.point(ray.direction)
                  : m_.directions == DirectionMistake::of_world ? ray.direction
                                                                : to_object.vector(ray.direction);
  bool found = false;
  const bool far = m_.nearest == NearestMistake::farthest || m_.nearest == NearestMistake::far_root;
  const auto offer = [&](double t, int face, std::uint32_t index, double b1, double b2) {
    if (!(t > t_min && t < t_max) || (found && (far ? t < hit.t : t > hit.t))) {
      return;
    }
    hit = {t, 1, &part, face, index, b1, b2};
    found = true;
  };
  Crossings crossings;
  const ShapeMistake of_caps =
      m_.caps_of.value_or(part.shape) == part.shape ? m_.shape : ShapeMistake::none;
  switch (part.shape) {
    case Shape::cube:
      cube(o, d, m_.missing_face, crossings);
      break;
    case Shape::sphere:
      sphere(o, d, m_.shape, crossings);
      break;
    case Shape::cylinder:
      cylinder(o, d, !m_.no_cylinder_caps, m_.shape, of_caps, crossings);
      break;
    case Shape::cone:
      cone(o, d, !m_.no_cone_cap, m_.shape, of_caps, crossings);
      break;
    case Shape::mesh: {
      const Mesh& mesh = assets_.meshes[part.mesh];
      const double scale = options_.profile == Profile::course ? glm::length(d) : 1;
      walk((*shapes_.mesh_trees)[part.mesh], o, d, t_min / scale,
           [&] { return (found && !far ? hit.t : t_max) / scale; }, far_steps_,
           [&](std::uint32_t index) {
             double t = 0;
             double b1 = 0;
             double b2 = 0;
             if (triangle(mesh, index, o, d, t, b1, b2)) {
               offer(t * scale, 0, index, b1, b2);
             }
             return shadow && found;
           });
      return found;
    }
  }
  if (m_.nearest == NearestMistake::near_root_only && crossings.count > 0) {
    const Crossing* nearest =
        std::min_element(crossings.at.begin(), crossings.at.begin() + crossings.count,
                         [](const Crossing& a, const Crossing& b) { return a.t < b.t; });
    offer(nearest->t, nearest->face, 0, 0, 0);
    return found;
  }
  for (int i = 0; i < crossings.count; ++i) {
    offer(crossings.at[i].t, crossings.at[i].face, 0, 0, 0);
  }
  return found;
}

bool Model::search(const ModelRay& ray, double t_min, double t_max, bool shadow,
                   const ModelPart* without, ModelHit& hit) const {
  ++rays_;
  const bool behind =
      m_.nearest == NearestMistake::behind || m_.nearest == NearestMistake::behind_first;
  // Only camera rays have t_min = 0.
  const bool right_here = shadow || (behind && t_min > 0 && !m_.behind_in_reflections);
  const NearestMistake nearest = right_here ? NearestMistake::none : m_.nearest;
  const bool scaled_shadow = shadow && (m_.nearest == NearestMistake::object_distance_everywhere ||
                                        m_.shadow == ShadowMistake::object_distance);
  const bool pruned =
      !scaled_shadow &&
      (nearest == NearestMistake::none || nearest == NearestMistake::first_of_ties ||
       nearest == NearestMistake::far_root || nearest == NearestMistake::near_root_only ||
       nearest == NearestMistake::behind || nearest == NearestMistake::behind_first);
  const bool of_object = nearest == NearestMistake::object_distance ||
                         nearest == NearestMistake::object_distance_compared ||
                         nearest == NearestMistake::object_distance_everywhere;
  if (behind && !right_here) {
    t_min = -infinity;
  }
  bool found = false;
  double best = 0;
  const auto better = [&](const ModelHit& candidate, double key) {
    switch (nearest) {
      case NearestMistake::farthest:
      case NearestMistake::farthest_object:
        return key > best;
      case NearestMistake::last:
        return candidate.part > hit.part;
      case NearestMistake::first:
        return candidate.part < hit.part;
      case NearestMistake::behind:
        return std::abs(key) < std::abs(best);
      case NearestMistake::first_of_ties:
        return key < best || (key == best && candidate.part < hit.part);
      case NearestMistake::none:
      case NearestMistake::object_distance:
      case NearestMistake::object_distance_compared:
      case NearestMistake::object_distance_everywhere:
      case NearestMistake::far_root:
      case NearestMistake::near_root_only:
      case NearestMistake::behind_first:
        break;
    }
    // On ties, the last shape in the file wins.
    return key < best || (key == best && candidate.part > hit.part);
  };
  const bool along = !behind || right_here;
  const double searched_to = scaled_shadow ? infinity : t_max;
  const auto visit = [&](std::uint32_t index) {
    const ModelPart& part = shapes_.parts[index];
    ModelHit candidate;
    if (&part == without || !meet(part, ray, t_min, searched_to, shadow, candidate)) {
      return false;
    }
    const double stretch =
        of_object || scaled_shadow ? glm::length(part.object_from_world.vector(ray.direction)) : 1;
    const double key = stretch * candidate.t;
    if (scaled_shadow && key >= t_max) {
      return false;
    }
    candidate.stretch =
        of_object && nearest != NearestMistake::object_distance_compared ? stretch : 1;
    if (!found || better(candidate, key)) {
      hit = candidate;
      best = key;
      found = true;
    }
    return shadow;
  };
  if (is_unbounded(m_.shape) || m_.directions != DirectionMistake::none) {
    far_steps_ += shapes_.parts.size();
    for (std::uint32_t i = 0; i < shapes_.parts.size() && !(shadow && found); ++i) {
      visit(i);
    }
    return found;
  }
  walk(
      shapes_.tree, ray.origin, ray.direction, t_min,
      [&] { return pruned && found && along ? hit.t * (1 + 1e-12) : searched_to; }, far_steps_,
      visit);
  return found;
}

}  // namespace scenefile
