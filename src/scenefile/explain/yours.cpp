#include "scenefile/explain/yours.h"

#include "scenefile/base/shape_traits.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace scenefile {

namespace {

using glm::dvec3;

constexpr std::size_t max_fits = 4;
constexpr double must_change = 3;  // in 1/255; smaller changes could be rounding

// The terms that one light contributes.
struct LightTerms {
  std::uint32_t light = 0;
  dvec3 diffuse{0};  // without shadows
  dvec3 specular{0};
  dvec3 hidden{0};  // removed by shadows
};

struct Terms {
  dvec3 ambient{0};
  std::vector<LightTerms> lights;
  dvec3 mirror{0};
  dvec3 glass{0};

  dvec3 diffuse() const { return sum(&LightTerms::diffuse); }
  dvec3 specular() const { return sum(&LightTerms::specular); }
  dvec3 hidden() const { return sum(&LightTerms::hidden); }
  dvec3 all() const { return ambient + diffuse() + specular() + mirror + glass; }

 private:
  dvec3 sum(dvec3 LightTerms::*part) const {
    dvec3 total(0);
    for (const LightTerms& l : lights) {
      total += l.*part;
    }
    return total;
  }
};

Terms terms_of(const PixelRecord& pixel) {
  const RayRecord& ray = pixel.rays.front();
  Terms terms;
  terms.ambient = dvec3(ray.ambient);
  for (const LightRecord& record : ray.lights) {
    LightTerms l;
    l.light = record.light;
    for (const LightSample& s : record.samples) {
      const dvec3 seen = dvec3(s.color) * dvec3(s.visibility) / double(record.taken);
      const dvec3 lost = dvec3(s.color) * (1.0 - dvec3(s.visibility)) / double(record.taken);
      l.diffuse += dvec3(s.diffuse) * seen;
      l.specular += dvec3(s.specular) * seen;
      l.hidden += (dvec3(s.diffuse) + dvec3(s.specular)) * lost;
    }
    terms.lights.push_back(l);
  }
  for (const auto& [branch, term] :
       {std::pair(&ray.mirror, &terms.mirror), std::pair(&ray.glass, &terms.glass)}) {
    if (branch->fate == Fate::followed) {
      *term = dvec3(branch->factor) * dvec3(pixel.rays[branch->ray].color);
    }
  }
  return terms;
}

class Comparison {
 public:
  Comparison(const RenderScene& scene, const PixelRecord& pixel,
             const std::array<std::uint8_t, 3>& value)
      : scene_(scene), pixel_(pixel), yours_(value[0], value[1], value[2]) {
    result_.value = value;
  }

  Yours run() {
    const dvec3 ours = 255.0 * glm::clamp(dvec3(pixel_.color), dvec3(0), dvec3(1));
    result_.equal = fits(ours);
    const RayRecord* const ray = pixel_.rays.empty() ? nullptr : &pixel_.rays.front();
    if (result_.equal || ray == nullptr || pixel_.options.mode == Mode::normals) {
      return result_;
    }
    shown_ = dvec3(ray->color);
    if (!ray->surface.has_value()) {
      return result_;
    }
    terms_ = terms_of(pixel_);
    surface_ = &*ray->surface;
    try_single_terms();
    try_variants();
    try_colors();
    if (result_.fits.empty()) {
      try_subsets();
    }
    return result_;
  }

 private:
  bool fits(const dvec3& color_255) const {
    // Course pictures are truncated, others rounded: the values differ by up to half a step.
    const dvec3 off = glm::abs(glm::clamp(color_255, dvec3(0), dvec3(255)) - 0.25 - yours_);
    return std::max({off.x, off.y, off.z}) <= yours_tolerance;
  }

  void offer(std::string what, const dvec3& color) {
    const dvec3 change =
        glm::abs(glm::clamp(color, dvec3(0), dvec3(1)) - glm::clamp(shown_, dvec3(0), dvec3(1)));
    if (result_.fits.size() < max_fits && fits(255.0 * color) &&
        255 * std::max({change.x, change.y, change.z}) > must_change) {
      result_.fits.push_back({std::move(what), 255.0 * color});
    }
  }

