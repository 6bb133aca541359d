#include "scenefile/export/baked_textures.h"

#include "scenefile/asset/image_file.h"

#include <cmath>
#include <utility>

namespace scenefile {

namespace {

float srgb_encoded(float linear) {
  return linear <= 0.0031308f ? 12.92f * linear : 1.055f * std::pow(linear, 1 / 2.4f) - 0.055f;
}

}  // namespace

bool BakedTextures::shows(const RenderMaterial& material) const {
  return material.texture.used() && material.blend > 0 &&
         material.texture.file < textures_.size() && !textures_[material.texture.file].empty();
}

std::uint32_t BakedTextures::bake(const RenderMaterial& material, const glm::vec3& diffuse,
                                  const glm::vec3& more, bool path) {
  const glm::vec3 factor = path && material.blend == 1 ? diffuse : glm::vec3(material.blend);
  const glm::vec3 added = (1 - material.blend) * diffuse + more;
  const Key key{material.texture.file, factor.x, factor.y, factor.z, added.x, added.y, added.z};
  const auto [entry, is_new] = known_.try_emplace(key, static_cast<std::uint32_t>(files_.size()));
  if (!is_new) {
    return entry->second;
  }
  const Texture& texture = textures_[material.texture.file];
  // A table of all possible results: three channels with 256 values each.
  float value_of[3][256];
  for (int channel = 0; channel < 3; ++channel) {
    for (int byte = 0; byte < 256; ++byte) {
      float value = added[channel] + factor[channel] * static_cast<float>(byte) / 255;
      clipped_ = clipped_ || value > 1.001f;
      value = std::min(1.0f, std::max(0.0f, value));
      value_of[channel][byte] = encoding_ == PictureEncoding::srgb ? srgb_encoded(value) : value;
    }
  }
  Image image(texture.width, texture.height);
  for (std::size_t i = 0; i < image.rgb.size(); ++i) {
    image.rgb[i] = value_of[i % 3][texture.rgb[i]];
  }
  files_.push_back(*encode_image(image, ImageFormat::png8, Rounding::nearest));
  return entry->second;
}

}  // namespace scenefile
