// Traces a wave of rays, in as many lanes as the number type has that is included before
// (base/one_lane.h, wide-inl.h). No include guard: included once for each. The includer defines
// `recording` in the namespace of the lanes: whether waves keep a trail (wave_trail.h).

// clang-format off
#include "scenefile/base/vector-inl.h"
#include "scenefile/geometry/crossings-inl.h"
#include "scenefile/geometry/surface-inl.h"
#include "scenefile/trace/camera-inl.h"
#include "scenefile/trace/footprint-inl.h"
#include "scenefile/trace/lighting-inl.h"
#include "scenefile/trace/optics-inl.h"
#include "scenefile/trace/wave_rays-inl.h"
#include "scenefile/trace/wave_bundle-inl.h"
#include "scenefile/trace/wave_search-inl.h"
#include "scenefile/trace/wave_surface-inl.h"
#include "scenefile/trace/wave_trail-inl.h"
#include "scenefile/trace/wave_light-inl.h"
#include "scenefile/trace/wave_follow-inl.h"
// clang-format on
namespace scenefile::SCENEFILE_LANES {

// Starts the camera rays, like CameraRays::ray().
void start_wave(const WaveScene& scene, const CameraSample* samples, int count,
                WaveMemory& memory) {
  WaveRays& rays = memory.rays[0];
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
  std::fill_n(memory.nodes.data(), count, WaveNode{});
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
      store_steps(no_steps(), rays.origin_steps, at);
      store_steps(camera_steps(scene.camera.frame(), x, y, lens_x, lens_y, load(widths)),
                  rays.direction_steps, at);
    }
    store3(ray.origin, rays.origin, at);
    store3(ray.direction, rays.direction, at);
  }
}

// Separates hits into points to shade and walls to pass through.
void select_points(const WaveScene& scene, const WaveRays& rays, WaveMemory& memory) {
  memory.points.count = 0;
  memory.walls.count = 0;
  for (int i = 0; i < rays.count; ++i) {
    if (memory.hits.t[i] == std::numeric_limits<double>::infinity()) {
      continue;
    }
    const Inside* const inside = rays.inside[i];
    const double part = memory.hits.part[i];
    const bool wall =
        inside != nullptr &&
        (part < 0 ? same_object(*inside->object, memory.hits.others[i])
                  : inside->object->part == &scene.root[static_cast<std::size_t>(part)]);
    WavePoints& list = wall ? memory.walls : memory.points;
    list.ray[list.count++] = static_cast<std::uint32_t>(i);
  }
}

void keep_colors(const WaveRays& rays, WaveMemory& memory) {
  for (int k = 0; k < memory.points.count; ++k) {
    memory.nodes[rays.node[memory.points.ray[k]]].color = get(memory.points.color, k);
  }
}

// Normals mode.
void color_by_normals(WavePoints& points) {
  for (int at = 0; at < points.count; at += lanes) {
    const V3 one{splat(1), splat(1), splat(1)};
    store3(splat(0.5) * (load3(points.normal, at) + one), points.color, at);
  }
}

// Records the surfaces hit by camera rays; materials only if lighting is on.
void record_surfaces(const WaveScene& scene, const WaveRays& rays, const WaveHits& hits,
                     const WavePoints& points, bool lit, const WaveRecord& record) {
  for (int k = 0; k < points.count; ++k) {
    const std::uint32_t r = points.ray[k];
    SurfaceSample& sample = record.samples[rays.node[r]];
    sample.hit = true;
    sample.normal = get(points.normal, k);
    sample.position = get(points.position, k);
    sample.uv = {points.u[k], points.v[k]};
    sample.source = hits.part[r] < 0 ? hits.others[r].source
                                     : scene.root[static_cast<std::size_t>(hits.part[r])].source;
    if (lit) {
      sample.albedo = get(points.diffuse, k);
    }
  }
}

// A number that identifies the surface that ray r hit.
std::uint32_t surface_number(const WaveHits& hits, std::uint32_t r) {
  if (hits.part[r] >= 0) {
    return static_cast<std::uint32_t>(hits.part[r]) * 16 + static_cast<std::uint32_t>(hits.face[r]);
  }
  const Hit& hit = hits.others[r];
  const glm::dvec3& place = hit.object_from_world.offset;
  std::uint32_t number = extended_signature(hit.source, static_cast<std::uint32_t>(hit.face));
  number = extended_signature(number, hit.shape == Shape::mesh ? hit.triangle : 0);
  for (const double x : {place.x, place.y, place.z}) {
    const auto bits = std::bit_cast<std::uint64_t>(x);
    number = extended_signature(number, static_cast<std::uint32_t>(bits ^ (bits >> 32)));
  }
  return number;
}

