#include "scenefile/asset/codec.h"
#include "scenefile/asset/image_file.h"
#include "scenefile/base/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

namespace scenefile {

namespace {

// TGA last: it has no signature and is recognized only by a plausible header.
constexpr const Codec* picture_codecs[] = {&png_codec, &jpeg_codec, &gif_codec, &bmp_codec,
                                           &pnm_codec, &pfm_codec,  &exr_codec, &tga_codec};
constexpr const Codec* texture_codecs[] = {&png_codec, &jpeg_codec, &gif_codec, &bmp_codec,
                                           &tga_codec};

const Codec* codec_of(std::string_view bytes, std::span<const Codec* const> codecs) {
  const auto found = std::find_if(codecs.begin(), codecs.end(),
                                  [&](const Codec* codec) { return codec->recognizes(bytes); });
  return found != codecs.end() ? *found : nullptr;
}

bool is_name_of(std::span<const Codec* const> codecs, std::string_view file_name) {
  const std::size_t point = file_name.rfind('.');
  if (point == std::string_view::npos) {
    return false;
  }
  const std::string extension = lower_case(file_name.substr(point)) + " ";
  return std::any_of(codecs.begin(), codecs.end(), [&](const Codec* codec) {
    return fmt::format("{} ", codec->format.extensions).find(extension) != std::string::npos;
  });
}

std::uint64_t megabytes(std::uint64_t bytes) {
  return (bytes + 999'999) / 1'000'000;
}

// Bytes of the result for each pixel: 8-bit values, and floats if the format has them.
std::uint64_t pixel_bytes(const Codec& codec) {
  return codec.decode_linear != nullptr ? 3 + 3 * sizeof(float) : 3;
}

// Why a file with this header exceeds the limits, or nothing.
std::string over_limits(const ImageHeader& header, std::uint64_t per_pixel, const Limits& limits,
                        std::uint64_t budget) {
  const std::uint32_t side = std::min(limits.texture_side, 1u << 24);  // no product overflows
  if (header.width > side || header.height > side) {
    return fmt::format("the limit is {} pixels on a side", side);
  }
  const std::uint64_t result = per_pixel * header.width * header.height;
  if (result > budget) {
    return fmt::format("that takes {} MB, and {} MB are left of the limit for all textures",
                       megabytes(result), budget / 1'000'000);
  }
  if (header.working_bytes > limits.texture_bytes ||
      result + header.working_bytes > limits.texture_bytes) {
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

Result<DecodedPicture> decode(const Codec& codec, std::string_view bytes, std::string_view layer,
                              const Limits& limits, std::uint64_t budget) {
  const Result<ImageHeader> header = codec.read_header(bytes);
  if (!header) {
    return input_error(fmt::format("{}: {}", codec.format.name, header.error().text));
  }
  const auto failed = [&](std::string_view why, ErrorKind kind) {
    return Error{fmt::format("{} of {} x {} pixels: {}", codec.format.name, header->width,
                             header->height, why),
                 kind};
  };
  if (const std::string why = over_limits(*header, pixel_bytes(codec), limits, budget);
      !why.empty()) {
    return failed(why, ErrorKind::limit);
  }
  if (const std::string why = implausible(*header, bytes.size()); !why.empty()) {
    return failed(why, ErrorKind::input);
  }
  const auto width = static_cast<int>(header->width);
  const auto height = static_cast<int>(header->height);
  DecodedPicture picture;
  Result<void> done;
  if (codec.decode_linear != nullptr) {
    picture.linear = Image(width, height);
    done = codec.decode_linear(bytes, layer, picture.linear);
  } else {
    picture.texture.width = width;
    picture.texture.height = height;
    picture.texture.rgb.reserve(3 * header->width * header->height);
    done = codec.decode(bytes, picture);
  }
  if (!done) {
    return failed(done.error().text, ErrorKind::input);
  }
  return picture;
}

std::size_t pixels_not_finite(const Image& image) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < image.rgb.size(); i += 3) {
    const float* const v = image.rgb.data() + i;
    count += std::isfinite(v[0]) && std::isfinite(v[1]) && std::isfinite(v[2]) ? 0 : 1;
  }
  return count;
}

}  // namespace

std::vector<PictureFormat> picture_formats() {
  std::vector<PictureFormat> formats;
  for (const Codec* codec : picture_codecs) {
    formats.push_back(codec->format);
  }
  return formats;
}

std::string picture_format_names() {
  std::string names;
  for (const PictureFormat& format : picture_formats()) {
    names += fmt::format("{}{}", names.empty() ? "" : ", ", format.name);
  }
  return names;
}

bool is_picture_name(std::string_view file_name) {
  return is_name_of(picture_codecs, file_name);
}

bool is_texture_name(std::string_view file_name) {
  return is_name_of(texture_codecs, file_name);
}

std::uint64_t decoded_bytes(std::string_view bytes) {
  const Codec* const codec = codec_of(bytes, texture_codecs);
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
  return codec_of(bytes, picture_codecs) != nullptr;
}

Result<Texture> decode_image(std::string_view bytes, const Limits& limits, std::uint64_t& budget) {
  if (bytes.empty()) {
    return input_error("the file is empty");
  }
  const Codec* const codec = codec_of(bytes, texture_codecs);
  if (codec == nullptr) {
    return input_error("this is not a PNG, JPEG, GIF, TGA or BMP image");
  }
  Result<DecodedPicture> picture = decode(*codec, bytes, {}, limits, budget);
  if (!picture) {
    return picture.error();
  }
  budget -= picture->texture.rgb.size();
  picture->texture.format = codec->format.name;
  return std::move(picture->texture);
}

Result<Texture> decode_image(std::string_view bytes, const Limits& limits) {
  std::uint64_t budget = limits.texture_bytes;
  return decode_image(bytes, limits, budget);
}

Result<DecodedPicture> decode_picture(std::string_view bytes, std::string_view layer,
                                      const Limits& limits) {
  if (bytes.empty()) {
    return input_error("the file is empty");
  }
  const Codec* const codec = codec_of(bytes, picture_codecs);
  if (codec == nullptr) {
    return input_error(
        fmt::format("not a picture that scenefile reads ({})", picture_format_names()));
  }
  Result<DecodedPicture> picture = decode(*codec, bytes, layer, limits, limits.texture_bytes);
  if (picture) {
    picture->jpeg = codec == &jpeg_codec;
    if (picture->is_linear()) {
      picture->texture = quantize(picture->linear, Rounding::nearest);
      picture->not_finite = pixels_not_finite(picture->linear);
    }
  }
  return picture;
}

}  // namespace scenefile
