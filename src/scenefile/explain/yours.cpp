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

dvec3 clamped(const dvec3& color) {
  return glm::clamp(color, dvec3(0), dvec3(1));
}

// Our color with a known mistake.
struct Variant {
  std::string what;
  dvec3 color{0};
  bool subset = false;         // a subset of the terms: the last resort
  bool has_zero_term = false;  // ... with a term that is zero, so a smaller subset gives the same
};

// The variants of one record; none if it shows the background.
class Variants {
 public:
  Variants(const RenderScene& scene, const PixelRecord& pixel) : scene_(scene), pixel_(pixel) {}

  std::vector<Variant> all() {
    if (pixel_.rays.empty() || !pixel_.rays.front().surface.has_value()) {
      return {};
    }
    terms_ = terms_of(pixel_);
    surface_ = &*pixel_.rays.front().surface;
    try_single_terms();
    try_variants();
    try_colors();
    try_subsets();
    return std::move(list_);
  }

 private:
  void offer(std::string what, const dvec3& color) { list_.push_back({std::move(what), color}); }

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
        offer(fmt::format("without {}{}", light_name(l),
                          pixel_.options.features.shadows ? ", as in its shadow" : ""),
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
    const auto& mirror = pixel_.rays.front().mirror;
    if (mirror.outcome == BranchOutcome::followed) {
      const dvec3 local = all - terms_.mirror;
      const dvec3 factor(mirror.factor);
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
      Variant v;
      v.subset = true;
      std::string names;
      for (std::size_t i = 0; i < parts.size(); ++i) {
        if ((set >> i & 1) != 0) {
          v.has_zero_term = v.has_zero_term || parts[i].color == dvec3(0);
          v.color += parts[i].color;
          names += fmt::format("{}{}", names.empty() ? "" : " + ", parts[i].name);
        }
      }
      v.what = fmt::format("with only these terms: {}", names);
      list_.push_back(std::move(v));
    }
  }

  const RenderScene& scene_;
  const PixelRecord& pixel_;
  Terms terms_;
  const SurfaceRecord* surface_ = nullptr;
  std::vector<Variant> list_;
};

bool fits(const dvec3& color_255, const dvec3& yours) {
  // Course pictures are truncated, others rounded: the values differ by up to half a step.
  const dvec3 off = glm::abs(glm::clamp(color_255, dvec3(0), dvec3(255)) - 0.25 - yours);
  return std::max({off.x, off.y, off.z}) <= yours_tolerance;
}

double change(const dvec3& a, const dvec3& b) {
  const dvec3 off = glm::abs(clamped(a) - clamped(b));
  return 255 * std::max({off.x, off.y, off.z});
}

// The records' colors with the variant of that name; a record without it keeps its color.
std::vector<dvec3> changed_colors(std::vector<dvec3> colors,
                                  const std::vector<std::vector<Variant>>& variants,
                                  const std::string& what) {
  for (std::size_t k = 0; k < colors.size(); ++k) {
    const auto& known = variants[k];
    const auto found =
        std::find_if(known.begin(), known.end(), [&](const Variant& v) { return v.what == what; });
    if (found != known.end()) {
      colors[k] = found->color;
    }
  }
  return colors;
}

}  // namespace

Terms terms_of(const PixelRecord& pixel) {
  Terms terms;
  if (pixel.rays.empty()) {
    return terms;
  }
  const RayRecord& ray = pixel.rays.front();
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
    if (branch->outcome == BranchOutcome::followed) {
      *term = dvec3(branch->factor) * dvec3(pixel.rays[branch->ray].color);
    }
  }
  return terms;
}

bool gives_value(const dvec3& color, const std::array<std::uint8_t, 3>& value) {
  return fits(color, dvec3(value[0], value[1], value[2]));
}

Yours compare_with_yours(const RenderScene& scene, std::span<const PixelRecord> records,
                         const PixelOf& pixel_of, const std::array<std::uint8_t, 3>& value) {
  Yours result;
  result.value = value;
  const dvec3 yours(value[0], value[1], value[2]);
  std::vector<dvec3> colors;
  for (const PixelRecord& record : records) {
    colors.emplace_back(record.color);
  }
  result.equal = fits(255.0 * clamped(pixel_of(colors)), yours);
  if (result.equal || records.front().options.mode == Mode::normals) {
    return result;
  }
  std::vector<std::vector<Variant>> variants;
  for (std::size_t k = 0; k < records.size(); ++k) {
    variants.push_back(Variants(scene, records[k]).all());
    colors[k] = records[k].rays.empty() ? dvec3(0) : records[k].rays.front().color;
  }
  const dvec3 ours = pixel_of(colors);
  bool explained = false;  // by a variant that is not a subset
  const auto surface = std::find_if(variants.begin(), variants.end(),
                                    [](const auto& of_record) { return !of_record.empty(); });
  if (surface == variants.end()) {
    return result;
  }
  for (const Variant& v : *surface) {
    if (result.fits.size() == max_fits || (v.subset && explained)) {
      break;
    }
    const dvec3 changed = pixel_of(changed_colors(colors, variants, v.what));
    if (!v.has_zero_term && fits(255.0 * changed, yours) && change(changed, ours) > must_change) {
      result.fits.push_back({v.what, 255.0 * changed});
      explained = explained || !v.subset;
    }
  }
  return result;
}

Yours compare_with_yours(const RenderScene& scene, const PixelRecord& pixel,
                         const std::array<std::uint8_t, 3>& value) {
  const auto itself = [](std::span<const dvec3> colors) { return colors.front(); };
  return compare_with_yours(scene, {&pixel, 1}, itself, value);
}

}  // namespace scenefile
