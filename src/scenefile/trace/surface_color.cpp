#include "scenefile/trace/surface_color.h"

#include "scenefile/base/shape_traits.h"

#include <algorithm>
#include <cmath>

namespace scenefile {

namespace {

// The height of white above black, in object space units.
constexpr double bump_height = 1.0 / 16;

double height(const Pyramid& map, const RenderTexture& use, const glm::dvec2& uv,
              const UvFootprint& footprint) {
  const glm::dvec3 color = lookup_filtered(map, use, uv, footprint);
  return bump_height * (color.x + color.y + color.z) / 3;
}

// The largest extent of the footprint along one coordinate.
double reach(const UvFootprint& footprint, int coordinate) {
  const double size =
      std::max(std::abs(footprint.right[coordinate]), std::abs(footprint.down[coordinate]));
  return std::isfinite(size) ? std::min(size, 0.25) : 0.25;
}

// The shading normal (world space, unit length) of a surface displaced along its normal by
// bump_height times the mean of red, green and blue. Slopes are central differences over one texel,
// or over the footprint if that is wider.
glm::dvec3 bumped_normal(const SurfacePoint& point, const Pyramid& map,
                         const UvFootprint& footprint) {
  const RenderTexture& use = point.material->bump_map;
  const Surface& s = point.object;
  const double area = glm::dot(glm::cross(s.tangent_u, s.tangent_v), s.normal);
  const double flat = 1e-12 * glm::length(s.tangent_u) * glm::length(s.tangent_v);
  if (!(std::abs(area) > flat) || use.repeat_u == 0 || use.repeat_v == 0) {
    return point.normal;
  }
  const Texture& texture = map.level(0);
  const double du =
      std::max(1 / std::abs(double(use.repeat_u) * texture.width), reach(footprint, 0));
  const double dv =
      std::max(1 / std::abs(double(use.repeat_v) * texture.height), reach(footprint, 1));
  const auto slope = [&](const glm::dvec2& step, double size) {
    return (height(map, use, s.uv + step, footprint) - height(map, use, s.uv - step, footprint)) /
           (2 * size);
  };
  const double slope_u = slope({du, 0}, du);
  const double slope_v = slope({0, dv}, dv);
  const glm::dvec3 gradient =
      (slope_u * glm::cross(s.tangent_v, s.normal) + slope_v * glm::cross(s.normal, s.tangent_u)) /
      area;
  return world_normal(point.hit.object_from_world, s.normal - gradient);
}

}  // namespace

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
