#include "scenefile/export/write_pov.h"

#include "scenefile/base/text.h"
#include "scenefile/export/codes.h"
#include "scenefile/export/pov_material.h"
#include "scenefile/export/pov_shape.h"
#include "scenefile/export/pov_text.h"
#include "scenefile/export/report_once.h"

#include <fmt/format.h>

#include <cmath>
#include <string_view>
#include <vector>

namespace scenefile {

namespace {

// Directional lights of POV-Ray have a position, and do not shine beyond it.
constexpr double far_away = 1e6;

// The light of emitting faces, and what other surfaces reflect of it.
constexpr std::string_view radiosity =
    " radiosity { pretrace_end 0.01 count 400 nearest_count 8 error_bound 0.4 recursion_limit 4 }";

class PovWriter {
 public:
  PovWriter(const RenderScene& scene, const Assets& assets,
            std::span<const std::string> texture_paths, const PovOptions& options,
            Diagnostics& diagnostics)
      : scene_(scene), meshes_(assets.meshes), options_(options), diagnostics_(diagnostics) {
    for (std::uint32_t i = 0; i < scene.materials.size(); ++i) {
      materials_.push_back(pov_material(scene, i, assets.textures, texture_paths, options));
      report_differences(materials_.back(), diagnostics);
    }
  }

  std::string write() {
    text_ = fmt::format(
        "// Render with File_Gamma=1.0: values are linear.\n#version 3.7;\n"
        "global_settings {{ assumed_gamma 1.0 max_trace_level {}{} }}\n",
        options_.bounces + 1, options_.path ? radiosity : "");
    if (options_.path) {
      note("light from faces is smoothed (radiosity), and makes no highlights or caustics");
    }
    camera();
    for (const RenderLight& light : scene_.lights) {
      this->light(light);
    }
    for (std::size_t i = 0; i < meshes_.size(); ++i) {
      if (!meshes_[i].triangles.empty()) {
        text_ += fmt::format("#declare Mesh_{} = {}", i, pov_mesh(meshes_[i]));
      }
    }
    groups();
    return std::move(text_);
  }

 private:
  void camera() {
    const RenderCamera& c = scene_.camera;
    const double distance = 0.5 / std::tan(c.fov_y / 2);
    text_ += fmt::format(
        "camera {{ perspective location {} direction {} right image_width / image_height * {} up "
        "{}",
        pov_vector(c.position), pov_vector(-distance * c.w), pov_vector(c.u), pov_vector(c.v));
    if (options_.lens && c.aperture > 0 && c.focal_length > 0) {
      text_ += fmt::format(" aperture {} blur_samples 16 focal_point {}", 2 * c.aperture,
                           pov_vector(c.position - c.focal_length * c.w));
      note("the lens uses other samples");
    }
    text_ += " }\n";
  }

  void light(const RenderLight& light) {
    text_ += "light_source { ";
    switch (light.type) {
      case LightType::point:
        text_ += pov_vector(light.position) + faded_color(light);
        break;
      case LightType::directional:
        text_ += pov_vector(glm::dvec3(light.direction) * -far_away) + " " +
                 pov_color(light.color) + " parallel point_at 0";
        break;
      case LightType::spot:
        text_ += pov_vector(light.position) + faded_color(light) + spot(light);
        break;
      case LightType::area:
        text_ += pov_vector(light.position) + faded_color(light) +
                 fmt::format(" area_light {}, {}, 4, 4", pov_vector(2.0f * light.half_u),
                             pov_vector(2.0f * light.half_v));
        break;
    }
    text_ += " }\n";
  }

  std::string spot(const RenderLight& light) {
    note("the edge of a spotlight falls off by the cosine of the angle, not by the angle");
    return fmt::format(" spotlight point_at {} radius {} falloff {} tightness 0",
                       pov_vector(light.position + light.direction),
                       glm::degrees(double(light.inner_angle)),
                       glm::degrees(double(light.outer_angle)));
  }

  // POV-Ray attenuates by 2 / (1 + (d / distance)^power). With a suitable color and distance, that
  // is 1 / (a + b d^power), as long as there is only one power.
  std::string faded_color(const RenderLight& light) {
    const glm::vec3& a = light.attenuation;
    const int power = a.z > 0 ? 2 : 1;
    const float factor = power == 2 ? a.z : a.y;
    if (a.z > 0 && a.y > 0) {
      note("of linear and quadratic attenuation, only the quadratic term is kept");
    }
    if (factor <= 0) {
      return fmt::format(" {}",
                         pov_color(a.x > 0 ? light.color / std::max(1.0f, a.x) : light.color));
    }
    note("an attenuated light is brighter than its color at short distances");
    const float constant = std::max(a.x, 1e-6f);
    const double distance = power == 2 ? std::sqrt(constant / factor) : constant / factor;
    return fmt::format(" {} fade_power {} fade_distance {}",
                       pov_color(light.color / (2 * constant)), power, distance);
  }

  // A group comes after those that it contains, so each is declared before it is used.
  void groups() {
    std::vector<bool> filled(scene_.groups.size());
    for (std::size_t i = 0; i < scene_.groups.size(); ++i) {
      const std::string parts = this->parts(scene_.groups[i], filled);
      filled[i] = !parts.empty();
      if (filled[i]) {
        text_ += fmt::format("#declare Group_{} = union {{\n{}}}\n", i, parts);
      }
    }
    if (filled[scene_.root]) {
      text_ += fmt::format("object {{ Group_{}{} }}\n", scene_.root,
                           options_.shadows ? "" : " no_shadow");
    }
  }

  std::string parts(const RenderGroup& group, const std::vector<bool>& filled) const {
    std::string text;
    for (const RenderPrimitive& p : group.primitives) {
      if (p.shape == Shape::mesh && meshes_[p.mesh].triangles.empty()) {
        continue;
      }
      const std::string mesh_name = fmt::format("Mesh_{}", p.mesh);
      text += pov_primitive(p.shape, materials_[p.material], mesh_name,
                            pov_matrix(p.group_from_object));
    }
    for (const RenderInstance& instance : group.instances) {
      if (filled[instance.group]) {
        text += fmt::format("object {{ Group_{} {} }}\n", instance.group,
                            pov_matrix(instance.group_from_instance));
      }
    }
    return text;
  }

  void note(std::string_view text) { report_once("pov.approximate"_code, text, diagnostics_); }

  const RenderScene& scene_;
  std::span<const Mesh> meshes_;
  PovOptions options_;
  Diagnostics& diagnostics_;
  std::vector<PovMaterial> materials_;
  std::string text_;
};

}  // namespace

std::string write_pov(const RenderScene& scene, const Assets& assets,
                      std::span<const std::string> texture_paths, const PovOptions& options,
                      Diagnostics& diagnostics) {
  return PovWriter(scene, assets, texture_paths, options, diagnostics).write();
}

}  // namespace scenefile
