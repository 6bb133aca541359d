#pragma once
// The arrays of a wavefront, padded to whole vectors of lanes.

#include "scenefile/trace/wavefront.h"

#include <cstddef>
#include <type_traits>
#include <utility>

namespace scenefile {

/// A single sample always fits (rays_of_a_sample, path.h): each of its rays may cause two rays with
/// half of its budget each, so no generation has more than half of them. Of several samples, as
/// many are traced as fit.
inline constexpr int queue_rays = 2048;       ///< in one generation
inline constexpr int wavefront_nodes = 4096;  ///< in all generations
inline constexpr int wavefront_insides = 4096;
static_assert(wavefront_nodes >= rays_of_a_sample && 2 * queue_rays >= rays_of_a_sample);

/// Elements of an array of rays. A few more than the rays: if all arrays began at the same place in
/// their memory pages, the elements of one ray would evict each other from the cache.
inline constexpr int queue_row = queue_rays + 16;

/// An array whose memory is not touched before it is written: a wavefront is large, and few scenes
/// use all of it.
template <typename T, int size>
class UninitializedArray {
 public:
  T& operator[](std::size_t i) { return data()[i]; }
  const T& operator[](std::size_t i) const { return data()[i]; }
  T* data() { return reinterpret_cast<T*>(bytes_); }
  const T* data() const { return reinterpret_cast<const T*>(bytes_); }

 private:
  static_assert(std::is_trivially_copyable_v<T> && std::is_trivially_destructible_v<T>);
  alignas(64) unsigned char bytes_[size * sizeof(T)];
};

struct VectorArrays {
  alignas(64) double x[queue_row];
  alignas(64) double y[queue_row];
  alignas(64) double z[queue_row];
};

/// Ray differentials (ray_differential.h).
struct DerivativeArrays {
  VectorArrays dx;
  VectorArrays dy;
};

/// One generation of rays.
struct RayQueue {
  int count = 0;
  VectorArrays origin;
  VectorArrays direction;
  alignas(64) double start[queue_row];
  std::uint32_t node[queue_row];
  int depth[queue_row];
  double weight[queue_row];
  DerivativeArrays d_origin;     ///< if WavefrontScene::by_footprint
  DerivativeArrays d_direction;  ///< the same
  UninitializedArray<SampleKey, queue_row> key;
  std::uint32_t budget[queue_row];
  const Inside* inside[queue_row];
};

/// The nearest hit of each ray of a generation.
struct HitQueue {
  bool incoherent = false;  ///< this or an earlier generation was incoherent: packets do not help
  alignas(64) double t[queue_row];            ///< infinity: no hit
  alignas(64) double face[queue_row];         ///< number of a Face
  alignas(64) double object[queue_row];       ///< index in the root group; -1: see `others`
  UninitializedArray<Hit, queue_row> others;  ///< hits other than shapes of the root group
};

/// What only explain.h needs of points; of wavefronts of one lane.
struct RecordedPoints {
  VectorArrays object_normal;
  VectorArrays texture;  ///< color of the texture, if `textured`
  bool has_uv[queue_row];
  bool bumped[queue_row];
  bool textured[queue_row];
};

/// The points to shade, a subset of the hits.
struct ShadingPoints {
  int count = 0;
  std::uint32_t ray[queue_row];  ///< ascending
  const ShadingMaterial* material[queue_row];
  VectorArrays position;
  VectorArrays normal;
  VectorArrays geometric;  ///< normal of the surface itself
  DerivativeArrays dp;     ///< dP/dx, dP/dy if rays go on and WavefrontScene::by_footprint
  DerivativeArrays dn;     ///< dN/dx, dN/dy of their geometric normals
  VectorArrays direction;  ///< of the ray
  alignas(64) double t[queue_row];
  alignas(64) double offset[queue_row];  ///< smallest t of rays that begin here
  VectorArrays diffuse;
  VectorArrays specular;
  alignas(64) double shininess[queue_row];
  VectorArrays color;
  std::uint32_t visible_lights[queue_row];  ///< fine profile: one bit per visible light
  bool with_uv = false;                     ///< u and v are wanted
  alignas(64) double u[queue_row];
  alignas(64) double v[queue_row];
  RecordedPoints* recorded = nullptr;
};

/// Adds an item to a surface hash.
inline std::uint32_t extended_hash(std::uint32_t hash, std::uint32_t thing) {
  const std::uint32_t mixed = (hash ^ thing) * 0x9e3779b1u;
  return mixed ^ (mixed >> 15);
}

/// Recent occluders of a light among the objects of the root group, which often occlude it again.
/// Successful ones move to the front.
struct RecentBlockers {
  static constexpr std::uint32_t most = 8;
  std::uint32_t last = no_index;  ///< for packets
  std::uint32_t object[most] = {no_index, no_index, no_index, no_index,
                                no_index, no_index, no_index, no_index};
  std::uint32_t added = 0;

