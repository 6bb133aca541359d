#pragma once
// Converts byte offsets in a text to lines and columns. Lines end with LF, CR or CR LF; columns
// count code points. Internal to format.

#include "scenefile/base/location.h"

#include <cstddef>
#include <string_view>
#include <vector>

namespace scenefile {

/// For places in any order. Each lookup scans at most a few kilobytes; all places of a text in
/// ascending order together take one pass.
class TextPlaces {
 public:
  explicit TextPlaces(std::string_view text);

  /// The place of the byte at `offset`, or of the end of the text.
  Location at(std::size_t offset);
  /// `byte` must point into the text.
  Location at(const char* byte) { return at(static_cast<std::size_t>(byte - text_.data())); }

  /// How much of the text is before the last place, 0..1.
  double progress() const;

 private:
  struct Mark {
    std::size_t offset = 0;
    Location location{1, 1};
  };
  void go_near(std::size_t offset);
  /// Returns the place that `mark` then has.
  Location advance(Mark& mark, std::size_t offset) const;

  std::string_view text_;
  bool lone_cr_;                 ///< whether a CR that is not part of CR LF ends a line
  std::vector<Location> steps_;  ///< of each multiple of the step in text_places.cpp, as needed
  Mark last_step_;
  Mark last_;
};

}  // namespace scenefile