  // "light 2 (spot)": counted from 1 in the order of the scene.
  std::string light_name(const LightTerms& l) const {
    return fmt::format("light {} ({})", l.light + 1, word_of(scene_.lights[l.light].type));
  }

  void try_single_terms() {
    const dvec3 all = terms_.all();
    offer("without the ambient term", all - terms_.ambient);
    offer("without the diffuse term", all - terms_.diffuse());
    offer("without the specular term", all - terms_.specular());
    offer("without the reflection", all - terms_.mirror);
    offer("without the refraction", all - terms_.glass);
    offer("without any shadow", all + terms_.hidden());
    for (const LightTerms& l : terms_.lights) {
      if (terms_.lights.size() > 1) {
        offer(fmt::format("without {}, as in its shadow", light_name(l)),
              all - l.diffuse - l.specular);
        offer(fmt::format("without the shadow of {}", light_name(l)), all + l.hidden);
        offer(fmt::format("with only {} and the ambient term", light_name(l)),
              terms_.ambient + l.diffuse + l.specular);
      }
    }
    offer("with only the ambient term", terms_.ambient);
    offer("with the ambient term twice", all + terms_.ambient);
    offer("with the diffuse term twice", all + terms_.diffuse());
    offer("with the specular term twice", all + terms_.specular());
    if (terms_.lights.size() > 2) {
      offer("with the ambient term once for each light",
            all + double(terms_.lights.size() - 1) * terms_.ambient);
    }
  }

  // Changes to the terms of each light that arrives.
  template <typename Change>
  dvec3 relit(const Change& change) const {
    dvec3 color = terms_.ambient + terms_.mirror + terms_.glass;
    for (const LightRecord& record : pixel_.rays.front().lights) {
      for (const LightSample& s : record.samples) {
        color +=
            change(s, scene_.lights[record.light]) * dvec3(s.visibility) / double(record.taken);
      }
    }
    return color;
  }

  void try_variants() {
    const RenderGlobal& global = scene_.global;
    const RenderMaterial& material = scene_.materials[surface_->material];
    const dvec3 all = terms_.all();
    if (global.ambient > 0) {
      offer("without the coefficient of the ambient term",
            all - terms_.ambient + terms_.ambient / double(global.ambient));
    }
    if (global.diffuse > 0) {
      offer("without the coefficient of the diffuse term",
            all - terms_.diffuse() + terms_.diffuse() / double(global.diffuse));
    }
    if (global.specular > 0) {
      offer("without the coefficient of the specular term",
            all - terms_.specular() + terms_.specular() / double(global.specular));
      offer("without the coefficient of the reflection",
            all - terms_.mirror + terms_.mirror / double(global.specular));
    }
    const dvec3 eye = -surface_->ray.direction;
    offer("with Blinn's highlight instead of Phong's",
          relit([&](const LightSample& s, const RenderLight&) {
            const dvec3 half = glm::normalize(s.to_light + eye);
            const double shine = std::max(0.0, glm::dot(half, surface_->normal));
            return dvec3(s.color) * (dvec3(s.diffuse) + dvec3(surface_->specular_color) *
                                                            std::pow(shine, material.shininess));
          }));
    const auto without_fading = [&](const LightSample& s) {
      return s.attenuation > 0 ? dvec3(s.color) / s.attenuation : dvec3(0);
    };
    offer("without attenuation", relit([&](const LightSample& s, const RenderLight&) {
            return without_fading(s) * (dvec3(s.diffuse) + dvec3(s.specular));
          }));
    offer("with 1 / d^2 as the attenuation", relit([&](const LightSample& s, const RenderLight& l) {
            const double fading =
                !has_position(l.type) ? 1 : std::min(1.0, 1 / (s.distance * s.distance));
            return without_fading(s) * fading * (dvec3(s.diffuse) + dvec3(s.specular));
          }));
    offer("without the spotlights' falloff", relit([&](const LightSample& s, const RenderLight&) {
            return (s.spot_factor > 0 ? dvec3(s.color) / s.spot_factor : dvec3(0)) *
                   (dvec3(s.diffuse) + dvec3(s.specular));
          }));
    offer("with the absolute value of N.L", relit([&](const LightSample& s, const RenderLight&) {
            return dvec3(s.color) *
                   (std::abs(s.n_dot_l) * dvec3(surface_->diffuse_color) + dvec3(s.specular));
          }));
    offer("with the normal flipped", relit([&](const LightSample& s, const RenderLight&) {
            return dvec3(s.color) *
                   (std::max(0.0, -s.n_dot_l) * dvec3(surface_->diffuse_color) + dvec3(s.specular));
          }));
    if (surface_->texture.has_value()) {
      const TextureRecord& t = *surface_->texture;
      const dvec3 plain = double(global.diffuse) * dvec3(material.diffuse);
      const auto textured = [&](const dvec3& base) {
        return relit([&](const LightSample& s, const RenderLight&) {
          return dvec3(s.color) * (std::max(0.0, s.n_dot_l) * base + dvec3(s.specular));
        });
      };
      offer("without the texture", textured(plain));
      offer("with only the texture, ignoring its blend", textured(dvec3(t.color)));
      offer("with the texture times the diffuse coefficient",
            textured((1 - t.blend) * plain + t.blend * double(global.diffuse) * dvec3(t.color)));
      offer("with the texture times the diffuse coefficient, ignoring its blend",
            textured(double(global.diffuse) * dvec3(t.color)));
      offer("with the texture times the diffuse color",
            textured((1 - t.blend) * plain + t.blend * plain * dvec3(t.color)));
    }
    const dvec3 reflective(material.reflective);
    if (terms_.mirror != dvec3(0)) {
      const dvec3 local = all - terms_.mirror;
      const dvec3 factor(pixel_.rays.front().mirror.factor);
      offer("with the reflection blended with the lighting, not added",
            (1.0 - factor) * local + terms_.mirror);
      offer("with the reflective color ignored",
            local + double(global.specular) * terms_.mirror / glm::max(factor, dvec3(1e-9)));
    }
  }

