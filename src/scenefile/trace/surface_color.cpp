#include "scenefile/trace/surface_color.h"

#include "scenefile/base/shape_traits.h"
#include "scenefile/trace/bump.h"

namespace scenefile {

std::optional<Color> texture_color(const Tracer& tracer, const SurfacePoint& point,
                                   const PixelSteps& steps, int grid) {
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
  return lookup_filtered(tracer.pyramids[material.texture.file], material.texture, uv,
                         uv_footprint(point, steps), grid);
}

Color diffuse_color(const Tracer& tracer, const RenderMaterial& material,
                    const std::optional<Color>& texture) {
  const Color plain = double(tracer.scene.global.diffuse) * Color(material.diffuse);
  return texture ? glm::mix(plain, *texture, double(material.blend)) : plain;
}

void apply_bump(const Tracer& tracer, SurfacePoint& point, const PixelSteps& steps, int grid) {
  const RenderTexture& map = point.material->bump_map;
  if (!map.used() || !point.has_uv || tracer.pyramids.empty() ||
      tracer.pyramids[map.file].empty()) {
    return;
  }
  UvFootprint footprint = uv_footprint(point, steps);
  footprint.right /= grid;
  footprint.down /= grid;
  point.normal = bumped_normal(point, tracer.pyramids[map.file], footprint);
}

bool shines_in(const Tracer& tracer, const RenderLight& light) {
  return !(tracer.options.mode == Mode::intersect && tracer.course()) ||
         is_in_intersect(light.type);
}

}  // namespace scenefile
