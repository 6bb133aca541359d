// JPEG decoding with libjpeg (libjpeg-turbo on Debian). It reports errors by longjmp, so functions
// between setjmp and the library hold no objects with destructors; those live in the callers.

#include "scenefile/asset/codec.h"

#include <jerror.h>
#include <jpeglib.h>

#include <csetjmp>
#include <cstdio>
#include <cstring>
#include <memory>
#include <new>
#include <utility>
#include <vector>

namespace scenefile {

namespace {

// Progressive files may ask for any number of passes over all pixels; real ones for about ten.
constexpr int max_scans = 100;

struct Decoder {
  jpeg_decompress_struct jpeg{};
  jpeg_error_mgr errors{};
  jpeg_progress_mgr progress{};
  std::jmp_buf failed{};
  char message[JMSG_LENGTH_MAX] = {};
  bool out_of_memory = false;
};

extern "C" void jpeg_failed(j_common_ptr jpeg) {
  auto* decoder = static_cast<Decoder*>(jpeg->client_data);
  (*jpeg->err->format_message)(jpeg, decoder->message);
  decoder->out_of_memory = jpeg->err->msg_code == JERR_OUT_OF_MEMORY;
  std::longjmp(decoder->failed, 1);
}

// The library continues after damage and fills the missing part with gray. Warnings that mean
// this are errors here.
extern "C" void jpeg_warned(j_common_ptr jpeg, int level) {
  const int code = jpeg->err->msg_code;
  if (level < 0 && (code == JWRN_JPEG_EOF || code == JWRN_HIT_MARKER ||
                    code == JWRN_HUFF_BAD_CODE || code == JWRN_MUST_RESYNC)) {
    jpeg_failed(jpeg);
  }
}

[[noreturn]] void refuse(Decoder& decoder, const char* why) {
  std::strncpy(decoder.message, why, sizeof decoder.message - 1);
  std::longjmp(decoder.failed, 1);
}

extern "C" void jpeg_progressed(j_common_ptr jpeg) {
  if (reinterpret_cast<j_decompress_ptr>(jpeg)->input_scan_number > max_scans) {
    refuse(*static_cast<Decoder*>(jpeg->client_data), "it has more than 100 passes over the image");
  }
}

// Up to the frame header, from which the size is known; nothing of that size is allocated yet.
void start(Decoder& decoder, std::string_view bytes) {
  jpeg_create_decompress(&decoder.jpeg);
  decoder.jpeg.client_data = &decoder;
  decoder.jpeg.progress = &decoder.progress;
  decoder.progress.progress_monitor = jpeg_progressed;
  jpeg_mem_src(&decoder.jpeg, reinterpret_cast<const unsigned char*>(bytes.data()),
               static_cast<unsigned long>(bytes.size()));
  jpeg_read_header(&decoder.jpeg, TRUE);
  if (decoder.jpeg.arith_code) {  // rarely written, and damage in it goes undetected
    refuse(decoder, "arithmetic coding is not supported");
  }
}

bool read_sizes(Decoder& decoder, std::string_view bytes, ImageHeader& header) {
  if (setjmp(decoder.failed) != 0) {
    return false;
  }
  start(decoder, bytes);
  const jpeg_decompress_struct& jpeg = decoder.jpeg;
  header.width = jpeg.image_width;
  header.height = jpeg.image_height;
  // A few rows; for progressive files all coefficients, 16 bits each.
  header.working_bytes = header.width * 64 * static_cast<std::uint64_t>(jpeg.num_components);
  const bool passes = jpeg_has_multiple_scans(&decoder.jpeg) != 0;
  for (int i = 0; passes && i < jpeg.num_components; ++i) {
    const jpeg_component_info& component = jpeg.comp_info[i];
    header.working_bytes +=
        std::uint64_t{128} * component.width_in_blocks * component.height_in_blocks;
  }
  return true;
}

// Adobe programs write inverted CMYK.
void cmyk_to_rgb(const std::uint8_t* cmyk, int width, bool inverted, std::uint8_t* rgb) {
  for (int x = 0; x < width; ++x) {
    for (int channel = 0; channel < 3; ++channel) {
      const int ink = cmyk[4 * x + channel];
      const int black = cmyk[4 * x + 3];
      const int light = inverted ? ink * black : (255 - ink) * (255 - black);
      rgb[3 * x + channel] = static_cast<std::uint8_t>((light + 127) / 255);
    }
  }
}

bool read_image(Decoder& decoder, std::string_view bytes, Texture& texture,
                std::vector<std::uint8_t>& cmyk) {
  if (setjmp(decoder.failed) != 0) {
    return false;
  }
  start(decoder, bytes);
  jpeg_decompress_struct& jpeg = decoder.jpeg;
  const bool four = jpeg.num_components == 4;
  jpeg.out_color_space = four ? JCS_CMYK : JCS_RGB;
  jpeg_start_decompress(&jpeg);
  const std::size_t row = std::size_t{3} * static_cast<std::size_t>(texture.width);
  for (int y = 0; y < texture.height; ++y) {
    texture.rgb.resize(row * static_cast<std::size_t>(y + 1));
    std::uint8_t* rgb = texture.rgb.data() + row * static_cast<std::size_t>(y);
    JSAMPROW to = four ? cmyk.data() : rgb;
    jpeg_read_scanlines(&jpeg, &to, 1);
    if (four) {
      cmyk_to_rgb(cmyk.data(), texture.width, jpeg.saw_Adobe_marker != 0, rgb);
    }
  }
  jpeg_finish_decompress(&jpeg);
  return true;
}

std::unique_ptr<Decoder> make_decoder() {
  auto decoder = std::make_unique<Decoder>();
  decoder->jpeg.err = jpeg_std_error(&decoder->errors);
  decoder->errors.error_exit = jpeg_failed;
  decoder->errors.emit_message = jpeg_warned;
  decoder->jpeg.client_data = decoder.get();
  return decoder;
}

// Returns what made the decoder fail.
Error finish(Decoder& decoder) {
  jpeg_destroy_decompress(&decoder.jpeg);
  if (decoder.out_of_memory) {
    throw std::bad_alloc();
  }
  return input_error(decoder.message);
}

bool recognizes_jpeg(std::string_view bytes) {
  return bytes.substr(0, 3) == "\xff\xd8\xff";
}

Result<ImageHeader> read_jpeg_header(std::string_view bytes) {
  const std::unique_ptr<Decoder> decoder = make_decoder();
  ImageHeader header;
  const bool fine = read_sizes(*decoder, bytes, header);
  Error error = finish(*decoder);
  return fine ? Result<ImageHeader>(header) : std::move(error);
}

Result<void> decode_jpeg(std::string_view bytes, DecodedPicture& picture) {
  Texture& texture = picture.texture;
  const std::unique_ptr<Decoder> decoder = make_decoder();
  std::vector<std::uint8_t> cmyk(std::size_t{4} * static_cast<std::size_t>(texture.width));
  const bool fine = read_image(*decoder, bytes, texture, cmyk);
  Error error = finish(*decoder);
  return fine ? Result<void>() : std::move(error);
}

}  // namespace

const Codec jpeg_codec{{"JPEG", ".jpg .jpeg"}, recognizes_jpeg, read_jpeg_header, decode_jpeg};

}  // namespace scenefile
