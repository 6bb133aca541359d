#include "scenefile/format/xml_scanner.h"

#include "scenefile/base/ascii.h"
#include "scenefile/base/text.h"

#include <algorithm>
#include <array>

namespace scenefile {

namespace {

constexpr std::size_t max_plain_attributes = 16;

/// Classes of characters in plain XML, as bits.
enum CharacterClass : std::uint8_t {
  blank = 1,
  name_start = 2,
  name_part = 4,
  name_end = 8,       ///< what may follow a name
  value_part = 16,    ///< of a value in either quotes
  comment_part = 32,  ///< but for the dash
  bare_part = 64,     ///< of a value without quotation marks, but for the slash
};

/// Bytes from 128 on are in no class.
constexpr std::array<std::uint8_t, 256> make_character_classes() {
  std::array<std::uint8_t, 256> classes{};
  for (unsigned c = ' '; c < 128; ++c) {
    const bool letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || c == ':';
    const bool digit = (c >= '0' && c <= '9') || c == '-' || c == '.';
    const bool special = c == '<' || c == '>' || c == '&' || c == '"' || c == '\'';
    const bool separator = c == ' ' || c == '=' || c == ',' || c == ';' || c == '/' || c == '\\';
    classes[c] =
        static_cast<std::uint8_t>((letter ? name_start | name_part : 0) | (digit ? name_part : 0) |
                                  (special ? 0 : value_part) | (c == '-' ? 0 : comment_part) |
                                  (special || separator ? 0 : bare_part));
  }
  for (const unsigned char c : {' ', '\t', '\n', '\r'}) {
    classes[c] |= blank | name_end | comment_part;
  }
  for (const unsigned char c : {'=', '>', '/', '"', '\''}) {
    classes[c] |= name_end;
  }
  return classes;
}
constexpr std::array<std::uint8_t, 256> character_classes = make_character_classes();

bool is(char c, CharacterClass what) {
  return (character_classes[static_cast<unsigned char>(c)] & what) != 0;
}

const char* skip(const char* p, const char* end, CharacterClass what) {
  while (p != end && is(*p, what)) {
    ++p;
  }
  return p;
}

std::string_view between(const char* first, const char* last) {
  return {first, static_cast<std::size_t>(last - first)};
}

// Whether XML allows the character beyond ASCII that `text` begins with; its size in bytes, or 0.
std::size_t plain_character(std::string_view text) {
  if (static_cast<unsigned char>(text.front()) < 128) {
    return 0;
  }
  const CodePoint c = first_code_point(text);
  return c.value == 0xFFFE || c.value == 0xFFFF ? 0 : c.bytes;
}

// Reads the tag at `begin`.
class TagScanner {
 public:
  TagScanner(const char* begin, const char* end, XmlToken& token)
      : begin_(begin), end_(end), token_(token) {}

  void run() {
    scan();
    if (unquoted_ && !plain_) {
      // Only tags that are plain otherwise are repaired. Where this one ends must be decided as
      // Expat does, which judges it.
      repairs_ = false;
      plain_ = true;
      unquoted_ = false;
      needs_decoding_ = false;
      scan();
    }
  }

 private:
  // The hot loop of reading: keeps its place in registers, and leaves it to functions that are not
  // inlined only if something is not plain.
  void scan() {
    token_.attributes.clear();
    const char* p = begin_ + 1;
    const bool is_end = p != end_ && *p == '/';
    p = read_name(p + is_end, token_.name);
    while (true) {
      const char* const before = p;
      p = skip(p, end_, blank);
      if (p == end_ || *p == '>' || *p == '/') {
        break;
      }
      if (p == before && repairs_ && end_unclosed(p)) {
        continue;
      }
      if (is(*p, name_end)) {
        break;
      }
      if (p == before || is_end) {
        plain_ = false;
      }
      // Read in place, because copying what was just written part by part stalls the processor.
      bool well_formed = true;
      p = read_attribute(p, token_.attributes.emplace_back(), well_formed);
      if (!well_formed) {
        token_.attributes.pop_back();
        break;
      }
      check_last_attribute();
    }
    p = finish(p, is_end);
    token_.written = between(begin_, p);
    token_.plain = plain_ && !unquoted_;
    token_.unquoted = plain_ && unquoted_;
    token_.needs_decoding = needs_decoding_;
  }

