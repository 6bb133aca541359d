#include "scenefile/base/text.h"
#include "scenefile/format/codes.h"
#include "scenefile/format/dialects.h"
#include "scenefile/format/layout_lines.h"
#include "scenefile/format/xml_context.h"
#include "scenefile/format/xml_reader.h"
#include "scenefile/format/xml_tag.h"
#include "scenefile/format/xml_tokens.h"

#include <fmt/format.h>

namespace scenefile {

namespace {

// Checks only the outermost element.
class RootCheck : public XmlHandler {
 public:
  explicit RootCheck(Diagnostics& diagnostics) : diagnostics_(diagnostics) {}

  bool start(const XmlTag& tag) override {
    if (!seen_ && !equal_ignoring_case(tag.name, "scenefile")) {
      diagnostics_.report(xml_root_element, tag.location,
                          fmt::format("the file is not a scene: expected <scenefile>, found {}",
                                      element_text(tag.name)));
      return false;
    }
    seen_ = true;
    return true;
  }
  void end() override {}
  void text(std::string_view, Location) override {}

 private:
  Diagnostics& diagnostics_;
  bool seen_ = false;
};

class XmlLayout {
 public:
  explicit XmlLayout(std::string_view text)
      : text_(text), tokens_(xml_tokens(text)), lines_(line_end_of(text)) {}

  std::string make() {
    for (std::size_t i = 0; i < tokens_.size();) {
      i = place(i);
    }
    return lines_.finish();
  }

 private:
  // Prints the token and those on the same line; returns the index of the next.
  std::size_t place(std::size_t index) {
    const XmlToken& token = tokens_[index];
    const XmlToken* const before = index == 0 ? nullptr : &tokens_[index - 1];
    if (token.kind == XmlTokenKind::end) {
      --depth_;
    }
    separate(token, before);
    switch (token.kind) {
      case XmlTokenKind::start:
        print_tag(token);
        if (token.verbatim) {
          return print_verbatim(index);
        }
        ++depth_;
        break;
      case XmlTokenKind::empty:
      case XmlTokenKind::end:
        print_tag(token);
        break;
      case XmlTokenKind::text:
      case XmlTokenKind::comment:
      case XmlTokenKind::cdata:
      case XmlTokenKind::other:
        lines_.add(token.of(text_));
        break;
    }
    return index + 1;
  }

  // Prints the white space before the token.
  void separate(const XmlToken& token, const XmlToken* before) {
    if (before == nullptr) {
      return;
    }
    const std::size_t line_ends =
        count_line_ends(text_.substr(before->end, token.begin - before->end));
    const bool begins = before->kind == XmlTokenKind::start && !before->verbatim;
    const bool ends = token.kind == XmlTokenKind::end;
    if (begins && ends) {
      return;
    }
    if (token.kind == XmlTokenKind::comment && line_ends == 0) {
      lines_.add(" ");
      return;
    }
    lines_.start_line(depth_, line_ends > 1 && !begins && !ends);
  }

  void print_tag(const XmlToken& token) {
    const TagScan tag = scan_tag(token.of(text_), attributes_);
    lines_.add(tag.is_end ? "</" : "<");
    lines_.add(tag.name);
    for (const XmlAttribute& attribute : attributes_) {
      lines_.add(" ");
      lines_.add(attribute.name);
      lines_.add("=");
      lines_.add({attribute.value.data() - 1, attribute.value.size() + 2});  // with its quotes
    }
    lines_.add(tag.is_empty ? "/>" : ">");
  }

  // Copies the contents and the end tag of the element.
  std::size_t print_verbatim(std::size_t start) {
    std::size_t open = 1;
    std::size_t index = start;
    while (open != 0) {
      ++index;
      open += tokens_[index].kind == XmlTokenKind::start ? 1 : 0;
      open -= tokens_[index].kind == XmlTokenKind::end ? 1 : 0;
    }
    const std::size_t from = tokens_[start].end;
    lines_.add(text_.substr(from, tokens_[index].end - from));
    return index + 1;
  }

  std::string_view text_;
  std::vector<XmlToken> tokens_;
  std::vector<XmlAttribute> attributes_;  // of the tag that is printed
  LinePrinter lines_;
  std::size_t depth_ = 0;
};

}  // namespace

bool check_xml_layout(std::string_view text, const Limits& limits, Diagnostics& diagnostics) {
  TextCursor places(text);
  RootCheck root(diagnostics);
  return read_events(text, limits, places, root, diagnostics) && !diagnostics.has_errors();
}

std::string lay_out_xml(std::string_view text) {
  return XmlLayout(text).make();
}

}  // namespace scenefile
