// The only file that knows Embree.
//
// Each kept group (merge_groups.h) is one Embree scene with one user geometry whose primitives are
// the group's parts: analytic shapes, meshes, instances of other groups. Embree only finds
// candidates, in single precision and with padded boxes; the callbacks below transform the ray in
// double precision and decide. Distances are those of the world's ray everywhere, because no
// transformed direction is normalized. Native Embree instances are not used: common builds allow
// one level of them and abort at the second.

#include "scenefile/trace/accelerator.h"

#include "scenefile/trace/group_bounds.h"
#include "scenefile/trace/hand_over.h"
#include "scenefile/trace/ray_box.h"

#if SCENEFILE_EMBREE_MAJOR == 4
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cmath>
#include <limits>

namespace scenefile {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// A ray that enters more instances than this is lost in overlapping templates.
constexpr std::uint32_t max_instances_entered = 1u << 22;

// Groups of so few parts are searched one by one.
constexpr std::size_t few_parts = 3;

enum class PartKind : std::uint8_t { shape, mesh, group };

// One cache line. The transform is the definition of where the part is; single precision moves it
// by no more than the file's own numbers do.
struct Part {
  Affine part_from_group;
  PartKind kind = PartKind::shape;
  Shape shape = Shape::cube;
  std::uint32_t target = no_index;  // mesh or group
  std::uint32_t material = 0;
  std::uint32_t source = 0;
};
static_assert(sizeof(Part) == 64);

struct FloatBox {
  float min[3];
  float max[3];
};

// Where the parts of a group or the triangles of a mesh are.
struct Extent {
  Bounds bounds;
  double diagonal = 0;
  double scale = 1;  // of Embree's copy, a power of two: enormous scenes stay in its range
};

struct Group {
  std::vector<Part> parts;
  std::vector<FloatBox> boxes;                        // of the parts, while the structure is built
  std::vector<std::vector<std::uint32_t>> instances;  // by part, where they have names
  Extent extent;
  RTCScene scene = nullptr;  // none for a few parts
};

struct MeshScene {
  const Mesh* mesh = nullptr;
  std::vector<std::uint32_t> triangles;  // in the mesh, by primitive of Embree; empty: all
  Extent extent;
  RTCScene scene = nullptr;
};

#if SCENEFILE_EMBREE_MAJOR == 4
using BaseContext = RTCRayQueryContext;
#else
using BaseContext = RTCIntersectContext;
#endif

// std::nextafter(value, infinity), without a call.
template <typename Bits, typename Float>
Float next_above(Float value) {
  if (!(value < std::numeric_limits<Float>::infinity())) {
    return value;
  }
  if (value == 0) {
    return std::numeric_limits<Float>::denorm_min();
  }
  const auto bits = std::bit_cast<Bits>(value);
  return std::bit_cast<Float>(value > 0 ? bits + 1 : bits - 1);
}

float next_up(double value) {
  return next_above<std::int32_t>(static_cast<float>(value));
}

// The group or mesh that is being traversed: its ray, and Embree's copy of that, whose t is
// (t - shift) * scale.
struct Level {
  const Ray* ray = nullptr;
  double shift = 0;
  double scale = 1;

  float embree_t(double t) const { return next_up((t - shift) * scale); }
};

// What one ray is about. Embree hands the context to every callback; the rest follows it in memory.
struct Query {
  BaseContext context;
  const std::vector<Group>* groups = nullptr;
  const std::vector<MeshScene>* meshes = nullptr;
  double t_min = 0;
  double best = infinity;                      // t of the nearest hit so far, or the end of the ray
  const Transmission* transmission = nullptr;  // shadow rays through transparent objects
  glm::i64vec3 density{0};
  bool shadow = false;
  bool blocked = false;
  bool overwhelmed = false;
  std::uint32_t entered = 0;

  Level level;
  std::uint32_t depth = 0;
  std::array<std::uint32_t, max_instance_nesting + 1> path;  // part in each group on the way