  void try_colors() {
    const dvec3 c = glm::clamp(terms_.all(), dvec3(0), dvec3(1));
    offer("with red and blue exchanged", {c.z, c.y, c.x});
    offer("with gamma 2.2", glm::pow(c, dvec3(1 / 2.2)));
    offer("to the power of 2.2", glm::pow(c, dvec3(2.2)));
    offer("as the background: your ray hits nothing here", dvec3(0));
    offer("as the normal's color, (n + 1) / 2", 0.5 * (surface_->normal + 1.0));
  }

  // Subsets of the terms, and of what shadows remove.
  void try_subsets() {
    struct Part {
      const char* name;
      dvec3 color;
    };
    const std::array<Part, 6> parts{{{"ambient", terms_.ambient},
                                     {"diffuse", terms_.diffuse()},
                                     {"specular", terms_.specular()},
                                     {"reflection", terms_.mirror},
                                     {"transparency", terms_.glass},
                                     {"what shadows remove", terms_.hidden()}}};
    for (unsigned set = 1; set < 1u << parts.size(); ++set) {
      dvec3 color(0);
      std::string names;
      bool useless = false;
      for (std::size_t i = 0; i < parts.size(); ++i) {
        if ((set >> i & 1) != 0) {
          useless = useless || parts[i].color == dvec3(0);
          color += parts[i].color;
          names += fmt::format("{}{}", names.empty() ? "" : " + ", parts[i].name);
        }
      }
      if (!useless) {
        offer(fmt::format("with only these terms: {}", names), color);
      }
    }
  }

  const RenderScene& scene_;
  const PixelRecord& pixel_;
  dvec3 yours_;
  dvec3 shown_{0};
  Terms terms_;
  const SurfaceRecord* surface_ = nullptr;
  Yours result_;
};

}  // namespace

Yours compare_with_yours(const RenderScene& scene, const PixelRecord& pixel,
                         const std::array<std::uint8_t, 3>& value) {
  return Comparison(scene, pixel, value).run();
}

}  // namespace scenefile
