#include "scenefile/base/text.h"
#include "scenefile/format/xml_reader.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace scenefile {

namespace {

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
  bool read_tag();
  bool end_element(std::string_view name);

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
    p_ = skip(p_, end_, blank);
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
  return p_[1] == '!' ? read_comment() : read_tag();
}

bool PlainReader::read_comment() {
  constexpr std::size_t longest = std::size_t{1} << 20;
  if (!between(p_, end_).starts_with("<!--")) {
    return false;
  }
  const char* p = skip(p_ + 4, end_, comment_part);
  while (!between(p, end_).starts_with("--")) {
    const bool single = p != end_ && (*p == '-' || *p == '>');
    const std::size_t size = single || p == end_ ? 1 : plain_character(between(p, end_));
    if (p == end_ || size == 0) {
      return false;
    }
    p = skip(p + size, end_, comment_part);
  }
  const bool plain = between(p, end_).starts_with("-->") && between(p_, p).size() < longest;
  p_ = p + 3;
  return plain;
}

bool PlainReader::read_tag() {
  const TagScan scan = scan_tag(between(p_, end_), attributes_);
  const char* const at = p_;
  p_ += scan.size;
  if (!scan.plain) {
    return false;
  }
  if (scan.is_end) {
    return end_element(scan.name);
  }
  if ((open_.empty() && has_root_) || open_.size() == limits_.nesting ||
      check_tag(scan.name, attributes_, limits_).fault != TagFault::none) {
    return false;
  }
  has_root_ = true;
  if (!handler_.start({scan.name, attributes_, places_.advance_to(at)})) {
    stopped_ = true;
    return false;
  }
  open_.push_back(scan.name);
  return !scan.is_empty || end_element(scan.name);
}

bool PlainReader::end_element(std::string_view name) {
  if (open_.empty() || open_.back() != name) {
    return false;
  }
  open_.pop_back();
  handler_.end();
  return true;
}

}  // namespace

PlainEnd read_plain_events(std::string_view text, const Limits& limits, TextCursor& places,
                           XmlHandler& handler) {
  return PlainReader(text, limits, places, handler).run();
}

}  // namespace scenefile