  // The mesh that is being traversed.
  const Part* mesh_part = nullptr;
  bool mesh_crossed = false;

  // MeshDistance::of_mesh: a mesh that is met at t counts as met at t * mesh_scale, and one that
  // counts as nearer than `best` is met before best * reach.
  bool mesh_distances = false;
  double mesh_scale = 1;
  double reach = 1;

  // The nearest hit.
  bool found = false;
  std::uint32_t found_depth = 0;
  std::array<std::uint32_t, max_instance_nesting + 1> found_path;
  const Part* part = nullptr;
  Face face = Face::side;
  std::uint32_t triangle = 0;
  double b1 = 0;
  double b2 = 0;
};

// Some versions hand it to filters as const.
Query& query_of(const BaseContext* context) {
  return *reinterpret_cast<Query*>(const_cast<BaseContext*>(context));
}

Ray transform(const Affine& to_from, const Ray& ray) {
  const DAffine m(to_from);
  return {m.point(ray.origin), m.vector(ray.direction)};
}

// Whether a hit at t replaces the one found so far. Of equal ones the last in the file wins (the
// course's references do so), whatever the order in which Embree offers them.
bool improves(const Query& q, double t, std::uint32_t triangle) {
  if (t != q.best || !q.found) {
    return t < q.best;
  }
  for (std::uint32_t i = 0; i <= std::min(q.depth, q.found_depth); ++i) {
    if (q.path[i] != q.found_path[i]) {
      return q.path[i] > q.found_path[i];
    }
  }
  return triangle > q.triangle;
}

void accept(Query& q, const Part& part, double t) {
  q.found = true;
  q.best = t;
  q.part = &part;
  q.found_depth = q.depth;
  std::copy_n(q.path.begin(), q.depth + 1, q.found_path.begin());
}

// A shadow ray met an object.
void obstruct(Query& q, std::uint32_t material) {
  if (q.transmission == nullptr) {
    q.blocked = true;
    return;
  }
  q.density += q.transmission->density(material);
  q.blocked = Transmission::blocks(q.density);
}

// Embree takes coordinates beyond this for infinite, and ends the process.
bool in_embree_range(const glm::vec3& v) {
  constexpr float largest = 1.8e18f;
  return std::abs(v.x) < largest && std::abs(v.y) < largest && std::abs(v.z) < largest;
}

// Embree's copy of a ray, from just before the box. Starting there instead of at the origin keeps
// single precision good however far away the origin is. False: the ray misses the box.
bool start_in_box(double t_min, double t_max, const Ray& ray, const Extent& extent, Level& level,
                  RTCRay& out) {
  double enter = t_min;
  double leave = t_max;
  if (!clip_to_box(ray, extent.bounds, enter, leave)) {
    return false;
  }
  const double length = glm::length(ray.direction);
  if (!(length > 1e-30 && length < 1e30)) {
    return false;
  }
  level = {&ray, enter - 1e-6 * extent.diagonal / length, extent.scale};
  const glm::vec3 origin(extent.scale * (ray.origin + level.shift * ray.direction));
  const glm::vec3 direction(ray.direction);
  if (!in_embree_range(origin) || !in_embree_range(direction)) {
    return false;
  }
  out = {origin.x,    origin.y,    origin.z,
         0.0f,        direction.x, direction.y,
         direction.z, 0.0f,        level.embree_t(t_max),
         0xffffffffu, 0,           0};
  return true;
}

void embree_intersect(RTCScene scene, Query& q, RTCRayHit& ray) {
#if SCENEFILE_EMBREE_MAJOR == 4
  RTCIntersectArguments arguments;
  rtcInitIntersectArguments(&arguments);
  arguments.context = &q.context;
  rtcIntersect1(scene, &ray, &arguments);
#else
  rtcIntersect1(scene, &q.context, &ray);
#endif
}

void embree_occluded(RTCScene scene, Query& q, RTCRay& ray) {
#if SCENEFILE_EMBREE_MAJOR == 4
  RTCOccludedArguments arguments;
  rtcInitOccludedArguments(&arguments);
  arguments.context = &q.context;
  rtcOccluded1(scene, &ray, &arguments);
#else
  rtcOccluded1(scene, &q.context, &ray);
#endif
}

void search_scene(Query& q, RTCScene scene, const RTCRay& start) {
  if (q.shadow) {
    RTCRay ray = start;
    embree_occluded(scene, q, ray);
    return;
  }
  RTCRayHit ray;
  ray.ray = start;
  ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  ray.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  embree_intersect(scene, q, ray);
}

void test_part(Query& q, const Group& group, std::uint32_t index, const Ray& ray);

void search_group(Query& q, const Group& group, const Ray& ray) {
  if (group.scene == nullptr) {
    for (std::uint32_t i = 0; i < group.parts.size() && !q.blocked; ++i) {
      test_part(q, group, i, ray);
    }
    return;
  }
  Level level;
  RTCRay start;
  const double t_min = q.mesh_distances ? 0 : q.t_min;
  if (!start_in_box(t_min, q.best * q.reach, ray, group.extent, level, start)) {
    return;
  }
  const Level outer = q.level;
  q.level = level;
  search_scene(q, group.scene, start);
  q.level = outer;
}

void search_mesh(Query& q, const Part& part, const Ray& ray) {
  const MeshScene& mesh = (*q.meshes)[part.target];
  Level level;
  RTCRay start;
  q.mesh_scale = q.mesh_distances ? glm::length(ray.direction) : 1;
  if (!start_in_box(q.t_min / q.mesh_scale, q.best / q.mesh_scale, ray, mesh.extent, level,
                    start)) {
    return;
  }
  const Level outer = q.level;
  q.level = level;
  q.mesh_part = &part;
  q.mesh_crossed = false;
  search_scene(q, mesh.scene, start);
  q.level = outer;
  if (q.mesh_crossed) {
    obstruct(q, part.material);
  }
}

void test_shape(Query& q, const Part& part, const Ray& ray) {
  // Up to and including the best t, for the decision between equals.
  ShapeHit hit;
  const double end = q.shadow ? q.best : next_above<std::int64_t>(q.best);
  if (!intersect(part.shape, ray, q.t_min, end, hit)) {
    return;
  }
  if (q.shadow) {
    obstruct(q, part.material);
  } else if (improves(q, hit.t, 0)) {
    accept(q, part, hit.t);
    q.face = hit.face;
    q.triangle = 0;
  }
}

void enter_instance(Query& q, const Part& part, const Ray& ray) {
  if (++q.entered > max_instances_entered) {
    q.overwhelmed = true;
    q.blocked = true;
    q.best = -infinity;
    return;
  }
  ++q.depth;
  search_group(q, (*q.groups)[part.target], ray);
  --q.depth;
}

void test_part(Query& q, const Group& group, std::uint32_t index, const Ray& ray) {
  const Part& part = group.parts[index];
  const Ray local = transform(part.part_from_group, ray);
  q.path[q.depth] = index;
  switch (part.kind) {
    case PartKind::shape:
      return test_shape(q, part, local);
    case PartKind::mesh:
      return search_mesh(q, part, local);
    case PartKind::group:
      return enter_instance(q, part, local);
  }
}

void group_bounds_callback(const RTCBoundsFunctionArguments* arguments) {
  const HandOver hand_over;
  const auto& group = *static_cast<const Group*>(arguments->geometryUserPtr);
  const FloatBox& box = group.boxes[arguments->primID];
  *arguments->bounds_o = {box.min[0], box.min[1], box.min[2], 0.0f,
                          box.max[0], box.max[1], box.max[2], 0.0f};
}

void group_intersect_callback(const RTCIntersectFunctionNArguments* arguments) {
  if (arguments->valid[0] == 0) {
    return;
  }
  Query& q = query_of(arguments->context);
  const auto& group = *static_cast<const Group*>(arguments->geometryUserPtr);
  test_part(q, group, arguments->primID, *q.level.ray);
  auto& ray = *reinterpret_cast<RTCRayHit*>(arguments->rayhit);
  const float end = q.overwhelmed ? -1.0f : q.level.embree_t(q.best * q.reach);
  if (end < ray.ray.tfar) {
    ray.ray.tfar = end;
    ray.hit.geomID = arguments->geomID;
    ray.hit.primID = arguments->primID;
  }
}

void group_occluded_callback(const RTCOccludedFunctionNArguments* arguments) {
  if (arguments->valid[0] == 0) {
    return;
  }
  Query& q = query_of(arguments->context);
  const auto& group = *static_cast<const Group*>(arguments->geometryUserPtr);
  test_part(q, group, arguments->primID, *q.level.ray);
  if (q.blocked) {
    reinterpret_cast<RTCRay*>(arguments->ray)->tfar = -std::numeric_limits<float>::infinity();
  }
}

std::uint32_t triangle_of(const MeshScene& mesh, std::uint32_t primitive) {
  return mesh.triangles.empty() ? primitive : mesh.triangles[primitive];
}

struct TriangleHit {
  double t = 0;
  double b1 = 0;
  double b2 = 0;
};

// Where the ray meets the triangle's plane; Embree has found that it is inside. Weights are
// clamped because at an edge the two precisions disagree.
bool meet_triangle(const Mesh& mesh, std::uint32_t index, const Ray& ray, TriangleHit& hit) {
  const auto& corners = mesh.triangles[index];
  const glm::dvec3 p0(mesh.positions[corners[0]]);
  const glm::dvec3 e1 = glm::dvec3(mesh.positions[corners[1]]) - p0;
  const glm::dvec3 e2 = glm::dvec3(mesh.positions[corners[2]]) - p0;
  const glm::dvec3 normal = glm::cross(e1, e2);
  const double facing = glm::dot(normal, ray.direction);
  hit.t = glm::dot(normal, p0 - ray.origin) / facing;
  if (!std::isfinite(hit.t)) {
    return false;
  }
  const glm::dvec3 q = glm::cross(p0 - ray.origin, ray.direction);
  hit.b1 = glm::clamp(glm::dot(q, e2) / facing, 0.0, 1.0);
  hit.b2 = glm::clamp(-glm::dot(q, e1) / facing, 0.0, 1.0 - hit.b1);
  return true;
}

void mesh_intersect_filter(const RTCFilterFunctionNArguments* arguments) {
  Query& q = query_of(arguments->context);
  const auto& mesh = *static_cast<const MeshScene*>(arguments->geometryUserPtr);
  const auto& candidate = *reinterpret_cast<const RTCHit*>(arguments->hit);
  const std::uint32_t triangle = triangle_of(mesh, candidate.primID);
  TriangleHit hit;
  const bool met = meet_triangle(*mesh.mesh, triangle, *q.level.ray, hit);
  const double t = hit.t * q.mesh_scale;
  if (!met || !(t > q.t_min) || !improves(q, t, triangle)) {
    arguments->valid[0] = 0;
    return;
  }
  accept(q, *q.mesh_part, t);
  q.triangle = triangle;
  q.b1 = hit.b1;
  q.b2 = hit.b2;
  // A little beyond the hit, so that triangles at the same distance are offered too.
  const double beyond = hit.t + 1e-6 * std::abs(hit.t - q.level.shift);
  reinterpret_cast<RTCRay*>(arguments->ray)->tfar = q.level.embree_t(beyond);
}

void mesh_occluded_filter(const RTCFilterFunctionNArguments* arguments) {
  Query& q = query_of(arguments->context);
  const auto& mesh = *static_cast<const MeshScene*>(arguments->geometryUserPtr);
  const auto& candidate = *reinterpret_cast<const RTCHit*>(arguments->hit);
  TriangleHit hit;
  const std::uint32_t triangle = triangle_of(mesh, candidate.primID);
  const bool met = meet_triangle(*mesh.mesh, triangle, *q.level.ray, hit);
  const double t = hit.t * q.mesh_scale;
  if (met && t > q.t_min && t < q.best) {
    q.mesh_crossed = true;
  } else {
    arguments->valid[0] = 0;
  }
}

// A single-precision box around what is to be found in a part. The padding covers the rounding of
// the part's transform and of Embree's rays; it is kept small beside the part itself.
FloatBox padded(const Bounds& box, const Bounds& group) {
  const glm::dvec3 reach = glm::max(glm::abs(group.min), glm::abs(group.max));
  const glm::dvec3 own = glm::max(glm::abs(box.min), glm::abs(box.max));
  const double largest = std::max({reach.x, reach.y, reach.z});
  const double own_largest = std::max({own.x, own.y, own.z});
  const double size = glm::length(box.max - box.min);
  const double pad = std::max(1e-6 * own_largest, std::min(1e-6 * largest, 0.02 * size));
  FloatBox result{};
  for (int axis = 0; axis < 3; ++axis) {
    result.min[axis] = -next_up(pad - box.min[axis]);
    result.max[axis] = next_up(box.max[axis] + pad);
  }
  return result;
}

Bounds scaled(const Bounds& box, double by) {
  return {by * box.min, by * box.max};
}

Bounds widened(const Bounds& box) {
  const glm::dvec3 own = glm::max(glm::abs(box.min), glm::abs(box.max));
  const glm::dvec3 pad(5e-7 * std::max({own.x, own.y, own.z}) + 1e-300);
  return {box.min - pad, box.max + pad};
}

// Brings coordinates that are too large for Embree to about one.
double embree_scale(const Bounds& box) {
  const glm::dvec3 reach = glm::max(glm::abs(box.min), glm::abs(box.max));
  const double largest = std::max({reach.x, reach.y, reach.z});
  return largest > 1e12 ? std::exp2(-std::ceil(std::log2(largest))) : 1;
}

Extent extent_of(const Bounds& box) {
  if (box.empty()) {
    return {};
  }
  return {widened(box), glm::length(box.max - box.min), embree_scale(box)};
}

// No vector becomes longer than this many times itself (the Frobenius norm).
double largest_stretch(const DAffine& map) {
  const glm::dmat3& m = map.linear;
  return std::sqrt(glm::dot(m[0], m[0]) + glm::dot(m[1], m[1]) + glm::dot(m[2], m[2]));
}

// How much longer than in its mesh a vector may be in the world; 1 at least. A group stands behind
// all that it contains.
double mesh_reach(const std::vector<Group>& groups, std::uint32_t root) {
  std::vector<double> longest(groups.size(), 0);
  for (std::size_t g = 0; g < groups.size(); ++g) {
    for (const Part& part : groups[g].parts) {
      const double within = part.kind == PartKind::mesh    ? 1
                            : part.kind == PartKind::group ? longest[part.target]
                                                           : 0;
      if (within > 0) {
        const double stretch = largest_stretch(inverse(DAffine(part.part_from_group)));
        longest[g] = std::max(longest[g], within * stretch);
      }
    }
  }
  return groups.empty() ? 1 : std::max(1.0, longest[root]);
}

}  // namespace

