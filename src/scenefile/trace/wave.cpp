// The only file that includes Highway. It includes itself once for each instruction set that the
// compiler supports; the best one of the machine is chosen at run time.

#include "scenefile/trace/wave.h"

#include "scenefile/base/components.h"
#include "scenefile/trace/optics.h"
#include "scenefile/trace/sequence.h"
#include "scenefile/trace/wave_memory.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <new>
#include <numeric>
#include <utility>

#if defined(__wasm_simd128__)
#include <wasm_simd128.h>
// The parts of Highway's interface that are used, for the one instruction set of simd128-inl.h.
#define HWY_NAMESPACE N_SIMD128
#define HWY_BEFORE_NAMESPACE() static_assert(true)
#define HWY_AFTER_NAMESPACE() static_assert(true)
#define HWY_STATIC_DISPATCH(function) HWY_NAMESPACE::function
#define HWY_TARGETS 0
#define HWY_ONCE 1
#else
// These are older than any 64-bit machine still in use, or have no advantage for this code.
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_AVX3_DL)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "scenefile/trace/wave.cpp"
// clang-format off
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
// clang-format on
#endif

#undef SCENEFILE_LANES
#define SCENEFILE_LANES HWY_NAMESPACE

HWY_BEFORE_NAMESPACE();
// clang-format off
#if defined(__wasm_simd128__)
#include "scenefile/trace/simd128-inl.h"
#else
#include "scenefile/trace/wide-inl.h"
#endif
#include "scenefile/base/vector-inl.h"
#include "scenefile/geometry/crossings-inl.h"
#include "scenefile/geometry/normals-inl.h"
#include "scenefile/trace/camera-inl.h"
#include "scenefile/trace/footprint-inl.h"
#include "scenefile/trace/lighting-inl.h"
#include "scenefile/trace/optics-inl.h"
#include "scenefile/trace/wave_rays-inl.h"
#include "scenefile/trace/wave_bundle-inl.h"
#include "scenefile/trace/wave_search-inl.h"
#include "scenefile/trace/wave_surface-inl.h"
#include "scenefile/trace/wave_light-inl.h"
#include "scenefile/trace/wave_follow-inl.h"
// clang-format on
namespace scenefile::HWY_NAMESPACE {

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
void record_surfaces(const WaveRays& rays, const WavePoints& points, bool lit,
                     const WaveRecord& record) {
  for (int k = 0; k < points.count; ++k) {
    SurfaceSample& sample = record.samples[rays.node[points.ray[k]]];
    sample.hit = true;
    sample.normal = get(points.normal, k);
    sample.position = get(points.position, k);
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
  return material.bumped || material.texture != nullptr;
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
  const bool lit = mode != Mode::normals;
  next.count = 0;
  find_hits(scene, rays, memory.hits);
  select_points(scene, rays, memory);
  find_surfaces(scene, rays, memory.hits, lit, memory.points);
  std::fill_n(memory.points.lit, memory.points.count, 0u);
  if (record != nullptr) {
    record_surfaces(rays, memory.points, lit, *record);
  }
  if (lit) {
    find_lights(scene, rays, memory, counts, record);
  } else {
    color_by_normals(memory.points);
  }
  keep_colors(rays, memory);
  if (!scene.course) {
    add_signatures(rays, memory.points, memory);
  }
  if (mode == Mode::ray) {
    follow_points(scene, memory, rays, next, memory.points, false, counts);
    find_surfaces(scene, rays, memory.hits, false, memory.walls);
    pass_walls(scene, memory, rays, next, counts);
  }
}

bool trace(const WaveScene& scene, const CameraSample* samples, int count, WaveMemory& memory,
           WaveSight* sights, RayCounts& counts, const WaveRecord* record) {
  start_wave(scene, samples, count, memory);
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

}  // namespace scenefile::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace scenefile {

namespace {

#if defined(__wasm_simd128__)
constexpr const char* baseline = "SIMD128";
#else
constexpr const char* baseline = "baseline";
#endif

// The widest first. Highway's own selection is in a library that measures the clock when it is
// loaded, which takes two milliseconds in each run of the program.
constexpr WaveKernel kernels[] = {
#if (HWY_TARGETS & HWY_AVX3) != 0
    {"AVX-512",
     [] {
       return __builtin_cpu_supports("avx512f") != 0 && __builtin_cpu_supports("avx512vl") != 0 &&
              __builtin_cpu_supports("avx512dq") != 0 && __builtin_cpu_supports("avx512bw") != 0 &&
              __builtin_cpu_supports("avx512cd") != 0 && __builtin_cpu_supports("bmi2") != 0;
     },
     N_AVX3::trace},
#endif
#if (HWY_TARGETS & HWY_AVX2) != 0
    {"AVX2",
     [] {
       return __builtin_cpu_supports("avx2") != 0 && __builtin_cpu_supports("fma") != 0 &&
              __builtin_cpu_supports("bmi2") != 0;
     },
     N_AVX2::trace},
#endif
#if (HWY_TARGETS & HWY_SSE4) != 0
    {"SSE4",
     [] { return __builtin_cpu_supports("sse4.2") != 0 && __builtin_cpu_supports("pclmul") != 0; },
     N_SSE4::trace},
#endif
    {baseline, [] { return true; }, HWY_STATIC_DISPATCH(trace)}};

void put(const Color& color, double (&to)[3]) {
  std::copy_n(&color.x, 3, to);
}

WaveMaterial wave_material(const Tracer& tracer, const RenderMaterial& m) {
  const RenderGlobal& global = tracer.scene.global;
  const Features& features = tracer.options.features;
  WaveMaterial out{};
  put(double(global.ambient) * Color(m.ambient), out.ambient);
  put(double(global.diffuse) * Color(m.diffuse), out.diffuse);
  const Color specular = double(global.specular) * Color(m.specular);
  const Color mirror = double(global.specular) * Color(m.reflective);
  const Color glass = tracer.transparency(m);
  put(specular, out.specular);
  put(mirror, out.mirror);
  put(glass, out.glass);
  out.shininess = specular == Color(0) ? 0 : double(m.shininess);
  out.ior = m.ior;
  out.material = &m;
  out.mirrors = features.reflect && mirror != Color(0);
  out.refracts = features.refract && glass != Color(0);
  const bool textured = tracer.options.mode == Mode::ray && features.texture && m.texture.used() &&
                        m.blend != 0 && !tracer.assets.textures[m.texture.file].empty();
  out.bumped = !tracer.pyramids.empty() && m.bump_map.used();
  if (textured) {
    const bool filtered = features.texture_filter && !tracer.course();
    out.texture = filtered ? nullptr : &tracer.assets.textures[m.texture.file];
    out.pyramid = filtered ? &tracer.pyramids[m.texture.file] : nullptr;
    out.blend = m.blend;
  }
  return out;
}

// As in Transmission; doubles represent sums of this few parts exactly.
void put_density(const Tracer& tracer, std::size_t index, WaveMaterial& material) {
  put(Color(tracer.transmission.density(static_cast<std::uint32_t>(index))), material.density);
}

const std::vector<Part>& root_parts(const Parts& parts) {
  static const std::vector<Part> none;
  return parts.groups.empty() ? none : parts.groups[parts.root].parts;
}

// The record for the samples from `first` on.
WaveRecord from(const WaveRecord& record, int first) {
  return {record.samples + first, record.light_colors + first * record.lights.size(),
          record.lights};
}

void add(const RayCounts& more, RayCounts& counts) {
  counts.primary += more.primary;
  counts.shadow += more.shadow;
  counts.secondary += more.secondary;
}

}  // namespace

WaveScene::WaveScene(const Tracer& t, const CameraRays& c)
    : tracer(t),
      camera(c),
      kernel(wave_kernels().front()),
      root(root_parts(t.accelerator.parts())),
      course(t.course()),
      clear_shadows(!t.transmission.all_opaque()),
      fresnel(t.options.fresnel && t.options.features.refract),
      tree(t.accelerator.part_tree()) {
  for (const RenderMaterial& material : tracer.scene.materials) {
    materials.push_back(wave_material(tracer, material));
    put_density(tracer, materials.size() - 1, materials.back());
    by_footprint = by_footprint || materials.back().pyramid != nullptr || materials.back().bumped;
  }
  tests_all_parts = root.size() <= PartTree::fewest_parts &&
                    std::all_of(root.begin(), root.end(),
                                [](const Part& part) { return part.kind == PartKind::shape; });
}

std::vector<const WaveKernel*> wave_kernels() {
  std::vector<const WaveKernel*> result;
  for (const WaveKernel& kernel : kernels) {
    if (kernel.runs_here()) {
      result.push_back(&kernel);
    }
  }
  return result;
}

void WaveDeleter::operator()(WaveMemory* memory) const {
  delete memory;
}

WavePointer make_wave() {
  return WavePointer(new WaveMemory);
}

// If the samples cause too many rays, traces half as many samples at once, until they fit again
// several times in a row.
void trace_wave(const WaveScene& scene, const CameraSample* samples, int count, WaveMemory& memory,
                WaveSight* sights, RayCounts& counts, const WaveRecord* record) {
  constexpr int often = 16;
  for (int done = 0; done < count;) {
    const int now = std::min(count - done, memory.fits);
    RayCounts rays;
    WaveRecord part;
    if (record != nullptr) {
      part = from(*record, done);
      std::fill_n(part.samples, now, SurfaceSample{});
      std::fill_n(part.light_colors, now * part.lights.size(), Color(0));
    }
    if (!scene.kernel->trace(scene, samples + done, now, memory, sights + done, rays,
                             record != nullptr ? &part : nullptr)) {
      memory.fits = std::max(1, now / 2);
      memory.fitted = 0;
      continue;
    }
    add(rays, counts);
    done += now;
    if (memory.fits < wave_samples && ++memory.fitted % often == 0) {
      memory.fits *= 2;
    }
  }
}

}  // namespace scenefile
#endif
