#pragma once
// The scene to draw: world space, radians, indices; no names, nodes or file places. Made by
// prepare() (prepare.h); callers may change the camera.
//
// Its size is proportional to the file, not to the number of instances: a template is one group,
// however often it is instantiated.

#include "scenefile/base/affine.h"
#include "scenefile/base/location.h"
#include "scenefile/base/shape.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <optional>
#include <vector>

namespace scenefile {

/// "No such index", in all index fields of a RenderScene.
inline constexpr std::uint32_t no_index = 0xffffffffu;

/// An image on a surface: an index into RenderScene::texture_files and how often it repeats.
struct RenderTexture {
  std::uint32_t file = no_index;
  float repeat_u = 1;
  float repeat_v = 1;

  bool used() const { return file != no_index; }
  friend bool operator==(const RenderTexture&, const RenderTexture&) = default;
};

/// Phong material; same meaning as Material in scene.h, except that the index of refraction is
/// always greater than 0 (1 if the file gives none).
struct RenderMaterial {
  glm::vec3 ambient{0};
  glm::vec3 diffuse{1};
  glm::vec3 specular{0};
  glm::vec3 reflective{0};
  glm::vec3 transparent{0};
  float shininess = 0;
  float ior = 1;
  float blend = 0;
  RenderTexture texture;
  RenderTexture bump_map;

  friend bool operator==(const RenderMaterial&, const RenderMaterial&) = default;
};

/// One shape in its group. `group_from_object` is invertible; prepare() leaves out primitives whose
/// transform is not, with a warning.
struct RenderPrimitive {
  Affine group_from_object;
  Shape shape = Shape::cube;
  std::uint32_t mesh = no_index;  ///< into RenderScene::mesh_files, for Shape::mesh
  std::uint32_t material = 0;     ///< into RenderScene::materials
  std::uint32_t source = 0;       ///< into Prepared::sources (prepare.h)

  friend bool operator==(const RenderPrimitive& a, const RenderPrimitive& b);
};

/// An instance of another group. `group_from_instance` maps the instance's space to that of the
/// group that contains it; it is invertible.
struct RenderInstance {
  Affine group_from_instance;
  std::uint32_t group = 0;  ///< into RenderScene::groups; smaller than that of the containing group
  std::uint32_t source = 0;

  friend bool operator==(const RenderInstance& a, const RenderInstance& b);
};

struct RenderGroup {
  std::vector<RenderPrimitive> primitives;
  std::vector<RenderInstance> instances;

  friend bool operator==(const RenderGroup&, const RenderGroup&) = default;
};

/// A light in world space. Members that its type does not use have their default values.
struct RenderLight {
  LightType type = LightType::point;
  glm::vec3 color{1};
  glm::vec3 position{0};           ///< point, spot; center of an area light
  glm::vec3 direction{0, -1, 0};   ///< of travel, unit length; directional, spot, area
  glm::vec3 attenuation{1, 0, 0};  ///< constant, linear, quadratic; point, spot, area
  float inner_angle = 0;           ///< spot: half-angle of full light, radians
  float outer_angle = 0;           ///< spot: half-angle where light ends, radians; >= inner_angle
  glm::vec3 half_u{0};             ///< area: from the center to the middle of one edge, world units
  glm::vec3 half_v{0};  ///< area: the same for an adjacent edge; perpendicular to `direction`
  std::uint32_t source = 0;

  friend bool operator==(const RenderLight& a, const RenderLight& b);
};

/// The camera: rays start at `position` and pass through
/// position - w + x * tan(fov_y / 2) * aspect * u + y * tan(fov_y / 2) * v, x and y in [-1, 1].
struct RenderCamera {
  glm::dvec3 position{0};
  glm::dvec3 u{1, 0, 0};              ///< to the right of the picture, unit length
  glm::dvec3 v{0, 1, 0};              ///< up in the picture, unit length
  glm::dvec3 w{0, 0, 1};              ///< opposite to the view direction, unit length
  double fov_y = 0.7853981633974483;  ///< full vertical angle of view, radians, in (0, pi)
  double aperture = 0;                ///< maximum lens offset along u and v; 0: pinhole
  double focal_length = 0;            ///< distance of the plane in focus along -w; 0: pinhole

  friend bool operator==(const RenderCamera&, const RenderCamera&) = default;
};

/// Coefficients of the lighting equation.
struct RenderGlobal {
  float ambient = 0.5f;
  float diffuse = 0.5f;
  float specular = 0.5f;
  std::optional<float> transparent;  ///< not given: the renderer's profile decides

  friend bool operator==(const RenderGlobal&, const RenderGlobal&) = default;
};

struct RenderScene {
  RenderGlobal global;
  RenderCamera camera;
  std::vector<RenderLight> lights;
  std::vector<RenderMaterial> materials;     ///< without duplicates
  std::vector<RenderGroup> groups;           ///< each group comes after all groups that it contains
  std::uint32_t root = 0;                    ///< the group that is the world
  std::vector<FileReference> texture_files;  ///< without duplicates
  std::vector<FileReference> mesh_files;     ///< without duplicates

  /// Equal render scenes give equal pictures; sources and locations are ignored.
  friend bool operator==(const RenderScene& a, const RenderScene& b);
};

/// The number of primitives after instancing. A double, because deeply nested templates exceed any
/// integer type; saturates at infinity.
double count_virtual_primitives(const RenderScene& scene);

/// The maximum nesting depth of instances; 0 for a scene without instances.
std::uint32_t instance_nesting(const RenderScene& scene);

}  // namespace scenefile
