// PNG decoding with libpng, which reports errors by longjmp, so functions between setjmp and
// the library hold no objects with destructors; those live in the callers.

#include "scenefile/asset/codec.h"

#include <png.h>

#include <array>
#include <csetjmp>
#include <cstdlib>
#include <cstring>
#include <new>
#include <vector>

namespace scenefile {

namespace {

constexpr std::string_view signature("\x89PNG\r\n\x1a\n", 8);

// The error from the library, stored where longjmp cannot lose it.
struct Message {
  std::array<char, 160> text{};
  bool out_of_memory = false;
};

extern "C" png_voidp png_take(png_structp png, png_alloc_size_t bytes) {
  void* const memory = std::malloc(bytes);
  if (memory == nullptr) {
    static_cast<Message*>(png_get_mem_ptr(png))->out_of_memory = true;
  }
  return memory;
}

extern "C" void png_give(png_structp, png_voidp memory) {
  std::free(memory);
}

extern "C" void png_failed(png_structp png, png_const_charp text) {
  auto* message = static_cast<Message*>(png_get_error_ptr(png));
  std::strncpy(message->text.data(), text, message->text.size() - 1);
  png_longjmp(png, 1);
}

extern "C" void png_warned(png_structp, png_const_charp) {}

constexpr png_uint_32 idat = 0x49444154;

struct Source {
  const char* at;
  std::size_t left;
  // The library decompresses data after the last pixel, up to a thousand times its size, only to
  // discard it.
  bool ending = false;    // the last rows are being read
  std::size_t ample = 0;  // more bytes of IDAT than those rows can need
};

extern "C" void png_fetch(png_structp png, png_bytep to, png_size_t count) {
  auto* source = static_cast<Source*>(png_get_io_ptr(png));
  if (count > source->left) {
    png_error(png, ends_early.data());
  }
  if (source->ending && png_get_io_chunk_type(png) == idat) {
    if (count > source->ample) {
      png_error(png, "it contains far more data than pixels");
    }
    source->ample -= count;
  }
  std::memcpy(to, source->at, count);
  source->at += count;
  source->left -= count;
}

std::uint32_t big_endian(std::string_view bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    value = value << 8 | static_cast<std::uint8_t>(bytes[at + i]);
  }
  return value;
}

bool recognizes_png(std::string_view bytes) {
  return bytes.substr(0, signature.size()) == signature;
}

bool is_indexed(std::string_view bytes) {
  return bytes[25] == PNG_COLOR_TYPE_PALETTE;
}

Result<ImageHeader> read_png_header(std::string_view bytes) {
  if (bytes.size() < 33) {
    return input_error(std::string(ends_early));
  }
  if (bytes.substr(12, 4) != "IHDR") {
    return input_error("it does not begin with IHDR");
  }
  ImageHeader header;
  header.width = big_endian(bytes, 16);
  header.height = big_endian(bytes, 20);
  const auto depth = static_cast<std::uint8_t>(bytes[24]);
  const bool rgb = (bytes[25] & 2) != 0 && (bytes[25] & 1) == 0;
  const std::uint64_t bits = header.width * depth * (rgb ? 3 : 1);
  header.working_bytes = is_indexed(bytes) ? header.width * header.height : 0;
  // Deflate shrinks to 1/1032 at best (zlib, "Technical Details").
  header.min_bytes = (bits / 8 + 1) * header.height / 1032;
  return header;
}

// Irrelevant chunks are not parsed: 8 kB of compressed text expand to 8 MB, and a file of 8 MB can
// hold a thousand such chunks. Gamma is not part of the scene format.
void skip_ancillary_chunks(png_structp png) {
  static const png_byte names[] =
      "bKGD\0cHRM\0eXIf\0gAMA\0hIST\0iCCP\0iTXt\0oFFs\0pCAL\0pHYs\0sBIT\0sCAL\0sPLT\0sRGB\0sTER\0"
      "tEXt\0tIME\0tRNS\0zTXt";
  png_set_keep_unknown_chunks(png, PNG_HANDLE_CHUNK_NEVER, nullptr, 0);
  png_set_keep_unknown_chunks(png, PNG_HANDLE_CHUNK_NEVER, names,
                              static_cast<int>(sizeof names / 5));
}

// The rows from the library are RGB, or palette indices, whose range it does not check.
struct PngPixels {
  std::vector<std::uint8_t> bytes;
  std::vector<std::uint8_t> row_with_alpha;
  bool alpha = false;    // rows come with alpha
  bool visible = false;  // some alpha is not 0
  bool indexed = false;
  png_colorp palette = nullptr;
  int colors = 0;
};

// One byte per index, three per color, four with alpha; returns the number of passes over the
// image.
int convert_samples(png_structp png, png_infop info, const PngPixels& pixels) {
  const int passes = png_set_interlace_handling(png);
  png_set_packing(png);
  if (!pixels.indexed) {
    png_set_expand_gray_1_2_4_to_8(png);
    png_set_gray_to_rgb(png);
    png_set_scale_16(png);
    if (!pixels.alpha) {
      png_set_strip_alpha(png);
    }
  }
  png_read_update_info(png, info);
  return passes;
}

// Reads a row and drops its alpha.
void read_row_with_alpha(png_structp png, PngPixels& pixels, std::uint8_t* to) {
  png_read_row(png, pixels.row_with_alpha.data(), nullptr);
  std::uint8_t most = 0;
  for (std::size_t i = 0; i < pixels.row_with_alpha.size(); i += 4, to += 3) {
    const std::uint8_t* const from = pixels.row_with_alpha.data() + i;
    std::memcpy(to, from, 3);
    most |= from[3];
  }
  pixels.visible = pixels.visible || most != 0;
}

// Rows are appended as they arrive, unless there are several passes. The memory is reserved.
void read_rows(png_structp png, int passes, std::size_t row, int height, PngPixels& pixels) {
  std::vector<std::uint8_t>& bytes = pixels.bytes;
  auto* source = static_cast<Source*>(png_get_io_ptr(png));
  source->ample = 8 * row + (1 << 16);
  if (passes > 1) {
    bytes.resize(row * static_cast<std::size_t>(height));
  }
  for (int pass = 0; pass < passes; ++pass) {
    for (int y = 0; y < height; ++y) {
      // With an odd number of rows the last pass does not contain the last row; with few rows a
      // pass may be empty.
      source->ending = (pass == passes - 1 || height <= 4) && y >= height - 2;
      if (passes == 1) {
        bytes.resize(row * static_cast<std::size_t>(y + 1));
      }
      std::uint8_t* const to = bytes.data() + row * static_cast<std::size_t>(y);
      if (pixels.alpha) {
        read_row_with_alpha(png, pixels, to);
      } else {
        png_read_row(png, to, nullptr);
      }
    }
  }
}

bool read_image(png_structp png, png_infop info, const Texture& texture, PngPixels& pixels) {
  if (setjmp(png_jmpbuf(png)) != 0) {
    return false;
  }
  skip_ancillary_chunks(png);
  png_read_info(png, info);
  const int passes = convert_samples(png, info, pixels);
  const auto width = static_cast<std::size_t>(texture.width);
  const std::size_t row = width * (pixels.indexed ? std::size_t{1} : std::size_t{3});
  if (png_get_rowbytes(png, info) != (pixels.alpha ? 4 * width : row)) {
    png_error(png, "its rows have an unexpected length");
  }
  png_get_PLTE(png, info, &pixels.palette, &pixels.colors);
  read_rows(png, passes, row, texture.height, pixels);
  png_read_end(png, nullptr);
  return true;
}

Result<void> look_up_colors(const PngPixels& pixels, std::vector<std::uint8_t>& rgb) {
  for (const std::uint8_t index : pixels.bytes) {
    if (index >= pixels.colors) {
      return input_error("a pixel has a color beyond the end of the palette");
    }
    const png_color& color = pixels.palette[index];
    rgb.insert(rgb.end(), {color.red, color.green, color.blue});
  }
  return {};
}

Result<void> decode_png(std::string_view bytes, DecodedPicture& picture) {
  Texture& texture = picture.texture;
  Message message;
  Source source{bytes.data(), bytes.size()};
  PngPixels pixels;
  pixels.indexed = is_indexed(bytes);
  if (pixels.indexed) {
    pixels.bytes.reserve(texture.rgb.capacity() / 3);
  } else {
    pixels.bytes.swap(texture.rgb);
  }
  // Several passes fill the rows of the result, which have no place for alpha.
  pixels.alpha = (bytes[25] & PNG_COLOR_MASK_ALPHA) != 0 && bytes[28] == PNG_INTERLACE_NONE;
  if (pixels.alpha) {
    pixels.row_with_alpha.resize(std::size_t{4} * static_cast<std::size_t>(texture.width));
  }
  png_structp png = png_create_read_struct_2(PNG_LIBPNG_VER_STRING, &message, png_failed,
                                             png_warned, &message, png_take, png_give);
  png_infop info = png != nullptr ? png_create_info_struct(png) : nullptr;
  if (info == nullptr) {
    png_destroy_read_struct(&png, nullptr, nullptr);
    throw std::bad_alloc();
  }
  png_set_read_fn(png, &source, png_fetch);
  png_set_user_limits(png, static_cast<png_uint_32>(texture.width),
                      static_cast<png_uint_32>(texture.height));
  Result<void> result;
  if (!read_image(png, info, texture, pixels)) {
    result = input_error(message.text.data());
  } else if (pixels.indexed) {
    result = look_up_colors(pixels, texture.rgb);
  } else {
    texture.rgb.swap(pixels.bytes);
    picture.transparent = pixels.alpha && !pixels.visible;
  }
  png_destroy_read_struct(&png, &info, nullptr);
  if (message.out_of_memory) {
    throw std::bad_alloc();
  }
  return result;
}

}  // namespace

const Codec png_codec{{"PNG", ".png"}, recognizes_png, read_png_header, decode_png};

}  // namespace scenefile
