#pragma once
// Textures with the material's blend and colors baked in. Internal to export.

#include "scenefile/asset/image.h"
#include "scenefile/export/phong_pbr.h"

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <tuple>
#include <vector>

namespace scenefile {

/// The encoding of pixel values.
enum class PictureEncoding : std::uint8_t {
  linear,  ///< unchanged
  srgb     ///< IEC 61966-2-1, as glTF requires for colors
};

/// PNG files of the distinct mixtures that materials use.
class BakedTextures {
 public:
  BakedTextures(std::span<const Texture> textures, PictureEncoding encoding)
      : textures_(textures), encoding_(encoding) {}

  /// Whether the material has a visible texture.
  bool shows(const RenderMaterial& material) const;
  /// The index of a picture of (1 - blend) diffuse + blend * texture + `more`, clamped to 0..1.
  /// `path`: the texture of a face material multiplies `diffuse` (export/face_materials.h).
  std::uint32_t bake(const RenderMaterial& material, const glm::vec3& diffuse,
                     const glm::vec3& more, bool path);

  const std::vector<std::string>& files() const { return files_; }
  /// Whether a value above 1 was clamped.
  bool clipped() const { return clipped_; }

 private:
  using Key = std::tuple<std::uint32_t, float, float, float, float, float, float>;

  std::span<const Texture> textures_;
  PictureEncoding encoding_;
  std::map<Key, std::uint32_t> known_;
  std::vector<std::string> files_;
  bool clipped_ = false;
};

}  // namespace scenefile
