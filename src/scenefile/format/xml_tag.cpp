#include "scenefile/format/xml_tag.h"

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

// Scans an attribute; returns one past its end.
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

}  // namespace scenefile