struct Accelerator::Impl {
  RTCDevice device = nullptr;
  std::vector<Group> groups;
  std::vector<MeshScene> meshes;
  std::uint32_t root = 0;
  AcceleratorOptions options;
  double reach = 1;  // of queries, for MeshDistance::of_mesh
  AcceleratorStatus status = AcceleratorStatus::ready;
  mutable std::atomic<bool> overwhelmed{false};

  Impl() = default;
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;
  ~Impl() {
    for (const Group& group : groups) {
      release(group.scene);
    }
    for (const MeshScene& mesh : meshes) {
      release(mesh.scene);
    }
    if (device != nullptr) {
      rtcReleaseDevice(device);
    }
  }

  static void release(RTCScene scene) {
    if (scene != nullptr) {
      rtcReleaseScene(scene);
    }
  }

  void build(const RenderScene& scene, const Assets& assets);
  void build_group(const RenderScene& scene, const MergePlan& plan, std::uint32_t index);
  void add_part(Group& group, const MergedPart& merged, std::vector<Bounds>& boxes);
  void commit_group(Group& group, const std::vector<Bounds>& boxes);
  void build_mesh(std::uint32_t index);
  static void set_triangles(RTCGeometry geometry, MeshScene& mesh,
                            std::vector<std::uint32_t> distinct);
  RTCScene commit(RTCGeometry geometry, RTCSceneFlags flags);
  bool search(Query& q, const Ray& ray) const;
  void fill(const Query& q, const Ray& ray, Hit& hit) const;
};

