#include "app/part_files.h"

#include "scenefile/base/hash.h"
#include "scenefile/base/text.h"
#include "scenefile/io/file.h"
#include "scenefile/io/file_writer.h"
#include "scenefile/io/interrupt.h"

#include <fmt/format.h>

#include <algorithm>

namespace scenefile::app {

namespace {

constexpr int rows_of_a_band = 16;
constexpr std::uint64_t max_bytes_of_class = std::uint64_t{1} << 36;
constexpr std::size_t bytes_at_once = std::size_t{1} << 20;

// What is wrong with the rows; empty if they are intact.
Result<std::string> check_rows(const FileReader& file, const PartHead& head,
                               std::size_t before_rows) {
  const std::uint64_t length = part_file_bytes(head, before_rows);
  if (file.size() != length) {
    return std::string(file.size() < length ? "the part is truncated"
                                            : "the part is longer than its header says");
  }
  const PixelRegion region = head.region();
  const std::size_t row = part_row_bytes(head.picture, region.width());
  const std::size_t rows_at_once =
      std::max<std::size_t>(1, bytes_at_once / std::max<std::size_t>(1, row));
  Hash hash;
  std::uint64_t at = before_rows;
  for (std::size_t left = static_cast<std::size_t>(region.height()); left > 0;) {
    const std::size_t rows = std::min(left, rows_at_once);
    const Result<std::string> bytes = file.read(at, rows * row);
    if (!bytes) {
      return bytes.error();
    }
    if (bytes->size() != rows * row) {
      return std::string("the part is truncated");
    }
    for (std::size_t i = 0; i < rows; ++i) {
      hash.add(std::string_view(*bytes).substr(i * row, row));
    }
    at += bytes->size();
    left -= rows;
  }
  return std::string(hash.value() == head.checksum ? ""
                                                   : "the part is damaged: its checksum is wrong");
}

}  // namespace

Result<PartCandidate> check_part_file(const std::string& path) {
  const Result<FileReader> file = FileReader::open(path);
  if (!file) {
    return file.error();
  }
  const Result<std::string> start = file->read(0, max_part_head_bytes);
  if (!start) {
    return start.error();
  }
  PartCandidate part;
  std::size_t before_rows = 0;
  part.damage = decode_part_head(*start, part.head, before_rows);
  part.has_head = part.damage.empty();
  if (part.has_head) {
    Result<std::string> damage = check_rows(*file, part.head, before_rows);
    if (!damage) {
      return damage.error();
    }
    part.damage = *std::move(damage);
  }
  return part;
}

Result<void> write_part_file(const std::string& path, const DividedPicture& picture,
                             std::uint32_t index, const Image& image,
                             std::span<const ImageLayer> layers) {
  const DeferredSignals deferred;
  Result<FileWriter> file = FileWriter::create(path);
  if (!file) {
    return file.error();
  }
  Result<void> written =
      file->append(encode_part_head(make_part_head(picture, index, image, layers)));
  for (int y = 0; y < image.height && written; ++y) {
    written = file->append(part_row(image, layers, y));
  }
  return written ? file->commit() : written;
}

Result<GradePart> read_grade_part(const std::string& path) {
  const Result<std::string> bytes = read_file(path, max_bytes_of_class);
  if (!bytes) {
    return bytes.error();
  }
  GradePart part;
  part.damage = decode_grade_part(*bytes, part.head, part.book);
  return part;
}

PartTag tag_of(const GradePart& part) {
  PartTag tag;
  tag.damage = part.damage;
  if (part.damage.empty()) {
    GradePartHead common;
    common.whole = part.head.whole;
    tag.whole = encode_grade_part(common, {});
    tag.index = part.head.index;
    tag.count = part.head.whole.count;
  }
  return tag;
}

PartKind kind_of_part(const std::string& path) {
  const Result<FileReader> file = FileReader::open(path);
  const Result<std::string> start = file ? file->read(0, 64) : Result<std::string>(std::string());
  return !start                  ? PartKind::none
         : is_part_file(*start)  ? PartKind::of_picture
         : is_grade_part(*start) ? PartKind::of_class
                                 : PartKind::none;
}

PartRows::PartRows(const PartSet& set, std::span<const PartHead> heads,
                   std::span<const std::string> paths)
    : set_(set), heads_(heads), paths_(paths), band_{-1, {{"", {"R", "G", "B"}, false, {}}}} {
  for (const Layer& layer : set.picture.layers) {
    band_.layers.push_back(layer_without_values(layer));
  }
  for (ImageLayer& layer : band_.layers) {
    layer.values.resize(layer.channels.size() * rows_of_a_band *
                        static_cast<std::size_t>(set.picture.region.width()));
  }
}

Result<const PartRows::Band*> PartRows::band_of(int y) {
  const int first = y / rows_of_a_band * rows_of_a_band;
  if (first == band_.first) {
    return &band_;
  }
  band_.first = -1;
  const PixelRegion& whole = set_.picture.region;
  const int end = std::min(whole.y0 + first + rows_of_a_band, whole.y1);
  if (const Result<void> done = read(whole.y0 + first, end); !done) {
    return done.error();
  }
  band_.first = first;
  return &band_;
}

// The rows from `first` up to, but not including, `end` of the picture.
Result<void> PartRows::read(int first, int end) {
  for (const std::size_t file : set_.files) {
    const PartHead& head = heads_[file];
    const PixelRegion part = head.region();
    const int from = std::max(first, part.y0);
    const int to = std::min(end, part.y1);
    if (from >= to) {
      continue;
    }
    const Result<FileReader> reader = FileReader::open(paths_[file]);
    if (!reader) {
      return reader.error();
    }
    const std::size_t row = part_row_bytes(head.picture, part.width());
    const std::uint64_t rows_begin =
        reader->size() - std::uint64_t{row} * static_cast<std::uint64_t>(part.height());
    const std::size_t wanted = row * static_cast<std::size_t>(to - from);
    const Result<std::string> rows = reader->read(
        rows_begin + std::uint64_t{row} * static_cast<std::uint64_t>(from - part.y0), wanted);
    if (!rows) {
      return rows.error();
    }
    if (rows->size() != wanted) {
      return Error{
          fmt::format("{}: the file was truncated while it was read", escaped(paths_[file], 4096))};
    }
    place_part_rows(head, *rows, from, first, band_.layers);
  }
  return {};
}

}  // namespace scenefile::app
