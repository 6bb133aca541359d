// The only file that includes Embree. Each scene has one user geometry whose primitives are the
// group's objects, or the triangles of a mesh, in single precision and with padded boxes. Embree's
// instances are not used, because common builds only allow one level of them and abort at the
// second.

#include "scenefile/geometry/ray_box.h"
#include "scenefile/trace/next_up.h"
#include "scenefile/trace/ray_scenes.h"
#include "scenefile/trace/triangle.h"
#include "scenefile/trace/tsan_handoff.h"

#if SCENEFILE_EMBREE_MAJOR == 4
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <exception>

namespace scenefile {

namespace {

#if SCENEFILE_EMBREE_MAJOR == 4
using BaseContext = RTCRayQueryContext;
#else
using BaseContext = RTCIntersectContext;
#endif

// The ray in the space of the group or mesh, and Embree's copy of it, whose t is (t - shift) *
// scale.
struct Level {
  const Ray* ray = nullptr;
  double shift = 0;
  double scale = 1;
  double margin = 0;  // exceeds Embree's errors of t, which grow where a ray grazes a triangle

  float embree_t(double t) const { return next_up((t - shift) * scale); }
  // Beyond t, so that triangles at the same distance are tested too, whichever comes first.
  float beyond(double t) const { return embree_t(t + margin); }
};

// The search of one group or mesh. Embree passes the context to every callback; the rest follows it
// in memory.
struct Search {
  BaseContext base;
  Query* query = nullptr;
  Level level;
  const Object* mesh_object = nullptr;
  bool mesh_crossed = false;
};

// Some versions pass it to filters as const.
Search& search_of(const BaseContext* context) {
  return *reinterpret_cast<Search*>(const_cast<BaseContext*>(context));
}

// Embree treats larger coordinates as infinite, and aborts the process.
bool in_embree_range(const glm::vec3& v) {
  constexpr float largest = 1.8e18f;
  return std::abs(v.x) < largest && std::abs(v.y) < largest && std::abs(v.z) < largest;
}

// Embree's copy of a ray, starting just before the box instead of at the origin, which keeps single
// precision accurate for distant origins. Returns false if the ray misses the box.
bool start_in_box(double t_min, double t_max, const Ray& ray, const Extent& extent, Level& level,
                  RTCRay& out) {
  double enter = t_min;
  double leave = t_max;
  const bool begins_inside = t_min >= 0 && holds(extent.bounds, ray.origin);
  if (!begins_inside && !clip_to_box(ray, extent.bounds, enter, leave)) {
    return false;
  }
  const glm::dvec3 size = glm::abs(ray.direction);
  const double largest = std::max({size.x, size.y, size.z});
  if (!(largest > 1e-30 && largest < 1e30)) {
    return false;
  }
  const double across = extent.diagonal / largest;
  level = {&ray, enter - 1e-6 * across, extent.scale, 1e-3 * across};
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

void embree_intersect(RTCScene scene, Search& s, RTCRayHit& ray) {
#if SCENEFILE_EMBREE_MAJOR == 4
  RTCIntersectArguments arguments;
  rtcInitIntersectArguments(&arguments);
  arguments.context = &s.base;
  rtcIntersect1(scene, &ray, &arguments);
#else
  rtcIntersect1(scene, &s.base, &ray);
#endif
}

void embree_occluded(RTCScene scene, Search& s, RTCRay& ray) {
#if SCENEFILE_EMBREE_MAJOR == 4
  RTCOccludedArguments arguments;
  rtcInitOccludedArguments(&arguments);
  arguments.context = &s.base;
  rtcOccluded1(scene, &ray, &arguments);
#else
  rtcOccluded1(scene, &s.base, &ray);
#endif
}

void search_scene(Search& s, RTCScene scene, const RTCRay& start) {
#if SCENEFILE_EMBREE_MAJOR == 4
  rtcInitRayQueryContext(&s.base);
#else
  rtcInitIntersectContext(&s.base);
#endif
  if (s.query->shadow) {
    RTCRay ray = start;
    embree_occluded(scene, s, ray);
    return;
  }
  RTCRayHit ray;
  ray.ray = start;
  ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  ray.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  embree_intersect(scene, s, ray);
}

void group_bounds_callback(const RTCBoundsFunctionArguments* arguments) {
  const TsanHandoff handoff;
  const auto& group = *static_cast<const Group*>(arguments->geometryUserPtr);
  const FloatBox& box = group.boxes[arguments->primID];
  *arguments->bounds_o = {box.min[0], box.min[1], box.min[2], 0.0f,
                          box.max[0], box.max[1], box.max[2], 0.0f};
}

void group_intersect_callback(const RTCIntersectFunctionNArguments* arguments) {
  if (arguments->valid[0] == 0) {
    return;
  }
  Search& s = search_of(arguments->context);
  Query& q = *s.query;
  const auto& group = *static_cast<const Group*>(arguments->geometryUserPtr);
  const double before = q.best;
  test_object(q, group, arguments->primID, *s.level.ray);
  if (q.best == before) {
    return;
  }
  auto& ray = *reinterpret_cast<RTCRayHit*>(arguments->rayhit);
  const float end = q.overwhelmed ? -1.0f : s.level.embree_t(q.best * q.reach);
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
  Search& s = search_of(arguments->context);
  Query& q = *s.query;
  const auto& group = *static_cast<const Group*>(arguments->geometryUserPtr);
  test_object(q, group, arguments->primID, *s.level.ray);
  if (q.blocked) {
    reinterpret_cast<RTCRay*>(arguments->ray)->tfar = -std::numeric_limits<float>::infinity();
  }
}

void mesh_intersect_filter(const RTCFilterFunctionNArguments* arguments) {
  Search& s = search_of(arguments->context);
  Query& q = *s.query;
  const auto& mesh = *static_cast<const MeshScene*>(arguments->geometryUserPtr);
  const auto& candidate = *reinterpret_cast<const RTCHit*>(arguments->hit);
  const std::uint32_t triangle = triangle_of(mesh, candidate.primID);
  TriangleHit hit;
  const bool met = meet_triangle(*mesh.mesh, triangle, *s.level.ray, hit);
  const double t = hit.t * q.mesh_scale;
  if (!met || !(t > q.t_min) || !improves(q, t, triangle)) {
    arguments->valid[0] = 0;
    return;
  }
  accept(q, *s.mesh_object, t);
  q.triangle = triangle;
  q.b1 = hit.b1;
  q.b2 = hit.b2;
  reinterpret_cast<RTCRay*>(arguments->ray)->tfar = s.level.beyond(hit.t);
}

void mesh_occluded_filter(const RTCFilterFunctionNArguments* arguments) {
  Search& s = search_of(arguments->context);
  Query& q = *s.query;
  const auto& mesh = *static_cast<const MeshScene*>(arguments->geometryUserPtr);
  const auto& candidate = *reinterpret_cast<const RTCHit*>(arguments->hit);
  TriangleHit hit;
  const std::uint32_t triangle = triangle_of(mesh, candidate.primID);
  const bool met = meet_triangle(*mesh.mesh, triangle, *s.level.ray, hit);
  const double t = hit.t * q.mesh_scale;
  if (met && t > q.t_min && t < q.best) {
    s.mesh_crossed = true;
  } else {
    arguments->valid[0] = 0;
  }
}

RTCGeometry group_geometry(RTCDevice device, Group& group) {
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_USER);
  rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned>(group.objects.size()));
  rtcSetGeometryUserData(geometry, &group);
  rtcSetGeometryBoundsFunction(
      geometry, [](const RTCBoundsFunctionArguments* a) { group_bounds_callback(a); }, nullptr);
  rtcSetGeometryIntersectFunction(geometry, group_intersect_callback);
  rtcSetGeometryOccludedFunction(geometry, group_occluded_callback);
  return geometry;
}

// Copied instead of shared, because Embree reads slightly past the last vertex.
void set_vertices(RTCGeometry geometry, const MeshScene& mesh) {
  const std::vector<glm::vec3>& positions = mesh.mesh->positions;
  void* const vertices = rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(glm::vec3), positions.size());
  if (vertices != nullptr) {
    const auto scale = static_cast<float>(mesh.extent.scale);
    std::transform(positions.begin(), positions.end(), static_cast<glm::vec3*>(vertices),
                   [&](const glm::vec3& p) { return scale * p; });
  }
}