void Accelerator::Impl::build(const RenderScene& scene, const Assets& assets) {
  const MergePlan plan = plan_merge(scene);
  if (plan.nesting > max_instance_nesting) {
    status = AcceleratorStatus::too_deep;
    return;
  }
  // Eight-wide trees: measured up to a quarter faster than the default.
  device = rtcNewDevice("frequency_level=simd256");
  if (device == nullptr) {
    status = AcceleratorStatus::out_of_memory;
    return;
  }
  const std::vector<Bounds> boxes = mesh_bounds(scene, assets);
  meshes.resize(boxes.size());
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    meshes[i].extent.bounds = boxes[i];
    meshes[i].mesh = boxes[i].empty() ? nullptr : &assets.meshes[i];
  }
  groups.resize(scene.groups.size());
  root = scene.root;
  for (std::uint32_t g = 0; g < groups.size(); ++g) {
    if (plan.kept[g]) {
      build_group(scene, plan, g);
    }
  }
  if (options.mesh_distance == MeshDistance::of_mesh) {
    reach = mesh_reach(groups, root);
  }
  if (rtcGetDeviceError(device) != RTC_ERROR_NONE) {
    status = AcceleratorStatus::out_of_memory;
  }
}

void Accelerator::Impl::build_group(const RenderScene& scene, const MergePlan& plan,
                                    std::uint32_t index) {
  Group& group = groups[index];
  const std::vector<MergedPart> merged = merged_parts(scene, plan, index, options.instances);
  group.parts.reserve(merged.size());
  std::vector<Bounds> boxes;
  boxes.reserve(merged.size());
  for (const MergedPart& part : merged) {
    add_part(group, part, boxes);
  }
  Bounds whole;
  for (const Bounds& box : boxes) {
    whole = unite(whole, box);
  }
  group.extent = extent_of(whole);
  if (group.parts.size() > few_parts) {
    commit_group(group, boxes);
  }
}

