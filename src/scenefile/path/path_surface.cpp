#include "scenefile/base/one_lane.h"
#include "scenefile/base/vector-inl.h"
#include "scenefile/geometry/surface-inl.h"
#include "scenefile/path/path_scene.h"
#include "scenefile/trace/camera-inl.h"
#include "scenefile/trace/footprint-inl.h"
#include "scenefile/trace/optics-inl.h"
#include "scenefile/trace/scene_geometry.h"
#include "scenefile/trace/surface_point.h"

#include <algorithm>
#include <array>

namespace scenefile {

namespace {

// The scene's surfaces and lights are those of mode ray. Textures need no mip maps, because many
// paths average them.
RenderOptions as_rays(RenderOptions options) {
  options.mode = Mode::ray;
  options.profile = Profile::fine;
  options.features = {};
  options.features.texture = false;
  return options;
}

// Meshes with face materials do not use the object's material, and cast full shadows.
Transmission transmission_of(const Tracer& tracer) {
  const RenderScene& scene = tracer.scene;
  std::vector<glm::dvec3> factors;
  for (const RenderMaterial& material : scene.materials) {
    factors.push_back(tracer.transparency(material));
  }
  for (const Group& group : tracer.accelerator.geometry().groups) {
    for (const Object& object : group.objects) {
      if (object.kind == ObjectKind::mesh && object.target < tracer.assets.mesh_materials.size() &&
          !tracer.assets.mesh_materials[object.target].of_triangle.empty()) {
        factors[object.material] = glm::dvec3(0);
      }
    }
  }
  return Transmission(factors);
}

glm::vec3 corner_of(const Mesh& mesh, std::uint32_t triangle, int corner) {
  return mesh.positions[mesh.triangles[triangle][corner]];
}

// The corners of a triangle in ascending order.
std::array<std::array<float, 3>, 3> corner_set(const Mesh& mesh, std::uint32_t triangle) {
  std::array<std::array<float, 3>, 3> corners;
  for (int i = 0; i < 3; ++i) {
    const glm::vec3 p = corner_of(mesh, triangle, i);
    corners[i] = {p.x, p.y, p.z};
  }
  std::sort(corners.begin(), corners.end());
  return corners;
}

void find_other_faces(const Assets& assets, const Lamps& lamps, PathScene& scene) {
  for (std::uint32_t m = 0; m < assets.mesh_materials.size(); ++m) {
    const Mesh& mesh = assets.meshes[m];
    const std::vector<std::uint32_t>& materials = assets.mesh_materials[m].of_triangle;
    const auto normal = [&](std::uint32_t t) { return surface_at(mesh, t, 0, 0, false).normal; };
    std::multimap<std::array<std::array<float, 3>, 3>, std::uint32_t> shining;
    for (std::uint32_t t = 0; t < materials.size(); ++t) {
      if (materials[t] != mesh_no_index && lamps.density(m, materials[t]) > 0) {
        shining.emplace(corner_set(mesh, t), t);
      }
    }
    for (std::uint32_t t = 0; t < materials.size() && !shining.empty(); ++t) {
      const auto [first, last] = shining.equal_range(corner_set(mesh, t));
      for (auto other = first; other != last; ++other) {
        if (glm::dot(normal(t), normal(other->second)) < 0) {
          scene.other_faces[{m, t}] = other->second;
        }
      }
    }
  }
}

// The same point on another triangle with the same corners.
Hit on_triangle(const Mesh& mesh, std::uint32_t triangle, const Hit& hit) {
  const double weights[3] = {1 - hit.b1 - hit.b2, hit.b1, hit.b2};
  Hit result = hit;
  result.triangle = triangle;
  for (int i = 0; i < 3; ++i) {
    const glm::vec3 corner = corner_of(mesh, hit.triangle, i);
    if (corner == corner_of(mesh, triangle, 1)) {
      result.b1 = weights[i];
    } else if (corner == corner_of(mesh, triangle, 2)) {
      result.b2 = weights[i];
    }
  }
  return result;
}

SurfacePoint visible_surface(const PathScene& scene, const Ray& ray, const Hit& hit) {
  const Tracer& tracer = scene.tracer;
  const SurfacePoint point = surface_point(tracer.scene, tracer.assets, ray, hit, true);
  if (scene.other_faces.empty() || hit.mesh == no_index ||
      glm::dot(point.geometric, ray.direction) <= 0) {
    return point;
  }
  const auto other = scene.other_faces.find({hit.mesh, hit.triangle});
  return other == scene.other_faces.end()
             ? point
             : surface_point(tracer.scene, tracer.assets, ray,
                             on_triangle(tracer.assets.meshes[hit.mesh], other->second, hit), true);
}

const FaceMaterial* face_material(const Assets& assets, const Hit& hit, std::uint32_t& index) {
  index = mesh_no_index;
  if (hit.mesh >= assets.mesh_materials.size()) {
    return nullptr;
  }
  const MeshMaterials& mesh = assets.mesh_materials[hit.mesh];
  index = mesh.of_triangle.empty() ? mesh_no_index : mesh.of_triangle[hit.triangle];
  return index == mesh_no_index ? nullptr : &mesh.materials[index];
}

Bsdf bsdf_of(const Tracer& tracer, const FaceMaterial& material, const glm::dvec2& uv) {
  Bsdf bsdf;
  bsdf.shininess = material.shininess;
  bsdf.ior = material.ior;
  if (material.illum == illum_glass) {
    bsdf.glass = Color(1);
    return bsdf;
  }
  const Color specular =
      Color(material.specular) * map_color(tracer.assets, material.specular_map, uv);
  if (material.illum == illum_mirror) {
    bsdf.mirror = specular;
    return bsdf;
  }
  bsdf.diffuse = Color(material.diffuse) * map_color(tracer.assets, material.diffuse_map, uv);
  bsdf.glossy = specular;
  return bsdf;
}

// kd * Cd, or the texture blended over it.
Color diffuse_color(const Tracer& tracer, const SurfacePoint& point) {
  const RenderMaterial& material = *point.material;
  const Color plain = double(tracer.scene.global.diffuse) * Color(material.diffuse);
  if (!material.texture.used() || material.blend == 0 ||
      tracer.assets.textures[material.texture.file].empty()) {
    return plain;
  }
  const Texture& texture = tracer.assets.textures[material.texture.file];
  return glm::mix(plain, lookup_smooth(texture, material.texture, point.object.uv),
                  double(material.blend));
}

// Replaces the shading normal by that of the bump map.
void apply_bump(const Tracer& tracer, SurfacePoint& point) {
  const RenderTexture& map = point.material->bump_map;
  if (!map.used() || !point.has_uv || tracer.assets.textures[map.file].empty()) {
    return;
  }
  const Texture& texture = tracer.assets.textures[map.file];
  const Surface& s = point.object;
  bool bumped = true;
  const one::V3 normal = one::bumped_normal(
      {one::splat3(s.normal), s.uv.x, s.uv.y, one::splat3(s.tangent_u), one::splat3(s.tangent_v)},
      {0, 0}, {0, 0}, double(map.repeat_u) * texture.width, double(map.repeat_v) * texture.height,
      bumped, [&](double u, double v, bool) {
        return one::splat3(lookup_smooth(texture, map, {u, v}));
      });
  if (bumped) {
    point.normal = world_normal(point.hit.object_from_world, {normal.x, normal.y, normal.z});
  }
}

// The object's own material, whose coefficients are those of the lighting equation.
Bsdf bsdf_of(const Tracer& tracer, const SurfacePoint& point) {
  const RenderMaterial& material = *point.material;
  const double specular = tracer.scene.global.specular;
  Bsdf bsdf;
  const auto positive = [](const Color& c) { return glm::max(c, Color(0)); };
  bsdf.diffuse = positive(diffuse_color(tracer, point));
  bsdf.shininess = material.shininess;
  bsdf.glossy = positive(material.shininess > 0 ? specular * Color(material.specular) : Color(0));
  bsdf.mirror = positive(specular * Color(material.reflective));
  bsdf.glass = positive(tracer.transparency(material));
  bsdf.ior = material.ior;
  return bsdf;
}

}  // namespace

PathScene::PathScene(const TraceScene& traced, const RenderScene& scene, const RenderOptions& o)
    : tracer(traced, scene, as_rays(o)),
      options(in_range(o)),
      camera(tracer.camera()),
      transmission(transmission_of(tracer)),
      lamps(tracer.accelerator.geometry(), tracer.assets) {
  find_other_faces(tracer.assets, lamps, *this);
}

PathPoint path_point(const PathScene& scene, const Ray& ray, const Hit& ray_hit) {
  const Tracer& tracer = scene.tracer;
  SurfacePoint surface = visible_surface(scene, ray, ray_hit);
  const Hit& hit = surface.hit;
  PathPoint point;
  point.position = surface.position;
  point.offset = one::fine_offset(one::splat3(point.position), hit.t);
  point.triangle = hit.triangle;
  const FaceMaterial* const material = face_material(tracer.assets, hit, point.material);
  if (material == nullptr) {
    apply_bump(tracer, surface);
    point.bsdf = bsdf_of(tracer, surface);
  } else {
    point.bsdf = bsdf_of(tracer, *material, surface.object.uv);
    if (material->emission != glm::vec3(0) && glm::dot(surface.geometric, ray.direction) < 0) {
      point.emission = Color(material->emission) *
                       map_color(tracer.assets, material->emission_map, surface.object.uv);
      point.lamp_density = scene.lamps.density(hit.mesh, point.material);
    }
  }
  if (scene.options.convention == Convention::course &&
      luminance(point.bsdf.glossy) > luminance(point.bsdf.diffuse)) {
    point.bsdf.diffuse = Color(0);
  }
  point.facing = facing_of(surface.normal, surface.geometric, -ray.direction);
  point.facing.outside = point.facing.outside || scene.always_enters;
  return point;
}

}  // namespace scenefile