void set_triangles(RTCGeometry geometry, const MeshScene& mesh) {
  using Corners = std::array<std::uint32_t, 3>;
  const std::vector<Corners>& all = mesh.mesh->triangles;
  if (mesh.triangles.empty()) {
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, all.data(), 0,
                               sizeof(Corners), all.size());
    return;
  }
  void* const corners = rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, sizeof(Corners), mesh.triangles.size());
  if (corners != nullptr) {
    std::transform(mesh.triangles.begin(), mesh.triangles.end(), static_cast<Corners*>(corners),
                   [&](std::uint32_t index) { return all[index]; });
  }
}

RTCGeometry mesh_geometry(RTCDevice device, MeshScene& mesh) {
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  set_vertices(geometry, mesh);
  set_triangles(geometry, mesh);
  rtcSetGeometryUserData(geometry, &mesh);
  rtcSetGeometryIntersectFilterFunction(geometry, mesh_intersect_filter);
  rtcSetGeometryOccludedFilterFunction(geometry, mesh_occluded_filter);
  return geometry;
}

}  // namespace

struct RayScenes::State {
  RTCDevice device = nullptr;
  std::vector<RTCScene> scenes;
  bool failed = false;
  int exceptions = std::uncaught_exceptions();  // when it was made

  // Reading the error resets it.
  bool good() {
    failed = failed || device == nullptr || rtcGetDeviceError(device) != RTC_ERROR_NONE;
    return !failed;
  }

