#include "scenefile/format/write_text.h"

#include "scenefile/base/number.h"
#include "scenefile/base/text.h"
#include "scenefile/format/codes.h"
#include "scenefile/format/scene_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <iterator>
#include <limits>
#include <optional>
#include <utility>

namespace scenefile {

namespace {

constexpr std::string_view replacement = "\xef\xbf\xbd";

// Appends the characters of `text` one by one; `append` receives each with its bytes and returns
// whether it could be represented.
template <typename Append>
bool append_all(std::string& out, std::string_view text, Append append) {
  bool all_said = true;
  while (!text.empty()) {
    const CodePoint c = first_code_point(text);
    if (c.bytes == 0 || !append(c.value, text.substr(0, c.bytes))) {
      out += replacement;
      all_said = false;
    }
    text.remove_prefix(c.bytes == 0 ? 1 : c.bytes);
  }
  return all_said;
}

// The character of a reference such as &lt; or &#10;, of which this is what is between & and ;.
std::optional<char32_t> referenced(std::string_view name) {
  constexpr std::pair<std::string_view, char32_t> predefined[] = {
      {"lt", '<'}, {"gt", '>'}, {"amp", '&'}, {"quot", '"'}, {"apos", '\''}};
  const auto* const found = std::find_if(std::begin(predefined), std::end(predefined),
                                         [&](const auto& entry) { return entry.first == name; });
  if (found != std::end(predefined)) {
    return found->second;
  }
  const bool hexadecimal = name.starts_with("#x");
  const std::string_view digits =
      name.substr(std::min<std::size_t>(hexadecimal ? 2 : 1, name.size()));
  std::uint32_t value = 0;
  const auto [end, error] =
      std::from_chars(digits.data(), digits.data() + digits.size(), value, hexadecimal ? 16 : 10);
  const bool whole =
      name.starts_with('#') && error == std::errc() && end == digits.data() + digits.size();
  return whole && value <= 0x10FFFF ? std::optional<char32_t>(value) : std::nullopt;
}

}  // namespace

bool append_xml(std::string& out, std::string_view text) {
  return append_all(out, text, [&](char32_t c, std::string_view bytes) {
    switch (c) {
      case '&':
        out += "&amp;";
        return true;
      case '<':
        out += "&lt;";
        return true;
      case '>':
        out += "&gt;";
        return true;
      case '"':
        out += "&quot;";
        return true;
      case '\t':
      case '\n':
      case '\r':
        fmt::format_to(std::back_inserter(out), "&#{};", static_cast<std::uint32_t>(c));
        return true;
      default:
        break;
    }
    if (c < 0x20 || c == 0xfffe || c == 0xffff) {
      return false;
    }
    out += bytes;
    return true;
  });
}

std::string unescaped_xml(std::string_view value) {
  std::string text;
  while (!value.empty()) {
    const std::size_t end = value[0] == '&' ? value.find(';') : std::string_view::npos;
    const std::optional<char32_t> character =
        end == std::string_view::npos ? std::nullopt : referenced(value.substr(1, end - 1));
    if (character) {
      append_utf8(text, *character);
    } else {
      text += value[0];
    }
    value.remove_prefix(character ? end + 1 : 1);
  }
  return text;
}

bool append_json(std::string& out, std::string_view text) {
  out += '"';
  const bool all_said = append_all(out, text, [&](char32_t c, std::string_view bytes) {
    if (c == '"' || c == '\\') {
      out += '\\';
      out += bytes;
    } else if (c == '\n') {
      out += "\\n";
    } else if (c == '\t') {
      out += "\\t";
    } else if (c < 0x20 || c == 0x7f) {
      fmt::format_to(std::back_inserter(out), "\\u{:04x}", static_cast<std::uint32_t>(c));
    } else {
      out += bytes;
    }
    return true;
  });
  out += '"';
  return all_said;
}

void LineStarts::start(std::string& out, std::size_t depth) {
  if (listing_ == nullptr) {
    out.append(2 * depth, ' ');
    return;
  }
  listing_->push_back(next_);
  listing_->back().begin = out.size();
  listing_->back().depth = static_cast<std::uint32_t>(depth);
}

std::string LineStarts::number(float value) const {
  return number_text(listing() ? value + 0.0f : value);
}

Limits listing_limits() {
  Limits limits;
  limits.nesting = std::numeric_limits<std::uint32_t>::max();
  return limits;
}

void report_nesting(const Limits& limits, Diagnostics& diagnostics) {
  diagnostics.report(
      "write.nesting-limit"_code, {},
      fmt::format("the file would be nested deeper than the limit of {} levels", limits.nesting));
}

}  // namespace scenefile