  const char* read_name(const char* p, std::string_view& name) {
    const char* const first = p;
    if (p == end_ || !is(*p, name_start)) {
      plain_ = false;
    }
    p = skip(p, end_, name_part);
    while (p != end_ && !is(*p, name_end)) {
      plain_ = false;
      ++p;
    }
    name = between(first, p);
    return p;
  }

  // Keeps the available parts of a truncated attribute.
  const char* read_attribute(const char* p, XmlAttribute& attribute, bool& well_formed) {
    p = skip(read_name(p, attribute.name), end_, blank);
    if (p == end_) {
      return p;
    }
    if (*p == '=') {
      p = skip(p + 1, end_, blank);
      if (p == end_) {
        return p;
      }
      if (*p == '"' || *p == '\'') {
        return read_value(p, attribute.value);
      }
      if (const char* const after = repairs_ ? read_unquoted(p, attribute.value) : nullptr) {
        unquoted_ = true;
        return after;
      }
    }
    plain_ = false;
    well_formed = false;
    return p;
  }

  const char* read_value(const char* p, std::string_view& value) {
    const char quote = *p++;
    const char* const first = p;
    while ((p = skip(p, end_, value_part)) != end_ && *p != quote) {
      if (*p == '>' && repairs_ && is_end_of_unclosed(first, p)) {
        p -= p[-1] == '/' ? 1 : 0;
        value = between(first, p);
        unquoted_ = true;
        return p;
      }
      p = pass_special(p);
    }
    value = between(first, p);
    return p == end_ ? p : p + 1;
  }

  // Whether a value without its closing quotation mark ends before the `>` at `p`, as in `v="1/>`:
  // it is one word, and another tag follows.
  bool is_end_of_unclosed(const char* first, const char* p) const {
    const char* const last = p[-1] == '/' ? p - 1 : p;
    const char* const next = skip(p + 1, end_, blank);
    return first < last && skip_unquoted(first, bare_part) == last &&
           (next == end_ || *next == '<');
  }

  // In `x="1 y="2"`, the value that ends at `p` is 1: ends it there, and moves `p` there.
  bool end_unclosed(const char*& p) {
    if (token_.attributes.empty() || !is_after_value(p, token_.attributes.back().value)) {
      return false;
    }
    std::string_view& value = token_.attributes.back().value;
    const auto last_not = [&](CharacterClass what, std::size_t end) {
      while (end > 0 && is(value[end - 1], what)) {
        --end;
      }
      return end;
    };
    const std::size_t sign = last_not(blank, value.size());
    const std::size_t name_end = last_not(blank, sign == 0 ? 0 : sign - 1);
    const std::size_t name = last_not(name_part, name_end);
    const std::size_t end = last_not(blank, name);
    const bool is_other = sign > 0 && value[sign - 1] == '=' && name < name_end &&
                          is(value[name], name_start) && end > 0 && end < name &&
                          value.substr(0, end).find_first_of("=>") == std::string_view::npos;
    if (is_other) {
      value = value.substr(0, end);
      p = value.data() + end;
      unquoted_ = true;
    }
    return is_other;
  }

  // Whether the quotation mark before `p` ends the value.
  static bool is_after_value(const char* p, std::string_view value) {
    return value.data() != nullptr && value.data() + value.size() + 1 == p &&
           (p[-1] == '"' || p[-1] == '\'') && value.data()[-1] == p[-1];
  }

  // Returns nullptr if it is not clear where the value ends.
  const char* read_unquoted(const char* p, std::string_view& value) const {
    const std::size_t opening = typographic_quote(between(p, end_));
    const char* const first = p + opening;
    p = skip_unquoted(first, opening != 0 ? value_part : bare_part);
    value = between(first, p);
    if (opening != 0) {
      const std::size_t closing = typographic_quote(between(p, end_));
      p = closing == 0 ? end_ : p + closing;
    } else if (p != end_ && (*p == '"' || *p == '\'')) {
      ++p;
    }
    const bool ends = p != end_ && (is(*p, blank) || *p == '>' || *p == '/');
    return ends && !value.empty() ? p : nullptr;
  }

