// OpenEXR decoding with OpenEXRCore, which reads through callbacks and reports errors by codes. The
// only file that includes it.

#include "scenefile/asset/codec.h"
#include "scenefile/asset/exr_rows.h"
#include "scenefile/asset/exr_signature.h"
#include "scenefile/base/text.h"

#include <fmt/format.h>
#include <openexr.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <new>
#include <utility>

namespace scenefile {

namespace {

// The file, and the last error, stored by a function that must not throw.
struct ExrSource {
  std::string_view bytes;
  std::array<char, 160> message{};
};

extern "C" std::int64_t exr_fetch(exr_const_context_t, void* user, void* to, std::uint64_t count,
                                  std::uint64_t at, exr_stream_error_func_ptr_t) {
  const std::string_view bytes = static_cast<const ExrSource*>(user)->bytes;
  const std::uint64_t size = bytes.size();
  const std::uint64_t there = std::min(count, size - std::min(at, size));
  std::memcpy(to, bytes.data() + std::min(at, size), there);
  return static_cast<std::int64_t>(there);
}

extern "C" std::int64_t exr_size(exr_const_context_t, void* user) {
  return static_cast<std::int64_t>(static_cast<const ExrSource*>(user)->bytes.size());
}

extern "C" void exr_failed(exr_const_context_t context, exr_result_t, const char* text) {
  void* user = nullptr;
  if (context != nullptr && exr_get_user_data(context, &user) == EXR_ERR_SUCCESS &&
      user != nullptr) {
    auto& message = static_cast<ExrSource*>(user)->message;
    std::strncpy(message.data(), text, message.size() - 1);
  }
}

// An open file; closed at the end of its life.
class ExrFile {
 public:
  explicit ExrFile(std::string_view bytes) : source_{bytes} {
    exr_context_initializer_t start = EXR_DEFAULT_CONTEXT_INITIALIZER;
    start.error_handler_fn = exr_failed;
    start.user_data = &source_;
    start.read_fn = exr_fetch;
    start.size_fn = exr_size;
    opened_ = check(exr_start_read(&context_, "file", &start));
  }
  ~ExrFile() {
    if (context_ != nullptr) {
      exr_finish(&context_);
    }
  }
  ExrFile(const ExrFile&) = delete;
  ExrFile& operator=(const ExrFile&) = delete;

  exr_const_context_t get() const { return context_; }
  const Result<void>& opened() const { return opened_; }

  Result<void> check(exr_result_t result) const {
    switch (result) {
      case EXR_ERR_SUCCESS:
        return {};
      case EXR_ERR_OUT_OF_MEMORY:
        throw std::bad_alloc();
      case EXR_ERR_READ_IO:
        return input_error(std::string(ends_early));
      default:
        break;
    }
    const std::string_view said = source_.message.data();
    return input_error(
        fmt::format("the file is damaged ({})",
                    escaped(said.empty() ? exr_get_default_error_message(result) : said)));
  }

 private:
  ExrSource source_;
  exr_context_t context_ = nullptr;
  Result<void> opened_;
};

struct ExrWindow {
  std::int64_t x0 = 0;
  std::int64_t y0 = 0;
  std::int64_t x1 = -1;  // beyond the last
  std::int64_t y1 = -1;

