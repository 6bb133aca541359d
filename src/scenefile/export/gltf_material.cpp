#include "scenefile/export/gltf_material.h"

#include "scenefile/base/components.h"
#include "scenefile/export/codes.h"
#include "scenefile/export/face_materials.h"
#include "scenefile/export/phong_pbr.h"
#include "scenefile/export/report_once.h"

#include <fmt/format.h>

namespace scenefile {

namespace {

std::string list(const glm::vec3& v) {
  return fmt::format("[{},{},{}]", v.x, v.y, v.z);
}

void report_differences(const RenderMaterial& material, const PhongColors& phong,
                        const PbrMaterial& pbr, bool path, Diagnostics& diagnostics) {
  const auto note = [&](std::string_view text) {
    report_once("export.approximate"_code, text, diagnostics);
  };
  const bool mirror = largest(phong.reflective) > 0;
  if (largest(phong.ambient) > 0 && !path) {
    note("ambient light becomes emission: path tracers let it shine on other surfaces");
  }
  if (phong.shininess > 0 && largest(phong.specular) > 0) {
    note(pbr.roughness == 0 ? "mirrors and glass have no separate highlight"
                            : "highlights have the nearest roughness and reflectance");
  }
  if (mirror) {
    note("mirrors reflect more at grazing angles");
  }
  if (largest(phong.transparent) > 0) {
    note("glass takes its color from the light that it lets through");
  }
  if (largest(phong.diffuse) > 1 || largest(phong.reflective) > 1 ||
      largest(phong.transparent) > 1) {
    note("colors over 1 are clamped to 1");
  }
  if (material.bump_map.used()) {
    report_once("export.lost"_code, "bump maps are left out", diagnostics);
  }
}

// The format's own values, which glTF cannot represent. What faces emit has another name than
// ambient light, because it cannot be read back as such.
std::string extras(const PhongColors& phong, bool path) {
  return fmt::format(R"({{"scenefile":{{"{}":{},"diffuse":{},"specular":{},"reflective":{},)"
                     R"("transparent":{},"shininess":{},"ior":{}}}}})",
                     path ? "emission" : "ambient", list(phong.ambient), list(phong.diffuse),
                     list(phong.specular), list(phong.reflective), list(phong.transparent),
                     phong.shininess, phong.ior);
}

}  // namespace

std::string gltf_material(const RenderMaterial& material, const RenderGlobal& global,
                          float transparent, bool path, BakedTextures& textures,
                          std::set<std::string_view>& extensions, Diagnostics& diagnostics) {
  const PhongColors phong = phong_colors(material, global, transparent);
  PhongColors shown = phong;
  if (path) {
    shown.specular *= highlight_of_lobe(phong.shininess);
  }
  const PbrMaterial pbr = pbr_of(shown);
  report_differences(material, phong, pbr, path, diagnostics);
  std::string color;
  if (textures.shows(material)) {
    const glm::vec3 through = pbr.transmission > 0 ? phong.transparent : glm::vec3(0);
    color = fmt::format(R"("baseColorTexture":{{"index":{}}})",
                        textures.bake(material, phong.diffuse, through, path));
  } else {
    color = fmt::format(R"("baseColorFactor":[{},{},{},1])", pbr.base.x, pbr.base.y, pbr.base.z);
  }
  std::string text = fmt::format(
      R"({{"pbrMetallicRoughness":{{{},"metallicFactor":0,"roughnessFactor":{}}},"doubleSided":{})",
      color, pbr.roughness, pbr.transmission == 0);
  if (largest(pbr.emissive) > 0) {
    const float strength = std::max(1.0f, largest(pbr.emissive));
    text += fmt::format(R"(,"emissiveFactor":{})", list(pbr.emissive / strength));
    if (strength > 1) {
      extensions.insert("KHR_materials_emissive_strength");
    }
  }
  std::string more;
  if (largest(pbr.emissive) > 1) {
    more += fmt::format(R"("KHR_materials_emissive_strength":{{"emissiveStrength":{}}},)",
                        largest(pbr.emissive));
  }
  extensions.insert("KHR_materials_specular");
  // Blender 3.4 reads only the color of two ways to say that there is no highlight.
  more += R"("KHR_materials_specular":)";
  more += largest(pbr.f0) > 0
              ? fmt::format(R"({{"specularColorFactor":{}}})", list(pbr.f0 / f0_of(pbr.ior)))
              : R"({"specularFactor":0,"specularColorFactor":[0,0,0]})";
  if (pbr.transmission > 0) {
    extensions.insert({"KHR_materials_transmission", "KHR_materials_ior", "KHR_materials_volume"});
    more += fmt::format(R"(,"KHR_materials_transmission":{{"transmissionFactor":{}}})"
                        R"(,"KHR_materials_ior":{{"ior":{}}})"
                        R"(,"KHR_materials_volume":{{"thicknessFactor":1}})",
                        pbr.transmission, pbr.ior);
  }
  return text + fmt::format(R"(,"extensions":{{{}}},"extras":{}}})", more, extras(phong, path));
}

}  // namespace scenefile
