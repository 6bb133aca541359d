#include "scenefile/import/gltf_material.h"

#include "scenefile/asset/image_file.h"
#include "scenefile/base/components.h"
#include "scenefile/export/phong_pbr.h"
#include "scenefile/import/codes.h"
#include "scenefile/import/complete_scene.h"
#include "scenefile/import/picture_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace scenefile {

namespace {

float unit(const JsonValue& json, float otherwise) {
  return static_cast<float>(std::clamp(json.number().value_or(otherwise), 0.0, 1.0));
}

// Clamped to a safe range: not negative, and not too large.
glm::vec3 color(const JsonValue& json, float otherwise) {
  return glm::clamp(json.color().value_or(glm::vec3(otherwise)), glm::vec3(0), glm::vec3(1e6f));
}

PbrMaterial read_pbr(const JsonValue& json) {
  PbrMaterial pbr;
  const JsonValue core = json["pbrMetallicRoughness"];
  const JsonValue more = json["extensions"];
  if (const auto base = core["baseColorFactor"].numbers(4)) {
    pbr.base =
        glm::clamp(glm::vec3((*base)[0], (*base)[1], (*base)[2]), glm::vec3(0), glm::vec3(1));
  }
  pbr.metallic = unit(core["metallicFactor"], 1);
  pbr.roughness = unit(core["roughnessFactor"], 1);
  if (!json["emissiveTexture"]) {  // which says where it emits, and is left out
    pbr.emissive =
        color(json["emissiveFactor"], 0) *
        static_cast<float>(std::clamp(
            more["KHR_materials_emissive_strength"]["emissiveStrength"].number().value_or(1), 0.0,
            1e6));
  }
  pbr.ior = static_cast<float>(
      std::clamp(more["KHR_materials_ior"]["ior"].number().value_or(1.5), 1.0, 10.0));
  const JsonValue specular = more["KHR_materials_specular"];
  pbr.f0 = glm::min(glm::vec3(1), f0_of(pbr.ior) * unit(specular["specularFactor"], 1) *
                                      color(specular["specularColorFactor"], 1));
  pbr.transmission = unit(more["KHR_materials_transmission"]["transmissionFactor"], 0);
  return pbr;
}

std::optional<PhongColors> read_extras(const JsonValue& extras) {
  const auto ambient = extras[extras["emission"] ? "emission" : "ambient"].color();
  const auto diffuse = extras["diffuse"].color();
  const auto specular = extras["specular"].color();
  const auto reflective = extras["reflective"].color();
  const auto transparent = extras["transparent"].color();
  const auto shininess = extras["shininess"].number();
  const auto ior = extras["ior"].number();
  if (!ambient || !diffuse || !specular || !reflective || !transparent || !shininess || !ior ||
      !(*ior > 0) || *shininess < 0) {
    return std::nullopt;
  }
  return PhongColors{*ambient,
                     *diffuse,
                     *specular,
                     *reflective,
                     *transparent,
                     static_cast<float>(*shininess),
                     static_cast<float>(*ior)};
}

bool near(float a, float b) {
  return std::abs(a - b) <= 1e-3f * std::max({1.0f, std::abs(a), std::abs(b)});
}

bool near(const glm::vec3& a, const glm::vec3& b) {
  return near(a.x, b.x) && near(a.y, b.y) && near(a.z, b.z);
}

// Whether a material is still the one that write_gltf() made from the stored values. `textured`:
// the picture contains the base color.
bool still_fits(const PbrMaterial& made, const PbrMaterial& read, bool textured) {
  return (textured || near(made.base, read.base)) && near(made.metallic, read.metallic) &&
         (read.f0 == glm::vec3(0) || near(made.roughness, read.roughness)) &&
         near(made.f0, read.f0) && near(made.transmission, read.transmission) &&
         near(made.emissive, read.emissive) && (made.transmission == 0 || near(made.ior, read.ior));
}

Material written(const PhongColors& phong) {
  Material m;
  m.ambient = phong.ambient;
  m.diffuse = phong.diffuse;
  m.specular = phong.specular;
  m.reflective = phong.reflective;
  m.transparent = phong.transparent;
  m.shininess = phong.shininess;
  m.ior = phong.ior == 1 ? 0 : phong.ior;
  return m;
}

// sRGB to linear, IEC 61966-2-1.
float linear_of_srgb(float value) {
  return value <= 0.04045f ? value / 12.92f : std::pow((value + 0.055f) / 1.055f, 2.4f);
}

bool repeats(const JsonValue& sampler) {
  constexpr std::uint64_t repeat = 10497;
  return sampler["wrapS"].whole().value_or(repeat) == repeat &&
         sampler["wrapT"].whole().value_or(repeat) == repeat;
}

glm::mat3x2 uv_map_of(const JsonValue& transform) {
  const auto offset = transform["offset"].numbers(2).value_or(std::vector<double>{0, 0});
  const auto scale = transform["scale"].numbers(2).value_or(std::vector<double>{1, 1});
  const double turn = transform["rotation"].number().value_or(0);
  const double c = std::cos(turn);
  const double s = std::sin(turn);
  return {c * scale[0], -s * scale[0], s * scale[1], c * scale[1], offset[0], offset[1]};
}

}  // namespace

GltfMaterials::GltfMaterials(const GltfFile& file, const ImportOptions& options,
                             std::vector<ImportedFile>& files, Diagnostics& diagnostics)
    : file_(file),
      options_(options),
      files_(files),
      diagnostics_(diagnostics),
      texture_budget_(options.limits.texture_bytes) {}

