#include "scenefile/explain/remarks.h"

#include "scenefile/base/components.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace scenefile {

namespace {

// A shadow ray that hits its own mesh within this distance has not left the surface.
constexpr double acne_distance = 1e-2;

constexpr double half_step = 0.5 / 255;

class Remarks {
 public:
  Remarks(const RenderScene& scene, const PixelRecord& pixel) : scene_(scene), pixel_(pixel) {}

  std::vector<Remark> all() {
    if (pixel_.options.mode == Mode::normals) {
      return {};
    }
    for (index_ = 0; index_ < pixel_.rays.size(); ++index_) {
      const RayRecord& ray = pixel_.rays[index_];
      about_way(ray);
      if (ray.surface.has_value()) {
        about_surface(*ray.surface);
        about_branches(ray);
        for (const LightRecord& light : ray.lights) {
          about_light(*ray.surface, light);
        }
      }
    }
    return std::move(list_);
  }

 private:
  void add(RemarkKind kind, std::string text, std::uint32_t light = no_index) {
    Remark& remark = list_.emplace_back();
    remark = {kind, index_, light, std::move(text)};
  }

  const RenderMaterial& material(const SurfaceRecord& s) const {
    return scene_.materials[s.material];
  }

  void about_way(const RayRecord& ray) {
    const bool mirrored = std::any_of(ray.walls.begin(), ray.walls.end(),
                                      [](const WallRecord& w) { return w.mirrored; });
    if (ray.total_reflection || mirrored) {
      add(RemarkKind::total_reflection,
          "total internal reflection: the angle is too flat for Snell's law, the ray is mirrored");
    }
    if (ray.trapped) {
      add(RemarkKind::trapped, fmt::format("mirrored inside the object until --max-depth {}: black",
                                           pixel_.options.max_depth));
    }
    const bool final_sum = pixel_.options.profile == Profile::course || index_ == 0;
    if (final_sum && largest(ray.sum) > 1) {
      add(RemarkKind::clamped,
          pixel_.options.profile == Profile::course
              ? "the sum exceeds 1 and is clamped before it is used"
              : "the sum exceeds 1; it is clamped when the picture is written");
    }
  }

  void about_surface(const SurfaceRecord& s) {
    const double facing = -glm::dot(s.geometric, s.ray.direction);
    const double shading = -glm::dot(s.normal, s.ray.direction);
    if (facing < 0) {
      add(RemarkKind::seen_from_behind,
          fmt::format("the normal points away from the viewer (N.V = {:.4g}): the surface is seen "
                      "from inside or behind; normals are never flipped",
                      facing));
    }
    if (facing * shading < 0) {
      add(RemarkKind::normal_past_horizon,
          "the interpolated or bumped normal points to the other side of the surface");
    }
    const RenderMaterial& m = material(s);
    if (s.specular_color != Color(0) && m.shininess <= 0) {
      add(RemarkKind::no_shininess, "specular without shininess: no highlight");
    }
    about_texture(s, m);
  }

  void about_texture(const SurfaceRecord& s, const RenderMaterial& m) {
    const bool textures = pixel_.options.mode == Mode::ray && pixel_.options.features.texture;
    if (!textures || !m.texture.used()) {
      return;
    }
    if (m.blend == 0) {
      add(RemarkKind::texture_hidden,
          "the material has a texture, but blend is 0: it is not visible");
    } else if (!s.texture.has_value()) {
      add(RemarkKind::texture_missing,
          "the texture could not be loaded: the diffuse color is used instead");
    }
  }

  void about_branches(const RayRecord& ray) {
    const RenderMaterial& m = material(*ray.surface);
    const bool glass = pixel_.options.mode == Mode::ray && pixel_.options.features.refract &&
                       m.transparent != glm::vec3(0);
    if (glass && ray.glass.factor == Color(0)) {
      add(RemarkKind::no_transparent_share,
          "the material is transparent, but transparentcoeff is 0 or missing: nothing is "
          "refracted");
    }
    about_outcome("reflected", ray.mirror.outcome);
    about_outcome("refracted", ray.glass.outcome);
  }

  void about_outcome(std::string_view ray, BranchOutcome outcome) {
    switch (outcome) {
      case BranchOutcome::absent:
      case BranchOutcome::followed:
        break;
      case BranchOutcome::too_deep:
        add(RemarkKind::too_deep, fmt::format("the {} ray is not followed: --max-depth {}", ray,
                                              pixel_.options.max_depth));
        break;
      case BranchOutcome::too_faint:
        add(RemarkKind::too_faint,
            fmt::format("the {} ray is not followed: it cannot change the pixel by 1/1024", ray));
        break;
      case BranchOutcome::too_many:
        add(RemarkKind::too_many,
            fmt::format("the {} ray is not followed: the sample has used up its rays", ray));
        break;
    }
  }