void Accelerator::Impl::add_part(Group& group, const MergedPart& merged,
                                 std::vector<Bounds>& boxes) {
  Part part;
  Bounds box;
  if (merged.primitive == nullptr) {
    part.kind = PartKind::group;
    part.target = merged.group;
    box = placed_bounds(groups[merged.group].extent.bounds, merged.group_from_part);
  } else {
    const RenderPrimitive& primitive = *merged.primitive;
    part.shape = primitive.shape;
    part.material = primitive.material;
    part.source = primitive.source;
    if (primitive.shape == Shape::mesh) {
      part.kind = PartKind::mesh;
      part.target = primitive.mesh;
      build_mesh(primitive.mesh);
      box = placed_bounds(meshes[primitive.mesh].extent.bounds, merged.group_from_part);
    } else {
      box = shape_bounds(primitive.shape, merged.group_from_part);
    }
  }
  part.part_from_group = Affine(inverse(merged.group_from_part));
  // Merging may have multiplied transforms beyond what a float can hold.
  if (!box.empty() && invertible(DAffine(part.part_from_group))) {
    group.parts.push_back(part);
    boxes.push_back(box);
    if (options.instances == Instances::named) {
      group.instances.push_back(merged.instances);
    }
  }
}

void Accelerator::Impl::commit_group(Group& group, const std::vector<Bounds>& boxes) {
  const double scale = group.extent.scale;
  const Bounds whole = scaled(group.extent.bounds, scale);
  group.boxes.reserve(boxes.size());
  for (const Bounds& box : boxes) {
    group.boxes.push_back(padded(scaled(box, scale), whole));
  }
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_USER);
  rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned>(group.parts.size()));
  rtcSetGeometryUserData(geometry, &group);
  rtcSetGeometryBoundsFunction(
      geometry, [](const RTCBoundsFunctionArguments* a) { group_bounds_callback(a); }, nullptr);
  rtcSetGeometryIntersectFunction(geometry, group_intersect_callback);
  rtcSetGeometryOccludedFunction(geometry, group_occluded_callback);
  group.scene = commit(geometry, RTC_SCENE_FLAG_NONE);
  group.boxes = {};
}

