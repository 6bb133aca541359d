#include "trace/scalar_shade.h"

#include "scenefile/base/shape_traits.h"
#include "scenefile/trace/sequence.h"
#include "scenefile/trace/wavefront.h"
#include "trace/scalar_lights.h"
#include "trace/scalar_rays.h"

#include <algorithm>

namespace scenefile {

namespace {

// The fraction of each color of light that reaches the point.
Color visibility(const Tracer& tracer, const SurfacePoint& point, const Illumination& light,
                 ScalarCounts& counts) {
  if (!tracer.options.features.shadows || tracer.options.mode != Mode::ray) {
    return Color(1);
  }
  ++counts.shadow;
  const Ray ray{point.position, light.to_light};
  const double start = start_offset(tracer, point.position, point.hit.t);
  const double end = tracer.course() ? light.distance : light.distance * (1 - 1e-9);
  const Color left = tracer.accelerator.transmittance(ray, start, end, tracer.transmission);
  if (counts.recorder != nullptr) {
    counts.recorder->shadow(ray, start, end, left);
  }
  return left;
}

// The light that the point reflects from a light to the eye.
struct Reflector {
  const Tracer& tracer;
  const SurfacePoint& point;
  glm::dvec3 to_eye;
  Color diffuse;
  Color specular;

  double highlight_cosine(const glm::dvec3& to_light, double cosine) const {
    return glm::dot(2 * cosine * point.normal - to_light, to_eye);
  }

  Color lit_by(const Illumination& light, ScalarCounts& counts) const {
    const double cosine = glm::dot(point.normal, light.to_light);
    const Color diffused = diffuse * std::max(0.0, cosine);
    const double mirrored = highlight_cosine(light.to_light, cosine);
    Color shining(0);
    if (mirrored > 0 && point.material->shininess > 0) {
      shining = specular * highlight(mirrored, double(point.material->shininess));
    }
    const Color share = diffused + shining;
    const Color color =
        share == Color(0) ? share : share * light.color * visibility(tracer, point, light, counts);
    if (counts.recorder != nullptr) {
      counts.recorder->lit(light, cosine, mirrored, diffused, shining, color);
    }
    return color;
  }

  Color lit_by_area(const RenderLight& light, std::uint32_t index, const SampleKey& key,
                    ScalarCounts& counts) const {
    const bool grid = tracer.course();
    const std::uint32_t side = course_light_side;
    const std::uint32_t samples = grid ? side * side : key.light_samples;
    const PatternSeeds seeds = seeds_of(mixed_bits(key.pattern, 16 + index));
    Color sum(0);
    std::uint32_t lit = 0;
    for (std::uint32_t i = 0; i < samples; ++i) {
      const glm::dvec2 on_light =
          grid ? glm::dvec2(i % side + 0.5, i / side + 0.5) / double(side)
               : in_unit_square(pattern_point(key.sample * samples + i, seeds));
      Illumination arriving;
      if (illuminate(light, point.position, on_light, arriving)) {
        const Color color = lit_by(arriving, counts);
        lit += color == Color(0) ? 0 : 1;
        sum += color;
      }
    }
    counts.penumbras += lit != 0 && lit != samples ? 1 : 0;
    const Color color = sum / double(samples);
    if (counts.recorder != nullptr) {
      counts.recorder->light(index, samples, color);
    }
    return color;
  }

  Color lit_by_light(const RenderLight& light, std::uint32_t index, const SampleKey& key,
                     ScalarCounts& counts) const {
    if (has_rectangle(light.type)) {
      return lit_by_area(light, index, key, counts);
    }
    Illumination arriving;
    const bool arrives = illuminate(light, point.position, {0.5, 0.5}, arriving);
    const Color color = arrives ? lit_by(arriving, counts) : Color(0);
    if (counts.recorder != nullptr) {
      counts.recorder->light(index, 1, color);
    }
    return color;
  }
};

}  // namespace

Color shade(const Tracer& tracer, SurfacePoint& point, const glm::dvec3& direction,
            const PixelDerivatives& dp, const SampleKey& key, ScalarCounts& counts) {
  apply_bump(tracer, point, dp, key.texture_grid);
  const RenderGlobal& global = tracer.scene.global;
  const RenderMaterial& material = *point.material;
  const std::optional<Color> texture = texture_color(tracer, point, dp, key.texture_grid);
  if (counts.recorder != nullptr && texture) {
    counts.recorder->textured(tracer.assets.textures[material.texture.file], material,
                              point.object.uv, *texture);
  }
  const Reflector reflector{tracer, point, -direction, diffuse_color(tracer, material, texture),
                            double(global.specular) * Color(material.specular)};
  Color color = double(global.ambient) * Color(material.ambient);
  if (counts.recorder != nullptr) {
    counts.recorder->surface(point, color, reflector.diffuse, reflector.specular);
  }
  for (std::uint32_t i = 0; i < tracer.scene.lights.size(); ++i) {
    const RenderLight& light = tracer.scene.lights[i];
    if (tracer.uses(light)) {
      color += reflector.lit_by_light(light, i, key, counts);
    } else if (counts.recorder != nullptr) {
      counts.recorder->light_of_other_mode(i);
    }
  }
  return color;
}

}  // namespace scenefile
