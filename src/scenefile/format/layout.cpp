#include "scenefile/format/layout.h"

#include "scenefile/base/text.h"
#include "scenefile/format/dialects.h"
#include "scenefile/format/syntax.h"
#include "scenefile/format/text_encoding.h"
#include "scenefile/format/xml_tokens.h"

#include <algorithm>

namespace scenefile {

namespace {

std::string_view byte_order_mark(std::string_view bytes) {
  for (const std::string_view mark : {"\xEF\xBB\xBF", "\xFF\xFE", "\xFE\xFF"}) {
    if (bytes.starts_with(mark)) {
      return bytes.substr(0, mark.size());
    }
  }
  return {};
}

// Neither syntax allows zero bytes, and every second byte of ASCII in UTF-16 is zero.
bool is_utf16(std::string_view bytes) {
  return bytes.find('\0') != std::string_view::npos;
}

void append_unit(std::string& out, char32_t unit, bool little_endian) {
  const char high = static_cast<char>(unit >> 8);
  const char low = static_cast<char>(unit & 0xFF);
  out += little_endian ? low : high;
  out += little_endian ? high : low;
}

std::string utf16(std::string_view text, bool little_endian) {
  std::string out;
  out.reserve(2 * text.size());
  while (!text.empty()) {
    const CodePoint c = first_code_point(text);
    if (c.value < 0x10000) {
      append_unit(out, c.value, little_endian);
    } else {
      append_unit(out, 0xD800 + ((c.value - 0x10000) >> 10), little_endian);
      append_unit(out, 0xDC00 + ((c.value - 0x10000) & 0x3FF), little_endian);
    }
    text.remove_prefix(c.bytes);
  }
  return out;
}

}  // namespace

std::optional<std::string> lay_out(std::string_view bytes, const Limits& limits,
                                   Diagnostics& diagnostics) {
  std::string storage;
  const std::optional<std::string_view> decoded = decode_text(bytes, storage, diagnostics);
  if (!decoded) {
    return std::nullopt;
  }
  const std::optional<SceneFormat> syntax = syntax_of(*decoded, diagnostics);
  if (!syntax) {
    return std::nullopt;
  }
  const std::string_view mark = byte_order_mark(bytes);
  const bool wide = is_utf16(bytes);
  std::optional<std::string> text;
  if (*syntax == SceneFormat::json) {
    text = lay_out_json(*decoded, limits, diagnostics);
  } else if (check_xml_layout(*decoded, limits, diagnostics)) {
    // Formats the original bytes if possible, which works in every superset of ASCII.
    text = lay_out_xml(wide ? *decoded : bytes.substr(mark.size()));
  }
  if (text) {
    const bool little_endian = wide && bytes[mark.size() + 1] == '\0';
    if (wide) {
      *text = utf16(*text, little_endian);
    }
    text->insert(0, mark);
  }
  return text;
}

std::size_t count_comments(std::string_view bytes) {
  std::string storage;
  Diagnostics ignored;
  const std::optional<std::string_view> decoded = decode_text(bytes, storage, ignored);
  if (!decoded || syntax_of(*decoded, ignored) != SceneFormat::xml) {
    return 0;
  }
  const std::vector<XmlToken> tokens = xml_tokens(*decoded);
  return static_cast<std::size_t>(
      std::count_if(tokens.begin(), tokens.end(),
                    [](const XmlToken& t) { return t.kind == XmlTokenKind::comment; }));
}

}  // namespace scenefile