  std::int64_t width() const { return std::max<std::int64_t>(x1 - x0, 0); }
  std::int64_t height() const { return std::max<std::int64_t>(y1 - y0, 0); }
};

ExrWindow exr_window(const exr_attr_box2i_t& box) {
  return {box.min.x, box.min.y, std::int64_t{box.max.x} + 1, std::int64_t{box.max.y} + 1};
}

// The versions in use do not decode DWA, and B44 only partly right.
bool is_supported_compression(exr_compression_t compression) {
  return compression <= EXR_COMPRESSION_PXR24;
}

// A part of the file with pixels, not with deep samples.
struct ExrPart {
  int index = 0;
  bool tiled = false;
  ExrWindow data;
  std::int64_t chunk_width = 0;
  std::int64_t chunk_height = 0;
  std::uint64_t chunk_bytes = 0;
  std::uint64_t chunks = 0;
};

Result<ExrPart> read_exr_part(const ExrFile& file, int index, bool tiled) {
  ExrPart part;
  part.index = index;
  part.tiled = tiled;
  exr_attr_box2i_t box{};
  exr_compression_t compression{};
  std::int32_t chunks = 0;
  std::int32_t rows = 0;
  std::int32_t tile_width = 0;
  for (const exr_result_t result :
       {exr_get_data_window(file.get(), index, &box),
        exr_get_compression(file.get(), index, &compression),
        exr_get_chunk_count(file.get(), index, &chunks),
        exr_get_chunk_unpacked_size(file.get(), index, &part.chunk_bytes),
        tiled ? exr_get_tile_sizes(file.get(), index, 0, 0, &tile_width, &rows)
              : exr_get_scanlines_per_chunk(file.get(), index, &rows)}) {
    if (const Result<void> read = file.check(result); !read) {
      return read.error();
    }
  }
  if (!is_supported_compression(compression)) {
    return input_error("B44 and DWA compression are not supported; save it with ZIP or PIZ");
  }
  part.data = exr_window(box);
  part.chunk_width = tiled ? tile_width : part.data.width();
  part.chunk_height = rows;
  part.chunks = static_cast<std::uint64_t>(std::max(chunks, 0));
  if (part.chunk_width <= 0 || part.chunk_height <= 0 || part.data.height() == 0) {
    return input_error("it has no pixels");
  }
  return part;
}

Result<std::vector<ExrPart>> read_exr_parts(const ExrFile& file) {
  int count = 0;
  if (const Result<void> read = file.check(exr_get_count(file.get(), &count)); !read) {
    return read.error();
  }
  std::vector<ExrPart> parts;
  for (int i = 0; i < count; ++i) {
    exr_storage_t storage{};
    if (const Result<void> read = file.check(exr_get_storage(file.get(), i, &storage)); !read) {
      return read.error();
    }
    if (storage == EXR_STORAGE_SCANLINE || storage == EXR_STORAGE_TILED) {
      Result<ExrPart> part = read_exr_part(file, i, storage == EXR_STORAGE_TILED);
      if (!part) {
        return part.error();
      }
      parts.push_back(*part);
    }
  }
  if (parts.empty()) {
    return input_error("its pixels are deep samples; flatten it in the program that wrote it");
  }
  return parts;
}

bool recognizes_exr(std::string_view bytes) {
  return has_exr_signature(bytes);
}

Result<ImageHeader> read_exr_header(std::string_view bytes) {
  const ExrFile file(bytes);
  if (!file.opened()) {
    return file.opened().error();
  }
  const Result<std::vector<ExrPart>> parts = read_exr_parts(file);
  if (!parts) {
    return parts.error();
  }
  exr_attr_box2i_t box{};  // the same for all parts
  if (const Result<void> read = file.check(exr_get_display_window(file.get(), 0, &box)); !read) {
    return read.error();
  }
  ImageHeader header;
  header.width = static_cast<std::uint64_t>(exr_window(box).width());
  header.height = static_cast<std::uint64_t>(exr_window(box).height());
  for (const ExrPart& part : *parts) {
    const auto colors =
        3 * sizeof(float) * static_cast<std::uint64_t>(part.chunk_width * part.chunk_height);
    // The library has up to four buffers for a chunk.
    const std::uint64_t most = std::numeric_limits<std::uint64_t>::max() / 8;
    header.working_bytes =
        std::max(header.working_bytes, 4 * std::min(part.chunk_bytes, most) + colors);
    header.min_bytes += 8 * part.chunks;  // the table of their places
  }
  return header;
}

// What can be shown as colors.
struct ExrLayer {
  std::string name;                     // of the channels or of the part; may be empty
  bool color = false;                   // these, or another layer with R, G, B
  int part = 0;                         // in the list of parts
  std::array<std::string, 3> channels;  // full names; all the same for gray
  bool plain = false;                   // of the first part, without a name of their own
};

struct ExrChannel {
  std::string layer;
  std::string name;  // after the point
  std::string full;
  bool whole = true;  // not subsampled
};

std::vector<ExrChannel> exr_channels(const ExrFile& file, const ExrPart& part) {
  const exr_attr_chlist_t* list = nullptr;
  std::vector<ExrChannel> channels;
  if (exr_get_channels(file.get(), part.index, &list) == EXR_ERR_SUCCESS) {
    for (int i = 0; i < list->num_channels; ++i) {
      const exr_attr_chlist_entry_t& entry = list->entries[i];
      const std::string full(entry.name.str, static_cast<std::size_t>(entry.name.length));
      const std::size_t point = full.rfind('.');
      const bool has_layer = point != std::string::npos;
      channels.push_back({has_layer ? full.substr(0, point) : "",
                          has_layer ? full.substr(point + 1) : full, full,
                          entry.x_sampling == 1 && entry.y_sampling == 1});
    }
  }
  return channels;
}

// `channels`: those of the layer.
std::optional<ExrLayer> exr_layer(const std::vector<ExrChannel>& channels) {
  const auto named = [&](std::string_view name) {
    return std::find_if(channels.begin(), channels.end(), [&](const ExrChannel& channel) {
      return channel.whole && equal_ignoring_case(channel.name, name);
    });
  };
  using Names = std::array<std::string_view, 3>;
  for (const Names& names : {Names{"R", "G", "B"}, Names{"Y", "Y", "Y"}, Names{"X", "Y", "Z"},
                             Names{"red", "green", "blue"}}) {
    const bool luminance_only = names[0] == "Y";
    if (luminance_only && (named("X") != channels.end() || named("Z") != channels.end())) {
      continue;  // coordinates
    }
    ExrLayer layer;
    layer.color = names[0] != "X";
    bool all = true;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto found = named(names[i]);
      all = all && found != channels.end();
      layer.channels[i] = found != channels.end() ? found->full : "";
    }
    const bool chroma = std::any_of(
        channels.begin(), channels.end(),
        [](const ExrChannel& channel) { return channel.name == "RY" || channel.name == "BY"; });
    if (all && !(luminance_only && chroma)) {
      return layer;
    }
  }
  if (channels.size() == 1 && channels.front().whole) {
    const std::string& name = channels.front().full;
    return ExrLayer{{}, false, 0, {name, name, name}};
  }
  return std::nullopt;
}

std::vector<ExrLayer> exr_layers(const ExrFile& file, const std::vector<ExrPart>& parts) {
  std::vector<ExrLayer> layers;
  for (std::size_t p = 0; p < parts.size(); ++p) {
    std::vector<ExrChannel> rest = exr_channels(file, parts[p]);
    while (!rest.empty()) {
      const std::string name = rest.front().layer;
      const auto others =
          std::stable_partition(rest.begin(), rest.end(),
                                [&](const ExrChannel& channel) { return channel.layer == name; });
      std::optional<ExrLayer> layer = exr_layer({rest.begin(), others});
      rest.erase(rest.begin(), others);
      if (layer) {
        layer->part = static_cast<int>(p);
        layer->name = name;
        const char* part_name = nullptr;
        layer->plain = name.empty() && p == 0;
        if (name.empty() &&
            exr_get_name(file.get(), parts[p].index, &part_name) == EXR_ERR_SUCCESS &&
            part_name != nullptr) {
          layer->name = part_name;
        }
        layers.push_back(*std::move(layer));
      }
    }
  }
  return layers;
}

std::string exr_layer_names(const std::vector<ExrLayer>& layers) {
  constexpr std::size_t most = 20;
  std::string names;
  for (std::size_t i = 0; i < std::min(layers.size(), most); ++i) {
    if (!layers[i].name.empty()) {
      names += (names.empty() ? "" : ", ") + escaped(layers[i].name, 80);
    }
  }
  return layers.size() > most ? fmt::format("{} and {} others", names, layers.size() - most)
                              : names;
}

Result<ExrLayer> choose_exr_layer(const ExrFile& file, const std::vector<ExrPart>& parts,
                                  std::string_view name) {
  std::vector<ExrLayer> layers = exr_layers(file, parts);
  if (layers.empty()) {
    const std::vector<ExrChannel> channels = exr_channels(file, parts.front());
    const bool chroma = std::any_of(
        channels.begin(), channels.end(),
        [](const ExrChannel& channel) { return channel.name == "RY" || channel.name == "BY"; });
    return input_error(chroma ? "its colors are luminance and chroma (Y, RY, BY); save it as RGB"
                              : "it has no channels R, G, B or Y");
  }
  const auto plain = std::find_if(layers.begin(), layers.end(),
                                  [](const ExrLayer& layer) { return layer.plain && layer.color; });
  if (layers.size() == 1 && (name.empty() || layers.front().plain)) {
    return layers.front();
  }
  if (name.empty()) {
    if (plain != layers.end()) {
      return *plain;
    }
    return input_error(fmt::format("it has several layers ({}); choose one with --layer NAME",
                                   exr_layer_names(layers)));
  }
  const auto chosen = std::find_if(layers.begin(), layers.end(),
                                   [&](const ExrLayer& layer) { return layer.name == name; });
  if (chosen == layers.end()) {
    return input_error(
        fmt::format("it has no layer {}; it has {}", quoted(name, 80), exr_layer_names(layers)));
  }
  return *chosen;
}

// Where the values of a channel go. Strides count floats.
struct ExrTarget {
  std::string_view channel;
  float* values = nullptr;
  std::size_t pixel_stride = 0;
  std::size_t row_stride = 0;
};

class ChunkDecoder {
 public:
  ChunkDecoder(const ExrFile& file, const ExrPart& part) : file_(file), part_(part) {}
  ~ChunkDecoder() { exr_decoding_destroy(file_.get(), &pipeline_); }
  ChunkDecoder(const ChunkDecoder&) = delete;
  ChunkDecoder& operator=(const ChunkDecoder&) = delete;

