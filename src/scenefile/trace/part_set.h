#pragma once
// Finds out which parts of a picture, or of something else that is divided, exist.

#include "scenefile/trace/part_file.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace scenefile {

/// A file that should be a part, as far as it can be read.
struct PartCandidate {
  PartHead head;
  bool has_head = false;
  std::string damage;  ///< an error message; empty if the part is intact
};

/// What such a file says about its place.
struct PartTag {
  std::string whole;  ///< equal for all parts of a whole; empty if the header cannot be read
  std::uint32_t index = 0;
  std::uint32_t count = 1;  ///< number of parts, > index
  std::string damage;       ///< as PartCandidate::damage
};

/// Parts are numbered from 0; files are indices into the candidates.
struct SortedParts {
  /// A file of the whole that most files are parts of; if several are equally common, of the first.
  /// no_file if no header can be read.
  std::size_t usual = ~std::size_t{0};
  std::vector<std::size_t> files;      ///< by part; no_file if there is no intact one
  std::vector<std::uint32_t> missing;  ///< parts without an intact file
  std::vector<std::size_t> doubled;    ///< files with a part that another file contains too
  std::vector<std::size_t> damaged;    ///< files
  std::vector<std::size_t> foreign;    ///< files with parts of something else

  bool complete() const {
    return !files.empty() && missing.empty() && doubled.empty() && damaged.empty() &&
           foreign.empty();
  }
};
inline constexpr std::size_t no_file = ~std::size_t{0};

/// The parts of a picture.
struct PartSet : SortedParts {
  DividedPicture picture;
};

/// Sorts the candidates. `files` is empty if no header can be read.
SortedParts sort_parts(std::span<const PartTag> tags);
PartSet sort_parts(std::span<const PartCandidate> candidates);

PartTag tag_of(const PartCandidate& candidate);

/// "3, 7-9, 12": the numbers of parts, counted from 1. `sorted` are indices.
std::string part_numbers(std::span<const std::uint32_t> sorted);

}  // namespace scenefile
