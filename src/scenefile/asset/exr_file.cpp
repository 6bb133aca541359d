// An OpenEXR writer, with zlib: a header, and blocks of 16 rows of all channels, deflated. Source:
// "OpenEXR File Layout" and ImfZip.cpp of OpenEXR.

#include "scenefile/asset/image_file.h"
#include "scenefile/asset/image_stream.h"
#include "scenefile/asset/zlib_bytes.h"

#include <algorithm>
#include <bit>

namespace scenefile {

namespace {

constexpr std::uint32_t magic = 20000630;
constexpr std::uint32_t version = 2;
constexpr std::uint32_t long_names = 0x400;  // a flag of the version: names beyond 31 bytes
constexpr std::size_t short_name = 31;
constexpr std::size_t longest_name = 255;
constexpr char zip_of_16_rows = 3;
// OpenEXR's own default; higher levels take twice the time to save one percent of the size.
constexpr int deflate_level = 4;

struct Channel {
  std::string name;
  bool whole = false;
  std::size_t layer = 0;
  std::size_t index = 0;  // of the layer's channels
};

// In file order: by name.
std::vector<Channel> channels_of(std::span<const ImageLayer> layers) {
  std::vector<Channel> channels;
  for (std::size_t l = 0; l < layers.size(); ++l) {
    const ImageLayer& layer = layers[l];
    for (std::size_t i = 0; i < layer.channels.size(); ++i) {
      channels.push_back({channel_name(layer, i), layer.whole, l, i});
    }
  }
  std::sort(channels.begin(), channels.end(),
            [](const Channel& a, const Channel& b) { return a.name < b.name; });
  return channels;
}

// Little-endian.
template <typename Integer>
void append(std::string& bytes, Integer value) {
  for (std::size_t shift = 0; shift < 8 * sizeof value; shift += 8) {
    bytes.push_back(static_cast<char>(value >> shift & 255));
  }
}

void append_attribute(std::string& bytes, std::string_view name, std::string_view type,
                      std::string_view value) {
  bytes.append(name).push_back('\0');
  bytes.append(type).push_back('\0');
  append(bytes, static_cast<std::uint32_t>(value.size()));
  bytes.append(value);
}

std::string channel_list(const std::vector<Channel>& channels) {
  std::string bytes;
  for (const Channel& channel : channels) {
    bytes.append(channel.name).push_back('\0');
    const std::uint32_t type = channel.whole ? 0 : 2;       // UINT, FLOAT
    for (const std::uint32_t value : {type, 0u, 1u, 1u}) {  // linear; every column and row
      append(bytes, value);
    }
  }
  bytes.push_back('\0');
  return bytes;
}

std::string window_of(int width, int first, int end) {
  std::string bytes;
  for (const int value : {0, first, width - 1, end - 1}) {
    append(bytes, static_cast<std::uint32_t>(value));
  }
  return bytes;
}

std::string header_of(int width, int height, const std::vector<Channel>& channels,
                      const FileNote& note) {
  const bool has_long = std::any_of(channels.begin(), channels.end(), [](const Channel& channel) {
    return channel.name.size() > short_name;
  });
  std::string one;
  append(one, std::bit_cast<std::uint32_t>(1.0F));
  std::string bytes;
  append(bytes, magic);
  append(bytes, version | (has_long ? long_names : 0));
  append_attribute(bytes, "channels", "chlist", channel_list(channels));
  append_attribute(bytes, "compression", "compression", {&zip_of_16_rows, 1});
  append_attribute(bytes, "dataWindow", "box2i", window_of(width, note.first, note.first + height));
  append_attribute(bytes, "displayWindow", "box2i",
                   window_of(width, 0, note.picture_height == 0 ? height : note.picture_height));
  append_attribute(bytes, "lineOrder", "lineOrder", std::string_view("\0", 1));
  append_attribute(bytes, "pixelAspectRatio", "float", one);
  if (!note.text.empty()) {
    append_attribute(bytes, "scenefile", "string", note.text);
  }
  append_attribute(bytes, "screenWindowCenter", "v2f", std::string(8, '\0'));
  append_attribute(bytes, "screenWindowWidth", "float", one);
  bytes.push_back('\0');
  return bytes;
}

void append_row(std::string& bytes, const Channel& channel, const ImageLayer& layer,
                std::size_t width, std::size_t y) {
  const std::size_t step = layer.channels.size();
  for (std::size_t i = y * width; i < (y + 1) * width; ++i) {
    const float value = layer.values[i * step + channel.index];
    if (channel.whole) {
      append(bytes, static_cast<std::uint32_t>(value));
    } else {
      append(bytes, std::bit_cast<std::uint32_t>(value));
    }
  }
}

// First the even bytes, then the odd ones, each as the difference to the previous byte: this groups
// exponents, which repeat.
std::string made_compressible(std::string_view raw) {
  std::string sorted;
  sorted.reserve(raw.size());
  for (const std::size_t first : {0u, 1u}) {
    for (std::size_t i = first; i < raw.size(); i += 2) {
      sorted.push_back(raw[i]);
    }
  }
  for (std::size_t i = sorted.size() - 1; i > 0; --i) {
    sorted[i] = static_cast<char>(sorted[i] - sorted[i - 1] + 128);
  }
  return sorted;
}

// Data that would not become shorter is stored uncompressed; readers recognize that by its length.
std::string packed_block(std::string raw) {
  std::string packed = deflated(made_compressible(raw), deflate_level);
  if (packed.size() < raw.size()) {
    return packed;
  }
  return raw;
}

std::string block_of(int width, int y, int end, const std::vector<Channel>& channels,
                     std::span<const ImageLayer> layers) {
  std::string raw;
  raw.reserve(channels.size() * 4 * static_cast<std::size_t>(width) *
              static_cast<std::size_t>(end - y));
  for (int row = y; row < end; ++row) {
    for (const Channel& channel : channels) {
      append_row(raw, channel, layers[channel.layer], static_cast<std::size_t>(width),
                 static_cast<std::size_t>(row));
    }
  }
  return packed_block(std::move(raw));
}

}  // namespace

std::string channel_name(const ImageLayer& layer, std::size_t channel) {
  const std::string& letter = layer.channels[channel];
  return layer.name.empty() ? letter : layer.name + "." + letter;
}

Result<void> stream_blocks(int width, int height, std::span<const ImageLayer> layers,
                           const BlockSource& block_at, const ByteSink& sink,
                           const FileNote& note) {
  const Error canceled{"canceled", ErrorKind::cancelled};
  const std::vector<Channel> channels = channels_of(layers);
  for (const Channel& channel : channels) {
    if (channel.name.size() > longest_name) {
      return Error{"the name of a layer is too long for EXR", ErrorKind::usage};
    }
  }
  const std::string header = header_of(width, height, channels, note);
  const std::size_t blocks = static_cast<std::size_t>(height - 1) / exr_block_rows + 1;
  // The offsets of the blocks are only known when all are written.
  std::string offsets(8 * blocks, '\0');
  if (!sink.append(header) || !sink.append(offsets)) {
    return canceled;
  }
  std::uint64_t place = header.size() + offsets.size();
  offsets.clear();
  for (int y = 0; y < height; y += exr_block_rows) {
    const std::optional<std::string> block = block_at(y, std::min(height, y + exr_block_rows));
    if (!block) {
      return canceled;
    }
    std::string head;
    append(head, static_cast<std::uint32_t>(note.first + y));
    append(head, static_cast<std::uint32_t>(block->size()));
    if (!sink.append(head) || !sink.append(*block)) {
      return canceled;
    }
    append(offsets, place);
    place += head.size() + block->size();
  }
  return sink.replace(header.size(), offsets) ? Result<void>() : canceled;
}

Result<std::string> encode_layers(int width, int height, std::span<const ImageLayer> layers,
                                  const FileNote& note) {
  std::string bytes;
  const std::vector<Channel> channels = channels_of(layers);
  const Result<void> written = stream_blocks(
      width, height, layers,
      [&](int y, int end) { return block_of(width, y, end, channels, layers); }, sink_to(bytes),
      note);
  return written ? Result<std::string>(std::move(bytes)) : written.error();
}

}  // namespace scenefile