const GltfMaterial& GltfMaterials::get(std::uint32_t index) {
  const auto [entry, is_new] = known_.try_emplace(index);
  if (is_new) {
    entry->second = make(index < file_.materials.size() ? file_.materials[index] : JsonValue());
  }
  return entry->second;
}

void GltfMaterials::leave_out(std::string_view what) {
  if (left_out_.emplace(what).second) {
    diagnostics_.report("import.left-out"_code, {}, fmt::format("{} are left out", what));
  }
}

GltfMaterial GltfMaterials::make(const JsonValue& json) {
  const PbrMaterial pbr = read_pbr(json);
  const JsonValue texture = json["pbrMetallicRoughness"]["baseColorTexture"];
  PhongColors phong = phong_of(pbr);
  const JsonValue extras = json["extras"]["scenefile"];
  const std::optional<PhongColors> own = read_extras(extras);
  const bool known = own && still_fits(pbr_of(*own), pbr, static_cast<bool>(texture));
  if (known) {
    phong = *own;
  }
  if (largest(pbr.emissive) > 0 && !(known && extras["ambient"])) {
    if (left_out_.emplace("emission").second) {
      report_emission(diagnostics_);
    }
  }
  const auto base = json["pbrMetallicRoughness"]["baseColorFactor"].numbers(4);
  const float alpha = base ? static_cast<float>(std::clamp((*base)[3], 0.0, 1.0)) : 1;
  const std::string alpha_mode = json["alphaMode"].string().value_or("OPAQUE");
  if (alpha < 1 && alpha_mode == "BLEND") {
    phong.diffuse *= alpha;
    phong.transparent += glm::vec3(1 - alpha);
    phong.ior = 1;
  }
  GltfMaterial result;
  result.material = written(phong);
  if (texture) {
    // The diffuse share of the base color.
    const float share = largest(pbr.base) > 0 ? largest(phong.diffuse) / largest(pbr.base) : 1;
    add_texture(texture, known ? pbr.base : pbr.base * std::min(1.0f, share), result);
  }
  if (alpha_mode == "MASK") {
    leave_out("masks by alpha");
  } else if (texture && alpha_mode == "BLEND") {
    leave_out("alpha values of pictures");
  }
  if (json["normalTexture"]) {
    leave_out("normal maps");
  }
  if (json["emissiveTexture"] || json["occlusionTexture"] ||
      json["pbrMetallicRoughness"]["metallicRoughnessTexture"]) {
    leave_out("pictures of roughness, metal, occlusion and emission");
  }
  return result;
}

void GltfMaterials::add_texture(const JsonValue& info, const glm::vec3& factor,
                                GltfMaterial& result) {
  const std::uint64_t index = info["index"].whole().value_or(no_item);
  const std::uint64_t image = index < file_.textures.size()
                                  ? file_.textures[index]["source"].whole().value_or(no_item)
                                  : no_item;
  if (image >= file_.images.size()) {
    diagnostics_.report("import.left-out"_code, {},
                        fmt::format("textures[{}] has no picture that can be read", index));
    return;
  }
  const std::string name = picture(static_cast<std::uint32_t>(image), factor);
  if (name.empty()) {
    return;
  }
  result.material.texture = TextureUse{name, 1, 1, {}};
  result.material.blend = 1;
  result.material.diffuse = glm::vec3(1);
  if (const std::uint64_t sampler = file_.textures[index]["sampler"].whole().value_or(no_item);
      sampler < file_.samplers.size()) {
    result.repeats = repeats(file_.samplers[sampler]);
  }
  const JsonValue transform = info["extensions"]["KHR_texture_transform"];
  result.uv_map = uv_map_of(transform);
  const JsonValue set = transform["texCoord"] ? transform["texCoord"] : info["texCoord"];
  result.uv_set = static_cast<std::uint32_t>(std::min<std::uint64_t>(set.whole().value_or(0), 63));
}

// The file of the picture multiplied by a color, in linear values; empty if it cannot be used.
std::string GltfMaterials::picture(std::uint32_t image, const glm::vec3& factor) {
  const auto [entry, is_new] = pictures_.try_emplace({image, factor.x, factor.y, factor.z});
  if (!is_new) {
    return entry->second;
  }
  const JsonValue& json = file_.images[image];
  Result<Texture> texture = input_error("it names neither a file nor a bufferView");
  if (const std::optional<std::string> uri = json["uri"].string()) {
    const Result<std::string> bytes = fetch_uri(*uri, options_);
    texture = bytes ? decode_image(*bytes, options_.limits, texture_budget_)
                    : input_error(bytes.error().text);
  } else if (const auto view = json["bufferView"].whole(); view && *view < file_.views.size()) {
    texture = decode_image(file_.views[*view].bytes, options_.limits, texture_budget_);
  }
  if (!texture) {
    const bool limit = texture.error().kind == ErrorKind::limit;
    diagnostics_.report(limit ? "import.limit"_code : "import.missing-file"_code, {},
                        fmt::format("images[{}]: {}", image, texture.error().text));
    return {};
  }
  std::array<std::array<std::uint8_t, 256>, 3> value_of{};
  for (int channel = 0; channel < 3; ++channel) {
    for (int byte = 0; byte < 256; ++byte) {
      value_of[channel][byte] = quantize(
          factor[channel] * linear_of_srgb(static_cast<float>(byte) / 255), Rounding::nearest);
    }
  }
  for (std::size_t i = 0; i < texture->rgb.size(); ++i) {
    texture->rgb[i] = value_of[i % 3][texture->rgb[i]];
  }
  entry->second = add_picture(*texture, options_, files_);
  return entry->second;
}

}  // namespace scenefile
