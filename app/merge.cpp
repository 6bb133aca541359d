// The command merge: assembles a picture from its parts, row by row.

#include "app/command.h"
#include "app/json.h"
#include "app/load.h"
#include "app/output.h"
#include "app/part_files.h"
#include "app/pictures.h"
#include "scenefile/asset/image_file.h"
#include "scenefile/asset/image_stream.h"
#include "scenefile/base/text.h"
#include "scenefile/io/file.h"
#include "scenefile/io/file_writer.h"
#include "scenefile/io/folder.h"
#include "scenefile/io/interrupt.h"
#include "scenefile/io/parallel.h"
#include "scenefile/verbs/scene_json.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

namespace scenefile::app {

namespace {

// The parts on the command line, after reading their headers.
struct Parts {
  std::vector<std::string> paths;
  std::vector<PartCandidate> candidates;  // by path
  PartSet set;
};

// The files that the arguments mean; a folder means the parts in it.
std::vector<std::string> part_paths(const Options& options) {
  std::vector<std::string> paths;
  for (const std::string& argument : options.arguments) {
    if (!is_folder(argument)) {
      paths.push_back(argument);
      continue;
    }
    for (const std::string& name : files_in(argument, 2 * std::size_t{most_parts})) {
      const std::string path = argument + (argument.ends_with('/') ? "" : "/") + name;
      if (!name.starts_with('.') && looks_like_part(path)) {
        paths.push_back(path);
      }
    }
  }
  return paths;
}

Outcome check_parts(const Options& options, Parts& parts, Context& context) {
  context.phase = "reading the parts";
  parts.paths = part_paths(options);
  parts.candidates.resize(parts.paths.size());
  std::vector<std::string> errors(parts.paths.size());
  for_each_index(parts.paths.size(), 0, [&](std::size_t i) {
    Result<PartCandidate> candidate = check_part_file(parts.paths[i]);
    if (candidate) {
      parts.candidates[i] = *std::move(candidate);
    } else {
      errors[i] = candidate.error().text;
    }
  });
  const auto unreadable = std::find_if(errors.begin(), errors.end(),
                                       [](const std::string& error) { return !error.empty(); });
  if (unreadable != errors.end()) {
    return {ExitCode::environment, *unreadable};
  }
  parts.set = sort_parts(parts.candidates);
  return {};
}

std::string numbered(const Parts& parts, std::size_t file) {
  const PartCandidate& part = parts.candidates[file];
  const std::string number =
      part.has_head ? fmt::format(" (part {} of {})", part.head.index + 1, part.head.picture.count)
                    : std::string();
  return escaped(parts.paths[file], 400) + number;
}

std::string foreign_text(const Parts& parts, std::size_t file) {
  const DividedPicture& found = parts.candidates[file].head.picture;
  const std::string_view why = foreign_part(found.key, parts.set.picture.key);
  return fmt::format("{}: {}{}", numbered(parts, file), why.empty() ? "" : "drawn ",
                     !why.empty() ? why
                     : found.count != parts.set.picture.count
                         ? "belongs to the same picture, divided into another number of parts"
                         : "belongs to another picture");
}

// The reasons why the parts do not make a picture, one per line.
std::vector<std::string> problems(const Parts& parts) {
  const PartSet& set = parts.set;
  std::vector<std::string> lines;
  if (parts.paths.empty()) {
    lines.emplace_back("no parts found");
  }
  for (const std::size_t file : set.foreign) {
    lines.push_back(foreign_text(parts, file));
  }
  for (const std::size_t file : set.damaged) {
    lines.push_back(fmt::format("{}: {}", numbered(parts, file), parts.candidates[file].damage));
  }
  for (const std::size_t file : set.doubled) {
    const std::size_t first = set.files[parts.candidates[file].head.index];
    lines.push_back(fmt::format("{}: the same part as {}", numbered(parts, file),
                                escaped(parts.paths[first], 400)));
  }
  if (!set.missing.empty()) {
    lines.push_back(fmt::format("missing: {} of {}: {}", set.missing.size(), set.files.size(),
                                part_numbers(set.missing)));
  }
  return lines;
}

ExitCode print_missing(const Parts& parts) {
  std::string lines;
  for (const std::uint32_t index : parts.set.missing) {
    lines += fmt::format("{}\n", index + 1);
  }
  return worse(answer(lines), parts.set.missing.empty() ? ExitCode::fine : ExitCode::findings);
}

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
  Merger(const Options& options, const Parts& parts) : options_(options), parts_(parts) {
    for (const PartCandidate& part : parts.candidates) {
      heads_.push_back(part.head);
    }
    rows_.emplace(parts.set, heads_, parts.paths);
  }

