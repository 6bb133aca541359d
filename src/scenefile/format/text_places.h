#pragma once
// Where bytes of a text stand: lines, which end with LF, CR or CR LF, and columns, which count code
// points. Private to the room.

#include "scenefile/base/location.h"

#include <cstddef>
#include <string_view>
#include <vector>

namespace scenefile {

/// For places in any order: each is found in the time to read a few kilobytes, in ascending order
/// in less.
class TextPlaces {
 public:
  explicit TextPlaces(std::string_view text);

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
  std::vector<Location> steps_;  ///< of each multiple of the step in text_places.cpp, as needed
  Mark last_step_;
  Mark last_;
};

/// For places in the order of the text: each call moves on from the place found before, so that all
/// places of a file together cost one pass over it.
class TextCursor {
 public:
  explicit TextCursor(std::string_view text);

  /// The place of a tag or text; calls must be in the order of the text.
  Location advance_to(const char* at);
  /// A place inside the tag that was advanced to last.
  Location inside_tag(const char* at);
  /// How much of the text is behind, 0..1.
  double progress() const;

 private:
  struct Point {
    const char* at;
    Location location{1, 1};
  };
  void move(Point& point, const char* to) const;

  const char* begin_;
  const char* end_;
  bool lone_cr_;  ///< carriage returns end lines by themselves
  Point tag_;
  Point inside_;
};

}  // namespace scenefile
