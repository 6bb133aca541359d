#pragma once
// Splits an OBJ file into words. Internal to asset.

#include "scenefile/base/location.h"

#include <cstdint>
#include <string_view>
#include <vector>

namespace scenefile {

/// Iterates over a text statement by statement, word by word, without copying. A statement is a
/// line, or several lines joined by a backslash at the end. Lines end with LF, CR or both; blanks,
/// tabs, vertical tabs and form feeds separate words; # begins a comment up to the end of the line.
class ObjWords {
 public:
  /// A byte order mark is skipped.
  explicit ObjWords(std::string_view text);

  /// Advances to the next statement that has a word. False at the end of the text.
  bool next_statement();
  /// The next word of the statement; empty when there is none.
  std::string_view next_word();
  /// From `first`, the word returned last, to the last word of the statement: a name that may hold
  /// blanks. A # inside a word belongs to it, and one before a digit: "Material #25".
  std::string_view rest(std::string_view first);

  /// How many bytes of the text were read.
  std::size_t at() const { return at_; }
  /// The place of a word returned by next_word() (columns beyond 65,536 count bytes); for a word on
  /// an earlier line of the statement, the start of the current line.
  Location location(std::string_view word) const;

 private:
  void skip_blanks();
  void skip_comment();
  std::size_t line_end_bytes(std::size_t at) const;
  void pass_line_end(std::size_t bytes);
  bool number_sign_in_name(std::size_t end) const;

  std::string_view text_;
  std::size_t at_ = 0;
  std::size_t line_start_ = 0;
  std::uint32_t line_ = 1;
  bool inside_ = false;  // inside a statement
};

/// The names after the word mtllib, in order of priority; the last may be the whole line, for a
/// name that holds blanks. Empty if there are none.
std::vector<FileReference> library_names(ObjWords& words);

}  // namespace scenefile
