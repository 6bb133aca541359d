#pragma once
// The file format for one part of a picture: a description of the whole, and the pixels of the
// part.
//
//   scenefile part 1        a line; the number is the version of the layout
//   length of the header    4 bytes
//   header                  PartHead
//   checksum of the header  8 bytes
//   rows                    the part's rows from the top: 3 floats per pixel, then those of
//                           each layer
//
// Numbers are in native byte order: builds for other machines have other keys.

#include "scenefile/asset/image.h"
#include "scenefile/trace/layers.h"
#include "scenefile/trace/pieces.h"
#include "scenefile/trace/render_options.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace scenefile {

/// What a picture was drawn from, as fingerprints (base/hash.h).
struct PartKey {
  std::uint64_t program = 0;  ///< the build of the program
  std::uint64_t scene = 0;    ///< bytes of the scene file
  std::uint64_t assets = 0;   ///< names and bytes of textures and meshes
  std::uint64_t options = 0;  ///< all options that affect the picture
  std::uint64_t driver = 0;   ///< the OpenGL driver; 0 for the ray tracer

  friend bool operator==(const PartKey&, const PartKey&) = default;
};

/// What all parts of a picture have in common.
struct DividedPicture {
  PartKey key;
  std::uint32_t count = 1;                ///< number of parts, up to max_parts
  PixelRegion region;                     ///< the pixels of the merged picture
  Rounding rounding = Rounding::nearest;  ///< for 8-bit output
  int max_depth = 0;                      ///< for layer_picture()
  std::vector<Layer> layers;

  friend bool operator==(const DividedPicture&, const DividedPicture&) = default;
};

struct PartHead {
  DividedPicture picture;
  std::uint32_t index = 0;         ///< counted from 0; selects the pixels, see part_of()
  std::vector<ValueRange> ranges;  ///< of each layer
  std::uint64_t checksum = 0;      ///< of all rows

  PixelRegion region() const { return part_of(picture.region, index, picture.count); }
  friend bool operator==(const PartHead&, const PartHead&) = default;
};

/// The header of a part with these pixels; `image` and `layers` contain exactly the part.
PartHead make_part_head(const DividedPicture& picture, std::uint32_t index, const Image& image,
                        std::span<const ImageLayer> layers);

/// The bytes of row y of the part, counted from its top.
std::string part_row(const Image& image, std::span<const ImageLayer> layers, int y);
/// The number of bytes of a row that is `width` pixels wide.
std::size_t part_row_bytes(const DividedPicture& picture, int width);

/// Everything before the rows.
std::string encode_part_head(const PartHead& head);

/// The maximum size of a header: this many bytes of a file are enough to decode it.
inline constexpr std::size_t max_part_head_bytes = std::size_t{1} << 16;

/// Decodes the result of encode_part_head() at the start of a file. Returns an error text for
/// people; empty on success. `bytes_before_rows`: the size of everything before the rows.
std::string decode_part_head(std::string_view first_bytes, PartHead& head,
                             std::size_t& bytes_before_rows);

/// The size of the complete file.
std::uint64_t part_file_bytes(const PartHead& head, std::size_t bytes_before_rows);

/// Whether a file that starts like this is a part, possibly a damaged one.
bool is_part_file(std::string_view first_bytes);

/// Why a part with the key `found` does not belong to the picture with the key `wanted`, in words
/// that complete "it was drawn"; empty if it does. Names everything that differs.
std::string foreign_part(const PartKey& found, const PartKey& wanted);

/// Copies rows of a part to their place in the picture. `rows`: complete rows as in the file,
/// starting with row `y` of the picture. `to`: the picture itself, then its layers; their values
/// are rows of the whole picture, starting with row `first`.
void place_part_rows(const PartHead& head, std::string_view rows, int y, int first,
                     std::span<ImageLayer> to);

}  // namespace scenefile
