// Truevision TGA. Source: Truevision, "TGA File Format Specification", version 2.0.

#include "scenefile/asset/byte_reader.h"
#include "scenefile/asset/codec.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace scenefile {

namespace {

constexpr std::size_t header_bytes = 18;

struct TgaHeader {
  std::uint32_t id_bytes, has_palette, type;
  std::uint32_t palette_first, palette_length, palette_bits;
  std::uint32_t width, height, bits, descriptor;

  bool indexed() const { return (type & 7) == 1; }
  bool gray() const { return (type & 7) == 3; }
  bool packed() const { return (type & 8) != 0; }
  bool from_top() const { return (descriptor & 0x20) != 0; }
  bool from_right() const { return (descriptor & 0x10) != 0; }
};

TgaHeader tga_header(std::string_view bytes) {
  ByteReader in(bytes);
  TgaHeader h{};
  h.id_bytes = in.u8();
  h.has_palette = in.u8();
  h.type = in.u8();
  h.palette_first = in.u16();
  h.palette_length = in.u16();
  h.palette_bits = in.u8();
  in.skip(4);
  h.width = in.u16();
  h.height = in.u16();
  h.bits = in.u8();
  h.descriptor = in.u8();
  return h;
}

bool is_color_depth(std::uint32_t bits) {
  return bits == 15 || bits == 16 || bits == 24 || bits == 32;
}

// TGA has no signature, so every field must be plausible.
bool recognizes_tga(std::string_view bytes) {
  if (bytes.size() < header_bytes) {
    return false;
  }
  const TgaHeader h = tga_header(bytes);
  const bool type =
      h.type == 1 || h.type == 2 || h.type == 3 || h.type == 9 || h.type == 10 || h.type == 11;
  const bool palette = h.has_palette == 0 ? h.palette_length == 0 && !h.indexed()
                                          : h.has_palette == 1 && is_color_depth(h.palette_bits);
  const bool depth = h.indexed() || h.gray() ? h.bits == 8 || h.bits == 16 : is_color_depth(h.bits);
  return type && palette && depth && (h.descriptor & 0xc0) == 0;
}

Result<ImageHeader> read_tga_header(std::string_view bytes) {
  ImageHeader header;
  const TgaHeader h = tga_header(bytes);
  header.width = h.width;
  header.height = h.height;
  const std::uint64_t pixels = header.width * header.height;
  const std::uint64_t pixel_bytes = (h.bits + 7) / 8;
  const std::uint64_t data = h.packed() ? pixels / 128 * (1 + pixel_bytes) : pixels * pixel_bytes;
  header.min_bytes =
      header_bytes + h.id_bytes + h.palette_length * ((h.palette_bits + 7) / 8) + data;
  return header;
}

using Color = std::array<std::uint8_t, 3>;

std::uint8_t from_5_bits(std::uint32_t value) {
  return static_cast<std::uint8_t>(((value & 31) * 255 + 15) / 31);
}

Color read_color(ByteReader& in, std::uint32_t bits) {
  if (bits <= 16) {
    const std::uint32_t v = in.u16();
    return {from_5_bits(v >> 10), from_5_bits(v >> 5), from_5_bits(v)};
  }
  const auto blue = static_cast<std::uint8_t>(in.u8());
  const auto green = static_cast<std::uint8_t>(in.u8());
  const auto red = static_cast<std::uint8_t>(in.u8());
  in.skip(bits == 32 ? 1 : 0);
  return {red, green, blue};
}

class TgaPixels {
 public:
  TgaPixels(std::string_view bytes, const TgaHeader& header)
      : header_(header), in_(bytes, header_bytes + header.id_bytes) {
    for (std::uint32_t i = 0; i < header.palette_length; ++i) {
      palette_.push_back(read_color(in_, header.palette_bits));
    }
  }

  // The next pixel in file order.
  Color next() {
    if (!header_.packed()) {
      return read();
    }
    if (left_ == 0) {
      const std::uint32_t packet = in_.u8();
      left_ = (packet & 127) + 1;
      repeats_ = (packet & 128) != 0;
      color_ = read();
    } else if (!repeats_) {
      color_ = read();
    }
    --left_;
    return color_;
  }

  /// Whether the last packet goes on past the pixel that was read last.
  bool in_packet() const { return left_ > 0; }
  bool ended() const { return in_.ended(); }
  bool bad_index() const { return bad_index_; }

 private:
  Color read() {
    if (header_.gray()) {
      const auto value = static_cast<std::uint8_t>(in_.u8());
      in_.skip(header_.bits == 16 ? 1 : 0);
      return {value, value, value};
    }
    if (!header_.indexed()) {
      return read_color(in_, header_.bits);
    }
    const std::uint32_t index = (header_.bits == 8 ? in_.u8() : in_.u16()) - header_.palette_first;
    if (index >= palette_.size()) {
      bad_index_ = true;
      return {};
    }
    return palette_[index];
  }

  const TgaHeader& header_;
  ByteReader in_;
  std::vector<Color> palette_;
  Color color_{};
  std::uint32_t left_ = 0;  // in the packet
  bool repeats_ = false;
  bool bad_index_ = false;
};

Result<void> decode_tga(std::string_view bytes, DecodedPicture& picture) {
  Texture& texture = picture.texture;
  const TgaHeader header = tga_header(bytes);
  TgaPixels pixels(bytes, header);
  texture.rgb.resize(std::size_t{3} * header.width * header.height);
  for (std::uint32_t row = 0; row < header.height; ++row) {
    const std::size_t y = header.from_top() ? row : header.height - 1 - row;
    for (std::uint32_t column = 0; column < header.width; ++column) {
      const std::size_t x = header.from_right() ? header.width - 1 - column : column;
      const Color color = pixels.next();
      std::copy(color.begin(), color.end(), texture.rgb.begin() + 3 * (y * header.width + x));
    }
    if (pixels.ended()) {
      return input_error(std::string(ends_early));
    }
    if (pixels.bad_index()) {
      return input_error(
          fmt::format("a pixel in row {} has a color beyond the end of the palette", row));
    }
  }
  // Packets may run from one row into the next, as those of TGA 1 do, but not out of the picture.
  if (pixels.in_packet()) {
    return input_error("the run-length data continues past the last pixel");
  }
  return {};
}

}  // namespace

const Codec tga_codec{{"TGA", ".tga"}, recognizes_tga, read_tga_header, decode_tga};

}  // namespace scenefile