// Textures that are not filtered over footprints differ in each sample.
bool unfiltered(const WaveMaterial& material) {
  return material.bump != nullptr || material.texture != nullptr;
}

void add_signatures(const WaveRays& rays, const WavePoints& points, WaveMemory& memory) {
  for (int k = 0; k < points.count; ++k) {
    const std::uint32_t r = points.ray[k];
    std::uint32_t& signature = memory.nodes[rays.node[r]].signature;
    signature = extended_signature(signature, surface_number(memory.hits, r));
    signature = extended_signature(signature, points.lit[k]);
    if (unfiltered(*points.material[k])) {
      signature = extended_signature(signature, rays.key[r].pattern);
    }
  }
}

// Traces one generation of rays: their colors, and the rays that follow.
void trace_generation(const WaveScene& scene, const WaveRays& rays, WaveRays& next,
                      WaveMemory& memory, RayCounts& counts, const WaveRecord* record) {
  const Mode mode = scene.tracer.options.mode;
  const bool only_surfaces = record != nullptr && record->only_surfaces;
  const bool lit = mode != Mode::normals && !only_surfaces;
  next.count = 0;
  find_hits(scene, rays, memory.hits);
  select_points(scene, rays, memory);
  memory.points.with_uv = recording || record != nullptr;
  find_surfaces(scene, rays, memory.hits, lit, memory.points);
  if constexpr (recording) {
    record_met(scene, rays, memory.hits, lit, memory.points, *memory.trail);
  }
  std::fill_n(memory.points.lit, memory.points.count, 0u);
  if (record != nullptr) {
    record_surfaces(scene, rays, memory.hits, memory.points, lit, *record);
  }
  if (only_surfaces) {
    return;
  }
  if (lit) {
    find_lights(scene, rays, memory, counts, record);
    if constexpr (recording) {
      record_local(rays, memory.points, *memory.trail);
    }
  } else {
    color_by_normals(memory.points);
  }
  keep_colors(rays, memory);
  if (!scene.course) {
    add_signatures(rays, memory.points, memory);
  }
  if (mode == Mode::ray) {
    follow_points(scene, memory, rays, next, memory.points, false, counts);
    memory.walls.with_uv = recording;
    find_surfaces(scene, rays, memory.hits, false, memory.walls);
    if constexpr (recording) {
      if (scene.fresnel) {
        record_inner_walls(scene, rays, memory, *memory.trail);
      }
    }
    pass_walls(scene, memory, rays, next, counts);
  }
}

// Counts the rays that each sample caused.
inline void count_rays(const WaveMemory& memory, SurfaceSample* samples) {
  std::uint32_t sample[wave_nodes];
  for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(memory.node_count); ++i) {
    const std::uint32_t parent = memory.nodes[i].parent;
    sample[i] = parent == no_index ? i : sample[parent];
    ++samples[sample[i]].rays;
  }
}

bool trace(const WaveScene& scene, const CameraSample* samples, int count, WaveMemory& memory,
           WaveSight* sights, RayCounts& counts, const WaveRecord* record) {
  start_wave(scene, samples, count, memory);
  if constexpr (recording) {
    record_camera_rays(memory.rays[0], *memory.trail);
  }
  counts.primary += static_cast<std::uint64_t>(count);
  const WaveRecord* of_camera_rays = record;
  for (int now = 0; memory.rays[now].count > 0; now = 1 - now) {
    trace_generation(scene, memory.rays[now], memory.rays[1 - now], memory, counts, of_camera_rays);
    of_camera_rays = nullptr;
    if (memory.full) {
      return false;
    }
  }
  sum_up(scene, memory);
  if (record != nullptr) {
    count_rays(memory, record->samples);
  }
  for (int i = 0; i < count; ++i) {
    sights[i].color = memory.nodes[i].color;
    sights[i].penumbra = memory.nodes[i].penumbra;
    sights[i].signature = memory.nodes[i].signature;
    if (record != nullptr) {
      record->samples[i].bounces = memory.nodes[i].bounces;
    }
  }
  return true;
}

}  // namespace scenefile::SCENEFILE_LANES