  // Only the values may differ between calls.
  Result<void> decode(const exr_chunk_info_t& chunk, std::span<const ExrTarget> targets) {
    if (chunk.width > part_.chunk_width || chunk.height > part_.chunk_height) {
      return input_error("a block has the wrong size");
    }
    const auto context = file_.get();
    const exr_result_t begun =
        started_ ? exr_decoding_update(context, part_.index, &chunk, &pipeline_)
                 : exr_decoding_initialize(context, part_.index, &chunk, &pipeline_);
    if (begun != EXR_ERR_SUCCESS) {
      return file_.check(begun);
    }
    for (int i = 0; i < pipeline_.channel_count; ++i) {
      set_target(pipeline_.channels[i], targets);
    }
    if (!std::exchange(started_, true)) {
      const exr_result_t chosen =
          exr_decoding_choose_default_routines(context, part_.index, &pipeline_);
      if (chosen != EXR_ERR_SUCCESS) {
        return file_.check(chosen);
      }
    }
    return file_.check(exr_decoding_run(context, part_.index, &pipeline_));
  }

 private:
  static void set_target(exr_coding_channel_info_t& channel, std::span<const ExrTarget> targets) {
    channel.decode_to_ptr = nullptr;
    const auto found = std::find_if(targets.begin(), targets.end(), [&](const ExrTarget& target) {
      return target.channel == channel.channel_name;
    });
    if (found == targets.end()) {
      return;
    }
    channel.user_data_type = EXR_PIXEL_FLOAT;
    channel.user_bytes_per_element = sizeof(float);
    channel.user_pixel_stride = static_cast<std::int32_t>(sizeof(float) * found->pixel_stride);
    channel.user_line_stride = static_cast<std::int32_t>(sizeof(float) * found->row_stride);
    channel.decode_to_ptr = reinterpret_cast<std::uint8_t*>(found->values);
  }

