#include "scenefile/format/xml_plain.h"

#include "scenefile/base/text.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace scenefile {

namespace {

// Character classes, as bits.
enum CharacterClass : std::uint8_t {
  blank = 1,
  name_start = 2,
  name_part = 4,
  value_part = 8,    // inside values, in either kind of quotes
  comment_part = 16  // inside comments, except the dash
};

// `>` ends every run of characters of one class, so a text that ends with it needs no bounds
// checks. Bytes from 128 on are in no class.
constexpr std::array<std::uint8_t, 256> make_classes() {
  std::array<std::uint8_t, 256> classes{};
  for (unsigned c = ' '; c < 128; ++c) {
    const bool letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || c == ':';
    const bool digit = (c >= '0' && c <= '9') || c == '-' || c == '.';
    const bool special = c == '<' || c == '>' || c == '&' || c == '"' || c == '\'';
    classes[c] = static_cast<std::uint8_t>((letter ? name_start | name_part : 0) |
                                           (digit ? name_part : 0) | (special ? 0 : value_part) |
                                           (c == '-' || c == '>' ? 0 : comment_part));
  }
  for (const unsigned c : {' ', '\t', '\n', '\r'}) {
    classes[c] |= blank | comment_part;
  }
  return classes;
}
constexpr std::array<std::uint8_t, 256> classes = make_classes();

bool is(char c, CharacterClass what) {
  return (classes[static_cast<unsigned char>(c)] & what) != 0;
}

const char* skip(const char* p, CharacterClass what) {
  while (is(*p, what)) {
    ++p;
  }
  return p;
}

std::string_view between(const char* first, const char* last) {
  return {first, static_cast<std::size_t>(last - first)};
}

// The most common spelling; others take the slow path.
bool is_xml_declaration(std::string_view text) {
  constexpr std::string_view version = "<?xml version=\"1.0\"";
  if (!text.starts_with(version)) {
    return false;
  }
  text.remove_prefix(version.size());
  constexpr std::string_view encoding = " encoding=\"";
  if (text.starts_with(encoding)) {
    text.remove_prefix(encoding.size());
    const std::string_view name = text.substr(0, text.find('"'));
    if (lower_case(name) != "utf-8" && lower_case(name) != "iso-8859-1") {
      return false;
    }
    text.remove_prefix(name.size());
    if (!text.starts_with('"')) {
      return false;
    }
    text.remove_prefix(1);
  }
  return text == "?>" || text == " ?>";
}

class PlainReader {
 public:
  PlainReader(std::string_view text, const Limits& limits, TextCursor& places, XmlHandler& handler)
      : limits_(limits),
        places_(places),
        handler_(handler),
        p_(text.data()),
        end_(text.data() + (text.find_last_not_of(" \t\r\n") + 1)) {}

  PlainEnd run();

 private:
  bool read_declaration();
  bool read_markup();
  bool read_comment();
  bool read_start();
  bool read_end();
  bool read_attribute();
  bool read_value(XmlAttribute& attribute);
  const char* skip_character(const char* p) const;

