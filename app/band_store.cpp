#include "app/band_store.h"

#include "app/item_key.h"
#include "app/named_files.h"
#include "app/pictures.h"
#include "scenefile/asset/image_file.h"
#include "scenefile/base/text.h"
#include "scenefile/io/file.h"
#include "scenefile/io/folder.h"
#include "scenefile/io/item.h"
#include "scenefile/trace/layers.h"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>
#include <utility>

namespace scenefile::app {

namespace {

// Whether the bytes may be what is left of an EXR file.
bool begins_like_exr(std::string_view bytes) {
  constexpr std::string_view signature = "\x76\x2f\x31\x01";
  return signature.starts_with(bytes.substr(0, signature.size()));
}

}  // namespace

BandStore::BandStore(const Options& options, const LoadedScene& scene)
    : options_(options), key_(picture_key_of(options, scene)) {
  const RenderOptions& render = options.render;
  const PixelRegion region = render.crop.value_or(PixelRegion{0, 0, render.width, render.height});
  width_ = region.width();
  picture_ = {0, region.height()};
}

std::string BandStore::path_of(const RowRange& band) const {
  return fmt::format("{}/{}", options_.store, band_name(band));
}

std::string BandStore::key_of(const RowRange& band) const {
  return fmt::format("{} rows={}-{}", key_, band.first, band.end);
}

Result<std::string> BandStore::read(const std::string& path) const {
  std::uint64_t channels = 0;
  for (const ImageLayer& layer : layers()) {
    channels += layer.channels.size();
  }
  const std::uint64_t header = std::uint64_t{1} << 20;
  return read_file(path, header + channels * sizeof(float) * static_cast<std::uint64_t>(width_) *
                                      static_cast<std::uint64_t>(picture_.rows()));
}

BandStore::State BandStore::state_of(const RowRange& band, std::string_view bytes,
                                     std::string& why) const {
  const Item item = read_item(bytes);
  if (item.state == ItemState::none && !begins_like_exr(bytes)) {
    why = "it is not a band";
    return State::foreign;
  }
  if (item.state != ItemState::intact) {
    return State::damaged;
  }
  if (item.key == key_of(band)) {
    return State::current;
  }
  // Of this picture, but renamed.
  if (compare_keys(item.key, key_of(band)).front().name == "rows") {
    return State::damaged;
  }
  why = "it was drawn " + key_mismatch(item.key, key_of(band));
  return State::foreign;
}

Outcome BandStore::open(Context& context) {
  context.phase = "reading the store";
  std::vector<RowRange> found;
  const std::error_code error = visit_entries(options_.store, [&](const FolderEntry& entry) {
    if (const std::optional<RowRange> band = band_of_name(entry.name)) {
      found.push_back(*band);
    }
    return true;
  });
  if (error == std::errc::no_such_file_or_directory) {
    return {};
  }
  if (error) {
    return {ExitCode::environment, fmt::format("{}: cannot read the folder of --store: {}",
                                               escaped(options_.store, 400), error.message())};
  }
  std::sort(found.begin(), found.end(), [](const RowRange& a, const RowRange& b) {
    return a.first != b.first ? a.first < b.first : a.end < b.end;
  });
  if (Outcome refused = claim(found, context); refused.status != ExitCode::fine) {
    return refused;
  }
  for (const RowRange& band : found) {
    const std::string path = path_of(band);
    const Result<std::string> bytes = read(path);
    std::string why = "it is too large for a band";
    if (!bytes && bytes.error().kind != ErrorKind::limit) {
      return {exit_code(bytes.error().kind), bytes.error().text};
    }
    const State state = bytes ? state_of(band, *bytes, why) : State::foreign;
    if (state == State::foreign) {
      return foreign_item(path, why);
    }
    if (state == State::current) {
      bands_.push_back(band);
    }
  }
  return {};
}

Outcome BandStore::claim(const std::vector<RowRange>& bands, Context& context) const {
  for (const RowRange& band : bands) {
    if (Outcome refused = outcome_of(context.files.write(named_file("band", path_of(band))));
        refused.status != ExitCode::fine) {
      return refused;
    }
  }
  return {};
}

Outcome BandStore::write(const RowRange& band, RenderResult result) {
  if (Outcome made = make_store(options_.store); made.status != ExitCode::fine) {
    return made;
  }
  Result<std::string> bytes = encode_layers(width_, band.rows(), all_layers(std::move(result)),
                                            {item_text(key_of(band)), band.first, picture_.rows()});
  if (!bytes) {
    return {ExitCode::environment, "cannot encode a band: " + bytes.error().text};
  }
  seal_item(*bytes);
  const Outcome written = outcome_of(write_file(path_of(band), *bytes));
  if (written.status == ExitCode::fine) {
    bands_.push_back(band);
  }
  return written;
}

std::vector<ImageLayer> BandStore::layers() const {
  std::vector<ImageLayer> layers{{"", {"R", "G", "B"}, false, {}}};
  for (const Layer& layer : options_.render.layers) {
    layers.push_back(layer_without_values(layer));
  }
  return layers;
}

Result<const BandStore::Band*> BandStore::band_at(int y) {
  const auto contains = [y](const RowRange& band) { return band.first <= y && y < band.end; };
  if (open_.file && contains(open_.rows)) {
    return &open_;
  }
  open_.file.reset();
  const RowRange& band = *std::find_if(bands_.begin(), bands_.end(), contains);
  const std::string path = path_of(band);
  Result<std::string> bytes = read(path);
  if (!bytes) {
    return bytes.error();
  }
  std::string why;
  if (state_of(band, *bytes, why) != State::current) {
    return Error{fmt::format("{}: the file was changed while it was used", escaped(path, 400))};
  }
  Result<ExrRows> file = ExrRows::open(*std::move(bytes));
  if (!file) {
    return Error{fmt::format("{}: cannot decode: {}", escaped(path, 400), file.error().text)};
  }
  open_.rows = band;
  open_.file.emplace(*std::move(file));
  return &open_;
}

}  // namespace scenefile::app