  const char* skip_unquoted(const char* p, CharacterClass what) const {
    while ((p = skip(p, end_, what)) != end_) {
      const std::string_view rest = between(p, end_);
      const bool slash = *p == '/' && rest.size() > 1 && rest[1] != '>' && !is(rest[1], blank);
      const std::size_t size = typographic_quote(rest) != 0 ? 0 : plain_character(rest);
      if (!slash && size == 0) {
        break;
      }
      p += slash ? 1 : size;
    }
    return p;
  }

  // The first character of a value that is not in the class value_part.
  const char* pass_special(const char* p) {
    const char c = *p;
    if (c == '>' || c == '"' || c == '\'') {
      return p + 1;
    }
    if (c == '&' || static_cast<unsigned char>(c) < ' ') {
      needs_decoding_ = true;
      plain_ = false;
      return p + 1;
    }
    const std::size_t size = plain_character(between(p, end_));
    plain_ = plain_ && size != 0;
    return p + std::max<std::size_t>(size, 1);
  }

  void check_last_attribute() {
    const std::vector<XmlAttribute>& all = token_.attributes;
    plain_ = plain_ && all.size() <= max_plain_attributes;
    // Only of plain tags, which have few attributes.
    for (std::size_t i = 0; plain_ && i + 1 < all.size(); ++i) {
      plain_ = !same_name(all[i].name, all.back().name);
    }
  }

  // Decides what follows the last attribute; returns the end of the tag.
  const char* finish(const char* p, bool is_end) {
    bool is_empty = false;
    if (p != end_ && *p == '/' && p + 1 != end_ && p[1] == '>') {
      is_empty = true;
      plain_ = plain_ && !is_end;
      p += 2;
    } else if (p != end_ && *p == '>') {
      ++p;
    } else {
      plain_ = false;
      p = pass_rest(p);
      is_empty = p[-1] == '>' && p[-2] == '/';
    }
    token_.kind = is_end ? XmlTokenKind::end : is_empty ? XmlTokenKind::empty : XmlTokenKind::start;
    return p;
  }

  const char* pass_rest(const char* p) const {
    while (p != end_ && *p != '>') {
      const char c = *p++;
      if (c == '"' || c == '\'') {
        p = std::find(p, end_, c);
        p += p == end_ ? 0 : 1;
      }
    }
    return p == end_ ? p : p + 1;
  }

