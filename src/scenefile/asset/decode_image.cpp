#include "scenefile/asset/codec.h"
#include "scenefile/asset/image_file.h"

#include <fmt/format.h>

#include <algorithm>

namespace scenefile {

namespace {

// TGA last: it has no signature and is recognized only by a plausible header.
constexpr const Codec* codecs[] = {&png_codec, &jpeg_codec, &gif_codec, &bmp_codec, &tga_codec};

const Codec* codec_of(std::string_view bytes) {
  for (const Codec* codec : codecs) {
    if (codec->recognizes(bytes)) {
      return codec;
    }
  }
  return nullptr;
}

std::uint64_t megabytes(std::uint64_t bytes) {
  return (bytes + 999'999) / 1'000'000;
}

// Why a file with this header exceeds the limits, or nothing.
std::string over_limits(const ImageHeader& header, const Limits& limits, std::uint64_t budget) {
  const std::uint32_t side = std::min(limits.texture_side, 1u << 24);  // no product overflows
  if (header.width > side || header.height > side) {
    return fmt::format("the limit is {} pixels on a side", side);
  }
  const std::uint64_t result = 3 * header.width * header.height;
  if (result > budget) {
    return fmt::format("that takes {} MB, and {} MB are left of the limit for all textures",
                       megabytes(result), budget / 1'000'000);
  }
  if (result + header.working_bytes > limits.texture_bytes) {
    return fmt::format("decoding that takes {} MB, and the limit is {} MB",
                       megabytes(result + header.working_bytes), limits.texture_bytes / 1'000'000);
  }
  return {};
}

// Why no valid file can have this header, or nothing.
std::string implausible(const ImageHeader& header, std::size_t bytes) {
  if (header.width == 0 || header.height == 0) {
    return "an image needs at least one pixel";
  }
  if (bytes < header.min_bytes) {
    return fmt::format("that many cannot be in {} bytes: the file is truncated or damaged", bytes);
  }
  return {};
}

bool decode(const Codec& codec, std::string_view bytes, const Limits& limits, std::uint64_t budget,
            Texture& texture, std::string& error, bool& over_limit) {
  ImageHeader header;
  if (!codec.read_header(bytes, header, error)) {
    error = fmt::format("{}: {}", codec.name, error);
    return false;
  }
  error = over_limits(header, limits, budget);
  over_limit = !error.empty();
  if (!over_limit) {
    error = implausible(header, bytes.size());
  }
  if (!error.empty()) {
    error = fmt::format("{} of {} x {} pixels: {}", codec.name, header.width, header.height, error);
    return false;
  }
  texture.width = static_cast<int>(header.width);
  texture.height = static_cast<int>(header.height);
  texture.rgb.reserve(3 * header.width * header.height);
  if (!codec.decode(bytes, texture, error)) {
    error = fmt::format("{} of {} x {} pixels: {}", codec.name, header.width, header.height, error);
    return false;
  }
  return true;
}

}  // namespace

std::uint64_t decoded_bytes(std::string_view bytes) {
  const Codec* const codec = codec_of(bytes);
  ImageHeader header;
  std::string error;
  if (codec == nullptr || !codec->read_header(bytes, header, error)) {
    return 0;
  }
  constexpr std::uint64_t most = 1u << 24;  // no product overflows
  return 3 * std::min<std::uint64_t>(header.width, most) *
         std::min<std::uint64_t>(header.height, most);
}

bool is_image(std::string_view bytes) {
  return codec_of(bytes) != nullptr;
}

Texture decode_image(std::string_view bytes, const Limits& limits, std::uint64_t& budget,
                     std::string& error, bool* over_limit) {
  error.clear();
  bool limit = false;
  Texture texture;
  const Codec* codec = codec_of(bytes);
  if (bytes.empty()) {
    error = "the file is empty";
  } else if (codec == nullptr) {
    error = "this is not a PNG, JPEG, GIF, TGA or BMP image";
  } else if (decode(*codec, bytes, limits, budget, texture, error, limit)) {
    budget -= texture.rgb.size();
  }
  if (!error.empty()) {
    texture = {};
  }
  if (over_limit != nullptr) {
    *over_limit = limit;
  }
  return texture;
}

}  // namespace scenefile
