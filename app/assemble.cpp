#include "app/assemble.h"

#include "app/pictures.h"
#include "scenefile/asset/image_file.h"
#include "scenefile/asset/image_stream.h"
#include "scenefile/io/file_writer.h"
#include "scenefile/io/interrupt.h"
#include "scenefile/trace/layers.h"

#include <algorithm>
#include <deque>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace scenefile::app {

namespace {

// An output file while it is written.
class Output {
 public:
  explicit Output(std::string path) : path_(std::move(path)) {}

  Outcome open() {
    Result<FileWriter> file = FileWriter::create(path_);
    if (!file) {
      return {ExitCode::environment, file.error().text};
    }
    file_.emplace(*std::move(file));
    return {};
  }

  ByteSink sink() {
    return {[this](std::string_view bytes) { return keep(file_->append(bytes)); },
            [this](std::uint64_t at, std::string_view bytes) {
              return keep(file_->replace(at, bytes));
            }};
  }

  bool commit() { return keep(file_->commit()); }
  const std::string& error() const { return error_; }

 private:
  bool keep(const Result<void>& done) {
    error_ = error_text(done);
    return error_.empty();
  }

  std::string path_;
  std::optional<FileWriter> file_;
  std::string error_;
};

// Writes the files of one picture.
class Assembler {
 public:
  Assembler(const Options& options, BandStore& store)
      : options_(options), store_(store), rows_(store.layers()), ranges_(rows_.size()) {}

  Outcome run(Context& context) {
    const DeferredSignals deferred;
    for (const std::string& path : picture_files(options_)) {
      outputs_.emplace_back(path);
      if (Outcome outcome = outputs_.back().open(); !outcome.error.empty()) {
        return outcome;
      }
    }
    if (tones() && !find_white()) {
      return failure({}, context);
    }
    for (std::size_t i = 0; i < outputs_.size(); ++i) {
      if (!write(i)) {
        return failure(outputs_[i].error(), context);
      }
    }
    for (Output& output : outputs_) {
      if (!output.commit()) {
        return failure(output.error(), context);
      }
    }
    return {};
  }

 private:
  ImageFormat format() const {
    return image_format_of(options_.output).value_or(ImageFormat::png8);
  }
  bool tones() const { return options_.render.mode == Mode::path && format() == ImageFormat::png8; }
  int height() const { return store_.picture().rows(); }

  // The picture for `index` 0, otherwise a layer.
  bool write(std::size_t index) {
    const ByteSink sink = outputs_[index].sink();
    switch (format()) {
      case ImageFormat::png8:
      case ImageFormat::png16:
        return index == 0 ? stream_png(store_.width(), height(), 8,
                                       rounding_of(options_.render.profile), colors(), sink)
                          : write_layer(index, sink);
      case ImageFormat::pfm:
        return stream_pfm(store_.width(), height(), colors(), sink);
      case ImageFormat::exr:
        break;
    }
    return bool(stream_blocks(
        store_.width(), height(), store_.layers(),
        [this](int y, int /*end*/) { return block_at(y); }, sink));
  }

  bool write_layer(std::size_t index, const ByteSink& sink) {
    const Layer& layer = options_.render.layers[index - 1];
    std::vector<float> row(std::size_t{3} * static_cast<std::size_t>(store_.width()));
    const auto colors_of = [&](int y) -> const float* {
      const std::optional<std::span<float>> values = row_of(index, y);
      if (!values) {
        return nullptr;
      }
      layer_colors(layer, *values, ranges_[index], options_.render.max_depth, row.data());
      if (tones() && is_path_light(layer.kind)) {
        map_tones(row, options_.tone, options_.exposure, white_);
      }
      return row.data();
    };
    return stream_png(store_.width(), height(), 8, Rounding::nearest, colors_of, sink);
  }

  RowSource colors() {
    return [this](int y) -> const float* {
      const std::optional<std::span<float>> row = row_of(0, y);
      if (!row) {
        return nullptr;
      }
      if (tones()) {
        map_tones(*row, options_.tone, options_.exposure, white_);  // each row is requested once
      }
      return row->data();
    };
  }

  bool find_white() {
    for (int y = 0; y < height(); ++y) {
      const std::optional<std::span<float>> row = row_of(0, y);
      if (!row) {
        return false;
      }
      white_ = std::max(white_, brightest(*row, options_.exposure));
    }
    decoded_ = {};
    return true;
  }

  // The values of a row; none to stop. After the first layer, the ranges of all are known.
  std::optional<std::span<float>> row_of(std::size_t layer, int y) {
    const BandStore::Band* const band = band_at(y);
    if (band == nullptr) {
      return std::nullopt;
    }
    if (decoded_ != band->rows) {
      const Result<void> read = band->file->read(rows_);
      if (!read) {
        unread_ = "cannot decode a band: " + read.error().text;
        return std::nullopt;
      }
      decoded_ = band->rows;
      for (std::size_t i = 1; i < rows_.size(); ++i) {
        ranges_[i] = joined(ranges_[i], range_of(rows_[i].values));
      }
    }
    const std::size_t count =
        rows_[layer].channels.size() * static_cast<std::size_t>(store_.width());
    return std::span(rows_[layer].values)
        .subspan(count * static_cast<std::size_t>(y - decoded_.first), count);
  }

  std::optional<std::string> block_at(int y) {
    const BandStore::Band* const band = band_at(y);
    if (band == nullptr) {
      return std::nullopt;
    }
    Result<std::string> block = band->file->block(y);
    if (!block) {
      unread_ = "cannot decode a band: " + block.error().text;
      return std::nullopt;
    }
    return *std::move(block);
  }

  // Null to stop.
  const BandStore::Band* band_at(int y) {
    if (DeferredSignals::pending() != 0) {
      return nullptr;
    }
    const Result<const BandStore::Band*> band = store_.band_at(y);
    unread_ = error_text(band);
    return band ? *band : nullptr;
  }

  Outcome failure(const std::string& unwritten, Context& context) const {
    if (DeferredSignals::pending() != 0) {
      return outcome_of(RenderStatus::cancelled, context);
    }
    return {ExitCode::environment, unread_.empty() ? unwritten : unread_};
  }

  const Options& options_;
  BandStore& store_;
  std::vector<ImageLayer> rows_;  // of the band that was decoded last
  RowRange decoded_;
  std::vector<ValueRange> ranges_;  // of the layers
  double white_ = 0;
  std::string unread_;  // why rows could not be read
  std::deque<Output> outputs_;
};

}  // namespace

Outcome assemble(const Options& options, BandStore& store, Context& context) {
  context.phase = "writing the picture";
  return Assembler(options, store).run(context);
}

}  // namespace scenefile::app
