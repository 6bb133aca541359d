#pragma once
// How a pixel came to its color: everything that render() does for one pixel, written down by the
// same code while it does it. Semantics: docs/rendering.md.
//
// The numbers add up, to the last bit, when the terms are added in the order in which they stand
// here (docs/explain.md has the sums).

#include "scenefile/geometry/shapes.h"
#include "scenefile/trace/color.h"
#include "scenefile/trace/render.h"

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace scenefile {

/// A primitive, by the way to it.
struct ObjectRef {
  std::uint32_t source = 0;              ///< RenderPrimitive::source
  std::vector<std::uint32_t> instances;  ///< RenderInstance::source, the outermost first
};

/// An object between a point and a light.
struct Blocker {
  ObjectRef object;
  double t = 0;         ///< along the unit direction to the light, world units
  Color passes{0};      ///< share of light that the object lets through; 0: opaque
  bool itself = false;  ///< the object that the point is on
};

/// Light from one point of a light, by way of the surface to the eye:
/// contribution = (diffuse + specular) * color * visibility.
struct LightSample {
  glm::dvec3 to_light{0};  ///< unit length
  double distance = 0;     ///< world units; infinite for directional lights
  double attenuation = 1;
  double spot_factor = 1;
  Color color{0};      ///< of the light * (attenuation * spot_factor)
  double n_dot_l = 0;  ///< cosine between normal and direction to the light
  double r_dot_v = 0;  ///< cosine between mirrored direction to the light and direction to the eye
  Color diffuse{0};    ///< D * max(0, n_dot_l)
  Color specular{0};   ///< ks * Cs * r_dot_v ^ shininess; 0 where r_dot_v <= 0
  bool shadow_ray = false;        ///< false: not needed, or shadows are off; visibility is 1
  Color visibility{1};            ///< what shadows leave
  std::vector<Blocker> blockers;  ///< nearest first; at most max_blockers
  Color contribution{0};
};
inline constexpr std::size_t max_blockers = 16;

/// Why a light gives nothing before any surface is asked.
enum class Unlit : std::uint8_t {
  no,            ///< it shines on the point
  in_this_mode,  ///< the course's ray caster knows only directional lights
  out_of_reach,  ///< outside the cone of a spot, behind an area light, or at the light itself
};

/// A light at a point. contribution = that of the only sample; of an area light the sum of all
/// divided by `taken`.
struct LightRecord {
  std::uint32_t light = 0;  ///< into RenderScene::lights
  Unlit unlit = Unlit::no;
  std::uint32_t taken = 1;           ///< points of the light that were asked
  std::vector<LightSample> samples;  ///< those from which light arrives, before any shadow
  Color contribution{0};
};

/// A texture in the diffuse color: D = (1 - blend) * kd * Cd + blend * color.
struct TextureRecord {
  std::uint32_t file = no_index;  ///< into RenderScene::texture_files
  glm::ivec2 texel{0};            ///< column and row that hold the point, row 0 on top
  Color texel_color{0};           ///< of that texel
  Color color{0};                 ///< as looked up: filtered where the filter is on
  double blend = 0;
};

/// What a ray met.
struct SurfaceRecord {
  ObjectRef object;
  Shape shape = Shape::cube;
  Face face = Face::side;         ///< analytic shapes
  std::uint32_t mesh = no_index;  ///< into RenderScene::mesh_files
  std::uint32_t triangle = 0;     ///< meshes
  std::uint32_t material = 0;     ///< into RenderScene::materials
  Ray ray;                        ///< world space, unit direction; after the last wall it passed
  Ray object_ray;                 ///< the same in object space; same t
  double t = 0;
  glm::dvec3 position{0};
  glm::dvec3 object_position{0};
  glm::dvec3 object_normal{0};
  glm::dvec3 normal{0};     ///< world space, for shading; with the bump map
  glm::dvec3 geometric{0};  ///< world space, of the surface itself
  bool bumped = false;
  glm::dvec2 uv{0};
  bool has_uv = true;
  std::optional<TextureRecord> texture;
  Color diffuse_color{0};   ///< D
  Color specular_color{0};  ///< ks * Cs
};

/// A wall of the transparent object that a ray was in.
struct WallRecord {
  ObjectRef object;
  double t = 0;
  glm::dvec3 position{0};
  glm::dvec3 normal{0};     ///< against the ray
  glm::dvec3 direction{0};  ///< of the ray behind it
  bool mirrored = false;    ///< total internal reflection
};

enum class RayKind : std::uint8_t { camera, reflected, refracted };

/// What became of the light of a mirror or of glass.
enum class Fate : std::uint8_t {
  absent,     ///< the material has none, or the feature is off
  followed,   ///< by the ray `ray`
  too_deep,   ///< max_depth is reached
  too_faint,  ///< fine: it can change the pixel by less than 1/1024
  too_many,   ///< the sample has spent its rays
};

struct BranchRecord {
  Fate fate = Fate::absent;
  Color factor{0};        ///< ks * Cr or kt * Ct; with `fresnel` its share of light in it
  std::uint32_t ray = 0;  ///< where followed: index of its record
};

/// A ray with all that it saw:
/// local = ambient + contributions of the lights;
/// sum = local + (mirror.factor * its color + glass.factor * its color);
/// color = sum, in the course profile clamped to 0..1. A ray that meets nothing is black.
struct RayRecord {
  RayKind kind = RayKind::camera;
  std::uint32_t parent = no_index;  ///< index of the record of the ray that it comes from
  int depth = 0;                    ///< reflections and refractions before it
  Color weight{1};                  ///< product of the factors on the way: share of the sample
  Ray ray;                          ///< as it starts, world space, unit direction
  double start = 0;                 ///< smallest t that counts
  bool total_reflection = false;    ///< refracted: the light that could not pass is mirrored
  std::vector<WallRecord> walls;
  bool trapped = false;  ///< mirrored inside an object more often than max_depth allows: black
  std::optional<SurfaceRecord> surface;
  bool inner_wall = false;  ///< fresnel: of the object that the ray is in; unlit, local is 0
  Color ambient{0};
  std::vector<LightRecord> lights;
  Color local{0};
  BranchRecord mirror;
  BranchRecord glass;
  Color sum{0};
  Color color{0};
};

/// A sample of the pixel.
struct SampleRecord {
  glm::dvec2 point{0};  ///< of the picture, in pixels, y down
  glm::dvec2 lens{0};   ///< where the ray leaves the lens, in apertures
  Color color{0};
  std::uint32_t rays = 0;            ///< camera, reflected and refracted rays
  std::optional<ObjectRef> object;   ///< what the camera ray met
  std::uint32_t refines = no_index;  ///< course: the sample that this one stands for, with others
  bool refined = false;              ///< course: others stand for it; its color does not count
};

/// Why the fine profile took more than the first samples.
struct MoreSamples {
  bool noisy = false;      ///< the first samples of its own do not agree
  bool penumbra = false;   ///< a sample saw part of an area light
  bool neighbors = false;  ///< a neighboring pixel differs
};

struct PixelRecord {
  int x = 0;
  int y = 0;
  RenderOptions options;
  std::vector<SampleRecord> samples;  ///< in the order in which they were taken
  MoreSamples more;                   ///< fine
  std::uint32_t shown = 0;            ///< the sample that `rays` tells of
  std::vector<RayRecord> rays;        ///< the camera ray first; mode normals: the camera ray alone
  Color color{0};                     ///< mean of the samples
  std::array<float, 3> picture{};     ///< as render() puts it into the image
  std::array<std::uint8_t, 3> value{};  ///< 8-bit
};

/// Explains pixels of one picture. Scene and assets must outlive it.
class Explainer {
 public:
  Explainer(const RenderScene& scene, const Assets& assets, const RenderOptions& options);
  ~Explainer();
  Explainer(const Explainer&) = delete;
  Explainer& operator=(const Explainer&) = delete;

  /// Pixels can be explained only when `complete`; later `limit_reached` where the tracer gave up.
  RenderStatus status() const;

  /// 0 <= x < width, 0 <= y < height. `sample` chooses the one to be shown in full; none, or one
  /// that was not taken: of those that count the one nearest to the middle of the pixel.
  PixelRecord explain(int x, int y, std::optional<std::uint32_t> sample = {}) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace scenefile
