#include "scenefile/format/other_files.h"

#include "scenefile/base/text.h"

#include <algorithm>

namespace scenefile {

namespace {

using namespace std::string_view_literals;

struct Signature {
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

constexpr Signature signatures[] = {{"version https://git-lfs"sv,
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

}  // namespace

std::string_view other_file(std::string_view text) {
  constexpr std::size_t longest = 32;
  const std::string start = lower_case(text.substr(0, longest));
  for (const Signature& signature : signatures) {
    if (start.starts_with(signature.start)) {
      return signature.what;
    }
  }
  return is_obj_line(first_line(text)) ? mesh : std::string_view();
}

}  // namespace scenefile
