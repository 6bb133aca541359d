#pragma once
// Lines of formatted text. Private to the room.

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>

namespace scenefile {

/// The line end of a text: that of its first line; LF if there is only one line.
inline std::string_view line_end_of(std::string_view text) {
  const std::size_t end = text.find_first_of("\r\n");
  if (end == std::string_view::npos || text[end] == '\n') {
    return "\n";
  }
  return text.substr(end).starts_with("\r\n") ? "\r\n" : "\r";
}

/// The number of line ends in the white space between two tokens.
inline std::size_t count_line_ends(std::string_view between) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < between.size(); ++i) {
    const bool half = between[i] == '\r' && i + 1 < between.size() && between[i + 1] == '\n';
    count += (between[i] == '\n' || between[i] == '\r') && !half;
  }
  return count;
}

/// Builds a text line by line.
class LinePrinter {
 public:
  explicit LinePrinter(std::string_view line_end) : line_end_(line_end) {}

  /// Ends the current line, if any, and indents the next. `blank`: adds an empty line before it.
  void start_line(std::size_t depth, bool blank) {
    if (!out_.empty()) {
      out_ += line_end_;
      out_ += blank ? line_end_ : std::string_view();
    }
    out_.append(2 * depth, ' ');
  }
  void add(std::string_view text) { out_ += text; }
  std::string finish() {
    out_ += line_end_;
    return std::move(out_);
  }

 private:
  std::string_view line_end_;
  std::string out_;
};

}  // namespace scenefile
