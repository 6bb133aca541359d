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
#include <vector>

namespace scenefile {

/// A format of picture files that can be read.
struct PictureFormat {
  std::string_view name;        ///< "JPEG"
  std::string_view extensions;  ///< in lower case, separated by spaces: ".jpg .jpeg"
};

/// All formats that decode_picture() reads; decode_image() does not read those that textures do not
/// have: PPM and PGM, PFM, EXR.
std::vector<PictureFormat> picture_formats();
/// Their names for messages: "PNG, JPEG, ...".
std::string picture_format_names();
/// Whether the name has one of their extensions, in any case.
bool is_picture_name(std::string_view file_name);
/// The same of the formats that textures have.
bool is_texture_name(std::string_view file_name);

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

/// A picture from a file, for comparison.
struct DecodedPicture {
  /// 8-bit values. Of `linear`, clamped to [0, 1] and rounded; NaN is 0.
  Texture texture{};
  /// The values of a format with floats (PFM, EXR), 1 is full intensity: not clamped, NaN and
  /// infinity are kept. Empty for other formats.
  Image linear{};
  std::size_t not_finite = 0;  ///< pixels of `linear` with a value that is NaN or infinite
  bool jpeg = false;           ///< its colors are not exactly those that were stored
  /// A PNG, not interlaced, whose pixels all have alpha 0: viewers show nothing of its colors.
  bool transparent = false;

  bool is_linear() const { return !linear.rgb.empty(); }
};

/// Decodes what decode_image() does, and
/// - PPM and PGM, as text or binary; values are scaled to 8 bits;
/// - PFM, in color or gray. The amount of its scale is ignored;
/// - OpenEXR with scan lines or tiles (the largest level), and any lossless compression or PXR24.
///   The picture is the display window, black where there are no pixels. Alpha is dropped. `layer`
///   selects one of its layers: three channels R, G, B or X, Y, Z, or a single channel, with a name
///   before the last point or of their part. Without it: R, G, B or Y of the first part without
///   such a name, otherwise the only layer. `layer` is ignored for files without layers.
/// The result and errors are otherwise those of decode_image(). Needs 15 bytes per pixel for
/// floats, which must fit in limits.texture_bytes.
Result<DecodedPicture> decode_picture(std::string_view bytes, std::string_view layer = {},
                                      const Limits& limits = {});

/// How much of its budget decode_image() will use if it succeeds, from the header alone; 0 if no
/// header can be read.
std::uint64_t decoded_bytes(std::string_view bytes);

/// Whether the bytes begin like a format that decode_picture() knows.
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

/// What a file may contain in addition to its pixels.
struct FileNote {
  /// One line of ASCII, for programs: the attribute `scenefile` of EXR files, the text with this
  /// keyword of PNG files, bytes after the pixels of PFM files. Empty: none.
  std::string text = {};
  /// EXR: the row of the picture that is the first one of the file, and the number of rows of the
  /// picture; 0: those of the file. (The data window lies in the display window.)
  int first = 0;
  int picture_height = 0;
};

/// Encodes; png8 and png16 clamp to [0, 1] and use `rounding`, the others keep every value
/// unchanged, as 32-bit floats. Linear values are stored directly, without gamma. The same
/// image gives the same bytes. Fails for an image without pixels.
Result<std::string> encode_image(const Image& image, ImageFormat format, Rounding rounding,
                                 const FileNote& note = {});

/// Makes a PNG file valid again after its FileNote::text was changed in place. Nothing for others.
void renew_png_text(std::string& file);

/// Encodes all layers as one OpenEXR file. By its convention the channel X of the layer normal is
/// called normal.X, channels of a layer without a name have no dot; channels are sorted by these
/// names. Values are 32-bit floats, integers are 32-bit unsigned. Same layers, same bytes. Fails if
/// the name of a layer is too long.
/// `height`: of the layers.
Result<std::string> encode_layers(int width, int height, std::span<const ImageLayer> layers,
                                  const FileNote& note = {});
/// The name of a channel of the layer in such a file.
std::string channel_name(const ImageLayer& layer, std::size_t channel);

}  // namespace scenefile
