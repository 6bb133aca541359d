#include "scenefile/trace/part_file.h"

#include "scenefile/base/hash.h"
#include "scenefile/trace/layers.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <type_traits>

namespace scenefile {

namespace {

constexpr std::string_view first_line = "scenefile part 1\n";
// The start of the first line in every version.
constexpr std::string_view name_of_format = "scenefile part ";
constexpr std::uint32_t max_layers = 4096;
constexpr int max_side = 1 << 20;

using Length = std::uint32_t;
using Checksum = std::uint64_t;

std::uint64_t checksum_of(std::string_view bytes) {
  Hash hash;
  hash.add(bytes);
  return hash.value();
}

// Calls value(x) for each number in the header, in order. The lists already have their sizes.
template <typename Head, typename Value>
void for_each_value(Head& head, const Value& value) {
  auto& picture = head.picture;
  value(picture.key.program);
  value(picture.key.scene);
  value(picture.key.assets);
  value(picture.key.options);
  value(picture.key.driver);
  value(picture.count);
  value(picture.region.x0);
  value(picture.region.y0);
  value(picture.region.x1);
  value(picture.region.y1);
  value(picture.rounding);
  value(picture.max_depth);
  value(head.index);
  value(head.checksum);
  for (auto& layer : picture.layers) {
    value(layer.kind);
    value(layer.light);
  }
  for (auto& range : head.ranges) {
    value(range.least);
    value(range.most);
  }
}

template <typename T>
T read_value(std::string_view bytes) {
  T value{};
  std::memcpy(&value, bytes.data(), sizeof value);
  return value;
}

bool is_kind(LayerKind kind) {
  return static_cast<std::size_t>(kind) < layer_words.size();
}

bool is_rounding(Rounding rounding) {
  switch (rounding) {
    case Rounding::truncate:
    case Rounding::nearest:
      return true;
  }
  return false;
}

// Whether a part can have this header.
bool is_possible(const PartHead& head) {
  const DividedPicture& picture = head.picture;
  const PixelRegion& region = picture.region;
  return picture.count > 0 && picture.count <= max_parts && head.index < picture.count &&
         is_rounding(picture.rounding) && region.x0 >= 0 && region.y0 >= 0 &&
         region.x0 < region.x1 && region.y0 < region.y1 && region.x1 <= max_side &&
         region.y1 <= max_side &&
         std::all_of(picture.layers.begin(), picture.layers.end(),
                     [](const Layer& layer) { return is_kind(layer.kind); });
}

// The number of floats per pixel.
std::size_t values_of_pixel(const DividedPicture& picture) {
  std::size_t count = 3;
  for (const Layer& layer : picture.layers) {
    count += layer_without_values(layer).channels.size();
  }
  return count;
}

// Values that are written as integers must be in range.
void make_whole(float* values, std::size_t count) {
  constexpr float most = 16777216;
  for (std::size_t i = 0; i < count; ++i) {
    values[i] = values[i] >= 0 && values[i] <= most ? values[i] : 0;
  }
}

}  // namespace

PartHead make_part_head(const DividedPicture& picture, std::uint32_t index, const Image& image,
                        std::span<const ImageLayer> layers) {
  PartHead head{picture, index, {}, 0};
  for (const ImageLayer& layer : layers) {
    head.ranges.push_back(range_of(layer.values));
  }
  head.ranges.resize(picture.layers.size());
  Hash hash;
  for (int y = 0; y < image.height; ++y) {
    hash.add(part_row(image, layers, y));
  }
  head.checksum = hash.value();
  return head;
}

std::string part_row(const Image& image, std::span<const ImageLayer> layers, int y) {
  std::string bytes;
  const auto append = [&](const std::vector<float>& values, std::size_t channels) {
    const std::size_t count = channels * static_cast<std::size_t>(image.width);
    bytes.append(reinterpret_cast<const char*>(values.data() + count * static_cast<std::size_t>(y)),
                 count * sizeof(float));
  };
  append(image.rgb, 3);
  for (const ImageLayer& layer : layers) {
    append(layer.values, layer.channels.size());
  }
  return bytes;
}

std::size_t part_row_bytes(const DividedPicture& picture, int width) {
  return values_of_pixel(picture) * static_cast<std::size_t>(width) * sizeof(float);
}

std::string encode_part_head(const PartHead& head) {
  std::string body;
  const auto append = [&](const auto& value) {
    static_assert(std::is_trivially_copyable_v<std::remove_cvref_t<decltype(value)>>);
    body.append(reinterpret_cast<const char*>(&value), sizeof value);
  };
  append(static_cast<std::uint32_t>(head.picture.layers.size()));
  for_each_value(head, append);
  const auto length = static_cast<Length>(body.size());
  const Checksum checksum = checksum_of(body);
  std::string bytes(first_line);
  bytes.append(reinterpret_cast<const char*>(&length), sizeof length);
  bytes += body;
  bytes.append(reinterpret_cast<const char*>(&checksum), sizeof checksum);
  return bytes;
}

std::string decode_part_head(std::string_view bytes, PartHead& head,
                             std::size_t& bytes_before_rows) {
  if (bytes.empty()) {
    return "the file is empty";
  }
  if (!bytes.starts_with(first_line.substr(0, bytes.size()))) {
    return is_part_file(bytes) ? "the part was written by another version of the program"
                               : "the file is not a part of a picture";
  }
  const std::string cut_off = "the part is truncated";
  std::size_t at = first_line.size();
  if (bytes.size() < at + sizeof(Length)) {
    return cut_off;
  }
  const auto length = read_value<Length>(bytes.substr(at));
  at += sizeof length;
  if (length > max_part_head_bytes - at - sizeof(Checksum)) {
    return "the part is damaged: its header is too long";
  }
  if (bytes.size() < at + length + sizeof(Checksum)) {
    return cut_off;
  }
  std::string_view body = bytes.substr(at, length);
  at += length;
  if (read_value<Checksum>(bytes.substr(at)) != checksum_of(body)) {
    return "the part is damaged: the checksum of its header is wrong";
  }
  bytes_before_rows = at + sizeof(Checksum);
  const std::string impossible = "the part is damaged: its header is invalid";
  if (length < sizeof(std::uint32_t)) {
    return impossible;
  }
  const auto layers = read_value<std::uint32_t>(body);
  body.remove_prefix(sizeof layers);
  PartHead read;
  read.picture.layers.resize(std::min(layers, max_layers));
  read.ranges.resize(read.picture.layers.size());
  std::size_t needed = 0;
  for_each_value(read, [&](const auto& value) { needed += sizeof value; });
  if (layers > max_layers || needed != body.size()) {
    return impossible;
  }
  for_each_value(read, [&](auto& value) {
    value = read_value<std::remove_cvref_t<decltype(value)>>(body);
    body.remove_prefix(sizeof value);
  });
  if (!is_possible(read)) {
    return impossible;
  }
  head = std::move(read);
  return {};
}

std::uint64_t part_file_bytes(const PartHead& head, std::size_t bytes_before_rows) {
  const PixelRegion region = head.region();
  return bytes_before_rows + std::uint64_t{part_row_bytes(head.picture, region.width())} *
                                 static_cast<std::uint64_t>(region.height());
}

bool is_part_file(std::string_view first_bytes) {
  return first_bytes.starts_with(name_of_format);
}

std::string foreign_part(const PartKey& found, const PartKey& wanted) {
  struct Row {
    std::uint64_t PartKey::*value;
    std::string_view why;
  };
  static constexpr std::array<Row, 5> rows{
      {{&PartKey::scene, "from another scene, or the scene was changed"},
       {&PartKey::assets, "with other textures or meshes"},
       {&PartKey::options, "with other options"},
       {&PartKey::program, "by another build of the program"},
       {&PartKey::driver, "by another OpenGL driver"}}};
  std::string text;
  for (const auto& [value, why] : rows) {
    if (found.*value != wanted.*value) {
      text += text.empty() ? "" : ", and ";
      text += why;
    }
  }
  return text;
}

void place_part_rows(const PartHead& head, std::string_view rows, int y, int first,
                     std::span<ImageLayer> to) {
  const PixelRegion own = head.region();
  const PixelRegion& whole = head.picture.region;
  const auto across = static_cast<std::size_t>(whole.width());
  for (; !rows.empty(); ++y) {
    for (ImageLayer& layer : to) {
      const std::size_t channels = layer.channels.size();
      const std::size_t pixel = static_cast<std::size_t>(y - first) * across +
                                static_cast<std::size_t>(own.x0 - whole.x0);
      const std::size_t count = channels * static_cast<std::size_t>(own.width());
      float* const place = layer.values.data() + channels * pixel;
      std::memcpy(place, rows.data(), count * sizeof(float));
      if (layer.whole) {
        make_whole(place, count);
      }
      rows.remove_prefix(count * sizeof(float));
    }
  }
}

}  // namespace scenefile