void Accelerator::Impl::build_mesh(std::uint32_t index) {
  MeshScene& mesh = meshes[index];
  if (mesh.mesh == nullptr || mesh.scene != nullptr) {
    return;
  }
  // Each triangle once: a file can repeat one so often that every ray takes seconds.
  std::vector<std::uint32_t> distinct = distinct_triangles(*mesh.mesh);
  if (distinct.empty()) {
    mesh = {};
    return;
  }
  mesh.extent = extent_of(mesh.extent.bounds);
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  const std::vector<glm::vec3>& positions = mesh.mesh->positions;
  // Copied, not shared: Embree reads a little past the last vertex.
  void* const vertices = rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(glm::vec3), positions.size());
  if (vertices != nullptr) {
    const auto scale = static_cast<float>(mesh.extent.scale);
    std::transform(positions.begin(), positions.end(), static_cast<glm::vec3*>(vertices),
                   [&](const glm::vec3& p) { return scale * p; });
  }
  set_triangles(geometry, mesh, std::move(distinct));
  rtcSetGeometryUserData(geometry, &mesh);
  rtcSetGeometryIntersectFilterFunction(geometry, mesh_intersect_filter);
  rtcSetGeometryOccludedFilterFunction(geometry, mesh_occluded_filter);
  // Robust: without it rays slip through between triangles.
  mesh.scene = commit(geometry, RTC_SCENE_FLAG_ROBUST);
}

