#include "trace/scalar_surface.h"

#include "scenefile/base/one_lane.h"
#include "scenefile/base/vector-inl.h"
#include "scenefile/geometry/surface-inl.h"
#include "scenefile/trace/camera-inl.h"
#include "scenefile/trace/footprint-inl.h"

#include <algorithm>
#include <cmath>

namespace scenefile {

namespace {

using one::splat3;

int wrap(double index, int size) {
  const double wrapped = index - size * std::floor(index / size);
  return std::clamp(static_cast<int>(wrapped), 0, size - 1);
}

glm::dvec3 texel(const Texture& texture, int x, int y) {
  const std::uint8_t* p = texture.texel(x, y);
  return glm::dvec3(p[0], p[1], p[2]) / 255.0;
}

// Interpolates the four texels around p; texel centers are at integer positions.
glm::dvec3 bilinear(const Texture& texture, const glm::dvec2& p) {
  const glm::dvec2 low = glm::floor(p);
  const glm::dvec2 f = p - low;
  const int x0 = wrap(low.x, texture.width);
  const int y0 = wrap(low.y, texture.height);
  const int x1 = x0 + 1 == texture.width ? 0 : x0 + 1;
  const int y1 = y0 + 1 == texture.height ? 0 : y0 + 1;
  const glm::dvec3 top = glm::mix(texel(texture, x0, y0), texel(texture, x1, y0), f.x);
  const glm::dvec3 bottom = glm::mix(texel(texture, x0, y1), texel(texture, x1, y1), f.x);
  return glm::mix(top, bottom, f.y);
}

// A texture with the interface for filtered(), for one lane.
struct OneTexture {
  const MipMap& mip_map;

  double levels() const { return mip_map.levels(); }

  one::V3 smooth(double level, bool wanted, double x, double y) const {
    if (!wanted) {
      return {0, 0, 0};
    }
    const Texture& base = mip_map.level(0);
    const Texture& texture = mip_map.level(static_cast<int>(level));
    return one::bilinear(
        texture.width, texture.height, x * (double(texture.width) / base.width) - 0.5,
        y * (double(texture.height) / base.height) - 0.5, [&](double column, double row) {
          return one::splat3(texel(texture, static_cast<int>(column), static_cast<int>(row)));
        });
  }
};

double number_of(Shape shape) {
  return static_cast<int>(shape);
}
double number_of(Face face) {
  return static_cast<int>(face);
}

glm::dvec2 uv_derivative(const SurfacePoint& point, const glm::dvec3& world_step) {
  const glm::dvec3 step = point.hit.object_from_world.linear * world_step;
  const one::UvDerivative uv =
      point.hit.shape == Shape::mesh
          ? one::mesh_uv_derivative(splat3(point.object.tangent_u), splat3(point.object.tangent_v),
                                    splat3(step))
          : one::shape_uv_derivative(number_of(point.hit.shape), number_of(point.hit.face),
                                     splat3(point.hit.object_point), splat3(step));
  return {uv.u, uv.v};
}

}  // namespace

UvFootprint uv_footprint(const SurfacePoint& point, const PixelDerivatives& dp) {
  if (!point.has_uv) {
    return {};
  }
  return {uv_derivative(point, dp.dx), uv_derivative(point, dp.dy)};
}

glm::dvec3 lookup_course_filter(const Texture& texture, const RenderTexture& use,
                                const glm::dvec2& uv) {
  return bilinear(
      texture, {uv.x * use.repeat_u * texture.width, (1 - uv.y) * use.repeat_v * texture.height});
}

glm::dvec3 lookup_filtered(const MipMap& mip_map, const RenderTexture& use, const glm::dvec2& uv,
                           const UvFootprint& footprint, int grid) {
  const Texture& base = mip_map.level(0);
  const one::V3 color =
      one::filtered(OneTexture{mip_map}, one::texel_x(uv.x, use.repeat_u, base.width),
                    one::texel_y(uv.y, use.repeat_v, base.height),
                    one::texel_footprint({footprint.right.x, footprint.right.y},
                                         {footprint.down.x, footprint.down.y}, use.repeat_u,
                                         use.repeat_v, base.width, base.height),
                    grid, true);
  return {color.x, color.y, color.z};
}

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