  void rise(std::uint32_t i) { std::swap(object[i], object[i == 0 ? 0 : i - 1]); }
  void add(std::uint32_t index) { object[most / 2 + added++ % (most / 2)] = index; }
};

/// The patterns of the points on an area light, and where in them a ray's points begin.
struct LightPatterns {
  std::uint32_t index[queue_row];
  std::uint32_t order[queue_row];
  std::uint32_t first[queue_row];
  std::uint32_t second[queue_row];
};

/// What only explain.h needs of the light that arrives; of wavefronts of one lane.
struct RecordedLight {
  alignas(64) double distance[queue_row];
  alignas(64) double attenuation[queue_row];
  alignas(64) double spot_factor[queue_row];
  alignas(64) double n_dot_l[queue_row];
  alignas(64) double r_dot_v[queue_row];
  VectorArrays diffuse;
  VectorArrays specular;
  VectorArrays contribution;
  std::uint8_t arrives[queue_row];  ///< one bit per lane
};

/// The light that arrives at the points from one light, and its shadow rays.
struct DirectLight {
  bool incoherent = false;  ///< rays to the last light were incoherent: packets do not help
  bool at_a_point = false;  ///< all shadow rays end at the same point
  glm::dvec3 from{0};       ///< that point
  VectorArrays to_light;
  alignas(64) double end[queue_row];       ///< of the shadow ray
  alignas(64) double share[queue_row];     ///< fraction of the light's color that arrives
  alignas(64) double cosine[queue_row];    ///< between normal and light, at least 0
  alignas(64) double mirrored[queue_row];  ///< cosine for the highlight
  std::uint8_t asks[queue_row];            ///< one bit per lane: whether light arrives
  std::uint8_t blocked[queue_row];         ///< one bit per lane
  std::uint32_t index = 0;                 ///< of the light
  LightPatterns patterns;                  ///< if it is an area light (fine profile)
  RecentBlockers recent[8];                ///< by index modulo their number
  VectorArrays left;                       ///< fraction that transparent objects let through
  RecordedLight* recorded = nullptr;
};

/// A ray of any generation: its color, and where it belongs.
struct RayNode {
  Color color{0};  ///< without secondary rays
  std::uint32_t parent = no_index;
  std::uint32_t surface_hash = 0;  ///< see SampleResult; includes secondary rays
  RayKind kind = RayKind::camera;
  std::uint8_t bounces = 0;  ///< maximum of it and its descendants
  bool penumbra = false;     ///< it or a descendant saw area lights partially
  bool mirrored = false;     ///< has a reflected ray
  bool refracted = false;    ///< has a refracted ray
};

/// Additional data of a ray that has or is a secondary ray. Separate, because most rays are
/// neither.
struct RayLink {
  Color factor;     ///< its weight in the parent's color
  Color mirrored;   ///< if RayNode::mirrored
  Color refracted;  ///< if RayNode::refracted
};

struct RayTreeRecorder;

struct WavefrontMemory {
  int fits = wavefront_samples;  ///< number of samples to trace at once
  int fitted = 0;                ///< how many times in a row they fit
  RayQueue rays[2];
  HitQueue hits;
  ShadingPoints points;
  ShadingPoints walls;
  DirectLight light;
  bool full = false;  ///< ran out of room for rays
  int node_count = 0;
  UninitializedArray<RayNode, wavefront_nodes> nodes;
  UninitializedArray<RayLink, wavefront_nodes> links;  ///< by node
  int inside_count = 0;
  UninitializedArray<Hit, wavefront_insides> inside_hits;
  UninitializedArray<Inside, wavefront_insides> insides;
  RayTreeRecorder* recorder = nullptr;  ///< of wavefronts of one lane (ray_tree_recorder.h)
};

}  // namespace scenefile
