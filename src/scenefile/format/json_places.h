#pragma once
// Offsets in a text turned into lines and columns. Private to the room.

#include "scenefile/base/location.h"

#include <cstddef>
#include <string_view>
#include <vector>

namespace scenefile {

/// Lines end with LF, CR or CR LF; columns count code points. Any order of questions is answered
/// in the time to read a few kilobytes, ascending order in less.
class JsonPlaces {
 public:
  explicit JsonPlaces(std::string_view text);

  /// The place of the byte at `offset`, or of the end of the text.
  Location at(std::size_t offset);

 private:
  struct Mark {
    std::size_t offset = 0;
    Location location{1, 1};
  };
  void go_near(std::size_t offset);
  void advance(Mark& mark, std::size_t offset) const;
  void advance_by_character(Mark& mark, std::size_t offset) const;

  std::string_view text_;
  bool lone_cr_;
  std::vector<Location> steps_;  ///< of each multiple of the step in json_places.cpp, as needed
  Mark last_step_;
  Mark last_;
};

}  // namespace scenefile