  const ExrFile& file_;
  const ExrPart& part_;
  exr_decode_pipeline_t pipeline_ = EXR_DECODE_PIPELINE_INITIALIZER;
  bool started_ = false;
};

// Copies the colors of the chunk at `x`, `y` that are in the display window at `shown`.
void copy_visible_chunk(const float* colors, std::int64_t row_width, const ExrWindow& chunk,
                        const ExrWindow& shown, Image& image) {
  const std::int64_t x0 = std::max(chunk.x0, shown.x0);
  const std::int64_t x1 = std::min(chunk.x1, shown.x1);
  for (std::int64_t y = std::max(chunk.y0, shown.y0); y < std::min(chunk.y1, shown.y1); ++y) {
    const float* const from = colors + 3 * ((y - chunk.y0) * row_width + x0 - chunk.x0);
    std::copy(from, from + 3 * (x1 - x0),
              image.pixel(static_cast<int>(x0 - shown.x0), static_cast<int>(y - shown.y0)));
  }
}

Result<void> decode_exr(std::string_view bytes, std::string_view layer_name, Image& image) {
  const ExrFile file(bytes);
  if (!file.opened()) {
    return file.opened().error();
  }
  const Result<std::vector<ExrPart>> parts = read_exr_parts(file);
  if (!parts) {
    return parts.error();
  }
  const Result<ExrLayer> layer = choose_exr_layer(file, *parts, layer_name);
  if (!layer) {
    return layer.error();
  }
  const ExrPart& part = (*parts)[static_cast<std::size_t>(layer->part)];
  exr_attr_box2i_t box{};
  if (const Result<void> read = file.check(exr_get_display_window(file.get(), 0, &box)); !read) {
    return read.error();
  }
  const ExrWindow shown = exr_window(box);
  const ExrWindow& data = part.data;
  const auto row_width = static_cast<std::size_t>(part.chunk_width);
  std::vector<float> colors(3 * row_width * static_cast<std::size_t>(part.chunk_height));
  std::vector<ExrTarget> targets;
  const bool gray = layer->channels[0] == layer->channels[1];
  for (std::size_t i = 0; i < (gray ? 1 : 3); ++i) {
    targets.push_back({layer->channels[i], &colors[i], 3, 3 * row_width});
  }
  ChunkDecoder decoder(file, part);
  for (std::int64_t y = data.y0; y < data.y1; y += part.chunk_height) {
    for (std::int64_t x = data.x0; x < data.x1; x += part.chunk_width) {
      const ExrWindow place{x, y, std::min(x + part.chunk_width, data.x1),
                            std::min(y + part.chunk_height, data.y1)};
      if (place.x0 >= shown.x1 || place.x1 <= shown.x0 || place.y0 >= shown.y1 ||
          place.y1 <= shown.y0) {
        continue;
      }
      exr_chunk_info_t chunk{};
      const exr_result_t found =
          part.tiled
              ? exr_read_tile_chunk_info(
                    file.get(), part.index, static_cast<int>((x - data.x0) / part.chunk_width),
                    static_cast<int>((y - data.y0) / part.chunk_height), 0, 0, &chunk)
              : exr_read_scanline_chunk_info(file.get(), part.index, static_cast<int>(y), &chunk);
      Result<void> done = file.check(found);
      if (done) {
        done = decoder.decode(chunk, targets);
      }
      if (!done) {
        return done;
      }
      for (std::size_t i = 0; gray && i < colors.size(); i += 3) {
        colors[i + 1] = colors[i + 2] = colors[i];
      }
      copy_visible_chunk(colors.data(), part.chunk_width, place, shown, image);
    }
  }
  return {};
}

}  // namespace

