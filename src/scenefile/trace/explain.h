#pragma once
// Explains the color of a pixel: everything that render() computes for one pixel, recorded by the
// same code. Semantics: docs/rendering.md.
//
// The numbers add up exactly if the terms are added in the order given here (docs/explain.md lists
// the sums).

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

/// Identifies a primitive and the instances around it.
struct ObjectRef {
  std::uint32_t source = 0;              ///< RenderPrimitive::source
  std::vector<std::uint32_t> instances;  ///< RenderInstance::source, outermost first
};

/// An occluder between a point and a light.
struct Blocker {
  ObjectRef object;
  double t = 0;         ///< along the unit direction to the light, world units
  Color passes{0};      ///< fraction of light that the object lets through; 0: opaque
  bool itself = false;  ///< the point is on this object
};

/// Light from one point of a light, reflected by the surface to the eye:
/// contribution = (diffuse + specular) * color * visibility.
struct LightSample {
  glm::dvec3 to_light{0};  ///< unit length
  double distance = 0;     ///< world units; infinite for directional lights
  double attenuation = 1;
  double spot_factor = 1;
  Color color{0};           ///< of the light * (attenuation * spot_factor)
  double n_dot_l = 0;       ///< cosine between the normal and the direction to the light
  double r_dot_v = 0;       ///< cosine between the reflected direction to the light and the eye
  Color diffuse{0};         ///< D * max(0, n_dot_l)
  Color specular{0};        ///< ks * Cs * r_dot_v ^ shininess; 0 if r_dot_v <= 0
  bool shadow_ray = false;  ///< false: not needed, or shadows are off; visibility is 1
  Color visibility{1};      ///< fraction of light that shadows leave
  std::vector<Blocker> blockers;  ///< nearest first; at most max_blockers
  Color contribution{0};
};
inline constexpr std::size_t max_blockers = 16;

/// Why a light contributes nothing, regardless of the surface.
enum class Unlit : std::uint8_t {
  no,            ///< it shines on the point
  in_this_mode,  ///< the course's ray caster and the milestone Lights, Camera of Realtime only use
                 ///< directional lights
  out_of_reach,  ///< outside a spotlight's cone, behind an area light, or at the light itself
};

/// A light at a point. Its contribution is that of its only sample; for an area light the sum of
/// all samples divided by `taken`.
struct LightRecord {
  std::uint32_t light = 0;  ///< into RenderScene::lights
  Unlit unlit = Unlit::no;
  std::uint32_t taken = 1;           ///< number of points sampled on the light
  std::vector<LightSample> samples;  ///< those from which light arrives, ignoring shadows
  Color contribution{0};
};

/// A texture in the diffuse color: D = (1 - blend) * kd * Cd + blend * color.
struct TextureRecord {
  std::uint32_t file = no_index;  ///< into RenderScene::texture_files
  glm::ivec2 texel{0};            ///< column and row that contain the point, row 0 at the top
  Color texel_color{0};           ///< of that texel
  Color color{0};                 ///< result of the lookup: filtered if filtering is on
  double blend = 0;
};

/// The surface that a ray hit.
struct SurfaceRecord {
  ObjectRef object;
  Shape shape = Shape::cube;
  Face face = Face::side;         ///< analytic shapes
  std::uint32_t mesh = no_index;  ///< into RenderScene::mesh_files
  std::uint32_t triangle = 0;     ///< meshes
  std::uint32_t material = 0;     ///< into RenderScene::materials
  Ray ray;                        ///< world space, unit direction; after the last wall
  Ray object_ray;                 ///< the same in object space; same t
  double t = 0;
  glm::dvec3 position{0};
  glm::dvec3 object_position{0};
  glm::dvec3 object_normal{0};
  glm::dvec3 normal{0};     ///< world space, for shading; includes the bump map
  glm::dvec3 geometric{0};  ///< world space, of the geometry
  bool bumped = false;
  glm::dvec2 uv{0};
  bool has_uv = true;
  std::optional<TextureRecord> texture;
  Color diffuse_color{0};   ///< D
  Color specular_color{0};  ///< ks * Cs
};

