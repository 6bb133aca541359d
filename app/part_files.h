#pragma once
// Files that contain parts of pictures and of classes.

#include "scenefile/base/result.h"
#include "scenefile/grade/grade_part.h"
#include "scenefile/io/file_reader.h"
#include "scenefile/trace/part_set.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace scenefile::app {

/// Reads the header, and compares the rows with their checksum. Returns an error if the file cannot
/// be read; if the part is damaged, the result says so in `damage`.
Result<PartCandidate> check_part_file(const std::string& path);

/// Writes the file of a part atomically.
Result<void> write_part_file(const std::string& path, const DividedPicture& picture,
                             std::uint32_t index, const Image& image,
                             std::span<const ImageLayer> layers);

/// The results of a part of a class.
struct GradePart {
  GradePartHead head;
  Gradebook book;
  std::string damage;  ///< an error message; empty if the part is intact
};

/// Reads the file. An error means that it cannot be read; for other defects, see `damage`.
Result<GradePart> read_grade_part(const std::string& path);

PartTag tag_of(const GradePart& part);

/// The type of a file, by its first bytes.
enum class PartKind : std::uint8_t { none, of_picture, of_class };
PartKind kind_of_part(const std::string& path);

/// Reads the rows of a picture from the files of its parts.
class PartRows {
 public:
  /// `set` must be complete; `paths` are the files of its candidates. Both must outlive this
  /// object.
  PartRows(const PartSet& set, std::span<const PartHead> heads, std::span<const std::string> paths);

  /// Rows of the picture and of its layers, in bands of up to 16.
  struct Band {
    int first = 0;                   ///< first row in the merged picture
    std::vector<ImageLayer> layers;  ///< the picture itself, then its layers
  };
  /// The band that contains row y of the merged picture, valid until the next call. An error if a
  /// file cannot be read.
  Result<const Band*> band_of(int y);

 private:
  Result<void> read(int first, int end);

  const PartSet& set_;
  std::span<const PartHead> heads_;  // by file
  std::span<const std::string> paths_;
  Band band_;
};

}  // namespace scenefile::app
