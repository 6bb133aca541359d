#include "scenefile/format/syntax.h"

#include "scenefile/base/text.h"
#include "scenefile/format/codes.h"
#include "scenefile/format/other_files.h"

#include <fmt/format.h>

#include <cstdint>

namespace scenefile {

namespace {

constexpr std::string_view blanks = " \t\r\n";

// The place of the character at `offset`, which only white space precedes.
Location after_blanks(std::string_view text, std::size_t offset) {
  Location place{1, 1};
  for (std::size_t i = 0; i < offset; ++i) {
    const bool ends_line =
        text[i] == '\n' || (text[i] == '\r' && i + 1 < text.size() && text[i + 1] != '\n');
    place.line += ends_line;
    place.column = ends_line ? 1 : place.column + 1;
  }
  return place;
}

// The first character after white space and C comments; NUL if there is none.
char first_character(std::string_view text) {
  for (std::size_t at = 0; (at = text.find_first_not_of(blanks, at)) != std::string_view::npos;) {
    const std::string_view two = text.substr(at, 2);
    if (two != "//" && two != "/*") {
      return text[at];
    }
    const std::size_t end = two == "//" ? text.find_first_of("\r\n", at) : text.find("*/", at + 2);
    at = end == std::string_view::npos ? end : end + (two == "//" ? 1 : 2);
  }
  return '\0';
}

}  // namespace

std::optional<SceneFormat> syntax_of(std::string_view text, Diagnostics& diagnostics) {
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) {
    diagnostics.report(
        format_empty, {1, 1},
        text.empty() ? "the file is empty" : "the file is empty but for white space");
    return std::nullopt;
  }
  const std::string_view content = text.substr(first);
  if (const std::string_view other = other_file(content); !other.empty()) {
    diagnostics.report(format_unknown, after_blanks(text, first),
                       fmt::format("the file is {}", other));
    return std::nullopt;
  }
  // The reader reports comments, which JSON does not allow.
  switch (first_character(content)) {
    case '<':
      return SceneFormat::xml;
    case '{':
    case '[':
      return SceneFormat::json;
    default:
      break;
  }
  if (content[0] == '"') {
    diagnostics.report(format_unknown, after_blanks(text, first),
                       "the file starts with a quotation mark; a JSON scene is an object, so { is "
                       "missing in front of it");
    return std::nullopt;
  }
  diagnostics.report(format_unknown, after_blanks(text, first),
                     fmt::format("the file starts with {}, so it is not a scene file: an XML scene "
                                 "starts with <, a JSON scene is an object and starts with {{",
                                 quoted(content.substr(0, 40), 10)));
  return std::nullopt;
}

std::string odd_blank_text(char32_t blank) {
  return fmt::format("a special blank, U+{:04X}; use an ordinary one",
                     static_cast<std::uint32_t>(blank));
}

}  // namespace scenefile
