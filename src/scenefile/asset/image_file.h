#pragma once
// Image files as bytes in memory: decoding textures and references, encoding results.

#include "scenefile/asset/image.h"
#include "scenefile/base/limits.h"
#include "scenefile/base/result.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace scenefile {

/// Decodes PNG, JPEG, GIF (first frame), TGA or BMP; detected from the bytes, not from the file
/// name. Gray is expanded, 16 bits are rounded to 8, alpha is dropped (colors are not multiplied by
/// it), gamma and color profiles are ignored. A truncated or damaged file is rejected, not partly
/// decoded.
///  Sizes are checked against `limits` before memory is allocated; `budget` is what remains of
/// limits.texture_bytes and is reduced by what is decoded. The text of an error is a phrase that
/// follows "cannot decode: "; its kind is ErrorKind::limit or ErrorKind::input.
Result<Texture> decode_image(std::string_view bytes, const Limits& limits, std::uint64_t& budget);
/// The same for a single image.
Result<Texture> decode_image(std::string_view bytes, const Limits& limits = {});

/// How much of its budget decode_image() will use if it succeeds, from the header alone; 0 if no
/// header can be read.
std::uint64_t decoded_bytes(std::string_view bytes);

/// Whether the bytes begin like a format that decode_image() knows.
bool is_image(std::string_view bytes);

/// Image formats that can be written.
enum class ImageFormat : std::uint8_t { png8, png16, exr, pfm };

/// The extensions of these formats, for messages.
inline constexpr std::string_view image_extensions = ".png, .exr or .pfm";

/// By the extension (.png is png8, .exr, .pfm, any case); nullopt for any other.
std::optional<ImageFormat> image_format_of(std::string_view file_name);

/// Where the layers of a picture are stored.
enum class LayerStorage : std::uint8_t {
  none,      ///< nowhere
  apart,     ///< as colors, each in a file of its own
  together,  ///< as numbers, in the file of the picture
};
constexpr LayerStorage layer_storage(ImageFormat format) {
  switch (format) {
    case ImageFormat::png8:
    case ImageFormat::png16:
      return LayerStorage::apart;
    case ImageFormat::exr:
      return LayerStorage::together;
    case ImageFormat::pfm:
      return LayerStorage::none;
  }
  return LayerStorage::none;
}

/// Encodes; png8 and png16 clamp to [0, 1] and use `rounding`, the others keep every value
/// unchanged, as 32-bit floats. Linear values are stored directly, without gamma. The same
/// image gives the same bytes. Fails for an image without pixels.
Result<std::string> encode_image(const Image& image, ImageFormat format, Rounding rounding);

/// Encodes all layers as one OpenEXR file. By its convention the channel X of the layer normal is
/// called normal.X, channels of a layer without a name have no dot; channels are sorted by these
/// names. Values are 32-bit floats, integers are 32-bit unsigned. Same layers, same bytes. Fails if
/// the name of a layer is too long.
Result<std::string> encode_layers(int width, int height, std::span<const ImageLayer> layers);

}  // namespace scenefile
