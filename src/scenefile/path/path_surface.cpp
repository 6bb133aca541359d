#include "scenefile/base/one_lane.h"
#include "scenefile/base/vector-inl.h"
#include "scenefile/path/path_scene.h"
#include "scenefile/trace/optics-inl.h"
#include "scenefile/trace/parts.h"
#include "scenefile/trace/surface_color.h"

namespace scenefile {

namespace {

constexpr int illum_mirror = 5;
constexpr int illum_glass = 7;

// The scene's surfaces, lights and textures are those of mode ray.
RenderOptions as_rays(RenderOptions options) {
  options.mode = Mode::ray;
  options.profile = Profile::fine;
  options.features = {};
  return options;
}

// Meshes with face materials do not use the object's material, and cast full shadows.
Transmission transmission_of(const Tracer& tracer) {
  const RenderScene& scene = tracer.scene;
  std::vector<glm::dvec3> factors;
  for (const RenderMaterial& material : scene.materials) {
    factors.push_back(tracer.transparency(material));
  }
  for (const Group& group : tracer.accelerator.parts().groups) {
    for (const Part& part : group.parts) {
      if (part.kind == PartKind::mesh && part.target < tracer.assets.mesh_materials.size() &&
          !tracer.assets.mesh_materials[part.target].of_triangle.empty()) {
        factors[part.material] = glm::dvec3(0);
      }
    }
  }
  return Transmission(factors);
}

const FaceMaterial* face_material(const Assets& assets, const Hit& hit, std::uint32_t& index) {
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
      Color(material.specular) * map_color(tracer.pyramids, material.specular_map, uv);
  if (material.illum == illum_mirror) {
    bsdf.mirror = specular;
    return bsdf;
  }
  bsdf.diffuse = Color(material.diffuse) * map_color(tracer.pyramids, material.diffuse_map, uv);
  bsdf.glossy = specular;
  return bsdf;
}

// The object's own material, whose coefficients are those of the lighting equation.
Bsdf bsdf_of(const Tracer& tracer, const SurfacePoint& point) {
  const RenderMaterial& material = *point.material;
  const double specular = tracer.scene.global.specular;
  Bsdf bsdf;
  bsdf.diffuse = diffuse_color(tracer, material, texture_color(tracer, point, {}, 1));
  bsdf.shininess = material.shininess;
  bsdf.glossy = material.shininess > 0 ? specular * Color(material.specular) : Color(0);
  bsdf.mirror = specular * Color(material.reflective);
  bsdf.glass = tracer.transparency(material);
  bsdf.ior = material.ior;
  return bsdf;
}

}  // namespace

PathScene::PathScene(const TraceScene& traced, const RenderScene& scene, const RenderOptions& o)
    : tracer(traced, scene, as_rays(o)),
      options(in_range(o)),
      camera(tracer.camera()),
      transmission(transmission_of(tracer)),
      lamps(tracer.accelerator.parts(), tracer.assets, tracer.pyramids) {}

PathPoint path_point(const PathScene& scene, const Ray& ray, const Hit& hit) {
  const Tracer& tracer = scene.tracer;
  SurfacePoint surface = surface_point(tracer.scene, tracer.assets, ray, hit, true);
  PathPoint point;
  point.position = surface.position;
  point.offset = one::fine_offset(one::splat3(point.position), hit.t);
  std::uint32_t index = 0;
  const FaceMaterial* const material = face_material(tracer.assets, hit, index);
  if (material == nullptr) {
    apply_bump(tracer, surface, {}, 1);
    point.bsdf = bsdf_of(tracer, surface);
  } else {
    point.bsdf = bsdf_of(tracer, *material, surface.object.uv);
    if (material->emission != glm::vec3(0) && glm::dot(surface.geometric, ray.direction) < 0) {
      point.emission = Color(material->emission) *
                       map_color(tracer.pyramids, material->emission_map, surface.object.uv);
      point.lamp_density = scene.lamps.density(hit.mesh, index);
    }
  }
  if (scene.options.lobe == Lobe::course &&
      luminance(point.bsdf.glossy) > luminance(point.bsdf.diffuse)) {
    point.bsdf.diffuse = Color(0);
  }
  point.facing = facing_of(surface.normal, surface.geometric, -ray.direction);
  return point;
}

}  // namespace scenefile
