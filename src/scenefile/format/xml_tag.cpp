#include "scenefile/format/xml_tag.h"

#include "scenefile/base/text.h"

#include <algorithm>

namespace scenefile {

namespace {

constexpr std::size_t most_plain_attributes = 16;

bool ends_name(char c) {
  return is(c, blank) || c == '=' || c == '>' || c == '/' || c == '"' || c == '\'';
}

class TagScanner {
 public:
  explicit TagScanner(std::string_view text) : begin_(text.data()), end_(begin_ + text.size()) {}

  // Calls `take` for each attribute; it returns whether the tag may still be plain.
  template <typename Take>
  TagScan run(Take take) {
    p_ = begin_ + 1;
    scan_.is_end = p_ != end_ && *p_ == '/';
    p_ += scan_.is_end ? 1 : 0;
    scan_.name = read_name();
    while (read_attribute()) {
      const bool plain = take(attribute_);
      scan_.plain = scan_.plain && plain;
    }
    finish();
    scan_.size = static_cast<std::size_t>(p_ - begin_);
    return scan_;
  }

 private:
  std::string_view read_name() {
    const char* const name = p_;
    scan_.plain = scan_.plain && p_ != end_ && is(*p_, name_start);
    p_ = skip(p_, end_, name_part);
    while (p_ != end_ && !ends_name(*p_)) {
      scan_.plain = false;
      ++p_;
    }
    return {name, static_cast<std::size_t>(p_ - name)};
  }

  // Returns false if no well-formed attribute follows. Keeps the available parts of a truncated
  // one.
  bool read_attribute() {
    const char* const before = p_;
    p_ = skip(p_, end_, blank);
    if (p_ == end_ || ends_name(*p_)) {
      return false;
    }
    scan_.plain = scan_.plain && p_ != before && !scan_.is_end;
    attribute_ = {read_name(), {}};
    p_ = skip(p_, end_, blank);
    if (p_ != end_) {
      if (*p_ != '=') {
        scan_.plain = false;
        return false;
      }
      p_ = skip(p_ + 1, end_, blank);
    }
    if (p_ != end_) {
      if (*p_ != '"' && *p_ != '\'') {
        scan_.plain = false;
        return false;
      }
      read_value();
    }
    return true;
  }

  void read_value() {
    const char quote = *p_++;
    const char* const value = p_;
    while ((p_ = skip(p_, end_, value_part)) != end_ && *p_ != quote) {
      pass_special();
    }
    attribute_.value = {value, static_cast<std::size_t>(p_ - value)};
    p_ += p_ == end_ ? 0 : 1;
  }

  // The first character of a value that is not in the class value_part.
  void pass_special() {
    const char c = *p_;
    if (c == '&' || static_cast<unsigned char>(c) < ' ') {
      scan_.needs_decoding = true;
      scan_.plain = false;
      ++p_;
    } else if (c == '>' || c == '"' || c == '\'') {
      ++p_;
    } else {
      const std::size_t size = plain_character({p_, static_cast<std::size_t>(end_ - p_)});
      scan_.plain = scan_.plain && size != 0;
      p_ += std::max<std::size_t>(size, 1);
    }
  }

  // Decides what follows the last attribute.
  void finish() {
    if (p_ != end_ && *p_ == '/' && p_ + 1 != end_ && p_[1] == '>') {
      scan_.is_empty = true;
      scan_.plain = scan_.plain && !scan_.is_end;
      p_ += 2;
      return;
    }
    if (p_ != end_ && *p_ == '>') {
      ++p_;
      return;
    }
    scan_.plain = false;
    while (p_ != end_ && *p_ != '>') {
      const char c = *p_++;
      if (c == '"' || c == '\'') {
        p_ = std::find(p_, end_, c);
        p_ += p_ == end_ ? 0 : 1;
      }
    }
    scan_.is_empty = p_ != end_ && p_[-1] == '/';
    p_ += p_ == end_ ? 0 : 1;
  }

  const char* begin_;
  const char* end_;
  const char* p_ = nullptr;
  XmlAttribute attribute_;
  TagScan scan_;
};

}  // namespace

const XmlAttribute* XmlTag::find(std::string_view attribute) const {
  for (const XmlAttribute& a : attributes) {
    if (a.name == attribute) {
      return &a;
    }
  }
  return nullptr;
}

TagScan scan_tag(std::string_view text, std::vector<XmlAttribute>& attributes) {
  attributes.clear();
  return TagScanner(text).run([&](const XmlAttribute& attribute) {
    const auto same = [&](const XmlAttribute& other) { return other.name == attribute.name; };
    const bool plain = attributes.size() < most_plain_attributes &&
                       std::none_of(attributes.begin(), attributes.end(), same);
    attributes.push_back(attribute);
    return plain;
  });
}

std::size_t tag_size(std::string_view text) {
  return TagScanner(text).run([](const XmlAttribute&) { return true; }).size;
}

TagVerdict check_tag(std::string_view name, std::span<const XmlAttribute> attributes,
                     const Limits& limits) {
  if (name.size() > limits.name_bytes) {
    return {TagFault::name_too_long, {}};
  }
  for (std::size_t i = 0; i < attributes.size(); ++i) {
    if (i >= limits.attributes) {
      return {TagFault::too_many_attributes, {}};
    }
    if (attributes[i].name.size() > limits.name_bytes) {
      return {TagFault::name_too_long, {}};
    }
    if (attributes[i].value.size() > limits.value_bytes) {
      return {TagFault::value_too_long, attributes[i].name};
    }
  }
  return {};
}

std::size_t plain_character(std::string_view text) {
  if (static_cast<unsigned char>(text.front()) < 128) {
    return 0;
  }
  const CodePoint c = first_code_point(text);
  return c.value == 0xFFFE || c.value == 0xFFFF ? 0 : c.bytes;
}

}  // namespace scenefile
