#pragma once
// The arrays of a wave, padded to whole vectors of lanes.

#include "scenefile/trace/wave.h"

#include <cstddef>
#include <type_traits>
#include <utility>

namespace scenefile {

/// A single sample always fits (rays_of_a_sample, path.h): each of its rays may cause two rays with
/// half of its budget each, so no generation has more than half of them. Of several samples, as
/// many are traced as fit.
inline constexpr int wave_rays = 2048;   ///< in one generation
inline constexpr int wave_nodes = 4096;  ///< in all generations
inline constexpr int wave_insides = 4096;
static_assert(wave_nodes >= rays_of_a_sample && 2 * wave_rays >= rays_of_a_sample);

/// Elements of an array of rays. A few more than the rays: if all arrays began at the same place in
/// their memory pages, the elements of one ray would evict each other from the cache.
inline constexpr int wave_row = wave_rays + 16;

/// An array whose memory is not touched before it is written: a wave is large, and few scenes use
/// all of it.
template <typename T, int size>
class WaveArray {
 public:
  T& operator[](std::size_t i) { return data()[i]; }
  const T& operator[](std::size_t i) const { return data()[i]; }
  T* data() { return reinterpret_cast<T*>(bytes_); }
  const T* data() const { return reinterpret_cast<const T*>(bytes_); }

 private:
  static_assert(std::is_trivially_copyable_v<T> && std::is_trivially_destructible_v<T>);
  alignas(64) unsigned char bytes_[size * sizeof(T)];
};

struct WaveVectors {
  alignas(64) double x[wave_row];
  alignas(64) double y[wave_row];
  alignas(64) double z[wave_row];
};

/// Ray differentials (footprint.h).
struct WaveSteps {
  WaveVectors x;
  WaveVectors y;
};

/// One generation of rays.
struct WaveRays {
  int count = 0;
  WaveVectors origin;
  WaveVectors direction;
  alignas(64) double start[wave_row];
  std::uint32_t node[wave_row];
  int depth[wave_row];
  double weight[wave_row];
  WaveSteps origin_steps;     ///< if WaveScene::by_footprint
  WaveSteps direction_steps;  ///< the same
  WaveArray<SampleKey, wave_row> key;
  std::uint32_t budget[wave_row];
  const Inside* inside[wave_row];
};

/// The nearest hit of each ray of a generation.
struct WaveHits {
  bool incoherent = false;  ///< this or an earlier generation was incoherent: bundles do not help
  alignas(64) double t[wave_row];     ///< infinity: no hit
  alignas(64) double face[wave_row];  ///< number of a Face
  alignas(64) double part[wave_row];  ///< index in the root group; -1: see `others`
  WaveArray<Hit, wave_row> others;    ///< hits other than shapes of the root group
};

/// What only explain.h needs of points; of waves of one lane.
struct WavePointNotes {
  WaveVectors object_normal;
  WaveVectors texture;  ///< color of the texture, if `textured`
  bool has_uv[wave_row];
  bool bumped[wave_row];
  bool textured[wave_row];
};

/// The points to shade, a subset of the hits.
struct WavePoints {
  int count = 0;
  std::uint32_t ray[wave_row];  ///< ascending
  const WaveMaterial* material[wave_row];
  WaveVectors position;
  WaveVectors normal;
  WaveVectors geometric;  ///< normal of the surface itself
  WaveSteps steps;        ///< of points with secondary rays, if WaveScene::by_footprint
  WaveSteps turns;        ///< the same for their geometric normals
  WaveVectors direction;  ///< of the ray
  alignas(64) double t[wave_row];
  alignas(64) double offset[wave_row];  ///< smallest t of rays that begin here
  WaveVectors diffuse;
  WaveVectors specular;
  alignas(64) double shininess[wave_row];
  WaveVectors color;
  std::uint32_t lit[wave_row];  ///< fine profile: one bit per visible light
  bool with_uv = false;         ///< u and v are wanted
  alignas(64) double u[wave_row];
  alignas(64) double v[wave_row];
  WavePointNotes* notes = nullptr;
};

/// Adds an item to a signature.
inline std::uint32_t extended_signature(std::uint32_t signature, std::uint32_t thing) {
  const std::uint32_t mixed = (signature ^ thing) * 0x9e3779b1u;
  return mixed ^ (mixed >> 15);
}

/// Recent occluders of a light among the parts of the root group, which often occlude it again.
/// Successful ones move to the front.
struct RecentBlockers {
  static constexpr std::uint32_t most = 8;
  std::uint32_t last = no_index;  ///< for bundles
  std::uint32_t part[most] = {no_index, no_index, no_index, no_index,
                              no_index, no_index, no_index, no_index};
  std::uint32_t added = 0;

