#pragma once
// Traces many rays at once: the camera rays of a tile with their reflections and refractions, in
// the machine's SIMD lanes. The results do not depend on the number of lanes, nor on which rays are
// traced together.

#include "scenefile/trace/aov_sample.h"
#include "scenefile/trace/camera_rays.h"
#include "scenefile/trace/packet_bvh.h"
#include "scenefile/trace/path.h"
#include "scenefile/trace/tracer.h"

#include <memory>
#include <span>
#include <string_view>
#include <vector>

namespace scenefile {

/// The maximum number of camera rays in a wavefront.
inline constexpr int wavefront_samples = 256;

/// The course profile samples the centers of a grid with this many cells along each side of an area
/// light.
inline constexpr std::uint32_t course_light_side = 4;

/// A material for shading, multiplied by the scene's coefficients.
struct ShadingMaterial {
  double ambient[3];
  double diffuse[3];
  double specular[3];
  double mirror[3];
  double glass[3];
  double shininess;
  double ior;
  double blend;       ///< of the texture, 0 without one
  double density[3];  ///< for shadow rays, as in Transmission
  const RenderMaterial* material;
  const Texture* texture;  ///< if it is not filtered over footprints
  const MipMap* mip_map;   ///< if it is
  const MipMap* bump;      ///< the bump map, if it has one; empty if the file cannot be used
  bool mirrors;            ///< reflects or transmits rays
  bool refracts;
};

/// The result of a sample.
struct SampleResult {
  Color color{0};
  bool penumbra = false;  ///< saw an area light partially
  /// Fine profile: equal for samples that saw the same objects and faces in the same light, through
  /// the same mirrors and glass. Such samples only differ by smooth shading and by textures, which
  /// are filtered.
  std::uint32_t surface_hash = 0;
};

/// Where to store what the camera rays hit; arrays by sample.
struct AovOutput {
  AovSample* samples = nullptr;           ///< except `camera` and `color`
  Color* light_colors = nullptr;          ///< by sample and separately recorded light
  std::span<const std::uint32_t> lights;  ///< recorded separately; into RenderScene::lights
  bool only_surfaces = false;             ///< without light, textures and secondary rays
};

struct WavefrontScene;
struct WavefrontMemory;

/// The wavefront tracer for one instruction set.
struct WavefrontKernel {
  std::string_view name;
  bool (*runs_here)();
  /// See trace_wavefront(). Returns false, having done nothing, if the rays do not fit.
  bool (*trace)(const WavefrontScene& scene, const CameraSample* samples, int count,
                WavefrontMemory& memory, SampleResult* results, RayCounts& counts,
                const AovOutput* aovs);
};

/// The kernels for this machine, fastest first; all give the same colors.
std::vector<const WavefrontKernel*> wavefront_kernels();
/// The same in one lane, for any machine: slow.
const WavefrontKernel& one_lane_kernel();

/// Data shared by all wavefronts of a picture.
struct WavefrontScene {
  WavefrontScene(const Tracer& tracer, const CameraRays& camera);

  const Tracer& tracer;
  const CameraRays& camera;
  const WavefrontKernel* kernel;
  const std::vector<Object>& root;  ///< the objects of the root group
  bool course;                      ///< the profile
  bool transmissive_shadows;        ///< some objects let light through
  bool fresnel;                     ///< use Fresnel's equations for glass
  std::vector<ShadingMaterial> materials;
  bool by_footprint = false;       ///< a texture or bump map is filtered over footprints
  bool tests_all_objects = false;  ///< only shapes, and so few that each is tested
  const PacketBvh& packet_bvh;  ///< otherwise used unless there are instances or too many objects
  double mesh_reach;            ///< Accelerator::mesh_reach()
};

/// The memory of a wavefront, to be reused for the same scene: it remembers recent occluders, which
/// does not affect colors. Large.
struct WavefrontDeleter {
  void operator()(WavefrontMemory* memory) const;
};
using WavefrontPointer = std::unique_ptr<WavefrontMemory, WavefrontDeleter>;
WavefrontPointer make_wavefront();

/// Traces `count` samples, at most wavefront_samples. Nearby samples are faster. `aovs`: may be
/// null.
void trace_wavefront(const WavefrontScene& scene, const CameraSample* samples, int count,
                     WavefrontMemory& memory, SampleResult* results, RayCounts& counts,
                     const AovOutput* aovs = nullptr);

}  // namespace scenefile