struct ExrRows::State {
  explicit State(std::string all) : bytes(std::move(all)), file(bytes) {}

  std::string bytes;
  ExrFile file;
  ExrPart part = {};
  ExrWindow picture = {};
};

ExrRows::ExrRows(std::unique_ptr<State> state) : state_(std::move(state)) {}
ExrRows::ExrRows(ExrRows&& other) noexcept = default;
ExrRows& ExrRows::operator=(ExrRows&& other) noexcept = default;
ExrRows::~ExrRows() = default;

Result<ExrRows> ExrRows::open(std::string bytes) {
  auto state = std::make_unique<State>(std::move(bytes));
  const ExrFile& file = state->file;
  if (!file.opened()) {
    return file.opened().error();
  }
  const Result<std::vector<ExrPart>> parts = read_exr_parts(file);
  if (!parts) {
    return parts.error();
  }
  exr_attr_box2i_t box{};
  exr_compression_t compression{};
  for (const exr_result_t result : {exr_get_display_window(file.get(), 0, &box),
                                    exr_get_compression(file.get(), 0, &compression)}) {
    if (const Result<void> read = file.check(result); !read) {
      return read.error();
    }
  }
  const ExrPart& part = state->part = parts->front();
  const ExrWindow& picture = state->picture = exr_window(box);
  const bool whole_rows = part.data.x0 == 0 && part.data.x1 == picture.x1 && picture.x0 == 0 &&
                          picture.y0 == 0 && part.data.y0 >= 0 && part.data.y1 <= picture.y1;
  if (parts->size() != 1 || part.tiled || compression != EXR_COMPRESSION_ZIP || !whole_rows) {
    return input_error("it does not have the rows of a picture in ZIP blocks");
  }
  return ExrRows(std::move(state));
}

