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

Result<Texture> decode(const Codec& codec, std::string_view bytes, const Limits& limits,
                       std::uint64_t budget) {
  const Result<ImageHeader> header = codec.read_header(bytes);
  if (!header) {
    return input_error(fmt::format("{}: {}", codec.name, header.error().text));
  }
  const auto failed = [&](std::string_view why, ErrorKind kind) {
    return Error{
        fmt::format("{} of {} x {} pixels: {}", codec.name, header->width, header->height, why),
        kind};
  };
  if (const std::string why = over_limits(*header, limits, budget); !why.empty()) {
    return failed(why, ErrorKind::limit);
  }
  if (const std::string why = implausible(*header, bytes.size()); !why.empty()) {
    return failed(why, ErrorKind::input);
  }
  Texture texture;
  texture.width = static_cast<int>(header->width);
  texture.height = static_cast<int>(header->height);
  texture.rgb.reserve(3 * header->width * header->height);
  if (const Result<void> done = codec.decode(bytes, texture); !done) {
    return failed(done.error().text, ErrorKind::input);
  }
  return texture;
}

}  // namespace

std::uint64_t decoded_bytes(std::string_view bytes) {
  const Codec* const codec = codec_of(bytes);
  const Result<ImageHeader> header =
      codec != nullptr ? codec->read_header(bytes) : input_error("unknown");
  if (!header) {
    return 0;
  }
  constexpr std::uint64_t most = 1u << 24;  // no product overflows
  return 3 * std::min<std::uint64_t>(header->width, most) *
         std::min<std::uint64_t>(header->height, most);
}

bool is_image(std::string_view bytes) {
  return codec_of(bytes) != nullptr;
}

Result<Texture> decode_image(std::string_view bytes, const Limits& limits, std::uint64_t& budget) {
  if (bytes.empty()) {
    return input_error("the file is empty");
  }
  const Codec* const codec = codec_of(bytes);
  if (codec == nullptr) {
    return input_error("this is not a PNG, JPEG, GIF, TGA or BMP image");
  }
  Result<Texture> texture = decode(*codec, bytes, limits, budget);
  budget -= texture ? texture->rgb.size() : 0;
  return texture;
}

Result<Texture> decode_image(std::string_view bytes, const Limits& limits) {
  std::uint64_t budget = limits.texture_bytes;
  return decode_image(bytes, limits, budget);
}

}  // namespace scenefile
