#include "scenefile/asset/image.h"

#include <algorithm>

namespace scenefile {

std::uint8_t quantize(float value, Rounding rounding) {
  if (!(value > 0)) {
    return 0;
  }
  const float scaled = std::min(value, 1.0f) * 255.0f;
  return static_cast<std::uint8_t>(rounding == Rounding::nearest ? scaled + 0.5f : scaled);
}

Texture quantize(const Image& image, Rounding rounding) {
  Texture texture;
  texture.width = image.width;
  texture.height = image.height;
  texture.rgb.resize(image.rgb.size());
  std::transform(image.rgb.begin(), image.rgb.end(), texture.rgb.begin(),
                 [rounding](float value) { return quantize(value, rounding); });
  return texture;
}

Image to_float(const Texture& texture) {
  Image image(texture.width, texture.height);
  std::transform(texture.rgb.begin(), texture.rgb.end(), image.rgb.begin(),
                 [](std::uint8_t value) { return static_cast<float>(value) / 255.0f; });
  return image;
}

}  // namespace scenefile