void Accelerator::Impl::set_triangles(RTCGeometry geometry, MeshScene& mesh,
                                      std::vector<std::uint32_t> distinct) {
  using Corners = std::array<std::uint32_t, 3>;
  const std::vector<Corners>& all = mesh.mesh->triangles;
  if (distinct.size() == all.size()) {
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, all.data(), 0,
                               sizeof(Corners), all.size());
    return;
  }
  void* const corners = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0,
                                                RTC_FORMAT_UINT3, sizeof(Corners), distinct.size());
  if (corners != nullptr) {
    std::transform(distinct.begin(), distinct.end(), static_cast<Corners*>(corners),
                   [&](std::uint32_t index) { return all[index]; });
  }
  mesh.triangles = std::move(distinct);
}

RTCScene Accelerator::Impl::commit(RTCGeometry geometry, RTCSceneFlags flags) {
  RTCScene scene = rtcNewScene(device);
  rtcSetSceneFlags(scene, flags);
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(scene, geometry);
  rtcReleaseGeometry(geometry);
  HandOver::give();
  rtcCommitScene(scene);
  HandOver::collect();
  return scene;
}

bool Accelerator::Impl::search(Query& q, const Ray& ray) const {
  const glm::dvec3 sum = ray.origin + ray.direction;
  if (groups.empty() || !std::isfinite(sum.x + sum.y + sum.z)) {
    return false;
  }
#if SCENEFILE_EMBREE_MAJOR == 4
  rtcInitRayQueryContext(&q.context);
#else
  rtcInitIntersectContext(&q.context);
#endif
  q.mesh_distances = options.mesh_distance == MeshDistance::of_mesh;
  q.reach = reach;
  q.groups = &groups;
  q.meshes = &meshes;
  search_group(q, groups[root], ray);
  if (q.overwhelmed) {
    overwhelmed.store(true, std::memory_order_relaxed);
  }
  return q.found && !q.overwhelmed;
}

