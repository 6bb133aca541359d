// Traces a wavefront of rays, in as many lanes as the number type has that is included before
// (base/one_lane.h, wide-inl.h). No include guard: included once for each. The includer defines
// `recording` in the namespace of the lanes: whether wavefronts have a recorder
// (ray_tree_recorder.h).

// clang-format off
#include "scenefile/base/vector-inl.h"
#include "scenefile/geometry/crossings-inl.h"
#include "scenefile/geometry/surface-inl.h"
#include "scenefile/trace/camera-inl.h"
#include "scenefile/trace/footprint-inl.h"
#include "scenefile/trace/lighting-inl.h"
#include "scenefile/trace/optics-inl.h"
#include "scenefile/trace/ray_lanes-inl.h"
#include "scenefile/trace/packet_frustum-inl.h"
#include "scenefile/trace/intersect-inl.h"
#include "scenefile/trace/shading_points-inl.h"
#include "scenefile/trace/ray_tree_recorder-inl.h"
#include "scenefile/trace/direct_light-inl.h"
#include "scenefile/trace/scatter-inl.h"
// clang-format on
namespace scenefile::SCENEFILE_LANES {

// Starts the camera rays, like CameraRays::ray().
void start_camera_rays(const WavefrontScene& scene, const CameraSample* samples, int count,
                       WavefrontMemory& memory) {
  RayQueue& rays = memory.rays[0];
  for (int i = 0; i < count; ++i) {
    const CameraSample& sample = samples[i];
    rays.origin.x[i] = sample.point.x;
    rays.origin.y[i] = sample.point.y;
    rays.direction.x[i] = sample.lens.x;
    rays.direction.y[i] = sample.lens.y;
    rays.key[i] = sample.key;
  }
  std::iota(rays.node, rays.node + count, 0u);
  std::fill_n(rays.start, count, 0.0);
  std::fill_n(rays.depth, count, 0);
  std::fill_n(rays.weight, count, 1.0);
  std::fill_n(rays.budget, count, rays_of_a_sample);
  std::fill_n(rays.inside, count, nullptr);
  std::fill_n(memory.nodes.data(), count, RayNode{});
  rays.count = count;
  memory.node_count = count;
  memory.inside_count = 0;
  memory.full = false;
  memory.hits.incoherent = false;
  for (int at = 0; at < count; at += lanes) {
    const F x = load(rays.origin.x + at);
    const F y = load(rays.origin.y + at);
    const F lens_x = load(rays.direction.x + at);
    const F lens_y = load(rays.direction.y + at);
    const CameraRay ray = camera_ray(scene.camera.frame(), x, y, lens_x, lens_y);
    if (scene.by_footprint) {
      alignas(64) double widths[lanes];
      for (int i = 0; i < lanes; ++i) {
        widths[i] = samples[std::min(at + i, count - 1)].width;
      }
      store_derivatives(no_derivatives(), rays.d_origin, at);
      store_derivatives(
          camera_derivatives(scene.camera.frame(), x, y, lens_x, lens_y, load(widths)),
          rays.d_direction, at);
    }
    store3(ray.origin, rays.origin, at);
    store3(ray.direction, rays.direction, at);
  }
}

// Separates hits into points to shade and walls to pass through.
void select_points(const WavefrontScene& scene, const RayQueue& rays, WavefrontMemory& memory) {
  memory.points.count = 0;
  memory.walls.count = 0;
  for (int i = 0; i < rays.count; ++i) {
    if (memory.hits.t[i] == std::numeric_limits<double>::infinity()) {
      continue;
    }
    const Inside* const inside = rays.inside[i];
    const double object = memory.hits.object[i];
    const bool wall =
        inside != nullptr &&
        (object < 0 ? same_object(*inside->hit, memory.hits.others[i])
                    : inside->hit->object == &scene.root[static_cast<std::size_t>(object)]);
    ShadingPoints& list = wall ? memory.walls : memory.points;
    list.ray[list.count++] = static_cast<std::uint32_t>(i);
  }
}

void keep_colors(const RayQueue& rays, WavefrontMemory& memory) {
  for (int k = 0; k < memory.points.count; ++k) {
    memory.nodes[rays.node[memory.points.ray[k]]].color = get(memory.points.color, k);
  }
}

// Normals mode.
void color_by_normals(ShadingPoints& points) {
  for (int at = 0; at < points.count; at += lanes) {
    const V3 one{splat(1), splat(1), splat(1)};
    store3(splat(0.5) * (load3(points.normal, at) + one), points.color, at);
  }
}

// Stores the surfaces hit by camera rays; materials only if lighting is on.
void store_aovs(const WavefrontScene& scene, const RayQueue& rays, const HitQueue& hits,
                const ShadingPoints& points, bool lit, const AovOutput& aovs) {
  for (int k = 0; k < points.count; ++k) {
    const std::uint32_t r = points.ray[k];
    AovSample& sample = aovs.samples[rays.node[r]];
    sample.hit = true;
    sample.normal = get(points.normal, k);
    sample.position = get(points.position, k);
    sample.uv = {points.u[k], points.v[k]};
    sample.source = hits.object[r] < 0
                        ? hits.others[r].source
                        : scene.root[static_cast<std::size_t>(hits.object[r])].source;
    if (lit) {
      sample.albedo = get(points.diffuse, k);
    }
  }
}

// A number that identifies the surface that ray r hit.
std::uint32_t surface_number(const HitQueue& hits, std::uint32_t r) {
  if (hits.object[r] >= 0) {
    return static_cast<std::uint32_t>(hits.object[r]) * 16 +
           static_cast<std::uint32_t>(hits.face[r]);
  }
  const Hit& hit = hits.others[r];
  const glm::dvec3& place = hit.object_from_world.offset;
  std::uint32_t number = extended_hash(hit.source, static_cast<std::uint32_t>(hit.face));
  number = extended_hash(number, hit.shape == Shape::mesh ? hit.triangle : 0);
  for (const double x : {place.x, place.y, place.z}) {
    const auto bits = std::bit_cast<std::uint64_t>(x);
    number = extended_hash(number, static_cast<std::uint32_t>(bits ^ (bits >> 32)));
  }
  return number;
}

// Textures that are not filtered over footprints differ in each sample.
bool unfiltered(const ShadingMaterial& material) {
  return material.bump != nullptr || material.texture != nullptr;
}

void add_surface_hashes(const RayQueue& rays, const ShadingPoints& points,
                        WavefrontMemory& memory) {
  for (int k = 0; k < points.count; ++k) {
    const std::uint32_t r = points.ray[k];
    std::uint32_t& surface_hash = memory.nodes[rays.node[r]].surface_hash;
    surface_hash = extended_hash(surface_hash, surface_number(memory.hits, r));
    surface_hash = extended_hash(surface_hash, points.visible_lights[k]);
    if (unfiltered(*points.material[k])) {
      surface_hash = extended_hash(surface_hash, rays.key[r].pattern);
    }
  }
}

// Traces one generation of rays: their colors, and the rays that follow.
void trace_generation(const WavefrontScene& scene, const RayQueue& rays, RayQueue& next,
                      WavefrontMemory& memory, RayCounts& counts, const AovOutput* aovs) {
  const Mode mode = scene.tracer.options.mode;
  const bool only_surfaces = aovs != nullptr && aovs->only_surfaces;
  const bool lit = mode != Mode::normals && !only_surfaces;
  next.count = 0;
  find_hits(scene, rays, memory.hits);
  select_points(scene, rays, memory);
  memory.points.with_uv = recording || aovs != nullptr;
  find_surfaces(scene, rays, memory.hits, lit, memory.points);
  if constexpr (recording) {
    record_met(scene, rays, memory.hits, lit, memory.points, *memory.recorder);
  }
  std::fill_n(memory.points.visible_lights, memory.points.count, 0u);
  if (aovs != nullptr) {
    store_aovs(scene, rays, memory.hits, memory.points, lit, *aovs);
  }
  if (only_surfaces) {
    return;
  }
  if (lit) {
    find_lights(scene, rays, memory, counts, aovs);
    if constexpr (recording) {
      record_local(rays, memory.points, *memory.recorder);
    }
  } else {
    color_by_normals(memory.points);
  }
  keep_colors(rays, memory);
  if (!scene.course) {
    add_surface_hashes(rays, memory.points, memory);
  }
  if (mode == Mode::ray) {
    scatter_points(scene, memory, rays, next, memory.points, false, counts);
    memory.walls.with_uv = recording;
    find_surfaces(scene, rays, memory.hits, false, memory.walls);
    if constexpr (recording) {
      if (scene.fresnel) {
        record_inner_walls(scene, rays, memory, *memory.recorder);
      }
    }
    pass_walls(scene, memory, rays, next, counts);
  }
}

// Counts the rays that each sample caused.
inline void count_rays(const WavefrontMemory& memory, AovSample* samples) {
  std::uint32_t sample[wavefront_nodes];
  for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(memory.node_count); ++i) {
    const std::uint32_t parent = memory.nodes[i].parent;
    sample[i] = parent == no_index ? i : sample[parent];
    ++samples[sample[i]].rays;
  }
}

bool trace(const WavefrontScene& scene, const CameraSample* samples, int count,
           WavefrontMemory& memory, SampleResult* results, RayCounts& counts,
           const AovOutput* aovs) {
  start_camera_rays(scene, samples, count, memory);
  if constexpr (recording) {
    record_camera_rays(memory.rays[0], *memory.recorder);
  }
  counts.primary += static_cast<std::uint64_t>(count);
  const AovOutput* of_camera_rays = aovs;
  for (int now = 0; memory.rays[now].count > 0; now = 1 - now) {
    trace_generation(scene, memory.rays[now], memory.rays[1 - now], memory, counts, of_camera_rays);
    of_camera_rays = nullptr;
    if (memory.full) {
      return false;
    }
  }
  sum_up(scene, memory);
  if (aovs != nullptr) {
    count_rays(memory, aovs->samples);
  }
  for (int i = 0; i < count; ++i) {
    results[i].color = memory.nodes[i].color;
    results[i].penumbra = memory.nodes[i].penumbra;
    results[i].surface_hash = memory.nodes[i].surface_hash;
    if (aovs != nullptr) {
      aovs->samples[i].bounces = memory.nodes[i].bounces;
    }
  }
  return true;
}

}  // namespace scenefile::SCENEFILE_LANES
