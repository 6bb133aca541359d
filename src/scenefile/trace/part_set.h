#pragma once
// Which of the parts of a picture are there, by their heads.

#include "scenefile/trace/part_file.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace scenefile {

/// What is known of a file that should be a part.
struct PartCandidate {
  PartHead head;
  bool has_head = false;
  std::string damage;  ///< for a person; empty: it is whole
};

/// Indices of parts are counted from 0, files are indices into the candidates.
struct PartSet {
  DividedPicture picture;              ///< of most parts; of the first of them where it is a tie
  std::vector<std::size_t> files;      ///< the good one by index of the part; no_file: none
  std::vector<std::uint32_t> missing;  ///< no good file at all
  std::vector<std::size_t> doubled;    ///< files of parts that another file is of, too
  std::vector<std::size_t> damaged;    ///< files
  std::vector<std::size_t> foreign;    ///< files that are parts of other pictures

  bool complete() const {
    return !files.empty() && missing.empty() && doubled.empty() && damaged.empty() &&
           foreign.empty();
  }
};
inline constexpr std::size_t no_file = ~std::size_t{0};

/// Sorts the parts. `files` is empty where no candidate has a head that can be read.
PartSet sort_parts(std::span<const PartCandidate> candidates);

/// "3, 7-9, 12": numbers of parts, counted from 1. `sorted` are indices.
std::string part_numbers(std::span<const std::uint32_t> sorted);

}  // namespace scenefile
