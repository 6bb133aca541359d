#include "scenefile/format/ini.h"

#include "scenefile/base/text.h"
#include "scenefile/format/codes.h"
#include "scenefile/format/scene_text.h"

#include <fmt/format.h>

namespace scenefile {

namespace {

constexpr std::string_view ini_blanks = " \t\v\f";

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(ini_blanks);
  if (first == std::string_view::npos) {
    return {};
  }
  return text.substr(first, text.find_last_not_of(ini_blanks) + 1 - first);
}

int hex_digit(char c) {
  if (c >= '0' && c <= '9') {
    return c - '0';
  }
  const char lower = static_cast<char>(c | 0x20);
  return lower >= 'a' && lower <= 'f' ? lower - 'a' + 10 : -1;
}

// A line and the state of reading it.
struct Line {
  std::string_view text;
  std::uint32_t number = 0;

  Location at(std::size_t offset) const {
    return {number, static_cast<std::uint32_t>(1 + count_code_points(text.substr(0, offset)))};
  }
};

// Resolves the escape after text[offset], a backslash; moves the offset past it.
bool read_escape(std::string_view text, std::size_t& offset, std::string& value) {
  const char kind = offset + 1 < text.size() ? text[offset + 1] : '\n';
  offset += 2;
  if (std::string_view("\\\"'?").find(kind) != std::string_view::npos) {
    value += kind;
    return true;
  }
  unsigned c = 0;
  std::size_t digits = 0;
  for (; kind == 'x' && digits < 4 && offset < text.size() && hex_digit(text[offset]) >= 0;
       ++digits) {
    c = 16 * c + static_cast<unsigned>(hex_digit(text[offset++]));
  }
  const bool half_of_a_pair = c >= 0xd800 && c < 0xe000;
  if (digits == 0 || c == 0 || half_of_a_pair) {
    return false;
  }
  append_utf8(value, c);
  return true;
}

// Reads the value from an offset to the end of the line or a comment. Returns false after an error.
bool read_value(const Line& line, std::size_t offset, std::string& value,
                Diagnostics& diagnostics) {
  bool quoted_part = false;
  std::size_t quote = 0;
  std::size_t kept = 0;  // characters that trimming must not touch
  while (offset < line.text.size()) {
    const char c = line.text[offset];
    if (c == ';' && !quoted_part) {
      break;
    }
    const std::size_t place = offset;
    if (c == '\\') {
      if (!read_escape(line.text, offset, value)) {
        diagnostics.report("config.backslash"_code, line.at(place),
                           "a backslash starts an escape, and this is not one; write / between "
                           "folders, or \\\\ for a backslash");
        return false;
      }
      kept = value.size();
      continue;
    }
    ++offset;
    if (c == '"') {
      quoted_part = !quoted_part;
      quote = place;
      kept = value.size();
    } else {
      value += c;
      kept = quoted_part || ini_blanks.find(c) == std::string_view::npos ? value.size() : kept;
    }
  }
  value.resize(kept);
  if (quoted_part) {
    diagnostics.report("config.syntax"_code, line.at(quote), "the quote is not closed on its line");
  }
  return !quoted_part;
}

void read_section(const Line& line, std::size_t start, std::string& section,
                  Diagnostics& diagnostics) {
  const std::size_t end = line.text.find(']', start);
  section =
      trimmed(line.text.substr(start + 1, end == std::string_view::npos ? end : end - start - 1));
  if (end == std::string_view::npos) {
    diagnostics.report("config.syntax"_code, line.at(start),
                       fmt::format("the section {} needs a ] after its name", quoted(section)));
    return;
  }
  const std::string_view rest = trimmed(line.text.substr(end + 1));
  if (!rest.empty() && rest.front() != ';') {
    diagnostics.report(
        "config.syntax"_code, line.at(end + 1),
        fmt::format("found {} after the section, expected the end of the line", quoted(rest)));
  }
}

void read_entry(const Line& line, std::size_t start, const std::string& section,
                std::vector<IniEntry>& entries, Diagnostics& diagnostics) {
  const std::size_t equals = line.text.find('=', start);
  if (equals == std::string_view::npos ||
      trimmed(line.text.substr(start, equals - start)).empty()) {
    diagnostics.report("config.syntax"_code, line.at(start),
                       fmt::format("found {}, expected [section], key = value or ; comment",
                                   quoted(trimmed(line.text.substr(start)))));
    return;
  }
  const std::size_t first = line.text.find_first_not_of(ini_blanks, equals + 1);
  const std::size_t value_at = first == std::string_view::npos ? line.text.size() : first;
  IniEntry entry{section,
                 std::string(trimmed(line.text.substr(start, equals - start))),
                 {},
                 line.at(start),
                 line.at(value_at)};
  if (read_value(line, value_at, entry.value, diagnostics)) {
    entries.push_back(std::move(entry));
  }
}

}  // namespace

std::vector<IniEntry> read_ini(std::string_view text, Diagnostics& diagnostics) {
  text = without_byte_order_mark(text);
  std::vector<IniEntry> entries;
  std::string section;
  Line line;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find_first_of("\r\n"), text.size());
    line.text = text.substr(0, end);
    ++line.number;
    const bool two = text.substr(end).starts_with("\r\n");
    text.remove_prefix(std::min(text.size(), end + (two ? 2 : 1)));
    const std::size_t start = line.text.find_first_not_of(ini_blanks);
    if (start == std::string_view::npos || line.text[start] == ';' || line.text[start] == '#') {
      continue;
    }
    if (line.text[start] == '[') {
      read_section(line, start, section, diagnostics);
    } else {
      read_entry(line, start, section, entries, diagnostics);
    }
  }
  return entries;
}

}  // namespace scenefile
