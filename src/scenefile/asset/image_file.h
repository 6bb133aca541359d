#pragma once
// Image files as bytes in memory: decoding textures and references, encoding results.

#include "scenefile/asset/image.h"
#include "scenefile/base/limits.h"

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace scenefile {

/// Decodes PNG, JPEG, GIF (first frame), TGA or BMP; detected from the bytes, not from the file
/// name. Gray is expanded, 16 bits are rounded to 8, alpha is dropped (colors are not multiplied by
/// it), gamma and color profiles are ignored. A truncated or damaged file is rejected, not partly
/// decoded.
///  Sizes are checked against `limits` before memory is allocated; `budget` is what remains of
/// limits.texture_bytes and is reduced by what is decoded. On failure the texture is empty, `error`
/// says why as a phrase that follows "cannot decode: ", and `over_limit`, if not null, whether a
/// limit was the reason.
Texture decode_image(std::string_view bytes, const Limits& limits, std::uint64_t& budget,
                     std::string& error, bool* over_limit = nullptr);

/// How much of its budget decode_image() will use if it succeeds, from the header alone; 0 if no
/// header can be read.
std::uint64_t decoded_bytes(std::string_view bytes);

/// Whether the bytes begin like a format that decode_image() knows.
bool is_image(std::string_view bytes);

/// Image formats that can be written, by file name extension.
enum class ImageFormat : std::uint8_t { png8, png16, exr, pfm };

/// By the extension (.png is png8, .exr, .pfm, any case). Returns false for any other.
bool image_format_of(std::string_view file_name, ImageFormat& format);

/// Encodes; png8 and png16 clamp to [0, 1] and use `rounding`, the others keep every value
/// unchanged, as 32-bit floats. Linear values are stored directly, without gamma. The same
/// image gives the same bytes. On failure the result is empty and `error` says why.
std::string encode_image(const Image& image, ImageFormat format, Rounding rounding,
                         std::string& error);

/// Encodes all layers as one OpenEXR file. By its convention the channel X of the layer normal is
/// called normal.X, channels of a layer without a name have no dot; channels are sorted by these
/// names. Values are 32-bit floats, integers are 32-bit unsigned. Same layers, same bytes. On
/// failure the result is empty and `error` says why.
std::string encode_layers(int width, int height, std::span<const ImageLayer> layers,
                          std::string& error);

}  // namespace scenefile
