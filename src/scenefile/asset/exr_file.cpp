// OpenEXR by tinyexr.

#include "scenefile/asset/image_file.h"

#include <tinyexr.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <memory>

namespace scenefile {

namespace {

struct Channel {
  std::string name;
  bool whole = false;
  std::vector<float> values;
  std::vector<unsigned> whole_values;

  unsigned char* bytes() {
    return whole ? reinterpret_cast<unsigned char*>(whole_values.data())
                 : reinterpret_cast<unsigned char*>(values.data());
  }
  int type() const { return whole ? TINYEXR_PIXELTYPE_UINT : TINYEXR_PIXELTYPE_FLOAT; }
};

Channel channel_of(const ImageLayer& layer, std::size_t index) {
  const std::string& letter = layer.channels[index];
  Channel channel{layer.name.empty() ? letter : layer.name + "." + letter, layer.whole, {}, {}};
  const std::size_t count = layer.channels.size();
  for (std::size_t i = index; i < layer.values.size(); i += count) {
    if (layer.whole) {
      channel.whole_values.push_back(static_cast<unsigned>(layer.values[i]));
    } else {
      channel.values.push_back(layer.values[i]);
    }
  }
  return channel;
}

// In the order in which the file has them: by name.
std::vector<Channel> channels_of(std::span<const ImageLayer> layers) {
  std::vector<Channel> channels;
  for (const ImageLayer& layer : layers) {
    for (std::size_t i = 0; i < layer.channels.size(); ++i) {
      channels.push_back(channel_of(layer, i));
    }
  }
  std::sort(channels.begin(), channels.end(),
            [](const Channel& a, const Channel& b) { return a.name < b.name; });
  return channels;
}

bool name_channel(const Channel& channel, EXRChannelInfo& info) {
  std::memset(&info, 0, sizeof info);
  if (channel.name.size() >= sizeof info.name) {
    return false;
  }
  std::memcpy(info.name, channel.name.data(), channel.name.size());
  return true;
}

}  // namespace

std::string encode_layers(int width, int height, std::span<const ImageLayer> layers,
                          std::string& error) {
  error.clear();
  std::vector<Channel> channels = channels_of(layers);
  std::vector<unsigned char*> planes;
  std::vector<EXRChannelInfo> infos(channels.size());
  std::vector<int> types;
  for (std::size_t i = 0; i < channels.size(); ++i) {
    if (!name_channel(channels[i], infos[i])) {
      error = "the name of a layer is too long for EXR";
      return {};
    }
    planes.push_back(channels[i].bytes());
    types.push_back(channels[i].type());
  }
  EXRHeader header;
  InitEXRHeader(&header);
  header.num_channels = static_cast<int>(channels.size());
  header.channels = infos.data();
  header.pixel_types = types.data();
  header.requested_pixel_types = types.data();
  header.compression_type = TINYEXR_COMPRESSIONTYPE_ZIP;
  EXRImage exr;
  InitEXRImage(&exr);
  exr.num_channels = header.num_channels;
  exr.images = planes.data();
  exr.width = width;
  exr.height = height;
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
