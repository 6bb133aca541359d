#include "scenefile/format/scene_text.h"

#include "scenefile/base/ascii.h"
#include "scenefile/base/text.h"
#include "scenefile/format/codes.h"
#include "scenefile/format/recognize.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

namespace scenefile {

namespace {

using namespace std::string_view_literals;

// The characters of windows-1252 where ISO-8859-1 has control characters; 0 for unused codes.
constexpr std::array<char16_t, 32> windows_1252 = {
    0x20AC, 0,      0x201A, 0x0192, 0x201E, 0x2026, 0x2020, 0x2021, 0x02C6, 0x2030, 0x0160,
    0x2039, 0x0152, 0,      0x017D, 0,      0,      0x2018, 0x2019, 0x201C, 0x201D, 0x2022,
    0x2013, 0x2014, 0x02DC, 0x2122, 0x0161, 0x203A, 0x0153, 0,      0x017E, 0x0178};

void report_encoding(Diagnostics& diagnostics, std::string message) {
  diagnostics.report("format.encoding"_code, {1, 1}, std::move(message));
}

bool is_low_surrogate(char32_t c) {
  return c >= 0xDC00 && c < 0xE000;
}

std::optional<std::string_view> decode_utf16(std::string_view bytes, bool little_endian,
                                             std::string& storage, Diagnostics& diagnostics) {
  if (bytes.size() % 2 != 0) {
    report_encoding(diagnostics,
                    "the file is UTF-16 but has an odd number of bytes; it is truncated");
    return std::nullopt;
  }
  const auto unit = [&](std::size_t i) {
    const auto a = static_cast<unsigned char>(bytes[i]);
    const auto b = static_cast<unsigned char>(bytes[i + 1]);
    return static_cast<char32_t>(little_endian ? a | (b << 8) : (a << 8) | b);
  };
  storage.reserve(bytes.size());
  for (std::size_t i = 0; i < bytes.size(); i += 2) {
    char32_t c = unit(i);
    if (c >= 0xD800 && c < 0xE000) {
      const char32_t low = i + 2 < bytes.size() ? unit(i + 2) : 0;
      if (c >= 0xDC00 || !is_low_surrogate(low)) {
        report_encoding(
            diagnostics,
            fmt::format("the file is not valid UTF-16 at byte {}: a lone surrogate", i));
        return std::nullopt;
      }
      c = 0x10000 + ((c - 0xD800) << 10) + (low - 0xDC00);
      i += 2;
    }
    append_utf8(storage, c);
  }
  return storage;
}

std::string_view decode_single_byte(std::string_view bytes, bool windows, std::string& storage) {
  storage.reserve(bytes.size() + bytes.size() / 8);
  for (const char byte : bytes) {
    const auto c = static_cast<unsigned char>(byte);
    const bool special = windows && c >= 0x80 && c < 0xA0 && windows_1252[c - 0x80] != 0;
    append_utf8(storage, special ? char32_t{windows_1252[c - 0x80]} : char32_t{c});
  }
  return storage;
}

// The encoding in the XML declaration, in lower case; empty without a declaration.
std::string declared_encoding(std::string_view bytes) {
  constexpr std::size_t longest_declaration = 400;
  if (!bytes.starts_with("<?xml")) {
    return {};
  }
  const std::string_view head = bytes.substr(0, longest_declaration);
  const std::string_view declaration = head.substr(0, head.find("?>"));
  const std::size_t word = declaration.find("encoding");
  const std::size_t open = declaration.find_first_of("\"'", word);
  if (word == std::string_view::npos || open == std::string_view::npos) {
    return {};
  }
  const std::size_t close = declaration.find(declaration[open], open + 1);
  return close == std::string_view::npos
             ? std::string()
             : lower_case(declaration.substr(open + 1, close - open - 1));
}

bool is_ascii(std::string_view bytes) {
  return std::all_of(bytes.begin(), bytes.end(),
                     [](char c) { return static_cast<unsigned char>(c) < 0x80; });
}

std::optional<std::string_view> decode_declared(std::string_view bytes, const std::string& name,
                                                std::string& storage, Diagnostics& diagnostics) {
  if (name.empty() || name == "utf-8" || name == "utf8" || name == "us-ascii" || name == "ascii") {
    return bytes;
  }
  if (name == "iso-8859-1" || name == "latin1" || name == "iso8859-1") {
    return decode_single_byte(bytes, false, storage);
  }
  if (name == "windows-1252" || name == "cp1252") {
    return decode_single_byte(bytes, true, storage);
  }
  if (name.starts_with("utf-16") || name.starts_with("utf16")) {
    report_encoding(diagnostics,
                    "the file declares the encoding UTF-16 but is not UTF-16; correct "
                    "the declaration or save the file again");
    return std::nullopt;
  }
  if (is_ascii(bytes)) {
    diagnostics.report("format.encoding-assumed"_code, {1, 1},
                       fmt::format("the encoding {} is not known; the file is plain ASCII, so it "
                                   "was read as that",
                                   quoted(name)));
    return bytes;
  }
  report_encoding(
      diagnostics,
      has_scene_parts(bytes)
          ? fmt::format("the encoding {} is not known; save the file as UTF-8", quoted(name))
          : "the encoding in the XML declaration is not known");
  return std::nullopt;
}

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
    "a configuration of the course's ray or path tracer, not a scene; the scene is the file that "
    "it names under [IO]";
constexpr std::string_view picture = "a picture, not a scene";
constexpr std::string_view povray =
    "a POV-Ray scene, which scenefile writes but does not read; convert the scene that it was made "
    "from";

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

// The text after white space and C comments.
std::string_view after_comments(std::string_view text) {
  for (std::size_t at = 0; (at = text.find_first_not_of(blanks, at)) != std::string_view::npos;) {
    const std::string_view two = text.substr(at, 2);
    if (two != "//" && two != "/*") {
      return text.substr(at);
    }
    const std::size_t end = two == "//" ? text.find_first_of("\r\n", at) : text.find("*/", at + 2);
    at = end == std::string_view::npos ? end : end + (two == "//" ? 1 : 2);
  }
  return {};
}

// NUL if nothing follows them.
char first_character(std::string_view text) {
  const std::string_view content = after_comments(text);
  return content.empty() ? '\0' : content[0];
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
  if (is_obj_line(first_line(text))) {
    return mesh;
  }
  // GLSL has versions without a point.
  const std::string code = lower_case(after_comments(text).substr(0, longest));
  const bool directive = code.starts_with("#version 3.") || code.starts_with("global_settings");
  return directive ? povray : std::string_view();
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

// Reports that a file is not a scene, in one line that shows nothing of its contents. `found`: what
// decoding it reported.
void report_other(std::string_view text, const Diagnostics& found, Diagnostics& diagnostics) {
  const std::size_t first = text.find_first_not_of(blanks);
  const auto report = [&](const Code& code, std::string message) {
    diagnostics.report(code, {}, std::move(message));
  };
  if (first == std::string_view::npos) {
    return report("format.empty"_code,
                  text.empty() ? "the file is empty" : "the file contains only white space");
  }
  const std::string_view content = text.substr(first);
  if (const std::string_view other = other_file(content); !other.empty()) {
    return report("format.unknown"_code, fmt::format("the file is {}", other));
  }
  if (found.has_errors()) {
    return report("format.encoding"_code, found.list().back().message);
  }
  const char start = first_character(content);
  if (start == '<') {
    return report("xml.root-element"_code,
                  "the file is XML but not a scene: a scene is one element <scenefile>");
  }
  if (start == '{' || start == '[') {
    return report(start == '{' ? "json.missing-key"_code : "json.wrong-type"_code,
                  "the file is JSON but not a scene: a scene is one object with the keys "
                  "\"globalData\", \"cameraData\" and \"groups\"");
  }
  report("format.unknown"_code,
         "not a scene file: a scene is XML with the element <scenefile>, or a JSON object");
}

// Decides by the first character that is not part of white space or a C comment. Otherwise reports
// an error that says what the file may be.
std::optional<SceneFormat> syntax_of(std::string_view text, Diagnostics& diagnostics) {
  const std::size_t first = text.find_first_not_of(blanks);
  const std::string_view content = text.substr(first);
  if (const std::string_view other = other_file(content); !other.empty()) {
    diagnostics.report("format.unknown"_code, after_blanks(text, first),
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
    diagnostics.report("format.unknown"_code, after_blanks(text, first),
                       "the file starts with a quotation mark; a JSON scene is an object, so { is "
                       "missing in front of it");
    return std::nullopt;
  }
  diagnostics.report("format.unknown"_code, after_blanks(text, first),
                     fmt::format("the file starts with {}; remove what is in front of the scene, "
                                 "which starts with < (XML) or {{ (JSON)",
                                 quoted(content.substr(0, 40), 10)));
  return std::nullopt;
}

}  // namespace

void append_utf8(std::string& out, char32_t c) {
  const auto tail = [&](int shift) { out += static_cast<char>(0x80 | ((c >> shift) & 0x3F)); };
  if (c < 0x80) {
    out += static_cast<char>(c);
  } else if (c < 0x800) {
    out += static_cast<char>(0xC0 | (c >> 6));
    tail(0);
  } else if (c < 0x10000) {
    out += static_cast<char>(0xE0 | (c >> 12));
    tail(6);
    tail(0);
  } else {
    out += static_cast<char>(0xF0 | (c >> 18));
    tail(12);
    tail(6);
    tail(0);
  }
}

std::optional<std::string_view> decode_text(std::string_view bytes, std::string& storage,
                                            Diagnostics& diagnostics) {
  if (bytes.starts_with("\xFF\xFE\0\0"sv) || bytes.starts_with("\0\0\xFE\xFF"sv) ||
      bytes.starts_with("<\0\0\0"sv) || bytes.starts_with("\0\0\0<"sv)) {
    report_encoding(diagnostics, "the file is UTF-32; save it as UTF-8");
    return std::nullopt;
  }
  if (const std::string_view text = without_byte_order_mark(bytes); text.size() < bytes.size()) {
    return text;
  }
  if (bytes.starts_with("\xFF\xFE"sv) || bytes.starts_with("\xFE\xFF"sv)) {
    return decode_utf16(bytes.substr(2), bytes[0] == '\xFF', storage, diagnostics);
  }
  if (bytes.size() >= 2 && (bytes[0] == '\0') != (bytes[1] == '\0')) {
    return decode_utf16(bytes, bytes[1] == '\0', storage, diagnostics);
  }
  return decode_declared(bytes, declared_encoding(bytes), storage, diagnostics);
}

std::optional<SceneText> open_text(std::string_view bytes, std::string& storage,
                                   Diagnostics& diagnostics) {
  Diagnostics found;
  const std::optional<std::string_view> text = decode_text(bytes, storage, found);
  if (!has_scene_parts(text.value_or(bytes))) {
    report_other(text.value_or(bytes), found, diagnostics);
    return std::nullopt;
  }
  for (const Diagnostic& d : found.list()) {
    diagnostics.add(d);
  }
  const std::optional<SceneFormat> syntax = text ? syntax_of(*text, diagnostics) : std::nullopt;
  return syntax ? std::optional(SceneText{*text, *syntax}) : std::nullopt;
}

std::string odd_blank_text(char32_t blank) {
  return fmt::format("a special space character, U+{:04X}; use an ordinary space",
                     static_cast<std::uint32_t>(blank));
}

}  // namespace scenefile
