#include "scenefile/path/surface_color.h"

#include "scenefile/base/one_lane.h"
#include "scenefile/base/vector-inl.h"
#include "scenefile/geometry/surface-inl.h"
#include "scenefile/trace/camera-inl.h"
#include "scenefile/trace/footprint-inl.h"

namespace scenefile {

using one::splat3;

std::optional<Color> texture_color(const Tracer& tracer, const SurfacePoint& point,
                                   const PixelDerivatives& dp, int grid) {
  const RenderMaterial& material = *point.material;
  const bool textured = tracer.options.mode == Mode::ray && tracer.options.features.texture &&
                        material.texture.used() && material.blend != 0;
  if (!textured || tracer.assets.textures[material.texture.file].empty()) {
    return std::nullopt;
  }
  const Texture& texture = tracer.assets.textures[material.texture.file];
  const glm::dvec2& uv = point.object.uv;
  if (!tracer.options.features.texture_filter) {
    return lookup_nearest(texture, material.texture, uv);
  }
  if (tracer.course()) {
    return lookup_course_filter(texture, material.texture, uv);
  }
  return lookup_filtered(tracer.mip_maps[material.texture.file], material.texture, uv,
                         uv_footprint(point, dp), grid);
}

Color diffuse_color(const Tracer& tracer, const RenderMaterial& material,
                    const std::optional<Color>& texture) {
  const Color plain = double(tracer.scene.global.diffuse) * Color(material.diffuse);
  return texture ? glm::mix(plain, *texture, double(material.blend)) : plain;
}

void apply_bump(const Tracer& tracer, SurfacePoint& point, const PixelDerivatives& dp, int grid) {
  const RenderTexture& map = point.material->bump_map;
  if (!map.used() || !point.has_uv || tracer.mip_maps.empty() ||
      tracer.mip_maps[map.file].empty()) {
    return;
  }
  const MipMap& mip_map = tracer.mip_maps[map.file];
  UvFootprint footprint = uv_footprint(point, dp);
  footprint.right /= grid;
  footprint.down /= grid;
  const Surface& s = point.object;
  bool bumped = true;
  const one::V3 normal = one::bumped_normal(
      {splat3(s.normal), s.uv.x, s.uv.y, splat3(s.tangent_u), splat3(s.tangent_v)},
      {footprint.right.x, footprint.right.y}, {footprint.down.x, footprint.down.y},
      double(map.repeat_u) * mip_map.level(0).width, double(map.repeat_v) * mip_map.level(0).height,
      bumped, [&](double u, double v, bool) {
        return splat3(lookup_filtered(mip_map, map, {u, v}, footprint));
      });
  if (bumped) {
    point.normal = world_normal(point.hit.object_from_world, {normal.x, normal.y, normal.z});
  }
}

}  // namespace scenefile
