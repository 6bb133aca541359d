// Feeds bytes to decode_image() or decode_picture(). SCENEFILE_FUZZ_IMAGE selects the format, so
// that a fuzzer does not drift to other formats.

#include "law.h"
#include "scenefile/asset/image_file.h"
#include "target.h"

#include <cstring>
#include <string>
#include <string_view>

namespace {

using namespace scenefile;
using fuzz::require;

constexpr std::string_view format = SCENEFILE_FUZZ_IMAGE;

bool is_png(std::string_view bytes) {
  return bytes.substr(0, 4) == "\x89PNG";
}

bool is_mine(std::string_view bytes) {
  if (is_png(bytes)) {
    return format == "png";
  }
  if (bytes.substr(0, 2) == "\xff\xd8") {
    return format == "jpeg";
  }
  if (bytes.substr(0, 3) == "GIF") {
    return format == "gif";
  }
  if (bytes.substr(0, 2) == "BM") {
    return format == "bmp";
  }
  if (bytes.substr(0, 4) == "\x76\x2f\x31\x01") {
    return format == "exr";
  }
  if (bytes.size() > 1 && bytes[0] == 'P' && std::string_view("2356Ff").find(bytes[1]) < 6) {
    return format == "pnm";
  }
  return format == "tga";  // has no signature
}

std::uint32_t crc32(std::string_view bytes) {
  std::uint32_t crc = 0xffffffffu;
  for (const char c : bytes) {
    crc ^= static_cast<unsigned char>(c);
    for (int bit = 0; bit < 8; ++bit) {
      crc = (crc >> 1) ^ ((crc & 1) != 0 ? 0xedb88320u : 0);
    }
  }
  return ~crc;
}

std::uint32_t big_endian(std::string_view bytes) {
  std::uint32_t value = 0;
  for (const char c : bytes.substr(0, 4)) {
    value = value << 8 | static_cast<unsigned char>(c);
  }
  return value;
}

// No fuzzer guesses a checksum: without this, every change to a PNG would fail at the first chunk.
std::string with_right_checksums(std::string_view png) {
  std::string fixed(png);
  std::size_t at = 8;
  while (at + 12 <= fixed.size()) {
    const std::size_t length = big_endian(std::string_view(fixed).substr(at));
    if (length > fixed.size() - at - 12) {
      break;
    }
    const std::uint32_t crc = crc32(std::string_view(fixed).substr(at + 4, length + 4));
    for (std::size_t i = 0; i < 4; ++i) {
      fixed[at + 8 + length + i] = static_cast<char>(crc >> (24 - 8 * i));
    }
    at += length + 12;
  }
  return fixed;
}

void judge(std::string_view bytes, const Limits& limits) {
  std::uint64_t budget = limits.texture_bytes;
  const Result<Texture> decoded = decode_image(bytes, limits, budget);
  require(budget <= limits.texture_bytes, "the budget never grows");
  if (!decoded) {
    require(!decoded.error().text.empty(), "there is a picture or a reason");
    return;
  }
  const Texture& texture = *decoded;
  require(!texture.empty(), "there is a picture or a reason");
  const auto side = static_cast<int>(limits.texture_side);
  require(
      texture.width >= 1 && texture.width <= side && texture.height >= 1 && texture.height <= side,
      "sides are bounded");
  require(texture.rgb.size() == std::size_t{3} * texture.width * texture.height,
          "a picture is complete");
  require(texture.rgb.size() <= limits.texture_bytes - budget, "bytes are counted");
}

// For the formats that textures do not have. Floats take five times the memory of the result.
void judge_picture(std::string_view bytes, std::string_view layer, const Limits& limits) {
  const Result<DecodedPicture> decoded = decode_picture(bytes, layer, limits);
  if (!decoded) {
    require(!decoded.error().text.empty(), "there is a picture or a reason");
    return;
  }
  const auto& [texture, linear, not_finite, jpeg, transparent] = *decoded;
  const std::size_t values = std::size_t{3} * texture.width * texture.height;
  require(values > 0 && texture.rgb.size() == values, "a picture is complete");
  require(linear.rgb.empty() || linear.rgb.size() == values, "floats are complete");
  require(linear.rgb.size() * sizeof(float) + values <= limits.texture_bytes, "bytes are limited");
  require(not_finite <= values / 3 && !jpeg && !transparent, "pixels are counted");
}

// Decoded pictures survive encoding; only for pictures small enough to test each time.
void judge_round_trip(std::string_view bytes) {
  const Limits limits;
  std::uint64_t budget = 4096;
  const Result<Texture> texture = decode_image(bytes, limits, budget);
  if (!texture) {
    return;
  }
  const Result<std::string> png =
      encode_image(to_float(*texture), ImageFormat::png8, Rounding::nearest);
  require(bool(png), "a decoded picture can be encoded");
  const Result<Texture> again = decode_image(*png);
  require(again && again->rgb == texture->rgb, "encoding keeps every pixel");
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view input(reinterpret_cast<const char*>(data), size);
  if (!is_mine(input)) {
    return -1;
  }
  const std::string bytes = is_png(input) ? with_right_checksums(input) : std::string(input);
  Limits limits;
  limits.texture_side = 2048;
  limits.texture_bytes = std::uint64_t{1} << 20;
  if (format == "exr" || format == "pnm") {
    judge_picture(bytes, {}, limits);
    judge_picture(bytes, "a", limits);
    limits.texture_bytes = 200;
    judge_picture(bytes, {}, limits);
    return 0;
  }
  judge(bytes, limits);
  limits.texture_side = 4;
  limits.texture_bytes = 20;
  judge(bytes, limits);
  judge_round_trip(bytes);
  return 0;
}
