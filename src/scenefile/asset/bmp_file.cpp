// Windows bitmaps without compression. Source: Microsoft, "Bitmap Storage" (Windows GDI).

#include "scenefile/asset/byte_reader.h"
#include "scenefile/asset/codec.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>

namespace scenefile {

namespace {

constexpr std::size_t file_header_bytes = 14;
constexpr std::uint32_t core_header = 12;  // from OS/2: 16-bit sizes, 3-byte colors
enum Compression : std::uint32_t { none = 0, masks = 3, masks_and_alpha = 6 };

struct BmpHeader {
  std::uint32_t pixels_at, header_bytes;
  std::uint64_t width, height;
  bool from_top;
  std::uint32_t bits, compression, colors;
  std::array<std::uint32_t, 3> mask;

  bool indexed() const { return bits <= 8; }
  std::uint64_t row_bytes() const { return (width * bits + 31) / 32 * 4; }
};

bool recognizes_bmp(std::string_view bytes) {
  return bytes.size() >= file_header_bytes + core_header && bytes.substr(0, 2) == "BM";
}

// Sizes are signed; a negative height means that rows are stored top-down.
void read_sizes(ByteReader& in, BmpHeader& h) {
  if (h.header_bytes == core_header) {
    h.width = in.u16();
    h.height = in.u16();
    return;
  }
  const auto width = static_cast<std::int32_t>(in.u32());
  const std::int64_t height = static_cast<std::int32_t>(in.u32());
  h.from_top = height < 0;
  h.width = static_cast<std::uint64_t>(width < 0 ? 0 : width);
  h.height = static_cast<std::uint64_t>(height < 0 ? -height : height);
}

BmpHeader bmp_header(std::string_view bytes) {
  ByteReader in(bytes, 10);
  BmpHeader h{};
  h.pixels_at = in.u32();
  h.header_bytes = in.u32();
  read_sizes(in, h);
  in.skip(2);
  h.bits = in.u16();
  if (h.header_bytes != core_header) {
    h.compression = in.u32();
    in.skip(12);
    h.colors = in.u32();
    in.skip(4);
  }
  if (h.compression != none) {
    h.mask = {in.u32(), in.u32(), in.u32()};
  } else if (h.bits == 16) {
    h.mask = {0x7c00, 0x03e0, 0x001f};
  } else {
    h.mask = {0xff0000, 0x00ff00, 0x0000ff};
  }
  if (h.indexed() && h.colors == 0) {
    h.colors = 1u << h.bits;
  }
  return h;
}

std::string unusable(const BmpHeader& h) {
  if (h.header_bytes != core_header && (h.header_bytes < 40 || h.header_bytes > 256)) {
    return fmt::format("unknown header of {} bytes", h.header_bytes);
  }
  if (h.pixels_at < file_header_bytes + h.header_bytes) {
    return "its pixels begin inside its header";
  }
  if (h.compression == 1 || h.compression == 2) {
    return "run-length compression is not supported; save it as PNG";
  }
  const bool masked = h.compression == masks || h.compression == masks_and_alpha;
  if (h.compression != none && !(masked && (h.bits == 16 || h.bits == 32))) {
    return fmt::format("unknown compression {}", h.compression);
  }
  const bool depth =
      h.bits == 1 || h.bits == 4 || h.bits == 8 || h.bits == 16 || h.bits == 24 || h.bits == 32;
  if (!depth) {
    return fmt::format("unknown depth of {} bits", h.bits);
  }
  if (h.indexed() && h.colors > 256) {
    return fmt::format("a palette of {} colors", h.colors);
  }
  return {};
}

Result<ImageHeader> read_bmp_header(std::string_view bytes) {
  const BmpHeader h = bmp_header(bytes);
  if (const std::string why = unusable(h); !why.empty()) {
    return input_error(why);
  }
  ImageHeader header;
  header.width = h.width;
  header.height = h.height;
  // The limits have already rejected sizes for which this product could overflow.
  header.min_bytes = h.pixels_at + h.row_bytes() * h.height;
  return header;
}

using Color = std::array<std::uint8_t, 3>;

std::vector<Color> read_palette(std::string_view bytes, const BmpHeader& h) {
  ByteReader in(bytes, file_header_bytes + h.header_bytes);
  std::vector<Color> palette;
  for (std::uint32_t i = 0; h.indexed() && i < h.colors; ++i) {
    const auto blue = static_cast<std::uint8_t>(in.u8());
    const auto green = static_cast<std::uint8_t>(in.u8());
    const auto red = static_cast<std::uint8_t>(in.u8());
    in.skip(h.header_bytes == core_header ? 0 : 1);
    palette.push_back({red, green, blue});
  }
  return palette;
}

// The bits under a mask, scaled to 8 bits.
std::uint8_t masked_value(std::uint32_t pixel, std::uint32_t mask) {
  if (mask == 0) {
    return 0;
  }
  const int shift = std::countr_zero(mask);
  const std::uint64_t value = (pixel & mask) >> shift;
  const std::uint64_t full = mask >> shift;
  return static_cast<std::uint8_t>(full == 255 ? value : (value * 255 + full / 2) / full);
}

std::uint32_t index_at(const std::uint8_t* row, std::size_t x, std::uint32_t bits) {
  const std::size_t bit = x * bits;
  return row[bit / 8] >> (8 - bits - bit % 8) & ((1u << bits) - 1);
}

Color masked_color(const std::uint8_t* row, std::size_t x, const BmpHeader& h) {
  const std::size_t size = h.bits / 8;
  std::uint32_t pixel = 0;
  for (std::size_t i = 0; i < size; ++i) {
    pixel |= std::uint32_t{row[x * size + i]} << (8 * i);
  }
  return {masked_value(pixel, h.mask[0]), masked_value(pixel, h.mask[1]),
          masked_value(pixel, h.mask[2])};
}

Result<void> decode_bmp(std::string_view bytes, DecodedPicture& picture) {
  Texture& texture = picture.texture;
  const BmpHeader h = bmp_header(bytes);
  const std::vector<Color> palette = read_palette(bytes, h);
  texture.rgb.resize(3 * h.width * h.height);
  for (std::uint64_t y = 0; y < h.height; ++y) {
    const std::uint64_t line = h.from_top ? y : h.height - 1 - y;
    const auto* row =
        reinterpret_cast<const std::uint8_t*>(bytes.data()) + h.pixels_at + line * h.row_bytes();
    std::uint8_t* to = texture.rgb.data() + 3 * h.width * y;
    for (std::uint64_t x = 0; x < h.width; ++x, to += 3) {
      Color color{};
      if (!h.indexed()) {
        color = masked_color(row, x, h);
      } else if (const std::uint32_t index = index_at(row, x, h.bits); index < palette.size()) {
        color = palette[index];
      } else {
        return input_error(
            fmt::format("a pixel in row {} has a color beyond the end of the palette", y));
      }
      std::copy(color.begin(), color.end(), to);
    }
  }
  return {};
}

}  // namespace

const Codec bmp_codec{{"BMP", ".bmp"}, recognizes_bmp, read_bmp_header, decode_bmp};

}  // namespace scenefile