int ExrRows::width() const {
  return static_cast<int>(state_->picture.width());
}
int ExrRows::picture_height() const {
  return static_cast<int>(state_->picture.height());
}
int ExrRows::first() const {
  return static_cast<int>(state_->part.data.y0);
}
int ExrRows::end() const {
  return static_cast<int>(state_->part.data.y1);
}

Result<void> ExrRows::read(std::span<ImageLayer> layers) const {
  const auto& [bytes, file, part, picture] = *state_;
  const std::vector<ExrChannel> there = exr_channels(file, part);
  const auto across = static_cast<std::size_t>(width());
  std::vector<std::string> names;
  std::vector<ExrTarget> targets;
  for (ImageLayer& layer : layers) {
    const std::size_t channels = layer.channels.size();
    layer.values.resize(channels * across * static_cast<std::size_t>(end() - first()));
    for (std::size_t i = 0; i < channels; ++i) {
      names.push_back(channel_name(layer, i));
      targets.push_back({{}, layer.values.data() + i, channels, channels * across});
      if (std::none_of(there.begin(), there.end(), [&](const ExrChannel& channel) {
            return channel.full == names.back() && channel.whole;
          })) {
        return input_error(fmt::format("it has no channel {}", quoted(names.back(), 80)));
      }
    }
  }
  for (std::size_t i = 0; i < names.size(); ++i) {
    targets[i].channel = names[i];
  }
  ChunkDecoder decoder(file, part);
  for (int y = first(); y < end(); y += static_cast<int>(part.chunk_height)) {
    exr_chunk_info_t chunk{};
    Result<void> done = file.check(exr_read_scanline_chunk_info(file.get(), part.index, y, &chunk));
    if (done) {
      done = decoder.decode(chunk, targets);
    }
    if (!done) {
      return done;
    }
    for (ExrTarget& target : targets) {
      target.values += target.row_stride * static_cast<std::size_t>(part.chunk_height);
    }
  }
  return {};
}

Result<std::string> ExrRows::block(int y) const {
  const auto& [bytes, file, part, picture] = *state_;
  exr_chunk_info_t chunk{};
  if (const Result<void> found =
          file.check(exr_read_scanline_chunk_info(file.get(), part.index, y, &chunk));
      !found) {
    return found.error();
  }
  if (chunk.packed_size > bytes.size()) {
    return input_error(std::string(ends_early));
  }
  std::string packed(chunk.packed_size, '\0');
  const Result<void> read =
      file.check(exr_read_chunk(file.get(), part.index, &chunk, packed.data()));
  return read ? Result<std::string>(std::move(packed)) : read.error();
}

const Codec exr_codec{{"EXR", ".exr"}, recognizes_exr, read_exr_header, nullptr, decode_exr};

}  // namespace scenefile
