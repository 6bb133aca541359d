#pragma once
// Many rays at once: the camera rays of a tile with all that comes of them, in as many lanes as the
// machine has. What they see is equal to the last bit to what trace_sample() finds for each alone.

#include "scenefile/trace/camera_rays.h"
#include "scenefile/trace/part_tree.h"
#include "scenefile/trace/path.h"
#include "scenefile/trace/surface_sample.h"

#include <memory>
#include <span>
#include <string_view>
#include <vector>

namespace scenefile {

/// A wave has at most so many camera rays.
inline constexpr int wave_samples = 256;

/// What shading asks of a material, multiplied by the coefficients of the scene.
struct WaveMaterial {
  double ambient[3];
  double diffuse[3];
  double specular[3];
  double mirror[3];
  double glass[3];
  double shininess;
  double ior;
  double blend;       ///< of the texture, 0 where there is none
  double density[3];  ///< that shadow rays gather, as Transmission has it
  const RenderMaterial* material;
  const Texture* texture;  ///< if it is not filtered over what a ray covers
  const Pyramid* pyramid;  ///< if it is
  bool bumped;             ///< has a bump map
  bool mirrors;            ///< rays go on by it
  bool refracts;
};

/// What a sample sees.
struct WaveSight {
  Color color{0};
  bool penumbra = false;  ///< area lights in part
  /// Fine profile: of two samples that saw the same parts and faces in the same light, by way of
  /// the same mirrors and glass, it is the same. Such samples differ by what changes evenly, and by
  /// textures, which are filtered.
  std::uint32_t signature = 0;
};

/// Where to write what the camera rays met; arrays by sample.
struct WaveRecord {
  SurfaceSample* samples = nullptr;       ///< but for `point` and `color`
  Color* light_colors = nullptr;          ///< by sample and light that is kept apart
  std::span<const std::uint32_t> lights;  ///< those, into RenderScene::lights
};

struct WaveScene;
struct WaveMemory;

/// What traces waves with one of the instruction sets.
struct WaveKernel {
  std::string_view name;
  bool (*runs_here)();
  /// See trace_wave(); false: they do not fit, and nothing was done.
  bool (*trace)(const WaveScene& scene, const CameraSample* samples, int count, WaveMemory& memory,
                WaveSight* sights, RayCounts& counts, const WaveRecord* record);
};

/// Those that this machine has, the best first; all find the same colors.
std::vector<const WaveKernel*> wave_kernels();

/// What all waves of a picture share.
struct WaveScene {
  WaveScene(const Tracer& tracer, const CameraRays& camera);

  const Tracer& tracer;
  const CameraRays& camera;
  const WaveKernel* kernel;
  const std::vector<Part>& root;  ///< the parts of the root group
  bool course;                    ///< the profile
  bool clear_shadows;             ///< light may pass through objects
  bool fresnel;                   ///< glass mirrors by Fresnel's equations
  std::vector<WaveMaterial> materials;
  bool by_footprint = false;  ///< a texture or bump map is filtered over what rays cover
  bool few_parts = false;     ///< all are shapes, and so few that each is tested
  const PartTree& tree;       ///< of more, where all are shapes and not too many
};

/// The memory of one wave, to be used again for the same scene: it remembers what was in the way of
/// lights, which changes no color. Large.
struct WaveDeleter {
  void operator()(WaveMemory* memory) const;
};
using WavePointer = std::unique_ptr<WaveMemory, WaveDeleter>;
WavePointer make_wave();

/// What the camera sees, `count` of at most wave_samples. Samples near each other are found faster.
/// `record`: null where nobody asks.
void trace_wave(const WaveScene& scene, const CameraSample* samples, int count, WaveMemory& memory,
                WaveSight* sights, RayCounts& counts, const WaveRecord* record = nullptr);

}  // namespace scenefile
