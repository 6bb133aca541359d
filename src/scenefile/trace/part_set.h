#pragma once
// Finds out which parts of a picture exist, from their headers.

#include "scenefile/trace/part_file.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace scenefile {

/// What is known about a file that should be a part.
struct PartCandidate {
  PartHead head;
  bool has_head = false;
  std::string damage;  ///< an error text for people; empty if the part is intact
};

/// Parts are numbered from 0; files are indices into the candidates.
struct PartSet {
  DividedPicture picture;              ///< of most candidates; of equals the first
  std::vector<std::size_t> files;      ///< by part; no_file if there is no intact one
  std::vector<std::uint32_t> missing;  ///< parts without an intact file
  std::vector<std::size_t> doubled;    ///< files with a part that another file contains too
  std::vector<std::size_t> damaged;    ///< files
  std::vector<std::size_t> foreign;    ///< files with parts of other pictures

  bool complete() const {
    return !files.empty() && missing.empty() && doubled.empty() && damaged.empty() &&
           foreign.empty();
  }
};
inline constexpr std::size_t no_file = ~std::size_t{0};

/// Sorts the candidates. `files` is empty if no header can be read.
PartSet sort_parts(std::span<const PartCandidate> candidates);

/// "3, 7-9, 12": the numbers of parts, counted from 1. `sorted` are indices.
std::string part_numbers(std::span<const std::uint32_t> sorted);

}  // namespace scenefile
