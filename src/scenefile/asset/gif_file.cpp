// The first frame of a GIF. Source: CompuServe, "Graphics Interchange Format, Version 89a".

#include "scenefile/asset/byte_reader.h"
#include "scenefile/asset/codec.h"

#include <algorithm>
#include <array>

namespace scenefile {

namespace {

constexpr std::uint32_t max_codes = 4096;

struct Palette {
  std::array<std::uint8_t, 768> rgb{};
  std::uint32_t colors = 0;
};

struct Frame {
  std::uint32_t left, top, width, height;
  bool interlaced;
};

bool recognizes_gif(std::string_view bytes) {
  return bytes.substr(0, 6) == "GIF87a" || bytes.substr(0, 6) == "GIF89a";
}

Result<ImageHeader> read_gif_header(std::string_view bytes) {
  ImageHeader header;
  ByteReader in(bytes, 6);
  header.width = in.u16();
  header.height = in.u16();
  // A code of at least 3 bits encodes at most 4096 pixels.
  header.min_bytes = header.width * header.height / (max_codes * 8 / 3);
  return header;
}

Palette read_palette(ByteReader& in, std::uint32_t flags) {
  Palette palette;
  if ((flags & 0x80) != 0) {
    palette.colors = 2u << (flags & 7);
    for (std::uint32_t i = 0; i < 3 * palette.colors; ++i) {
      palette.rgb[i] = static_cast<std::uint8_t>(in.u8());
    }
  }
  return palette;
}

// Data comes in blocks of up to 255 bytes; an empty block ends it.
void skip_blocks(ByteReader& in) {
  while (const std::uint32_t size = in.u8()) {
    in.skip(size);
  }
}

// Skips extensions up to the first image. False if there is none.
bool find_image(ByteReader& in) {
  while (!in.ended()) {
    const std::uint32_t tag = in.u8();
    if (tag == 0x2c) {
      return true;
    }
    if (tag != 0x21) {
      return false;
    }
    in.skip(1);
    skip_blocks(in);
  }
  return false;
}

// Reads variable-length codes from the blocks.
class CodeReader {
 public:
  explicit CodeReader(ByteReader& in) : in_(in) {}

  // False at the end of the data.
  bool next(std::uint32_t bits, std::uint32_t& code) {
    while (held_bits_ < bits) {
      if (block_left_ == 0) {
        block_left_ = in_.u8();
        if (block_left_ == 0) {
          return false;
        }
      }
      held_ |= in_.u8() << held_bits_;
      held_bits_ += 8;
      --block_left_;
    }
    code = held_ & ((1u << bits) - 1);
    held_ >>= bits;
    held_bits_ -= bits;
    return !in_.ended();
  }

 private:
  ByteReader& in_;
  std::uint32_t held_ = 0;
  std::uint32_t held_bits_ = 0;
  std::uint32_t block_left_ = 0;
};

// The LZW dictionary: each string is an earlier one plus a color.
class StringTable {
 public:
  explicit StringTable(std::uint32_t code_bits) : colors_(1u << code_bits) { clear(); }

  void clear() { size_ = colors_ + 2; }
  std::uint32_t clear_code() const { return colors_; }
  std::uint32_t end_code() const { return colors_ + 1; }
  std::uint32_t size() const { return size_; }

  void add(std::uint32_t prefix, std::uint8_t color) {
    if (size_ < max_codes) {
      entries_[size_++] = {static_cast<std::uint16_t>(prefix), color};
    }
  }

  // Writes the string backwards, ending at `end`; returns its start.
  std::uint8_t* expand(std::uint32_t code, std::uint8_t* end) const {
    while (code >= colors_ + 2) {
      *--end = entries_[code].color;
      code = entries_[code].prefix;
    }
    *--end = static_cast<std::uint8_t>(code);
    return end;
  }

 private:
  struct Entry {
    std::uint16_t prefix;
    std::uint8_t color;
  };
  std::array<Entry, max_codes> entries_{};
  std::uint32_t colors_;
  std::uint32_t size_ = 0;
};

// Writes the colors of a frame to their positions.
class Canvas {
 public:
  Canvas(Texture& texture, const Frame& frame, const Palette& palette)
      : texture_(texture), frame_(frame), palette_(palette) {}

  bool full() const { return row_ >= frame_.height; }
  bool bad_color() const { return bad_color_; }