  void rise(std::uint32_t i) { std::swap(part[i], part[i == 0 ? 0 : i - 1]); }
  void add(std::uint32_t index) { part[most / 2 + added++ % (most / 2)] = index; }
};

/// The patterns of the points on an area light, and where in them a ray's points begin.
struct WaveLightPatterns {
  std::uint32_t index[wave_row];
  std::uint32_t order[wave_row];
  std::uint32_t first[wave_row];
  std::uint32_t second[wave_row];
};

/// What only explain.h needs of the light that arrives; of waves of one lane.
struct WaveLightNotes {
  alignas(64) double distance[wave_row];
  alignas(64) double attenuation[wave_row];
  alignas(64) double spot_factor[wave_row];
  alignas(64) double n_dot_l[wave_row];
  alignas(64) double r_dot_v[wave_row];
  WaveVectors diffuse;
  WaveVectors specular;
  WaveVectors contribution;
  std::uint8_t arrives[wave_row];  ///< one bit per lane
};

/// The light that arrives at the points from one light.
struct WaveLight {
  bool incoherent = false;  ///< rays to the last light were incoherent: bundles do not help
  bool at_a_point = false;  ///< all shadow rays end at the same point
  glm::dvec3 from{0};       ///< that point
  WaveVectors to_light;
  alignas(64) double end[wave_row];       ///< of the shadow ray
  alignas(64) double share[wave_row];     ///< fraction of the light's color that arrives
  alignas(64) double cosine[wave_row];    ///< between normal and light, at least 0
  alignas(64) double mirrored[wave_row];  ///< cosine for the highlight
  std::uint8_t asks[wave_row];            ///< one bit per lane: whether light arrives
  std::uint8_t blocked[wave_row];         ///< one bit per lane
  std::uint32_t index = 0;                ///< of the light
  WaveLightPatterns patterns;             ///< if it is an area light (fine profile)
  RecentBlockers recent[8];               ///< by index modulo their number
  WaveVectors left;                       ///< fraction that transparent objects let through
  WaveLightNotes* notes = nullptr;
};

/// A ray of any generation: its color, and where it belongs.
struct WaveNode {
  Color color{0};  ///< without secondary rays
  std::uint32_t parent = no_index;
  std::uint32_t signature = 0;  ///< see WaveSight; includes secondary rays
  RayKind kind = RayKind::camera;
  std::uint8_t bounces = 0;  ///< maximum of it and its descendants
  bool penumbra = false;     ///< it or a descendant saw area lights partially
  bool mirrored = false;     ///< has a reflected ray
  bool refracted = false;    ///< has a refracted ray
};

/// Additional data of a ray that has or is a secondary ray. Separate, because most rays are
/// neither.
struct WaveLink {
  Color factor;     ///< its weight in the parent's color
  Color mirrored;   ///< if WaveNode::mirrored
  Color refracted;  ///< if WaveNode::refracted
};

struct WaveTrail;

struct WaveMemory {
  int fits = wave_samples;  ///< number of samples to trace at once
  int fitted = 0;           ///< how many times in a row they fit
  WaveRays rays[2];
  WaveHits hits;
  WavePoints points;
  WavePoints walls;
  WaveLight light;
  bool full = false;  ///< ran out of room for rays
  int node_count = 0;
  WaveArray<WaveNode, wave_nodes> nodes;
  WaveArray<WaveLink, wave_nodes> links;  ///< by node
  int inside_count = 0;
  WaveArray<Hit, wave_insides> objects;
  WaveArray<Inside, wave_insides> insides;
  WaveTrail* trail = nullptr;  ///< of waves of one lane (wave_trail.h)
};

}  // namespace scenefile
