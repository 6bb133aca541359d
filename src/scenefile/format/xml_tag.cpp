#include "scenefile/format/xml_tag.h"

#include <cstring>

namespace scenefile {

namespace {

bool is_blank(char c) {
  return c == ' ' || c == '\n' || c == '\t' || c == '\r';
}

bool ends_name(char c) {
  return is_blank(c) || c == '=' || c == '>' || c == '/';
}

const char* skip_blanks(const char* p, const char* end) {
  while (p != end && is_blank(*p)) {
    ++p;
  }
  return p;
}

const char* skip_name(const char* p, const char* end) {
  while (p != end && !ends_name(*p)) {
    ++p;
  }
  return p;
}

std::string_view between(const char* first, const char* last) {
  return {first, static_cast<std::size_t>(last - first)};
}

bool has_lone_cr(std::string_view text) {
  std::size_t at = text.find('\r');
  while (at != std::string_view::npos && at + 1 < text.size()) {
    if (text[at + 1] != '\n') {
      return true;
    }
    at = text.find('\r', at + 1);
  }
  return false;
}

bool starts_character(char c) {
  return (static_cast<unsigned char>(c) & 0xC0) != 0x80;
}

// From the first character of an attribute to the one behind it.
const char* scan_attribute(const char* p, const char* end, XmlAttribute& out,
                           bool& needs_decoding) {
  const char* const name = p;
  p = skip_name(p, end);
  out.name = between(name, p);
  while (p != end && *p != '"' && *p != '\'') {
    ++p;
  }
  if (p == end) {
    return p;
  }
  const char quote = *p++;
  const char* const value = p;
  for (; p != end && *p != quote; ++p) {
    needs_decoding |= *p == '&' || static_cast<unsigned char>(*p) < ' ';
  }
  out.value = between(value, p);
  return p == end ? p : p + 1;
}

TagFault fault_of(const XmlAttribute& attribute, std::size_t before, const Limits& limits) {
  if (before >= limits.attributes) {
    return TagFault::too_many_attributes;
  }
  if (attribute.name.size() > limits.name_bytes) {
    return TagFault::name_too_long;
  }
  return attribute.value.size() > limits.value_bytes ? TagFault::value_too_long : TagFault::none;
}

}  // namespace

const XmlAttribute* XmlTag::find(std::string_view attribute) const {
  for (const XmlAttribute& a : attributes) {
    if (a.name == attribute) {
      return &a;
    }
  }
  return nullptr;
}

TagScan scan_tag(std::string_view text, const Limits& limits, std::vector<XmlAttribute>& out) {
  out.clear();
  const char* const end = text.data() + text.size();
  const char* p = skip_name(text.data() + 1, end);
  TagScan scan;
  scan.name = between(text.data() + 1, p);
  scan.fault = scan.name.size() > limits.name_bytes ? TagFault::name_too_long : TagFault::none;
  p = skip_blanks(p, end);
  while (scan.fault == TagFault::none && p != end && *p != '>' && *p != '/') {
    XmlAttribute attribute;
    p = scan_attribute(p, end, attribute, scan.needs_decoding);
    scan.fault = fault_of(attribute, out.size(), limits);
    scan.culprit = attribute;
    out.push_back(attribute);
    p = skip_blanks(p, end);
  }
  return scan;
}

TextCursor::TextCursor(std::string_view text)
    : begin_(text.data()),
      end_(text.data() + text.size()),
      lone_cr_(has_lone_cr(text)),
      tag_{text.data()},
      inside_{text.data()} {}

Location TextCursor::advance_to(const char* at) {
  move(tag_, at);
  inside_ = tag_;
  return tag_.location;
}

Location TextCursor::inside_tag(const char* at) {
  if (at < inside_.at) {
    inside_ = tag_;
  }
  move(inside_, at);
  return inside_.location;
}

double TextCursor::progress() const {
  return static_cast<double>(tag_.at - begin_) / static_cast<double>(end_ - begin_);
}

void TextCursor::move(Point& point, const char* to) const {
  const char* p = point.at;
  Location location = point.location;
  if (lone_cr_) {
    for (; p != to; ++p) {
      const bool ends_line = *p == '\n' || (*p == '\r' && p + 1 != end_ && p[1] != '\n');
      location.line += ends_line;
      location.column = ends_line ? 1 : location.column + starts_character(*p);
    }
    point = {to, location};
    return;
  }
  while (const void* newline = std::memchr(p, '\n', static_cast<std::size_t>(to - p))) {
    p = static_cast<const char*>(newline) + 1;
    ++location.line;
    location.column = 1;
  }
  for (; p != to; ++p) {
    location.column += starts_character(*p);
  }
  point = {to, location};
}

}  // namespace scenefile