  void put(std::uint8_t color) {
    if (color >= palette_.colors) {
      bad_color_ = true;
      return;
    }
    const std::size_t x = frame_.left + column_;
    const std::size_t y = frame_.top + row_;
    const std::uint8_t* from = palette_.rgb.data() + 3 * std::size_t{color};
    std::copy(from, from + 3,
              texture_.rgb.begin() + 3 * (y * static_cast<std::size_t>(texture_.width) + x));
    if (++column_ == frame_.width) {
      column_ = 0;
      next_row();
    }
  }

 private:
  // Interlaced: rows 0, 8, ..., then 4, 12, ..., then 2, 6, ..., then 1, 3, ...
  void next_row() {
    if (!frame_.interlaced) {
      ++row_;
      return;
    }
    constexpr std::uint32_t start[] = {0, 4, 2, 1};
    constexpr std::uint32_t step[] = {8, 8, 4, 2};
    row_ += step[pass_];
    while (row_ >= frame_.height && pass_ < 3) {
      row_ = start[++pass_];
    }
  }

  Texture& texture_;
  const Frame& frame_;
  const Palette& palette_;
  std::uint32_t column_ = 0;
  std::uint32_t row_ = 0;
  std::uint32_t pass_ = 0;
  bool bad_color_ = false;
};

Result<void> read_pixels(ByteReader& in, Canvas& canvas) {
  const std::uint32_t code_bits = in.u8();
  if (code_bits < 1 || code_bits > 8) {
    return input_error("its colors have an impossible number of bits");
  }
  StringTable table(code_bits);
  CodeReader codes(in);
  std::array<std::uint8_t, max_codes> buffer{};
  std::uint8_t* const end = buffer.data() + buffer.size();
  std::uint32_t bits = code_bits + 1;
  std::uint32_t code = 0;
  std::uint32_t last = table.clear_code();
  while (!canvas.full()) {
    if (!codes.next(bits, code) || code == table.end_code()) {
      return input_error(std::string(ends_early));
    }
    if (code == table.clear_code()) {
      table.clear();
      bits = code_bits + 1;
      last = code;
      continue;
    }
    const bool first = last == table.clear_code();
    const bool newest = code == table.size() && !first;
    if (code >= table.size() && !newest) {
      return input_error("it contains an invalid code");
    }
    // A code for the string under construction: the previous string plus its own first color.
    std::uint8_t* begin = table.expand(newest ? last : code, newest ? end - 1 : end);
    if (newest) {
      end[-1] = *begin;
    }
    if (!first) {
      table.add(last, *begin);
    }
    for (; begin != end && !canvas.full(); ++begin) {
      canvas.put(*begin);
    }
    if (canvas.bad_color()) {
      return input_error("a pixel has a color beyond the end of the palette");
    }
    bits += table.size() == 1u << bits && bits < 12 ? 1 : 0;
    last = code;
  }
  return {};
}

void fill_background(Texture& texture, const Palette& palette, std::uint32_t index) {
  texture.rgb.resize(std::size_t{3} * static_cast<std::size_t>(texture.width) *
                     static_cast<std::size_t>(texture.height));
  const std::size_t from = index < palette.colors ? 3 * std::size_t{index} : 0;
  for (std::size_t i = 0; palette.colors > 0 && i < texture.rgb.size(); ++i) {
    texture.rgb[i] = palette.rgb[from + i % 3];
  }
}

Result<void> decode_gif(std::string_view bytes, DecodedPicture& picture) {
  Texture& texture = picture.texture;
  ByteReader in(bytes, 10);
  const std::uint32_t flags = in.u8();
  const std::uint32_t background = in.u8();
  in.skip(1);
  const Palette shared = read_palette(in, flags);
  if (!find_image(in)) {
    return input_error("it contains no image");
  }
  Frame frame{in.u16(), in.u16(), in.u16(), in.u16(), false};
  const std::uint32_t frame_flags = in.u8();
  frame.interlaced = (frame_flags & 0x40) != 0;
  const Palette own = read_palette(in, frame_flags);
  if (frame.width == 0 || frame.height == 0 ||
      frame.left + frame.width > static_cast<std::uint32_t>(texture.width) ||
      frame.top + frame.height > static_cast<std::uint32_t>(texture.height)) {
    return input_error("its first frame is empty or reaches beyond the image");
  }
  fill_background(texture, shared, background);
  Canvas canvas(texture, frame, own.colors > 0 ? own : shared);
  return read_pixels(in, canvas);
}

}  // namespace

const Codec gif_codec{{"GIF", ".gif"}, recognizes_gif, read_gif_header, decode_gif};

}  // namespace scenefile
