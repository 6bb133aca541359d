// The only file that includes Highway. It includes itself once for each instruction set that the
// compiler supports; the best one of the machine is chosen at run time.

#include "scenefile/trace/wavefront.h"

#include "scenefile/base/components.h"
#include "scenefile/trace/next_up.h"
#include "scenefile/trace/optics.h"
#include "scenefile/trace/ray_tree_recorder.h"
#include "scenefile/trace/sequence.h"

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
#define HWY_TARGET_INCLUDE "scenefile/trace/wavefront.cpp"
// clang-format off
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
// clang-format on
#endif

#undef SCENEFILE_LANES
#define SCENEFILE_LANES HWY_NAMESPACE

HWY_BEFORE_NAMESPACE();
#if defined(__wasm_simd128__)
#include "scenefile/trace/simd128-inl.h"
#else
#include "scenefile/trace/wide-inl.h"
#endif
namespace scenefile::HWY_NAMESPACE {
inline constexpr bool recording = false;
}
#include "scenefile/trace/wavefront_kernel-inl.h"
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
constexpr WavefrontKernel kernels[] = {
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

ShadingMaterial shading_material(const Tracer& tracer, const RenderMaterial& m) {
  const RenderGlobal& global = tracer.scene.global;
  const Features& features = tracer.options.features;
  ShadingMaterial out{};
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
  if (!tracer.mip_maps.empty() && m.bump_map.used()) {
    out.bump = &tracer.mip_maps[m.bump_map.file];
  }
  if (textured) {
    const bool filtered = features.texture_filter && !tracer.course();
    out.texture = filtered ? nullptr : &tracer.assets.textures[m.texture.file];
    out.mip_map = filtered ? &tracer.mip_maps[m.texture.file] : nullptr;
    out.blend = m.blend;
  }
  return out;
}

// As in Transmission; doubles represent sums of this few numbers exactly.
void put_density(const Tracer& tracer, std::size_t index, ShadingMaterial& material) {
  put(Color(tracer.transmission.density(static_cast<std::uint32_t>(index))), material.density);
}

const std::vector<Object>& root_objects(const SceneGeometry& geometry) {
  static const std::vector<Object> none;
  return geometry.groups.empty() ? none : geometry.groups[geometry.root].objects;
}

// The AOVs of the samples from `first` on.
AovOutput from(const AovOutput& aovs, int first) {
  AovOutput rest = aovs;
  rest.samples += first;
  rest.light_colors += first * aovs.lights.size();
  return rest;
}

void add(const RayCounts& more, RayCounts& counts) {
  counts.primary += more.primary;
  counts.shadow += more.shadow;
  counts.secondary += more.secondary;
}

}  // namespace

WavefrontScene::WavefrontScene(const Tracer& t, const CameraRays& c)
    : tracer(t),
      camera(c),
      kernel(wavefront_kernels().front()),
      root(root_objects(t.accelerator.geometry())),
      course(t.course()),
      transmissive_shadows(!t.transmission.all_opaque()),
      fresnel(t.options.fresnel && t.options.features.refract),
      packet_bvh(t.accelerator.packet_bvh()),
      mesh_reach(t.accelerator.mesh_reach()) {
  for (const RenderMaterial& material : tracer.scene.materials) {
    materials.push_back(shading_material(tracer, material));
    put_density(tracer, materials.size() - 1, materials.back());
    by_footprint =
        by_footprint || materials.back().mip_map != nullptr || materials.back().bump != nullptr;
  }
  tests_all_objects = root.size() <= PacketBvh::max_linear_objects &&
                      std::all_of(root.begin(), root.end(), [](const Object& object) {
                        return object.kind == ObjectKind::shape;
                      });
}

std::vector<const WavefrontKernel*> wavefront_kernels() {
  std::vector<const WavefrontKernel*> result;
  for (const WavefrontKernel& kernel : kernels) {
    if (kernel.runs_here()) {
      result.push_back(&kernel);
    }
  }
  return result;
}

void WavefrontDeleter::operator()(WavefrontMemory* memory) const {
  delete memory;
}

WavefrontPointer make_wavefront() {
  return WavefrontPointer(new WavefrontMemory);
}

// If the samples cause too many rays, traces half as many samples at once, until they fit again
// several times in a row.
void trace_wavefront(const WavefrontScene& scene, const CameraSample* samples, int count,
                     WavefrontMemory& memory, SampleResult* results, RayCounts& counts,
                     const AovOutput* aovs) {
  constexpr int often = 16;
  for (int done = 0; done < count;) {
    const int now = std::min(count - done, memory.fits);
    RayCounts rays;
    AovOutput rest;
    if (aovs != nullptr) {
      rest = from(*aovs, done);
      std::fill_n(rest.samples, now, AovSample{});
      std::fill_n(rest.light_colors, now * rest.lights.size(), Color(0));
    }
    if (!scene.kernel->trace(scene, samples + done, now, memory, results + done, rays,
                             aovs != nullptr ? &rest : nullptr)) {
      memory.fits = std::max(1, now / 2);
      memory.fitted = 0;
      continue;
    }
    add(rays, counts);
    done += now;
    if (memory.fits < wavefront_samples && ++memory.fitted % often == 0) {
      memory.fits *= 2;
    }
  }
}

}  // namespace scenefile
#endif
