#include "scenefile/asset/image.h"

#include <algorithm>
#include <new>

namespace scenefile {

namespace {

// An allocation larger than max_size() is reported as out of memory, too.
std::size_t value_count(int width, int height) {
  const std::size_t count =
      std::size_t{3} * static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  if (count > std::vector<float>().max_size()) {
    throw std::bad_alloc();
  }
  return count;
}

}  // namespace

Image::Image(int w, int h) : width(w), height(h), rgb(value_count(w, h)) {}

std::uint8_t quantize(float value, Rounding rounding) {
  std::uint8_t quantized = 0;
  quantize(&value, 1, rounding, &quantized);
  return quantized;
}

// Branch-free, so that the compiler vectorizes it.
void quantize(const float* values, std::size_t count, Rounding rounding, std::uint8_t* to) {
  const float up = rounding == Rounding::nearest ? 0.5f : 0.0f;
  for (std::size_t i = 0; i < count; ++i) {
    const float positive = values[i] > 0 ? values[i] : 0.0f;
    const float clamped = positive < 1 ? positive : 1.0f;
    to[i] = static_cast<std::uint8_t>(static_cast<int>(clamped * 255.0f + up));
  }
}

Texture quantize(const Image& image, Rounding rounding) {
  Texture texture;
  texture.width = image.width;
  texture.height = image.height;
  texture.rgb.resize(image.rgb.size());
  quantize(image.rgb.data(), image.rgb.size(), rounding, texture.rgb.data());
  return texture;
}

Image to_float(const Texture& texture) {
  Image image(texture.width, texture.height);
  std::transform(texture.rgb.begin(), texture.rgb.end(), image.rgb.begin(),
                 [](std::uint8_t value) { return static_cast<float>(value) / 255.0f; });
  return image;
}

}  // namespace scenefile