  const Limits& limits_;
  TextCursor& places_;
  XmlHandler& handler_;
  const char* p_;
  const char* end_;  // the character before it is >
  std::vector<std::string_view> open_;
  std::vector<XmlAttribute> attributes_;
  bool has_root_ = false;
  bool stopped_ = false;
};

PlainEnd PlainReader::run() {
  if (p_ == end_ || end_[-1] != '>' || !read_declaration()) {
    return PlainEnd::not_plain;
  }
  while (p_ != end_) {
    p_ = skip(p_, blank);
    if (*p_ != '<' || !read_markup()) {
      return stopped_ ? PlainEnd::stopped : PlainEnd::not_plain;
    }
  }
  return has_root_ && open_.empty() ? PlainEnd::complete : PlainEnd::not_plain;
}

bool PlainReader::read_declaration() {
  if (p_[0] != '<' || p_[1] != '?') {
    return true;
  }
  const char* const end = std::find(p_, end_, '>') + 1;
  const bool plain = is_xml_declaration(between(p_, end));
  p_ = end;
  return plain;
}

bool PlainReader::read_markup() {
  switch (p_[1]) {
    case '/':
      return read_end();
    case '!':
      return read_comment();
    default:
      return read_start();
  }
}

bool PlainReader::read_comment() {
  constexpr std::size_t longest = std::size_t{1} << 20;
  const char* p = p_ + 4;
  if (!between(p_, end_).starts_with("<!--")) {
    return false;
  }
  while (true) {
    p = skip(p, comment_part);
    if (*p == '-' && p[1] == '-') {
      break;
    }
    p = *p == '-' || *p == '>' ? p + 1 : skip_character(p);
    if (p == nullptr || p == end_) {
      return false;
    }
  }
  const bool plain = p[2] == '>' && between(p_, p).size() < longest;
  p_ = p + 3;
  return plain;
}

bool PlainReader::read_start() {
  const char* const at = p_++;
  const char* const name = p_;
  if (!is(*p_, name_start)) {
    return false;
  }
  p_ = skip(p_, name_part);
  const XmlTag head{between(name, p_), {}, {}};
  attributes_.clear();
  while (is(*p_, blank) && is(*(p_ = skip(p_, blank)), name_start)) {
    if (!read_attribute()) {
      return false;
    }
  }
  const bool is_empty = *p_ == '/';
  p_ += is_empty;
  if (*p_ != '>' || (open_.empty() && has_root_) || open_.size() == limits_.nesting ||
      head.name.size() > limits_.name_bytes) {
    return false;
  }
  ++p_;
  has_root_ = true;
  if (!handler_.start({head.name, attributes_, places_.advance_to(at)})) {
    stopped_ = true;
    return false;
  }
  if (is_empty) {
    handler_.end();
  } else {
    open_.push_back(head.name);
  }
  return true;
}

bool PlainReader::read_end() {
  p_ += 2;
  const char* const name = p_;
  p_ = skip(p_, name_part);
  if (open_.empty() || open_.back() != between(name, p_)) {
    return false;
  }
  p_ = skip(p_, blank);
  if (*p_ != '>') {
    return false;
  }
  ++p_;
  open_.pop_back();
  handler_.end();
  return true;
}

bool PlainReader::read_attribute() {
  constexpr std::size_t most = 16;
  XmlAttribute attribute;
  const char* const name = p_;
  p_ = skip(p_, name_part);
  attribute.name = between(name, p_);
  p_ = skip(p_, blank);
  if (*p_ != '=') {
    return false;
  }
  p_ = skip(p_ + 1, blank);
  if ((*p_ != '"' && *p_ != '\'') || !read_value(attribute)) {
    return false;
  }
  const auto same = [&](const XmlAttribute& other) { return other.name == attribute.name; };
  if (std::any_of(attributes_.begin(), attributes_.end(), same) ||
      attributes_.size() >= std::min<std::size_t>(most, limits_.attributes) ||
      attribute.name.size() > limits_.name_bytes || attribute.value.size() > limits_.value_bytes) {
    return false;
  }
  attributes_.push_back(attribute);
  return true;
}

bool PlainReader::read_value(XmlAttribute& attribute) {
  const char quote = *p_++;
  const char* const value = p_;
  while (*(p_ = skip(p_, value_part)) != quote) {
    p_ = *p_ == '>' || *p_ == '"' || *p_ == '\'' ? p_ + 1 : skip_character(p_);
    if (p_ == nullptr || p_ == end_) {
      return false;
    }
  }
  attribute.value = between(value, p_++);
  return true;
}

// One past a character beyond ASCII; null if XML does not allow the bytes.
const char* PlainReader::skip_character(const char* p) const {
  if (static_cast<unsigned char>(*p) < 128) {
    return nullptr;
  }
  const CodePoint c = first_code_point(between(p, end_));
  return c.bytes == 0 || c.value == 0xFFFE || c.value == 0xFFFF ? nullptr : p + c.bytes;
}

}  // namespace

PlainEnd read_plain_events(std::string_view text, const Limits& limits, TextCursor& places,
                           XmlHandler& handler) {
  return PlainReader(text, limits, places, handler).run();
}

}  // namespace scenefile