/// The ray at a wall of the transparent object that it is inside of.
struct WallRecord {
  ObjectRef object;
  double t = 0;
  glm::dvec3 position{0};
  glm::dvec3 normal{0};     ///< pointing against the ray
  glm::dvec3 direction{0};  ///< of the ray after the wall
  bool mirrored = false;    ///< total internal reflection
};

enum class RayKind : std::uint8_t { camera, reflected, refracted };

/// What happened to reflected or refracted light.
enum class BranchOutcome : std::uint8_t {
  absent,     ///< not reflective or transparent, or the feature is off
  followed,   ///< by the ray `ray`
  too_deep,   ///< max_depth is reached
  too_faint,  ///< fine: it can change the pixel by less than 1/1024
  too_many,   ///< the sample has used up its rays
};

struct BranchRecord {
  BranchOutcome outcome = BranchOutcome::absent;
  Color factor{0};        ///< ks * Cr or kt * Ct; with `fresnel` multiplied by the Fresnel term
  std::uint32_t ray = 0;  ///< if followed: index of its record
};

/// A ray and its result:
/// local = ambient + contributions of the lights;
/// sum = local + (mirror.factor * its color + glass.factor * its color);
/// color = sum, in the course profile clamped to 0..1. A ray that hits nothing is black.
struct RayRecord {
  RayKind kind = RayKind::camera;
  std::uint32_t parent = no_index;  ///< index of the record of the ray that caused it
  int depth = 0;                    ///< reflections and refractions before it
  Color weight{1};                  ///< product of the factors along the path
  Ray ray;                          ///< at its start, world space, unit direction
  double start = 0;                 ///< smallest t that counts
  bool total_reflection = false;    ///< refracted: total internal reflection instead
  std::vector<WallRecord> walls;
  bool trapped = false;  ///< reflected inside an object more often than max_depth allows: black
  std::optional<SurfaceRecord> surface;
  bool inner_wall = false;  ///< fresnel: a wall of the object that the ray is in; unlit, local is 0
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
  glm::dvec2 lens{0};   ///< point on the lens, in apertures
  Color color{0};
  std::uint32_t rays = 0;            ///< camera, reflected and refracted rays
  std::optional<ObjectRef> object;   ///< hit by the camera ray
  std::uint32_t refines = no_index;  ///< course: the sample whose quadrant this one refines
  bool refined = false;              ///< course: replaced by finer samples; its color is ignored
};

/// Why the fine profile took more than the initial samples.
struct MoreSamples {
  bool noisy = false;      ///< the first pattern samples disagree
  bool penumbra = false;   ///< a sample saw part of an area light
  bool neighbors = false;  ///< a neighboring pixel differs
};

struct PixelRecord {
  int x = 0;
  int y = 0;
  RenderOptions options;
  std::vector<SampleRecord> samples;    ///< in sampling order
  MoreSamples more;                     ///< fine
  std::uint32_t shown = 0;              ///< the sample that `rays` describes
  std::vector<RayRecord> rays;          ///< the camera ray first; mode normals: only the camera ray
  Color color{0};                       ///< mean of the samples
  std::array<float, 3> picture{};       ///< as stored in the image by render()
  std::array<std::uint8_t, 3> value{};  ///< 8-bit
};

/// Explains pixels of a picture. Scene and assets must outlive it.
class Explainer {
 public:
  Explainer(const RenderScene& scene, const Assets& assets, const RenderOptions& options);
  ~Explainer();
  Explainer(const Explainer&) = delete;
  Explainer& operator=(const Explainer&) = delete;

  /// Pixels can only be explained when `complete`; later `limit_reached` if a ray had to be
  /// abandoned.
  RenderStatus status() const;

  /// 0 <= x < width, 0 <= y < height. `sample` selects the sample to describe in full; by default,
  /// or if it was not taken, the one that counts and is nearest to the center of the pixel.
  PixelRecord explain(int x, int y, std::optional<std::uint32_t> sample = {}) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace scenefile