void Accelerator::Impl::fill(const Query& q, const Ray& ray, Hit& hit) const {
  const Part& part = *q.part;
  hit.t = q.best;
  hit.shape = part.shape;
  hit.face = q.face;
  hit.mesh = part.kind == PartKind::mesh ? part.target : no_index;
  hit.triangle = q.triangle;
  hit.b1 = q.b1;
  hit.b2 = q.b2;
  hit.material = part.material;
  hit.source = part.source;
  hit.part = &part;
  hit.object_from_world = DAffine();
  std::uint32_t group = root;
  for (std::uint32_t i = 0; i <= q.found_depth; ++i) {
    const Part& step = groups[group].parts[q.found_path[i]];
    hit.object_from_world = DAffine(step.part_from_group) * hit.object_from_world;
    group = step.target;
  }
  hit.object_point = hit.object_from_world.point(ray.origin + q.best * ray.direction);
}

Accelerator::Accelerator(const RenderScene& scene, const Assets& assets,
                         const AcceleratorOptions& options)
    : impl_(std::make_unique<Impl>()) {
  impl_->options = options;
  impl_->build(scene, assets);
}

Accelerator::~Accelerator() = default;

AcceleratorStatus Accelerator::status() const {
  return impl_->status;
}

bool Accelerator::closest(const Ray& ray, double t_min, double t_max, Hit& hit) const {
  Query q;
  q.t_min = t_min;
  q.best = t_max;
  if (!impl_->search(q, ray)) {
    return false;
  }
  impl_->fill(q, ray, hit);
  return true;
}

std::vector<std::uint32_t> Accelerator::instances_of_closest(const Ray& ray, double t_min,
                                                             double t_max) const {
  Query q;
  q.t_min = t_min;
  q.best = t_max;
  std::vector<std::uint32_t> names;
  if (impl_->options.instances == Instances::unnamed || !impl_->search(q, ray)) {
    return names;
  }
  std::uint32_t index = impl_->root;
  for (std::uint32_t i = 0; i <= q.found_depth; ++i) {
    const Group& group = impl_->groups[index];
    const std::vector<std::uint32_t>& step = group.instances[q.found_path[i]];
    names.insert(names.end(), step.begin(), step.end());
    index = group.parts[q.found_path[i]].target;
  }
  return names;
}

bool Accelerator::occluded(const Ray& ray, double t_min, double t_max) const {
  Query q;
  q.t_min = t_min;
  q.best = t_max;
  q.shadow = true;
  impl_->search(q, ray);
  return q.blocked;
}

glm::dvec3 Accelerator::transmittance(const Ray& ray, double t_min, double t_max,
                                      const Transmission& transmission) const {
  if (transmission.all_opaque()) {
    return glm::dvec3(occluded(ray, t_min, t_max) ? 0 : 1);
  }
  Query q;
  q.t_min = t_min;
  q.best = t_max;
  q.shadow = true;
  q.transmission = &transmission;
  impl_->search(q, ray);
  return q.blocked ? glm::dvec3(0) : Transmission::factor(q.density);
}

bool Accelerator::overwhelmed() const {
  return impl_->overwhelmed.load(std::memory_order_relaxed);
}

bool same_object(const Hit& a, const Hit& b) {
  return a.part == b.part && a.object_from_world == b.object_from_world;
}

}  // namespace scenefile
