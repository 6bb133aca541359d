#pragma once
// Textures with what the format mixes into them. Private to the room.

#include "scenefile/asset/image.h"
#include "scenefile/export/phong_pbr.h"

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <tuple>
#include <vector>

namespace scenefile {

/// How the values of the pictures are encoded.
enum class PictureEncoding : std::uint8_t {
  linear,  ///< as the format has them
  srgb     ///< IEC 61966-2-1, as glTF wants colors
};

/// A PNG file of each mixture that materials use, each once.
class BakedTextures {
 public:
  BakedTextures(std::span<const Texture> textures, PictureEncoding encoding)
      : textures_(textures), encoding_(encoding) {}

  /// Whether the material shows a picture.
  bool shows(const RenderMaterial& material) const;
  /// The index of (1 - blend) diffuse + blend * texture + `more`, cut to 0..1.
  std::uint32_t bake(const RenderMaterial& material, const glm::vec3& diffuse,
                     const glm::vec3& more);

  const std::vector<std::string>& files() const { return files_; }
  /// A value was over 1.
  bool clipped() const { return clipped_; }

 private:
  using Key = std::tuple<std::uint32_t, float, float, float, float>;

  std::span<const Texture> textures_;
  PictureEncoding encoding_;
  std::map<Key, std::uint32_t> known_;
  std::vector<std::string> files_;
  bool clipped_ = false;
};

}  // namespace scenefile
