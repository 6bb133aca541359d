#pragma once
// Converts byte offsets in a text to lines and columns. Lines end with LF, CR or CR LF; columns
// count code points. Private to the room.

#include "scenefile/base/location.h"

#include <cstddef>
#include <string_view>
#include <vector>

namespace scenefile {

/// For offsets in any order. Each lookup scans at most a few kilobytes, less in ascending order.
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

/// For places in the order of the text: each call continues from the previous place, so that all
/// places of a file together take one pass.
class TextCursor {
 public:
  explicit TextCursor(std::string_view text);

  /// The place of a tag or text. Calls must be in the order of the text.
  Location advance_to(const char* at);
  /// A place inside the tag of the last advance_to().
  Location inside_tag(const char* at);
  /// The fraction of the text that has been passed, 0..1.
  double progress() const;

 private:
  struct Point {
    const char* at;
    Location location{1, 1};
  };
  void move(Point& point, const char* to) const;

  const char* begin_;
  const char* end_;
  bool lone_cr_;  ///< whether a CR that is not part of CR LF ends a line
  Point tag_;
  Point inside_;
};

}  // namespace scenefile
