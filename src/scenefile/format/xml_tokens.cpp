#include "scenefile/format/xml_tokens.h"

#include "scenefile/base/ascii.h"
#include "scenefile/format/xml_tag.h"

#include <algorithm>

namespace scenefile {

namespace {

// One past the next `what`, or the end of the text.
std::size_t end_after(std::string_view text, std::string_view what, std::size_t from) {
  const std::size_t at = text.find(what, from);
  return at == std::string_view::npos ? text.size() : at + what.size();
}

// A DOCTYPE can contain declarations in brackets.
std::size_t doctype_end(std::string_view text, std::size_t from) {
  bool inside = false;
  while (from < text.size() && (inside || text[from] != '>')) {
    const char c = text[from];
    if (text.substr(from).starts_with("<!--")) {
      from = end_after(text, "-->", from);
    } else if (text.substr(from).starts_with("<?")) {
      from = end_after(text, "?>", from);
    } else if (c == '"' || c == '\'') {
      from = end_after(text, {&c, 1}, from + 1);
    } else {
      inside = c == '[' || (inside && c != ']');
      ++from;
    }
  }
  return std::min(from + 1, text.size());
}

XmlTokenKind kind_of(std::string_view markup) {
  if (markup.starts_with("<!--")) {
    return XmlTokenKind::comment;
  }
  if (markup.starts_with("<![CDATA[")) {
    return XmlTokenKind::cdata;
  }
  if (markup.starts_with("<?") || markup.starts_with("<!")) {
    return XmlTokenKind::other;
  }
  if (markup.starts_with("</")) {
    return XmlTokenKind::end;
  }
  return markup.ends_with("/>") ? XmlTokenKind::empty : XmlTokenKind::start;
}

XmlToken markup_at(std::string_view text, std::size_t begin) {
  const std::size_t end = markup_end(text, begin);
  return {static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end),
          kind_of(text.substr(begin, end - begin))};
}

bool preserves_space(std::string_view tag) {
  std::vector<XmlAttribute> attributes;
  scan_tag(tag, attributes);
  return std::any_of(attributes.begin(), attributes.end(), [](const XmlAttribute& attribute) {
    return attribute.name == "xml:space" &&
           attribute.value.find("preserve") != std::string_view::npos;
  });
}

// Tracks which elements contain only text.
class OpenElements {
 public:
  explicit OpenElements(std::vector<XmlToken>& tokens) : tokens_(tokens) {}

  void add(XmlToken token) {
    switch (token.kind) {
      case XmlTokenKind::start:
      case XmlTokenKind::empty:
        mark(&Element::has_element);
        if (token.kind == XmlTokenKind::start) {
          open_.push_back({tokens_.size()});
        }
        break;
      case XmlTokenKind::end:
        tokens_[open_.back().start].verbatim |= open_.back().has_text && !open_.back().has_element;
        open_.pop_back();
        break;
      case XmlTokenKind::text:
      case XmlTokenKind::cdata:
        mark(&Element::has_text);
        break;
      case XmlTokenKind::comment:
      case XmlTokenKind::other:
        break;
    }
    tokens_.push_back(token);
  }

 private:
  struct Element {
    std::size_t start = 0;
    bool has_text = false;
    bool has_element = false;
  };

  void mark(bool Element::*what) {
    if (!open_.empty()) {
      open_.back().*what = true;
    }
  }

  std::vector<XmlToken>& tokens_;
  std::vector<Element> open_;
};

}  // namespace

std::size_t markup_end(std::string_view text, std::size_t begin) {
  const std::string_view rest = text.substr(begin);
  if (rest.starts_with("<!--")) {
    return end_after(text, "-->", begin + 4);
  }
  if (rest.starts_with("<![CDATA[")) {
    return end_after(text, "]]>", begin);
  }
  if (rest.starts_with("<?")) {
    return end_after(text, "?>", begin);
  }
  return rest.starts_with("<!") ? doctype_end(text, begin + 2) : begin + tag_size(rest);
}

std::vector<XmlToken> xml_tokens(std::string_view text) {
  std::vector<XmlToken> tokens;
  OpenElements elements(tokens);
  std::size_t at = 0;
  while ((at = text.find_first_not_of(blanks, at)) != std::string_view::npos) {
    XmlToken token;
    if (text[at] == '<') {
      token = markup_at(text, at);
    } else {
      const std::size_t end = text.find_last_not_of(blanks, text.find('<', at) - 1) + 1;
      token = {static_cast<std::uint32_t>(at), static_cast<std::uint32_t>(end)};
    }
    token.verbatim = token.kind == XmlTokenKind::start && preserves_space(token.of(text));
    elements.add(token);
    at = token.end;
  }
  return tokens;
}

}  // namespace scenefile
