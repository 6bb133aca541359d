#include "scene_laws.h"

#include "law.h"

#include <algorithm>
#include <cmath>

namespace scenefile::fuzz {

namespace {

template <typename Vector>
bool finite(const Vector& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

template <typename Vector>
bool unit(const Vector& v) {
  return finite(v) && std::abs(glm::dot(glm::dvec3(v), glm::dvec3(v)) - 1) < 1e-5;
}

void require_material(const RenderScene& scene, const RenderMaterial& material) {
  require(finite(material.ambient) && finite(material.diffuse) && finite(material.specular) &&
              finite(material.reflective) && finite(material.transparent) &&
              std::isfinite(material.shininess) && std::isfinite(material.blend),
          "materials are finite");
  require(material.ior > 0 && std::isfinite(material.ior), "indices of refraction are positive");
  for (const RenderTexture& texture : {material.texture, material.bump_map}) {
    require(!texture.used() || (texture.file < scene.texture_files.size() &&
                                std::isfinite(texture.repeat_u) && std::isfinite(texture.repeat_v)),
            "textures are usable");
  }
}

void require_light(const RenderLight& light) {
  require(finite(light.color) && finite(light.position) && finite(light.half_u) &&
              finite(light.half_v) && finite(light.attenuation),
          "lights are finite");
  require(light.type == LightType::point || unit(light.direction), "lights have a direction");
  require(light.inner_angle >= 0 && light.outer_angle >= light.inner_angle, "cones are in order");
  require(light.attenuation.x >= 0 && light.attenuation.y >= 0 && light.attenuation.z >= 0 &&
              light.attenuation != glm::vec3(0),
          "attenuation is positive");
}

void require_camera(const RenderCamera& camera) {
  require(finite(camera.position), "the camera has a position");
  require(unit(camera.u) && unit(camera.v) && unit(camera.w), "camera axes are unit vectors");
  require(std::abs(glm::dot(camera.u, camera.v)) < 1e-6 &&
              std::abs(glm::dot(camera.u, camera.w)) < 1e-6 &&
              std::abs(glm::dot(camera.v, camera.w)) < 1e-6,
          "camera axes are perpendicular");
  require(camera.fov_y > 0 && camera.fov_y < 3.14159265358979, "the angle of view is possible");
  require(camera.aperture >= 0 && camera.focal_length >= 0 && std::isfinite(camera.aperture) &&
              std::isfinite(camera.focal_length),
          "the lens is possible");
}

}  // namespace

void require_safe(const Prepared& prepared, const Limits& limits) {
  const RenderScene& scene = prepared.scene;
  require(scene.root < scene.groups.size(), "there is a root");
  require(scene.lights.size() <= limits.lights, "lights are bounded");
  for (std::size_t g = 0; g < scene.groups.size(); ++g) {
    for (const RenderPrimitive& primitive : scene.groups[g].primitives) {
      require(primitive.material < scene.materials.size(), "materials exist");
      require(primitive.source < prepared.sources.size(), "sources of primitives exist");
      require(primitive.shape != Shape::mesh || primitive.mesh < scene.mesh_files.size(),
              "meshes exist");
      require(invertible(DAffine(primitive.group_from_object)), "primitives can be placed");
    }
    for (const RenderInstance& instance : scene.groups[g].instances) {
      require(instance.group < g, "groups come after those that they contain");
      require(instance.source < prepared.sources.size(), "sources of instances exist");
      require(invertible(DAffine(instance.group_from_instance)), "instances can be placed");
    }
  }
  for (const RenderLight& light : scene.lights) {
    require(light.source < prepared.sources.size(), "sources of lights exist");
  }
}

void require_valid(const Prepared& prepared, const Limits& limits) {
  require_safe(prepared, limits);
  const RenderScene& scene = prepared.scene;
  require(std::isfinite(scene.global.ambient) && std::isfinite(scene.global.diffuse) &&
              std::isfinite(scene.global.specular) &&
              std::isfinite(scene.global.transparent.value_or(0)),
          "coefficients are finite");
  require_camera(scene.camera);
  std::for_each(scene.lights.begin(), scene.lights.end(), require_light);
  for (const RenderMaterial& material : scene.materials) {
    require_material(scene, material);
  }
  require(instance_nesting(scene) <= limits.instance_nesting, "instance nesting is bounded");
}

}  // namespace scenefile::fuzz