  Outcome run(ImageFormat format) {
    const DeferredSignals deferred;
    for (const std::string& path : files(format)) {
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
  const DividedPicture& picture() const { return parts_.set.picture; }
  int width() const { return picture().region.width(); }
  int height() const { return picture().region.height(); }

  std::vector<std::string> files(ImageFormat format) const {
    std::vector<std::string> paths{options_.output};
    for (const Layer& layer : picture().layers) {
      if (format == ImageFormat::png8) {
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
    std::string error;  // unused: render rejects what cannot be written
    return stream_layers(
        width(), height(), names,
        [this](int y, int /*end*/) -> std::optional<LayerRows> {
          const PartRows::Band* const band = band_of(y);
          return band == nullptr ? std::nullopt
                                 : std::optional(LayerRows{band->layers, band->first});
        },
        sink, error);
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

  const PartRows::Band* band_of(int y) {
    return DeferredSignals::pending() != 0 ? nullptr : rows_->band_of(y);
  }

  Outcome failure(const Output& output) const {
    if (DeferredSignals::pending() != 0) {
      return judge(RenderStatus::cancelled, {});
    }
    return {ExitCode::environment, rows_->error().empty() ? output.error() : rows_->error()};
  }

  const Options& options_;
  const Parts& parts_;
  std::vector<PartHead> heads_;
  std::optional<PartRows> rows_;
  std::vector<Output> outputs_;
};

Outcome check_target(const Options& options, const Parts& parts, ImageFormat format) {
  if (!parts.set.picture.layers.empty() && format == ImageFormat::pfm) {
    return {ExitCode::usage,
            "the parts have layers, which PFM cannot hold: end the output in .exr or .png"};
  }
  if (!parts.set.picture.layers.empty() && format == ImageFormat::png8 &&
      options.output.find('.') == std::string::npos) {
    return {ExitCode::usage, "the parts have layers: the output must end in .exr or .png"};
  }
  for (const std::string& path : parts.paths) {
    if (same_file(options.output, path)) {
      return {ExitCode::usage, "the output would replace a part"};
    }
  }
  return {};
}

std::string merge_json(const Options& options, const Parts& parts, const std::string& error) {
  Json json;
  begin_document(json, "merge");
  const PartSet& set = parts.set;
  json.add("parts", set.files.size());
  json.begin_array("missing");
  for (const std::uint32_t index : set.missing) {
    json.value(index + 1);
  }
  json.end_array();
  const auto add_files = [&](std::string_view name, const std::vector<std::size_t>& files,
                             const auto& why) {
    json.begin_array(name);
    for (const std::size_t file : files) {
      json.begin_object();
      json.add("file", parts.paths[file]);
      if (parts.candidates[file].has_head) {
        json.add("number", parts.candidates[file].head.index + 1);
      }
      if (const std::string reason = why(file); !reason.empty()) {
        json.add("error", reason);
      }
      json.end_object();
    }
    json.end_array();
  };
  add_files("doubled", set.doubled, [](std::size_t) { return std::string(); });
  add_files("damaged", set.damaged,
            [&](std::size_t file) { return parts.candidates[file].damage; });
  add_files("foreign", set.foreign, [&](std::size_t file) { return foreign_text(parts, file); });
  if (!options.missing) {
    json.add("output", options.output);
    json.add("width", set.picture.region.width());
    json.add("height", set.picture.region.height());
    json.add("written", error.empty());
  }
  if (!error.empty()) {
    json.add("error", error);
  }
  json.end_object();
  return json.text();
}

}  // namespace

ExitCode run_merge(const Options& options, Context& context) {
  Parts parts;
  Outcome outcome = check_parts(options, parts, context);
  std::vector<std::string> wrong;
  if (outcome.status == ExitCode::fine) {
    wrong = problems(parts);
  }
  if (outcome.status == ExitCode::fine && options.missing && !parts.set.files.empty()) {
    if (options.json) {
      return worse(parts.set.missing.empty() ? ExitCode::fine : ExitCode::findings,
                   answer(merge_json(options, parts, {})));
    }
    return print_missing(parts);
  }
  if (!wrong.empty()) {
    outcome = {ExitCode::findings, wrong.back()};
  }
  ImageFormat format = ImageFormat::png8;
  image_format_of(options.output, format);
  if (outcome.status == ExitCode::fine) {
    outcome = check_target(options, parts, format);
  }
  if (outcome.status == ExitCode::fine) {
    context.phase = "writing the picture";
    outcome = Merger(options, parts).run(format);
  }
  if (options.json) {
    return worse(outcome.status, answer(merge_json(options, parts, outcome.error)));
  }
  for (std::size_t i = 0; i + 1 < wrong.size(); ++i) {
    say_error(wrong[i]);
  }
  if (!outcome.error.empty()) {
    say_error(outcome.error);
  } else if (!options.quiet) {
    say_afterwards([&] {
      const PixelRegion& region = parts.set.picture.region;
      return fmt::format("{}: {}x{}, {} parts\n",
                         options.output == "-" ? "<stdout>" : escaped(options.output),
                         region.width(), region.height(), parts.set.files.size());
    });
  }
  return outcome.status;
}

}  // namespace scenefile::app