  void about_light(const SurfaceRecord& s, const LightRecord& record) {
    const std::uint32_t light = record.light;
    if (record.unlit == Unlit::in_this_mode) {
      add(RemarkKind::light_of_another_mode,
          pixel_.options.mode == Mode::intersect
              ? "the course's ray caster only uses directional lights"
              : "this milestone does not use lights of this type",
          light);
    } else if (record.unlit == Unlit::out_of_reach) {
      add(RemarkKind::light_out_of_reach, reach_text(scene_.lights[light], s.position), light);
    }
    if (record.samples.empty()) {
      return;
    }
    // One remark for all samples of an area light, judged by the first.
    const LightSample& sample = record.samples.front();
    if (sample.n_dot_l <= 0) {
      const bool highlight = largest(sample.specular * sample.color) >= half_step;
      add(highlight ? RemarkKind::highlight_from_behind : RemarkKind::light_behind,
          highlight ? "the light is behind the surface, yet its highlight counts: the equation "
                      "only requires R.V > 0"
                    : fmt::format("the surface faces away (N.L = {:.4g}): no diffuse light",
                                  sample.n_dot_l),
          light);
    }
    if (sample.attenuation * largest(Color(scene_.lights[light].color)) < half_step) {
      add(RemarkKind::light_faded,
          fmt::format("attenuation leaves {:.3g} of the light", sample.attenuation), light);
    }
    about_shadow(s, record);
  }

  static std::string reach_text(const RenderLight& light, const glm::dvec3& point) {
    switch (light.type) {
      case LightType::spot: {
        const glm::dvec3 way = glm::normalize(point - glm::dvec3(light.position));
        const double cosine = glm::dot(way, glm::dvec3(light.direction));
        return fmt::format(
            "outside the cone of the spotlight: {:.4g} degrees from its axis, light ends "
            "at {:.4g}",
            glm::degrees(std::acos(std::clamp(cosine, -1.0, 1.0))),
            glm::degrees(double(light.outer_angle)));
      }
      case LightType::area:
        return "behind the area light, which shines only in its direction";
      case LightType::point:
      case LightType::directional:
        break;
    }
    return "at the light itself, or too far to be lit";
  }

  void about_shadow(const SurfaceRecord& s, const LightRecord& record) {
    for (const LightSample& sample : record.samples) {
      const auto self = std::find_if(sample.blockers.begin(), sample.blockers.end(),
                                     [](const Blocker& b) { return b.itself; });
      if (self == sample.blockers.end()) {
        continue;
      }
      // Solids cannot occlude themselves on the lit side; meshes can, but not at a short distance.
      const bool lit_side = glm::dot(s.geometric, sample.to_light) > 0;
      const bool acne = lit_side && (s.shape != Shape::mesh || self->t < acne_distance);
      if (acne) {
        add(RemarkKind::shadow_acne,
            fmt::format("shadow acne: the shadow ray hits the surface it starts on, at t = {:.4g}",
                        self->t),
            record.light);
      } else {
        add(RemarkKind::shadow_by_itself,
            fmt::format("the object shadows itself, at t = {:.4g}", self->t), record.light);
      }
      return;
    }
  }

  const RenderScene& scene_;
  const PixelRecord& pixel_;
  std::uint32_t index_ = 0;
  std::vector<Remark> list_;
};

}  // namespace

std::string_view remark_name(RemarkKind kind) {
  static constexpr std::array<std::string_view, 19> names{"clamped",
                                                          "seen-from-behind",
                                                          "normal-past-horizon",
                                                          "no-shininess",
                                                          "texture-hidden",
                                                          "texture-missing",
                                                          "no-transparent-share",
                                                          "total-reflection",
                                                          "trapped",
                                                          "too-deep",
                                                          "too-faint",
                                                          "too-many",
                                                          "light-behind",
                                                          "highlight-from-behind",
                                                          "shadow-acne",
                                                          "shadow-by-itself",
                                                          "light-faded",
                                                          "light-out-of-reach",
                                                          "light-of-another-mode"};
  return names[static_cast<std::size_t>(kind)];
}

std::vector<Remark> remarks(const RenderScene& scene, const PixelRecord& pixel) {
  return Remarks(scene, pixel).all();
}

}  // namespace scenefile
