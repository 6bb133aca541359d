#pragma once
// Parts of pictures as files of this machine.

#include "scenefile/base/result.h"
#include "scenefile/io/file_reader.h"
#include "scenefile/trace/part_set.h"

#include <span>
#include <string>
#include <vector>

namespace scenefile::app {

/// Reads the head and holds the rows against their checksum. An error is one of reading; what is
/// wrong with the part stands in its `damage`.
Result<PartCandidate> check_part_file(const std::string& path);

/// Writes the file of a part, whole or not at all.
Result<void> write_part_file(const std::string& path, const DividedPicture& picture,
                             std::uint32_t index, const Image& image,
                             std::span<const ImageLayer> layers);

/// Whether the file starts as one of a part does.
bool looks_like_part(const std::string& path);

/// The rows of a picture, from the files of its parts.
class PartRows {
 public:
  /// A complete set, and the paths of its candidates. Both must outlive this.
  PartRows(const PartSet& set, std::span<const PartHead> heads, std::span<const std::string> paths);

  /// Rows of the picture and of its layers, in bands of 16.
  struct Band {
    int first = 0;                   ///< row of the merged picture that it begins with
    std::vector<ImageLayer> layers;  ///< the picture itself, then its layers
  };
  /// The band that holds the row y of the merged picture, good until the next call; null where a
  /// file could not be read: error() says why.
  const Band* band_of(int y);
  const std::string& error() const { return error_; }

 private:
  bool read(int first, int end);

  const PartSet& set_;
  std::span<const PartHead> heads_;  // by file
  std::span<const std::string> paths_;
  Band band_;
  std::string error_;
};

}  // namespace scenefile::app
