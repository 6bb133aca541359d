#include "app/merge.h"
#include "app/named_files.h"
#include "app/output.h"
#include "app/part_files.h"
#include "app/pictures.h"
#include "scenefile/asset/image_file.h"
#include "scenefile/asset/image_stream.h"
#include "scenefile/base/text.h"
#include "scenefile/io/file.h"
#include "scenefile/io/file_writer.h"
#include "scenefile/io/interrupt.h"

#include <fmt/format.h>

#include <optional>

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
class Merger {
 public:
  Merger(const Options& options, const PartSet& set, std::span<const PartCandidate> candidates,
         std::span<const std::string> paths)
      : options_(options), set_(set) {
    for (const PartCandidate& part : candidates) {
      heads_.push_back(part.head);
    }
    rows_.emplace(set, heads_, paths);
  }

  Outcome run(ImageFormat format, Context& context) {
    const DeferredSignals deferred;
    std::vector<UsedFile> claimed;
    for (const std::string& path : files(format)) {
      claimed.push_back(named_file(claimed.empty() ? "output" : "layer", path));
    }
    if (Outcome refused = claim_outputs(claimed, context); !refused.error.empty()) {
      return refused;
    }
    for (const auto& [path, what] : claimed) {
      outputs_.emplace_back(path);
      if (Outcome outcome = outputs_.back().open(); !outcome.error.empty()) {
        return outcome;
      }
    }
    for (std::size_t i = 0; i < outputs_.size(); ++i) {
      if (!write(format, i)) {
        return failure(outputs_[i]);
      }
    }
    for (Output& output : outputs_) {
      if (!output.commit()) {
        return failure(output);
      }
    }
    return {};
  }

 private:
  const DividedPicture& picture() const { return set_.picture; }
  int width() const { return picture().region.width(); }
  int height() const { return picture().region.height(); }

  std::vector<std::string> files(ImageFormat format) const {
    std::vector<std::string> paths{options_.output};
    for (const Layer& layer : picture().layers) {
      if (layer_storage(format) == LayerStorage::apart) {
        paths.push_back(layer_file(options_.output, layer));
      }
    }
    return paths;
  }

  // The picture for `index` 0, otherwise a layer.
  bool write(ImageFormat format, std::size_t index) {
    const ByteSink sink = outputs_[index].sink();
    switch (format) {
      case ImageFormat::png8:
      case ImageFormat::png16:
        return index == 0 ? stream_png(width(), height(), 8, picture().rounding, colors(), sink)
                          : write_layer(index - 1, sink);
      case ImageFormat::pfm:
        return stream_pfm(width(), height(), colors(), sink);
      case ImageFormat::exr:
        break;
    }
    std::vector<ImageLayer> names{{"", {"R", "G", "B"}, false, {}}};
    for (const Layer& layer : picture().layers) {
      names.push_back(layer_without_values(layer));
    }
    const auto rows = [this](int y, int /*end*/) -> std::optional<LayerRows> {
      const PartRows::Band* const band = band_of(y);
      return band == nullptr ? std::nullopt : std::optional(LayerRows{band->layers, band->first});
    };
    // Only fails if it is canceled: render rejects pictures that cannot be written.
    return bool(stream_layers(width(), height(), names, rows, sink));
  }

  bool write_layer(std::size_t index, const ByteSink& sink) {
    const Layer& layer = picture().layers[index];
    ValueRange range;
    for (const PartHead& head : heads_) {
      range = joined(range, head.ranges[index]);
    }
    std::vector<float> row(std::size_t{3} * static_cast<std::size_t>(width()));
    const auto colors_of = [&](int y) -> const float* {
      const PartRows::Band* const band = band_of(y);
      if (band == nullptr) {
        return nullptr;
      }
      const ImageLayer& values = band->layers[index + 1];
      const std::size_t count = values.channels.size() * static_cast<std::size_t>(width());
      layer_colors(
          layer, {values.values.data() + count * static_cast<std::size_t>(y - band->first), count},
          range, picture().max_depth, row.data());
      return row.data();
    };
    return stream_png(width(), height(), 8, Rounding::nearest, colors_of, sink);
  }

  RowSource colors() {
    return [this](int y) -> const float* {
      const PartRows::Band* const band = band_of(y);
      return band == nullptr ? nullptr
                             : band->layers[0].values.data() +
                                   std::size_t{3} * static_cast<std::size_t>(width()) *
                                       static_cast<std::size_t>(y - band->first);
    };
  }

  // Null to stop.
  const PartRows::Band* band_of(int y) {
    if (DeferredSignals::pending() != 0) {
      return nullptr;
    }
    const Result<const PartRows::Band*> band = rows_->band_of(y);
    unread_ = error_text(band);
    return band ? *band : nullptr;
  }

  Outcome failure(const Output& output) const {
    if (DeferredSignals::pending() != 0) {
      return outcome_of(RenderStatus::cancelled, {});
    }
    return {ExitCode::environment, unread_.empty() ? output.error() : unread_};
  }

  const Options& options_;
  const PartSet& set_;
  std::vector<PartHead> heads_;
  std::optional<PartRows> rows_;
  std::string unread_;  // why rows could not be read
  std::vector<Output> outputs_;
};

Outcome check_target(const Options& options, const PartSet& set, ImageFormat format) {
  const LayerStorage storage = layer_storage(format);
  if (!set.picture.layers.empty() && storage == LayerStorage::none) {
    return {ExitCode::usage,
            "the parts have layers, which PFM cannot store: end the output in .exr or .png"};
  }
  if (!set.picture.layers.empty() && storage == LayerStorage::apart &&
      options.output.find('.') == std::string::npos) {
    return {ExitCode::usage, "the parts have layers: the output must end in .exr or .png"};
  }
  return {};
}

}  // namespace

Outcome merge_picture(const Options& options, std::span<const PartCandidate> candidates,
                      std::span<const std::string> paths, Context& context) {
  const PartSet set = sort_parts(candidates);
  const ImageFormat format = image_format_of(options.output).value_or(ImageFormat::png8);
  Outcome outcome = check_target(options, set, format);
  if (outcome.status == ExitCode::fine) {
    context.phase = "writing the picture";
    outcome = Merger(options, set, candidates, paths).run(format, context);
  }
  if (outcome.error.empty() && !options.quiet && !options.json) {
    say_afterwards([&] {
      const PixelRegion& region = set.picture.region;
      return fmt::format(
          "{}: {}x{}, {} part{}\n", options.output == "-" ? "<stdout>" : escaped(options.output),
          region.width(), region.height(), set.files.size(), set.files.size() == 1 ? "" : "s");
    });
  }
  return outcome;
}

}  // namespace scenefile::app
