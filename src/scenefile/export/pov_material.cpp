#include "scenefile/export/pov_material.h"

#include "scenefile/base/components.h"
#include "scenefile/base/text.h"
#include "scenefile/export/codes.h"
#include "scenefile/export/face_materials.h"
#include "scenefile/export/pov_text.h"
#include "scenefile/export/report_once.h"

#include <fmt/format.h>

#include <algorithm>

namespace scenefile {

namespace {

float mean(const glm::vec3& c) {
  return (c.x + c.y + c.z) / 3;
}

// POV-Ray subtracts transmitted light from the surface color of glass, but the format adds it, so
// the surface must not vanish completely.
constexpr float max_transmit = 0.95f;

float transmit(const PovMaterial& m) {
  if (!m.transparent()) {
    return 0;
  }
  const float kt = m.global.transparent.value_or(m.options.transparent);
  return std::min(max_transmit, kt * mean(m.material->transparent));
}

// The pigment also multiplies the ambient term, which would vanish with a black pigment.
glm::vec3 pigment_color(const PovMaterial& m) {
  constexpr float darkest = 1.0f / 1024;
  const glm::vec3 diffuse = m.global.diffuse * m.material->diffuse / (1 - transmit(m));
  return glm::max(diffuse, glm::vec3(darkest));
}

glm::vec3 ambient_of_pigment(const PovMaterial& m) {
  const glm::vec3 ambient = m.global.ambient * m.material->ambient / (1 - transmit(m));
  const float shown = m.textured() ? m.material->blend : 0;
  return ambient / glm::mix(pigment_color(m), glm::vec3(1), shown);
}

std::string image(const PovMaterial& m, std::string_view mapping) {
  const RenderTexture& t = m.material->texture;
  return fmt::format("image_map {{ {} {} gamma 1.0{} }} scale <{}, {}, 1> {}", m.texture_kind,
                     pov_string(m.texture_path), m.options.texture_filter ? " interpolate 2" : "",
                     1 / t.repeat_u, 1 / t.repeat_v, mapping);
}

std::string pigment(const PovMaterial& m, std::string_view mapping) {
  const std::string color = fmt::format("color rgbt <{0}, {1}, {2}, {3}>", pigment_color(m).x,
                                        pigment_color(m).y, pigment_color(m).z, transmit(m));
  const float blend = m.material->blend;
  if (!m.textured()) {
    return color;
  }
  if (blend >= 1) {
    return image(m, mapping);
  }
  return fmt::format("average pigment_map {{ [{} {}] [{} {}] }}", 1 - blend, color, blend,
                     image(m, mapping));
}

std::string finish(const PovMaterial& m) {
  const RenderMaterial& material = *m.material;
  std::string text =
      fmt::format("finish {{ {} {} diffuse 1", m.options.path ? "ambient 0 emission" : "ambient",
                  pov_color(ambient_of_pigment(m)));
  const float lobe = m.options.path ? highlight_of_lobe(material.shininess) : 1;
  const float highlight = lobe * m.global.specular * largest(material.specular);
  if (highlight > 0 && material.shininess > 0) {
    text += fmt::format(" phong {} phong_size {}", highlight, material.shininess);
  }
  if (m.options.reflect && largest(material.reflective) > 0) {
    text += fmt::format(" reflection {{ {} }}", pov_color(m.global.specular * material.reflective));
  }
  return text + " }";
}

bool gray(const glm::vec3& c) {
  return c.x == c.y && c.y == c.z;
}

}  // namespace

bool pov_opens(std::string_view path) {
  return std::none_of(path.begin(), path.end(),
                      [](char c) { return static_cast<unsigned char>(c) >= 0x80; });
}

bool PovMaterial::transparent() const {
  return options.refract && global.transparent.value_or(options.transparent) > 0 &&
         largest(material->transparent) > 0;
}

PovMaterial pov_material(const RenderScene& scene, std::uint32_t index,
                         std::span<const Texture> textures,
                         std::span<const std::string> texture_paths, const PovOptions& options) {
  PovMaterial m{&scene.materials[index], scene.global, options, {}, {}, false};
  const RenderTexture& texture = m.material->texture;
  if (options.texture && texture.used() && m.material->blend > 0 &&
      !textures[texture.file].empty()) {
    const std::string& path = texture_paths[texture.file];
    m.lost_texture = !pov_opens(path);
    m.texture_path = m.lost_texture ? std::string() : path;
    m.texture_kind = lower_case(textures[texture.file].format);
  }
  return m;
}

void report_differences(const PovMaterial& m, Diagnostics& diagnostics) {
  const RenderMaterial& material = *m.material;
  const auto note = [&](std::string_view text) {
    report_once("pov.approximate"_code, text, diagnostics);
  };
  if (!gray(material.specular) && material.shininess > 0) {
    note("highlights take the strongest channel of a specular color in all channels");
  }
  if (m.textured() && largest(m.global.ambient * material.ambient) > 0) {
    note("the ambient light of a textured object takes the color of the texture");
  }
  if (m.transparent()) {
    note("transparency dims the color of the surface itself");
  }
  if (m.lost_texture) {
    report_once("pov.lost"_code,
                "textures whose path has a character other than ASCII are left out: POV-Ray cannot "
                "open them; rename the files or their folders",
                diagnostics);
  }
  if (m.textured() && m.texture_kind == "gif") {
    note("POV-Ray scrambles interlaced GIF files; save such textures as PNG");
  }
  if (m.options.texture && material.bump_map.used()) {
    report_once("pov.lost"_code, "bump maps are left out", diagnostics);
  }
}

std::string pov_texture(const PovMaterial& m, std::string_view mapping) {
  return fmt::format("texture {{ pigment {{ {} }} {} }}", pigment(m, mapping), finish(m));
}

std::string pov_interior(const PovMaterial& m) {
  return m.transparent() ? fmt::format(" interior {{ ior {} }}", m.material->ior) : std::string();
}

}  // namespace scenefile
