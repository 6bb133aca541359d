#include "trace/scalar_surface.h"

#include "scenefile/base/one_lane.h"
#include "scenefile/base/vector-inl.h"
#include "scenefile/geometry/surface-inl.h"
#include "scenefile/trace/camera-inl.h"
#include "scenefile/trace/footprint-inl.h"

namespace scenefile {

namespace {

using one::splat3;

// Interpolates the four texels around (x, y); the centers of texels are at integer positions.
one::V3 bilinear(const Texture& texture, double x, double y) {
  return one::bilinear(texture.width, texture.height, x, y, [&](double column, double row) {
    const std::uint8_t* p = texture.texel(static_cast<int>(column), static_cast<int>(row));
    return one::V3{p[0] / 255.0, p[1] / 255.0, p[2] / 255.0};
  });
}

glm::dvec3 as_vector(const one::V3& v) {
  return {v.x, v.y, v.z};
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
    return bilinear(texture, x * (double(texture.width) / base.width) - 0.5,
                    y * (double(texture.height) / base.height) - 0.5);
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
  return as_vector(bilinear(texture, one::texel_x(uv.x, use.repeat_u, texture.width),
                            one::texel_y(uv.y, use.repeat_v, texture.height)));
}

glm::dvec3 lookup_filtered(const MipMap& mip_map, const RenderTexture& use, const glm::dvec2& uv,
                           const UvFootprint& footprint, int grid) {
  const Texture& base = mip_map.level(0);
  return as_vector(
      one::filtered(OneTexture{mip_map}, one::texel_x(uv.x, use.repeat_u, base.width),
                    one::texel_y(uv.y, use.repeat_v, base.height),
                    one::texel_footprint({footprint.right.x, footprint.right.y},
                                         {footprint.down.x, footprint.down.y}, use.repeat_u,
                                         use.repeat_v, base.width, base.height),
                    grid, true));
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
    point.normal = world_normal(point.hit.object_from_world, as_vector(normal));
  }
}

}  // namespace scenefile
