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
  TagScan scan{between(text.data() + 1, p), TagFault::none, {}};
  if (scan.name.size() > limits.name_bytes) {
    scan.fault = TagFault::name_too_long;
    return scan;
  }
  for (p = skip_blanks(p, end); p != end && *p != '>' && *p != '/'; p = skip_blanks(p, end)) {
    const char* const name = p;
    p = skip_name(p, end);
    XmlAttribute attribute{between(name, p), {}};
    while (p != end && *p != '"' && *p != '\'') {
      ++p;
    }
    if (p != end) {
      const char quote = *p++;
      const char* const value = p;
      while (p != end && *p != quote) {
        ++p;
      }
      attribute.value = between(value, p);
      p += p != end;
    }
    if (out.size() == limits.attributes) {
      scan.fault = TagFault::too_many_attributes;
      return scan;
    }
    if (attribute.name.size() > limits.name_bytes || attribute.value.size() > limits.value_bytes) {
      const bool name_long = attribute.name.size() > limits.name_bytes;
      scan.fault = name_long ? TagFault::name_too_long : TagFault::value_too_long;
      scan.culprit = attribute;
      return scan;
    }
    out.push_back(attribute);
  }
  return scan;
}

PlaceFinder::PlaceFinder(std::string_view text)
    : end_(text.data() + text.size()),
      lone_cr_(has_lone_cr(text)),
      tag_{text.data()},
      inside_{text.data()} {}

Location PlaceFinder::advance_to(const char* at) {
  move(tag_, at);
  inside_ = tag_;
  return tag_.location;
}

Location PlaceFinder::inside_tag(const char* at) {
  if (at < inside_.at) {
    inside_ = tag_;
  }
  move(inside_, at);
  return inside_.location;
}

void PlaceFinder::move(Cursor& cursor, const char* to) const {
  const char* p = cursor.at;
  Location location = cursor.location;
  if (lone_cr_) {
    for (; p != to; ++p) {
      const bool ends_line = *p == '\n' || (*p == '\r' && p + 1 != end_ && p[1] != '\n');
      location.line += ends_line;
      location.column = ends_line ? 1 : location.column + starts_character(*p);
    }
    cursor = {to, location};
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
  cursor = {to, location};
}

}  // namespace scenefile
