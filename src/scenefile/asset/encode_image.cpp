#include "scenefile/asset/codec.h"
#include "scenefile/asset/image_file.h"
#include "scenefile/asset/image_stream.h"
#include "scenefile/base/text.h"

#include <fmt/format.h>

#include <bit>

namespace scenefile {

namespace {

void append_float(std::string& bytes, float value) {
  const auto bits = std::bit_cast<std::uint32_t>(value);
  for (int shift = 0; shift < 32; shift += 8) {
    bytes.push_back(static_cast<char>(bits >> shift & 255));
  }
}

std::string encode_pfm(const Image& image) {
  std::string bytes;
  bytes.reserve(64 + 4 * image.rgb.size());
  stream_pfm(
      image.width, image.height, [&](int y) { return image.pixel(0, y); }, sink_to(bytes));
  return bytes;
}

Result<std::string> encode_exr(const Image& image, const FileNote& note) {
  const ImageLayer picture{"", {"R", "G", "B"}, false, image.rgb};
  return encode_layers(image.width, image.height, {&picture, 1}, note);
}

bool ends_with(std::string_view text, std::string_view end) {
  return text.size() >= end.size() &&
         equal_ignoring_case(text.substr(text.size() - end.size()), end);
}

}  // namespace

ByteSink sink_to(std::string& bytes) {
  return {[&bytes](std::string_view more) {
            bytes += more;
            return true;
          },
          [&bytes](std::uint64_t at, std::string_view other) {
            bytes.replace(at, other.size(), other);
            return true;
          }};
}

// Portable float map: a text header, then rows from the bottom up. A negative scale means
// little-endian numbers. Source: Debevec, "PFM Portable FloatMap Image Format".
bool stream_pfm(int width, int height, const RowSource& rows, const ByteSink& sink) {
  std::string bytes = fmt::format("PF\n{} {}\n-1.0\n", width, height);
  for (int y = height - 1; y >= 0; --y) {
    const float* const row = rows(y);
    if (row == nullptr) {
      return false;
    }
    for (int i = 0; i < 3 * width; ++i) {
      append_float(bytes, row[i]);
    }
    if (!sink.append(bytes)) {
      return false;
    }
    bytes.clear();
  }
  return true;
}

std::optional<ImageFormat> image_format_of(std::string_view file_name) {
  if (ends_with(file_name, ".png")) {
    return ImageFormat::png8;
  }
  if (ends_with(file_name, ".exr")) {
    return ImageFormat::exr;
  }
  if (ends_with(file_name, ".pfm")) {
    return ImageFormat::pfm;
  }
  return std::nullopt;
}

Result<std::string> encode_image(const Image& image, ImageFormat format, Rounding rounding,
                                 const FileNote& note) {
  if (image.rgb.empty()) {
    return input_error("an image without pixels cannot be written");
  }
  switch (format) {
    case ImageFormat::png8:
      return encode_png(image, 8, rounding, note.text);
    case ImageFormat::png16:
      return encode_png(image, 16, rounding, note.text);
    case ImageFormat::exr:
      return encode_exr(image, note);
    case ImageFormat::pfm:
      break;
  }
  return encode_pfm(image) + note.text;
}

}  // namespace scenefile
