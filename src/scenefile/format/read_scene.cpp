#include "scenefile/format/read_scene.h"

#include "scenefile/base/text.h"
#include "scenefile/format/codes.h"
#include "scenefile/format/json_reader.h"
#include "scenefile/format/text_encoding.h"
#include "scenefile/format/xml_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>

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

Scene read_scene(std::string_view text, const ReadOptions& options, Diagnostics& diagnostics) {
  std::string storage;
  const std::optional<std::string_view> decoded = decode_text(text, storage, diagnostics);
  if (!decoded) {
    return {};
  }
  const std::size_t first = decoded->find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos) {
    diagnostics.report(
        format_empty, {1, 1},
        text.empty() ? "the file is empty" : "the file is empty but for white space");
    return {};
  }
  if ((*decoded)[first] == '<') {
    return read_xml(*decoded, options, diagnostics);
  }
  if ((*decoded)[first] == '{' || (*decoded)[first] == '[') {
    return read_json(*decoded, options, diagnostics);
  }
  diagnostics.report(
      format_unknown, after_blanks(*decoded, first),
      fmt::format("the file starts with {}, so it is no scene file: an XML scene starts with <, a "
                  "JSON scene is an object and starts with {{",
                  quoted(decoded->substr(first, 40), 10)));
  return {};
}

}  // namespace scenefile
