// The only file that knows Highway. It includes itself once for each instruction set that the
// compiler can write; the best that the machine has is chosen when the program runs.

#include "scenefile/trace/wave.h"

#include "scenefile/trace/integrator.h"
#include "scenefile/trace/texture_lookup.h"
#include "scenefile/trace/wave_memory.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <new>

// What is left out is older than any machine with 64 bits that still runs, or nothing new to this
// code.
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_AVX3_DL)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "scenefile/trace/wave.cpp"
// clang-format off
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
// clang-format on

#undef SCENEFILE_LANES
#define SCENEFILE_LANES HWY_NAMESPACE

HWY_BEFORE_NAMESPACE();
// clang-format off
#include "scenefile/trace/wide-inl.h"
#include "scenefile/base/vector-inl.h"
#include "scenefile/geometry/crossings-inl.h"
#include "scenefile/geometry/normals-inl.h"
#include "scenefile/trace/camera-inl.h"
#include "scenefile/trace/lighting-inl.h"
#include "scenefile/trace/optics-inl.h"
#include "scenefile/trace/wave_rays-inl.h"
#include "scenefile/trace/wave_bundle-inl.h"
#include "scenefile/trace/wave_search-inl.h"
#include "scenefile/trace/wave_shade-inl.h"
#include "scenefile/trace/wave_follow-inl.h"
// clang-format on
namespace scenefile::HWY_NAMESPACE {

// The rays of the camera, as CameraRays::ray() has them.
void start_wave(const WaveScene& scene, const glm::dvec2* samples, int count, WaveMemory& memory) {
  WaveRays& rays = memory.rays[0];
  for (int i = 0; i < count; ++i) {
    rays.origin.x[i] = samples[i].x;
    rays.origin.y[i] = samples[i].y;
    rays.start[i] = 0;
    rays.node[i] = static_cast<std::uint32_t>(i);
    rays.depth[i] = 0;
    rays.budget[i] = rays_of_a_sample;
    rays.inside[i] = nullptr;
    memory.nodes[i] = {};
  }
  rays.count = count;
  memory.node_count = count;
  memory.inside_count = 0;
  for (int at = 0; at < count; at += lanes) {
    const F x = load(rays.origin.x + at);
    const F y = load(rays.origin.y + at);
    store3(pinhole_direction(scene.camera.pinhole(), x, y), rays.direction, at);
    store3(splat3(scene.camera.pinhole().position), rays.origin, at);
  }
}

// Parts hits into those to be lit and walls to be passed.
void select_points(const WaveRays& rays, const Parts& parts, WaveMemory& memory) {
  memory.points.count = 0;
  memory.walls.count = 0;
  const std::vector<Part>& group = parts.groups[parts.root].parts;
  for (int i = 0; i < rays.count; ++i) {
    if (memory.hits.t[i] == std::numeric_limits<double>::infinity()) {
      continue;
    }
    const Inside* const inside = rays.inside[i];
    const double part = memory.hits.part[i];
    const bool wall = inside != nullptr &&
                      (part < 0 ? same_object(*inside->object, memory.hits.others[i])
                                : inside->object->part == &group[static_cast<std::size_t>(part)]);
    WavePoints& list = wall ? memory.walls : memory.points;
    list.ray[list.count++] = static_cast<std::uint32_t>(i);
  }
}

void keep_colors(const WaveRays& rays, WaveMemory& memory) {
  for (int k = 0; k < memory.points.count; ++k) {
    memory.nodes[rays.node[memory.points.ray[k]]].color = get(memory.points.color, k);
  }
}

void trace(const WaveScene& scene, const glm::dvec2* samples, int count, WaveMemory& memory,
           Color* colors, RayCounts& counts) {
  start_wave(scene, samples, count, memory);
  counts.primary += static_cast<std::uint64_t>(count);
  const bool follows = scene.tracer.options.mode == Mode::ray;
  for (int now = 0; memory.rays[now].count > 0; now = 1 - now) {
    const WaveRays& rays = memory.rays[now];
    WaveRays& next = memory.rays[1 - now];
    next.count = 0;
    find_hits(scene, rays, memory.hits);
    select_points(rays, scene.tracer.accelerator.parts(), memory);
    find_surfaces(scene, rays, memory.hits, memory.points);
    find_lights(scene, memory.hits.apart, memory.points, memory.light, counts);
    keep_colors(rays, memory);
    if (follows) {
      follow_points(scene, memory, rays, next, counts);
      find_surfaces(scene, rays, memory.hits, memory.walls);
      pass_walls(scene, memory, rays, next, counts);
    }
  }
  sum_up(memory);
  for (int i = 0; i < count; ++i) {
    colors[i] = memory.nodes[i].color;
  }
}

}  // namespace scenefile::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace scenefile {

namespace {

// The widest first. Highway's own choice is in a library that measures the clock when it is loaded,
// for two milliseconds of each run of the program.
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
    {"what every such processor has", [] { return true; }, HWY_STATIC_DISPATCH(trace)}};

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
  if (textured) {
    out.texture = &tracer.assets.textures[m.texture.file];
    out.blend = m.blend;
  }
  return out;
}

bool all_shapes(const std::vector<Part>& parts) {
  return std::all_of(parts.begin(), parts.end(),
                     [](const Part& part) { return part.kind == PartKind::shape; });
}

}  // namespace

WaveScene::WaveScene(const Tracer& t, const CameraRays& c)
    : tracer(t), camera(c), kernel(wave_kernels().front()) {
  for (const RenderMaterial& material : tracer.scene.materials) {
    materials.push_back(wave_material(tracer, material));
  }
  constexpr std::size_t few = 8;
  const Parts& parts = tracer.accelerator.parts();
  const Group& root = parts.groups[parts.root];
  if (!all_shapes(root.parts)) {
    return;
  }
  few_parts = root.parts.size() <= few;
  if (!few_parts && root.boxes.size() == root.parts.size() && root.extent.scale == 1) {
    tree = PartTree(root.boxes);
  }
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

bool takes_waves(const Tracer& tracer, const CameraRays& camera) {
  const RenderOptions& options = tracer.options;
  return tracer.course() && options.mode != Mode::normals && !camera.has_lens() &&
         options.mistakes == Mistakes{} && !tracer.accelerator.parts().groups.empty();
}

void WaveDeleter::operator()(WaveMemory* memory) const {
  delete memory;
}

WavePointer make_wave() {
  return WavePointer(new WaveMemory);
}

void trace_wave(const WaveScene& scene, const glm::dvec2* points, int count, WaveMemory& memory,
                Color* colors, RayCounts& counts) {
  scene.kernel->trace(scene, points, count, memory, colors, counts);
}

}  // namespace scenefile
#endif