  const char* begin_;
  const char* end_;
  XmlToken& token_;
  bool repairs_ = true;  // whether values may lack quotation marks
  bool plain_ = true;
  bool unquoted_ = false;
  bool needs_decoding_ = false;
};

// One past the next `what`, or the end of the text.
std::size_t end_after(std::string_view text, std::string_view what, std::size_t from) {
  const std::size_t at = text.find(what, from);
  return at == std::string_view::npos ? text.size() : at + what.size();
}

// A DOCTYPE can contain declarations in brackets.
std::size_t doctype_end(std::string_view text) {
  bool inside = false;
  std::size_t at = 2;
  while (at < text.size() && (inside || text[at] != '>')) {
    const char c = text[at];
    if (text.substr(at).starts_with("<!--")) {
      at = end_after(text, "-->", at);
    } else if (text.substr(at).starts_with("<?")) {
      at = end_after(text, "?>", at);
    } else if (c == '"' || c == '\'') {
      at = end_after(text, {&c, 1}, at + 1);
    } else {
      inside = c == '[' || (inside && c != ']');
      ++at;
    }
  }
  return std::min(at + 1, text.size());
}

std::size_t false_comment_end(std::string_view text) {
  const std::string_view until_tag = text.substr(0, text.find('<', 1));
  return end_after(until_tag, "-->", 3);
}

bool is_plain_comment(std::string_view comment) {
  if (comment.size() < 7 || !comment.starts_with("<!--") || !comment.ends_with("-->")) {
    return false;
  }
  const char* p = comment.data() + 4;
  const char* const end = comment.data() + comment.size() - 3;
  while ((p = skip(p, end, comment_part)) != end) {
    // The character after a dash at the end is another dash.
    const bool single_dash = *p == '-' && p[1] != '-';
    const std::size_t size = single_dash ? 1 : plain_character(between(p, end));
    if (size == 0) {
      return false;
    }
    p += size;
  }
  return true;
}

// The most common spelling; Expat must judge others.
bool is_plain_declaration(std::string_view text) {
  constexpr std::string_view version = "<?xml version=\"1.0\"";
  if (!text.starts_with(version)) {
    return false;
  }
  text.remove_prefix(version.size());
  constexpr std::string_view encoding = " encoding=\"";
  if (text.starts_with(encoding)) {
    text.remove_prefix(encoding.size());
    const std::string name = lower_case(text.substr(0, text.find('"')));
    if ((name != "utf-8" && name != "iso-8859-1") || name.size() == text.size()) {
      return false;
    }
    text.remove_prefix(name.size() + 1);
  }
  return text == "?>" || text == " ?>";
}

// Of markup that is not a tag.
std::size_t markup_end(std::string_view text, XmlTokenKind& kind) {
  if (text.starts_with("<!--")) {
    kind = XmlTokenKind::comment;
    return end_after(text, "-->", 4);
  }
  if (text.starts_with("<--")) {
    kind = XmlTokenKind::comment;
    return false_comment_end(text);
  }
  if (text.starts_with("<![CDATA[")) {
    kind = XmlTokenKind::cdata;
    return end_after(text, "]]>", 9);
  }
  kind = XmlTokenKind::other;
  return text.starts_with("<?") ? end_after(text, "?>", 2) : doctype_end(text);
}

// Whether the `<` at `p` begins a tag.
bool is_tag(const char* p, const char* end) {
  const char c = p + 1 != end ? p[1] : ' ';
  return c != '!' && c != '?' && !(c == '-' && between(p, end).starts_with("<--"));
}

}  // namespace

const XmlAttribute* XmlTag::find(std::string_view attribute) const {
  for (const XmlAttribute& a : attributes) {
    if (same_name(a.name, attribute)) {
      return &a;
    }
  }
  return nullptr;
}

bool is_unquoted(const XmlAttribute& attribute) {
  const char before = attribute.value.data()[-1];
  const char after = attribute.value.data()[attribute.value.size()];
  return (before != '"' && before != '\'') || after != before;
}

StrayMarks stray_marks(const XmlAttribute& attribute) {
  const char* const value = attribute.value.data();
  const auto is_quote = [](char c) { return c == '"' || c == '\'' ? std::size_t{1} : 0; };
  // Before a value are at least `<a b=`.
  if (const std::size_t typographic = typographic_quote({value - 3, 3})) {
    return {typographic, typographic_quote({value + attribute.value.size(), 3})};
  }
  return {is_quote(value[-1]), is_quote(value[attribute.value.size()])};
}

std::size_t typographic_quote(std::string_view text) {
  for (const std::string_view quote : {"\u201C", "\u201D", "\u201E", "\u2018", "\u2019"}) {
    if (text.starts_with(quote)) {
      return quote.size();
    }
  }
  return 0;
}

bool XmlScanner::next(XmlToken& token) {
  const char* const begin = text_.data() + at_;
  const char* const end = text_.data() + text_.size();
  const char* const p = skip(begin, end, blank);
  if (p == end) {
    return false;
  }
  if (*p == '<' && is_tag(p, end)) {
    TagScanner(p, end, token).run();
  } else {
    const std::string_view rest = between(p, end);
    token.attributes.clear();
    token.name = {};
    token.needs_decoding = false;
    token.unquoted = false;
    if (*p == '<') {
      token.written = rest.substr(0, markup_end(rest, token.kind));
      token.plain = (token.kind == XmlTokenKind::comment && is_plain_comment(token.written)) ||
                    (at_ == 0 && p == begin && is_plain_declaration(token.written));
    } else {
      token.kind = XmlTokenKind::text;
      token.written = rest.substr(0, rest.find('<'));
      token.written = token.written.substr(0, token.written.find_last_not_of(blanks) + 1);
      token.plain = false;
    }
  }
  at_ = static_cast<std::size_t>(p - text_.data()) + token.written.size();
  return true;
}

}  // namespace scenefile
