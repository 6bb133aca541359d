#pragma once
// The file of one part of a picture: what it is of, and its pixels as they were drawn.
//
//   scenefile part 1        a line; the number is that of this layout
//   length of the head      4 bytes
//   head                    PartHead
//   checksum of the head    8 bytes
//   rows                    the part's rows from the top: 3 floats a pixel, then those of each
//   layer
//
// Numbers are in the machine's own order of bytes: no other machine's build has the same key.

#include "scenefile/asset/image.h"
#include "scenefile/trace/layers.h"
#include "scenefile/trace/picture_parts.h"
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
  std::uint64_t program = 0;  ///< the build
  std::uint64_t scene = 0;    ///< its bytes
  std::uint64_t assets = 0;   ///< names and bytes of its textures and meshes
  std::uint64_t options = 0;  ///< all that changes the picture
  std::uint64_t driver = 0;   ///< of OpenGL; 0: the ray tracer

  friend bool operator==(const PartKey&, const PartKey&) = default;
};

/// What all parts of a picture say alike.
struct DividedPicture {
  PartKey key;
  std::uint32_t count = 1;                ///< of the parts, up to most_parts
  PixelRegion region;                     ///< the pixels of the picture when it is merged
  Rounding rounding = Rounding::nearest;  ///< to 8 bits
  int max_depth = 0;                      ///< as layer_picture() takes it
  std::vector<Layer> layers;

  friend bool operator==(const DividedPicture&, const DividedPicture&) = default;
};

struct PartHead {
  DividedPicture picture;
  std::uint32_t index = 0;         ///< counted from 0; its pixels are those of part_of()
  std::vector<ValueRange> ranges;  ///< of each layer
  std::uint64_t checksum = 0;      ///< of the rows (PartChecksum)

  PixelRegion region() const { return part_of(picture.region, index, picture.count); }
  friend bool operator==(const PartHead&, const PartHead&) = default;
};

/// The head of a part with these pixels; `image` and `layers` have its size and nothing else.
PartHead make_part_head(const DividedPicture& picture, std::uint32_t index, const Image& image,
                        std::span<const ImageLayer> layers);

/// Row y of the part, counted from its top, as it stands in the file.
std::string part_row(const Image& image, std::span<const ImageLayer> layers, int y);
/// How long a row is for a part of this picture that is so many pixels wide.
std::size_t part_row_bytes(const DividedPicture& picture, int width);

/// All that stands before the rows.
std::string encode_part_head(const PartHead& head);

/// No head is longer; that many bytes from the start of a file are enough to read it.
inline constexpr std::size_t most_part_head_bytes = std::size_t{1} << 16;

/// Reads what encode_part_head() made from the first bytes of a file. Returns what is wrong, for a
/// person; empty: nothing. `bytes_before_rows`: how long it is.
std::string decode_part_head(std::string_view first_bytes, PartHead& head,
                             std::size_t& bytes_before_rows);

/// How long the whole file is.
std::uint64_t part_file_bytes(const PartHead& head, std::size_t bytes_before_rows);

/// Whether a file that starts so is, or once was, a part.
bool is_part_file(std::string_view first_bytes);

/// Why a part with the first key is none of the picture with the second, in words that follow "it
/// is of"; empty where it is.
std::string_view foreign_part(const PartKey& found, const PartKey& wanted);

/// Copies rows of a part, bytes as in the file, to where they belong. `rows`: whole rows of the
/// part, beginning with the row `y` of the picture. `to`: the picture itself first, then its
/// layers; their values are those of rows of the whole picture, beginning with the row `first`.
void place_part_rows(const PartHead& head, std::string_view rows, int y, int first,
                     std::span<ImageLayer> to);

}  // namespace scenefile
