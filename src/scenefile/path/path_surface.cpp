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
#include <utility>
#include <vector>

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
  std::vector<bool> opaque;
  for (const MeshMaterials& mesh : tracer.assets.mesh_materials) {
    opaque.push_back(!mesh.of_triangle.empty());
  }
  return Transmission(factors, std::move(opaque));
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

Bsdf bsdf_of(const PathScene& scene, const FaceMaterial& material, const glm::dvec2& uv) {
  const Tracer& tracer = scene.tracer;
  Bsdf bsdf;
  bsdf.shininess = material.shininess;
  bsdf.ior = material.ior;
  const bool is_glass = material.illum == illum_glass;
  const bool is_mirror = material.illum == illum_mirror;
  bsdf.glass = Color(is_glass ? 1 : 0);
  if (is_glass && !scene.shaded_glass) {
    return bsdf;
  }
  const Color specular =
      Color(material.specular) * map_color(tracer.assets, material.specular_map, uv);
  bsdf.mirror = is_mirror ? specular : Color(0);
  if (is_mirror && !scene.shaded_mirrors) {
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

// The shading normal, or that of the bump map.
glm::dvec3 bumped_normal(const Tracer& tracer, const SurfacePoint& point) {
  const RenderTexture& map = point.material->bump_map;
  if (!map.used() || !point.has_uv || tracer.assets.textures[map.file].empty()) {
    return point.normal;
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
  return bumped ? world_normal(point.hit.object_from_world, {normal.x, normal.y, normal.z})
                : point.normal;
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
      lamps(tracer.accelerator.geometry(), tracer.assets) {}

PathPoint path_point(const PathScene& scene, const Ray& ray, Hit& hit) {
  const Tracer& tracer = scene.tracer;
  const double lamp_density = scene.lamps.reveal(ray, hit);
  const SurfacePoint surface = surface_point(tracer.scene, tracer.assets, ray, hit, true);
  glm::dvec3 normal = surface.normal;
  PathPoint point;
  point.position = surface.position;
  point.offset = one::fine_offset(one::splat3(point.position), hit.t);
  point.triangle = hit.triangle;
  const FaceMaterial* const material = face_material(tracer.assets, hit, point.material);
  if (material == nullptr) {
    normal = bumped_normal(tracer, surface);
    point.bsdf = bsdf_of(tracer, surface);
  } else {
    point.bsdf = bsdf_of(scene, *material, surface.object.uv);
    if (material->emission != glm::vec3(0) && glm::dot(surface.geometric, ray.direction) < 0) {
      point.emission = Color(material->emission) *
                       map_color(tracer.assets, material->emission_map, surface.object.uv);
      point.lamp_density = std::max(lamp_density, scene.lamps.density(hit.mesh, point.material));
    }
  }
  if (scene.options.convention == Convention::course &&
      luminance(point.bsdf.glossy) > luminance(point.bsdf.diffuse)) {
    point.bsdf.diffuse = Color(0);
  }
  point.facing = facing_of(normal, surface.normal, surface.geometric, -ray.direction);
  point.facing.outside = point.facing.outside || scene.always_enters;
  return point;
}

}  // namespace scenefile
