#include "scenefile/format/syntax.h"

#include "scenefile/base/text.h"
#include "scenefile/format/codes.h"

#include <fmt/format.h>

namespace scenefile {

namespace {

// The place of the character at `offset`; the text in front of it is blank.
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

}  // namespace

std::optional<SceneFormat> syntax_of(std::string_view text, Diagnostics& diagnostics) {
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos) {
    diagnostics.report(
        format_empty, {1, 1},
        text.empty() ? "the file is empty" : "the file is empty but for white space");
    return std::nullopt;
  }
  if (text[first] == '<') {
    return SceneFormat::xml;
  }
  if (text[first] == '{' || text[first] == '[') {
    return SceneFormat::json;
  }
  diagnostics.report(
      format_unknown, after_blanks(text, first),
      fmt::format("the file starts with {}, so it is no scene file: an XML scene starts with <, a "
                  "JSON scene is an object and starts with {{",
                  quoted(text.substr(first, 40), 10)));
  return std::nullopt;
}

}  // namespace scenefile
