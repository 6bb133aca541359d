#pragma once
// The decoders used by decode_image() and decode_picture(). Internal to asset.

#include "scenefile/asset/image.h"
#include "scenefile/asset/image_file.h"
#include "scenefile/base/result.h"

#include <cstdint>
#include <string>
#include <string_view>

namespace scenefile {

/// What the header of an image file declares, read before anything of that size is allocated.
struct ImageHeader {
  std::uint64_t width = 0;
  std::uint64_t height = 0;
  std::uint64_t working_bytes = 0;  ///< needed for decoding, in addition to the result
  std::uint64_t min_bytes = 0;      ///< a smaller file cannot hold that many pixels
};

/// One image format over bytes in memory. The functions fail if the bytes are invalid.
struct Codec {
  PictureFormat format;
  bool (*recognizes)(std::string_view bytes);
  Result<ImageHeader> (*read_header)(std::string_view bytes);
  /// Fills texture.rgb of the picture, and sets `transparent`. The size is set and rgb has the
  /// capacity reserved, so that a truncated file never touches most of that memory. Null for
  /// formats with floats.
  Result<void> (*decode)(std::string_view bytes, DecodedPicture& picture);
  /// Fills a black image of the size of the header; `layer` as for decode_picture(). Null for
  /// formats with integers.
  Result<void> (*decode_linear)(std::string_view bytes, std::string_view layer,
                                Image& image) = nullptr;
};

extern const Codec png_codec;
extern const Codec jpeg_codec;
extern const Codec gif_codec;
extern const Codec bmp_codec;
extern const Codec tga_codec;
extern const Codec pnm_codec;
extern const Codec pfm_codec;
extern const Codec exr_codec;

/// Encodes PNG for encode_image(). The image must not be empty.
std::string encode_png(const Image& image, int bits, Rounding rounding, std::string_view text);

inline constexpr std::string_view ends_early = "the file ends early";

}  // namespace scenefile