  // Takes ownership of the geometry.
  RTCScene commit(RTCGeometry geometry, RTCSceneFlags flags) {
    RTCScene scene = rtcNewScene(device);
    scenes.push_back(scene);
    rtcSetSceneFlags(scene, flags);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene, geometry);
    rtcReleaseGeometry(geometry);
    // Not in a separate arena: scenes outlive it, and TBB would never free it.
    TsanHandoff::give();
    rtcCommitScene(scene);
    TsanHandoff::collect();
    return scene;
  }
};

// Eight-wide BVH nodes: up to a quarter faster than the default.
RayScenes::RayScenes() : state_(std::make_unique<State>()) {
  state_->device = rtcNewDevice("frequency_level=simd256");
}

// After a failure, nothing is released: that could wait forever for a task that could not be
// created. Nor because of an exception: it means that memory ran out, and then Embree throws
// another one.
RayScenes::~RayScenes() {
  if (std::uncaught_exceptions() > state_->exceptions || !state_->good()) {
    return;
  }
  for (RTCScene scene : state_->scenes) {
    rtcReleaseScene(scene);
  }
  rtcReleaseDevice(state_->device);
}

std::string embree_version() {
  RTCDevice device = rtcNewDevice(nullptr);
  if (device == nullptr) {
    return {};
  }
  const auto number = rtcGetDeviceProperty(device, RTC_DEVICE_PROPERTY_VERSION);
  rtcReleaseDevice(device);
  return fmt::format("{}.{}.{}", number / 10000, number / 100 % 100, number % 100);
}

bool RayScenes::good() const {
  return state_->good();
}

void RayScenes::add(Group& group) {
  if (state_->good()) {
    group.scene = state_->commit(group_geometry(state_->device, group), RTC_SCENE_FLAG_NONE);
  }
}

// Robust mode: otherwise rays can pass between adjacent triangles.
void RayScenes::add(MeshScene& mesh) {
  if (state_->good()) {
    mesh.scene = state_->commit(mesh_geometry(state_->device, mesh), RTC_SCENE_FLAG_ROBUST);
  }
}

void search_group_scene(Query& q, const Group& group, const Ray& ray) {
  Search search;
  search.query = &q;
  RTCRay start;
  const double t_min = q.mesh_distances ? 0 : q.t_min;
  if (start_in_box(t_min, q.best * q.reach, ray, group.extent, search.level, start)) {
    search_scene(search, static_cast<RTCScene>(group.scene), start);
  }
}

bool mesh_scene_crossed(Query& q, const Object& object, const Ray& ray) {
  const MeshScene& mesh = q.geometry->meshes[object.target];
  Search search;
  search.query = &q;
  search.mesh_object = &object;
  RTCRay start;
  const double end = q.best / q.mesh_scale;
  if (start_in_box(q.t_min / q.mesh_scale, end, ray, mesh.extent, search.level, start)) {
    if (!q.shadow) {
      start.tfar = search.level.beyond(end);
    }
    search_scene(search, static_cast<RTCScene>(mesh.scene), start);
  }
  return search.mesh_crossed;
}

}  // namespace scenefile
