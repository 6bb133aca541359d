#pragma once
// Places in a text file.

#include <cstdint>
#include <string>

namespace scenefile {

/// A place in a text file. Lines and columns count from 1; columns count characters (Unicode code
/// points), a tab as one. {0, 0} means "no place", as in scenes built in memory.
struct Location {
  std::uint32_t line = 0;
  std::uint32_t column = 0;

  bool known() const { return line != 0; }
  friend bool operator==(const Location&, const Location&) = default;
};

/// A file named by another file, and the place of its first mention.
struct FileReference {
  std::string name;   ///< as written by the author, not resolved
  Location location;  ///< for messages
};

}  // namespace scenefile
