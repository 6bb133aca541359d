// OpenEXR by tinyexr.

#include "scenefile/asset/codec.h"

#include <tinyexr.h>

#include <array>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <vector>

namespace scenefile {

namespace {

// The channels apart, in the order in which the file has them: by name.
std::array<std::vector<float>, 3> blue_green_red(const Image& image) {
  std::array<std::vector<float>, 3> channels;
  const std::size_t pixels = image.rgb.size() / 3;
  for (std::size_t i = 0; i < 3; ++i) {
    channels[i].resize(pixels);
    for (std::size_t p = 0; p < pixels; ++p) {
      channels[i][p] = image.rgb[3 * p + 2 - i];
    }
  }
  return channels;
}

}  // namespace

std::string encode_exr(const Image& image, std::string& error) {
  std::array<std::vector<float>, 3> channels = blue_green_red(image);
  std::array<unsigned char*, 3> planes{};
  std::array<EXRChannelInfo, 3> infos{};
  std::array<int, 3> types{};
  for (std::size_t i = 0; i < 3; ++i) {
    planes[i] = reinterpret_cast<unsigned char*>(channels[i].data());
    std::memset(&infos[i], 0, sizeof infos[i]);
    infos[i].name[0] = "BGR"[i];
    types[i] = TINYEXR_PIXELTYPE_FLOAT;
  }
  EXRHeader header;
  InitEXRHeader(&header);
  header.num_channels = 3;
  header.channels = infos.data();
  header.pixel_types = types.data();
  header.requested_pixel_types = types.data();
  header.compression_type = TINYEXR_COMPRESSIONTYPE_ZIP;
  EXRImage exr;
  InitEXRImage(&exr);
  exr.num_channels = 3;
  exr.images = planes.data();
  exr.width = image.width;
  exr.height = image.height;
  unsigned char* bytes = nullptr;
  const char* message = nullptr;
  const std::size_t size = SaveEXRImageToMemory(&exr, &header, &bytes, &message);
  const std::unique_ptr<unsigned char, decltype(&std::free)> owner(bytes, std::free);
  if (size == 0) {
    error = message != nullptr ? message : "the EXR library gave no reason";
    FreeEXRErrorMessage(message);
    return {};
  }
  return {reinterpret_cast<const char*>(bytes), size};
}

}  // namespace scenefile
