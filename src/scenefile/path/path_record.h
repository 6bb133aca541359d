#pragma once
// What a path did, recorded by the code that follows it (path_kernel.h). Everything is a double,
// and sums are exact to the last bit if their terms are added in the order given here.

#include "scenefile/geometry/mesh.h"
#include "scenefile/path/bsdf.h"
#include "scenefile/trace/explain.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <limits>
#include <vector>

namespace scenefile {

/// A point of a surface on a path.
struct PathPoint {
  std::uint32_t triangle = 0;              ///< of a mesh
  std::uint32_t material = mesh_no_index;  ///< of a face: into MeshMaterials::materials
  glm::dvec3 position{0};
  double offset = 0;  ///< t of the nearest hit that counts on rays from here
  Facing facing;
  Bsdf bsdf;
  Color emission{0};        ///< radiance toward the eye
  double lamp_density = 0;  ///< of Lamps::sample() for this point, per area
};

/// A random point on a lamp, or a light of the scene, seen from a vertex:
/// unshadowed = weight / density * reflected * emission;
/// contribution = visibility * unshadowed.
struct PathLight {
  std::uint32_t light = no_index;  ///< into RenderScene::lights; no_index: a lamp
  glm::dvec3 to_light{0};          ///< unit length
  double distance = 0;             ///< world units; infinite for directional lights
  double lamp_cosine = 0;          ///< between a lamp's normal and the direction to the vertex
  std::uint32_t lamp = no_index;   ///< triangle of the lamps
  glm::dvec2 lamp_weights{0};      ///< where on it: barycentric, of its second and third corner
  /// Radiance of the lamp toward the vertex; 0 if it faces away or is black there. Of a light its
  /// color * (attenuation * spot factor).
  Color emission{0};
  Color reflected{0};  ///< BSDF times cosine; of a light Kd cos + Ks cos^n (docs/rendering.md)
  /// Of a lamp: of this direction per solid angle, times the number of samples. Of a light: the
  /// number of points on it, divided by the number of lights if only one of them is chosen.
  double density = 1;
  double bsdf_density = 0;  ///< lamps: of sample() for this direction, per solid angle
  double weight = 1;        ///< by multiple importance sampling
  Color unshadowed{0};
  bool shadow_ray = false;  ///< false: not needed
  Color visibility{0};      ///< fraction of the light that arrives
  Color contribution{0};
};

/// What ended a path at a vertex.
enum class PathEnd : std::uint8_t {
  none,         ///< it continues
  direct_only,  ///< only direct light is wanted
  max_depth,
  absorbed,  ///< the sampled direction reflects no light
  roulette,
};

/// A surface on a path. It adds throughput * emission, then throughput * light. The throughput of
/// the next vertex is throughput * next.weight / continuation.
struct PathVertex {
  Ray ray;                 ///< that led here; unit direction
  double start = 0;        ///< smallest t that counted on it
  double ray_density = 0;  ///< of its direction per solid angle; infinity: camera, mirror or glass
  double t = 0;            ///< on it
  std::uint32_t source = 0;  ///< RenderPrimitive::source of what it hit
  Shape shape = Shape::cube;
  Face face = Face::side;         ///< analytic shapes
  std::uint32_t mesh = no_index;  ///< meshes: into RenderScene::mesh_files
  PathPoint point;
  Color throughput{1};  ///< of the path before the vertex
  /// Emission: point.emission * emission_weight.
  Color emission{0};
  double emission_weight = 1;     ///< by multiple importance sampling, or 0
  double emission_density = 0;    ///< of light samples for this point, per solid angle; 0: none
  std::uint32_t first_light = 0;  ///< into PathRecord::lights
  std::uint32_t lights = 0;       ///< how many
  Color light{0};                 ///< sum of their contributions
  PathEnd end = PathEnd::none;
  BsdfSample next;          ///< if the end is not direct_only or max_depth
  double continuation = 1;  ///< probability of going on by roulette
};

/// direct: the sum of the terms that were reflected or refracted at most once, in order; indirect:
/// the sum of the others; light = direct + indirect, or direct + clamp * indirect.
struct PathRecord {
  glm::dvec2 point{0};  ///< of the picture, in pixels, y down
  glm::dvec2 lens{0};   ///< in apertures
  std::vector<PathVertex> vertices;
  std::vector<PathLight> lights;
  Ray last;              ///< if it `escaped`: the ray that hit nothing
  bool escaped = false;  ///< the background is black
  Color direct{0};
  Color indirect{0};
  double clamp = 1;
  Color light{0};
};

}  // namespace scenefile
