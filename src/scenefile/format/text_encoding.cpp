#include "scenefile/format/text_encoding.h"

#include "scenefile/base/text.h"
#include "scenefile/format/codes.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>

namespace scenefile {

namespace {

// The characters of windows-1252 where ISO-8859-1 has control characters; 0 for unused codes.
constexpr std::array<char16_t, 32> windows_1252 = {
    0x20AC, 0,      0x201A, 0x0192, 0x201E, 0x2026, 0x2020, 0x2021, 0x02C6, 0x2030, 0x0160,
    0x2039, 0x0152, 0,      0x017D, 0,      0,      0x2018, 0x2019, 0x201C, 0x201D, 0x2022,
    0x2013, 0x2014, 0x02DC, 0x2122, 0x0161, 0x203A, 0x0153, 0,      0x017E, 0x0178};

void report_encoding(Diagnostics& diagnostics, std::string message) {
  diagnostics.report(format_encoding, {1, 1}, std::move(message));
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
    diagnostics.report(format_encoding_assumed, {1, 1},
                       fmt::format("the encoding {} is not known; the file is plain ASCII, so it "
                                   "was read as that",
                                   quoted(name)));
    return bytes;
  }
  report_encoding(diagnostics, fmt::format("the encoding {} is not known; save the file as UTF-8",
                                           quoted(name)));
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
  using namespace std::string_view_literals;
  if (bytes.starts_with("\xFF\xFE\0\0"sv) || bytes.starts_with("\0\0\xFE\xFF"sv) ||
      bytes.starts_with("<\0\0\0"sv) || bytes.starts_with("\0\0\0<"sv)) {
    report_encoding(diagnostics, "the file is UTF-32; save it as UTF-8");
    return std::nullopt;
  }
  if (bytes.starts_with("\xEF\xBB\xBF"sv)) {
    return bytes.substr(3);
  }
  if (bytes.starts_with("\xFF\xFE"sv) || bytes.starts_with("\xFE\xFF"sv)) {
    return decode_utf16(bytes.substr(2), bytes[0] == '\xFF', storage, diagnostics);
  }
  if (bytes.size() >= 2 && (bytes[0] == '\0') != (bytes[1] == '\0')) {
    return decode_utf16(bytes, bytes[1] == '\0', storage, diagnostics);
  }
  return decode_declared(bytes, declared_encoding(bytes), storage, diagnostics);
}

}  // namespace scenefile
