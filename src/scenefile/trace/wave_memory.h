#pragma once
// The arrays of a wave, each with room for whole vectors of lanes.

#include "scenefile/trace/wave.h"

#include <cstddef>
#include <type_traits>
#include <utility>

namespace scenefile {

/// One sample always fits (rays_of_a_sample, path.h): each of its rays may become two, with half of
/// the budget each, so that no generation has more than half of them. Of more samples as many are
/// taken as fit.
inline constexpr int wave_rays = 2048;   ///< of one generation
inline constexpr int wave_nodes = 4096;  ///< rays of all generations
inline constexpr int wave_insides = 4096;
static_assert(wave_nodes >= rays_of_a_sample && 2 * wave_rays >= rays_of_a_sample);

/// An array whose memory nobody touches before its numbers are written: a wave is large, and few
/// scenes use all of it.
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
  alignas(64) double x[wave_rays];
  alignas(64) double y[wave_rays];
  alignas(64) double z[wave_rays];
};

/// Changes from pixel to pixel (footprint.h).
struct WaveSteps {
  WaveVectors x;
  WaveVectors y;
};

/// One generation of rays.
struct WaveRays {
  int count = 0;
  WaveVectors origin;
  WaveVectors direction;
  alignas(64) double start[wave_rays];
  std::uint32_t node[wave_rays];
  int depth[wave_rays];
  double weight[wave_rays];
  WaveSteps origin_steps;     ///< where WaveScene::by_footprint
  WaveSteps direction_steps;  ///< likewise
  WaveArray<SampleKey, wave_rays> key;
  std::uint32_t budget[wave_rays];
  const Inside* inside[wave_rays];
};

/// What each ray of a generation hit first.
struct WaveHits {
  bool apart = false;  ///< most rays of this generation or one before it went where bundles are of
                       ///< no use
  alignas(64) double t[wave_rays];     ///< infinite: nothing
  alignas(64) double face[wave_rays];  ///< number of a Face
  alignas(64) double part[wave_rays];  ///< index in the root group; -1: it is in `others`
  WaveArray<Hit, wave_rays> others;    ///< what is no shape of the root group
};

/// The points where light is to be found, a selection of the hits.
struct WavePoints {
  int count = 0;
  std::uint32_t ray[wave_rays];  ///< rising
  const WaveMaterial* material[wave_rays];
  WaveVectors position;
  WaveVectors normal;
  WaveVectors geometric;  ///< normal of the surface itself
  WaveSteps steps;        ///< of points from where rays go on, where WaveScene::by_footprint
  WaveSteps turns;        ///< of their geometric normals, likewise
  WaveVectors direction;  ///< of the ray
  alignas(64) double t[wave_rays];
  alignas(64) double offset[wave_rays];  ///< smallest t of rays that begin here
  WaveVectors diffuse;
  WaveVectors specular;
  alignas(64) double shininess[wave_rays];
  WaveVectors color;
  std::uint32_t lit[wave_rays];  ///< fine profile: a bit for each light that is seen, in turn
};

/// A signature with one thing more.
inline std::uint32_t signed_with(std::uint32_t signature, std::uint32_t thing) {
  const std::uint32_t mixed = (signature ^ thing) * 0x9e3779b1u;
  return mixed ^ (mixed >> 15);
}

/// Parts of the root group that were in the way of a light not long ago: with luck they are so
/// again. Those that prove themselves rise.
struct RecentBlockers {
  static constexpr std::uint32_t most = 8;
  std::uint32_t last = no_index;  ///< of bundles
  std::uint32_t part[most] = {no_index, no_index, no_index, no_index,
                              no_index, no_index, no_index, no_index};
  std::uint32_t added = 0;

  void rise(std::uint32_t i) { std::swap(part[i], part[i == 0 ? 0 : i - 1]); }
  void add(std::uint32_t index) { part[most / 2 + added++ % (most / 2)] = index; }
};

/// What one light sends to the points.
struct WaveLight {
  bool apart = false;       ///< rays to the last light went apart: bundles are of no use here
  bool at_a_point = false;  ///< all rays to it end in one point
  glm::dvec3 from{0};       ///< that
  WaveVectors to_light;
  alignas(64) double end[wave_rays];       ///< of the shadow ray
  alignas(64) double share[wave_rays];     ///< of the light's color that arrives
  alignas(64) double cosine[wave_rays];    ///< to the normal, 0 at least
  alignas(64) double mirrored[wave_rays];  ///< to the highlight
  std::uint8_t asks[wave_rays];            ///< a bit for each lane: whether anything comes of it
  std::uint8_t blocked[wave_rays];         ///< a bit for each lane
  std::uint32_t index = 0;                 ///< of the light
  RecentBlockers recent[8];                ///< by index, in turn
  WaveVectors left;                        ///< share that objects let through, where some do
};

/// A ray of any generation: what it sees, and where that goes.
struct WaveNode {
  Color color{0};  ///< without what follows
  std::uint32_t parent = no_index;
  std::uint32_t signature = 0;  ///< see WaveSight, of it and of what came of it
  RayKind kind = RayKind::camera;
  std::uint8_t bounces = 0;  ///< of it or of what came of it, most
  bool penumbra = false;     ///< saw area lights in part, or what came of it did
  bool mirrored = false;     ///< something came by way of a mirror
  bool refracted = false;    ///< by way of glass
};

/// What is more of a ray that others follow, or that follows one. Apart, because most do neither.
struct WaveLink {
  Color factor;     ///< of what its parent gets
  Color mirrored;   ///< where WaveNode says so
  Color refracted;  ///< likewise
};

struct WaveMemory {
  int fits = wave_samples;  ///< so many samples are taken at once
  int fitted = 0;           ///< times in turn that they did
  WaveRays rays[2];
  WaveHits hits;
  WavePoints points;
  WavePoints walls;
  WaveLight light;
  bool full = false;  ///< more rays were asked for than there is room
  int node_count = 0;
  WaveArray<WaveNode, wave_nodes> nodes;
  WaveArray<WaveLink, wave_nodes> links;  ///< by node
  int inside_count = 0;
  WaveArray<Hit, wave_insides> objects;
  WaveArray<Inside, wave_insides> insides;
};

}  // namespace scenefile
