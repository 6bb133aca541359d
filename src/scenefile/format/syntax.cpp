#include "scenefile/format/syntax.h"

#include "scenefile/base/ascii.h"
#include "scenefile/base/text.h"
#include "scenefile/format/codes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>

namespace scenefile {

namespace {

using namespace std::string_view_literals;

struct FileSignature {
  std::string_view start;  // lowercase
  std::string_view what;
};

constexpr std::string_view html =
    "an HTML page, as a browser saves it, not the scene it shows; download the file itself (on "
    "GitHub: \"Download raw file\")";
constexpr std::string_view mesh =
    "an OBJ mesh, not a scene; a scene draws it with <object type=\"primitive\" name=\"mesh\" "
    "filename=\"...\"/> (JSON: a primitive of type mesh with meshFile)";
constexpr std::string_view configuration =
    "a configuration of the course's ray tracer, not a scene; the scene is the file that it names "
    "under [IO]";
constexpr std::string_view picture = "a picture, not a scene";

constexpr FileSignature signatures[] = {
    {"version https://git-lfs"sv,
     "a Git LFS pointer, which is a placeholder for the scene; "
     "fetch the scene itself with \"git lfs pull\""},
    {"<!doctype html"sv, html},
    {"<html"sv, html},
    {"\x1f\x8b"sv, "compressed with gzip; unpack it first"},
    {"pk\x03\x04"sv, "a ZIP archive; unpack it first"},
    {"bzh"sv, "compressed with bzip2; unpack it first"},
    {"\xfd"
     "7zxz"sv,
     "compressed with xz; unpack it first"},
    {"7z\xbc\xaf"sv, "a 7z archive; unpack it first"},
    {"rar!"sv, "a RAR archive; unpack it first"},
    {"\x89png"sv, picture},
    {"\xff\xd8\xff"sv, picture},
    {"gif8"sv, picture},
    {"%pdf"sv, "a PDF document, not a scene"},
    {"mtllib "sv, mesh},
    {"usemtl "sv, mesh},
    {"newmtl "sv, "a material library of an OBJ mesh, not a scene"},
    {"[io]"sv, configuration},
    {"[canvas]"sv, configuration},
    {"[feature]"sv, configuration},
    {"[settings]"sv, configuration}};

bool is_number_start(char c) {
  return (c >= '0' && c <= '9') || c == '-' || c == '+' || c == '.';
}

// Whether this is a line of an OBJ file: "v 1 2 3", "o name", "g name".
bool is_obj_line(std::string_view line) {
  for (const std::string_view word : {"v ", "vn ", "vt "}) {
    const std::size_t number = line.find_first_not_of(" \t", word.size());
    if (line.starts_with(word) && number != std::string_view::npos) {
      return is_number_start(line[number]);
    }
  }
  return line.starts_with("o ") || line.starts_with("g ") || line.starts_with("mtllib ");
}

// The first line that is neither blank nor a comment with #.
std::string_view first_line(std::string_view text) {
  while (!text.empty()) {
    const std::size_t end = std::min(text.find_first_of("\r\n"), text.size());
    const std::string_view line = text.substr(0, end);
    if (!line.empty() && line[0] != '#') {
      return line;
    }
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return {};
}

// What a text is if it is not a scene, and what to do; completes the sentence "the file is". Empty
// if unknown. `text` must not start with white space.
std::string_view other_file(std::string_view text) {
  constexpr std::size_t longest = 32;
  const std::string start = lower_case(text.substr(0, longest));
  for (const FileSignature& signature : signatures) {
    if (start.starts_with(signature.start)) {
      return signature.what;
    }
  }
  return is_obj_line(first_line(text)) ? mesh : std::string_view();
}

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
    diagnostics.report(format_empty, {1, 1},
                       text.empty() ? "the file is empty" : "the file contains only white space");
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
  return fmt::format("a special space character, U+{:04X}; use an ordinary space",
                     static_cast<std::uint32_t>(blank));
}

}  // namespace scenefile
