#include "scenefile/format/xml_syntax_cause.h"

#include "scenefile/base/text.h"
#include "scenefile/format/codes.h"
#include "scenefile/format/xml_comments.h"
#include "scenefile/format/xml_tag.h"

#include <fmt/format.h>

#include <algorithm>

namespace scenefile {

namespace {

using Cause = std::optional<SyntaxCause>;

constexpr std::string_view blanks = " \t\r\n";

std::uint32_t line_of(std::string_view text, std::size_t at) {
  return TextCursor(text).advance_to(text.data() + at).line;
}

// The offset of the < that opened the tag that is still open at the offset, or npos.
std::size_t open_tag(std::string_view text, std::size_t at) {
  const std::size_t open = at == 0 ? std::string_view::npos : text.rfind('<', at - 1);
  return open == std::string_view::npos || open + 1 == at ? std::string_view::npos : open;
}

// A < in a value that ran over the end of its tag.
Cause unclosed_value(std::string_view text, std::size_t at) {
  const std::size_t open = open_tag(text, at);
  if (text[at] != '<' || open == std::string_view::npos) {
    return {};
  }
  std::size_t value = std::string_view::npos;
  for (std::size_t i = open; i < at; ++i) {
    const bool outside = value == std::string_view::npos;
    if (outside && (text[i] == '"' || text[i] == '\'')) {
      value = i;
    } else if (!outside && text[i] == text[value]) {
      value = std::string_view::npos;
    }
  }
  if (value == std::string_view::npos ||
      text.substr(value, at - value).find_first_of(">\r\n") == std::string_view::npos) {
    return {};
  }
  return SyntaxCause{&xml_syntax, value,
                     fmt::format("the value that begins here, in <{}>, lacks its closing quotation "
                                 "mark",
                                 escaped(name_at(text.substr(open + 1)), 40))};
}

// The offset is behind <! that begins no comment.
Cause broken_comment_start(std::string_view text, std::size_t at) {
  const std::size_t open = open_tag(text, at);
  if (open == std::string_view::npos || at - open > 3 || text[open + 1] != '!') {
    return {};
  }
  return SyntaxCause{&xml_syntax, open, "a comment starts with <!-- and ends with -->"};
}

// Dashes in a comment that has no proper end.
Cause broken_comment_end(std::string_view text, std::size_t at) {
  const std::size_t open = text.rfind("<!--", at);
  if (open == std::string_view::npos || at < open + 6 || text.substr(at - 2, 2) != "--" ||
      text.find("-->", open) != std::string_view::npos) {
    return {};
  }
  const std::size_t next = text.find_first_not_of(blanks, at);
  if (next == std::string_view::npos || text[next] != '>') {
    return {};
  }
  return SyntaxCause{&xml_comment, at - 2, std::string(broken_comment_end_text)};
}

Cause unfinished_declaration(std::string_view text, std::size_t at) {
  if (!text.substr(at).starts_with("<?")) {
    return {};
  }
  const std::string name = escaped(name_at(text.substr(at + 2)), 40);
  return SyntaxCause{&xml_syntax, at,
                     fmt::format("<?{} lacks its end ?>: write ? in front of the >", name)};
}

// A closing tag of an element that ended in itself just before.
Cause closed_twice(std::string_view text, std::size_t at) {
  const std::string_view name = name_at(text.substr(at + 2));
  const std::size_t last = at == 0 ? std::string_view::npos : text.find_last_not_of(blanks, at - 1);
  if (last == std::string_view::npos || last == 0 || text.substr(last - 1, 2) != "/>") {
    return {};
  }
  const std::size_t open = text.rfind('<', last);
  if (open == std::string_view::npos || name_at(text.substr(open + 1)) != name) {
    return {};
  }
  const std::string shown = escaped(name, 40);
  return SyntaxCause{&xml_syntax, at,
                     fmt::format("</{}> closes nothing: <{}> ends in itself with />; remove </{}>",
                                 shown, shown, shown)};
}

// A closing tag whose opening one lacks its <, so that it was taken for text.
Cause opened_as_text(std::string_view text, std::size_t at, std::span<const OpenElement> open) {
  const std::string name(name_at(text.substr(at + 2)));
  const bool is_open =
      std::any_of(open.begin(), open.end(), [&](const OpenElement& e) { return e.name == name; });
  if (name.empty() || is_open || at == 0) {
    return {};
  }
  const std::size_t written = text.rfind(name, at - 1);
  if (written == std::string_view::npos || written == 0) {
    return {};
  }
  const std::size_t behind = text.find_first_not_of(blanks, written + name.size());
  const std::size_t before = text.find_last_not_of(blanks, written - 1);
  if (text[behind] != '>' || before == std::string_view::npos || text[before] != '>') {
    return {};
  }
  return SyntaxCause{&xml_syntax, written,
                     fmt::format("the tag {}> lacks its <; </{}> of line {} has nothing to close",
                                 escaped(name, 40), escaped(name, 40), line_of(text, at))};
}

}  // namespace

std::string_view name_at(std::string_view text) {
  return text.substr(0, text.find_first_of(" \t\r\n=/>&;\"'<"));
}

std::optional<SyntaxCause> find_cause(SyntaxFault fault, std::string_view text, std::size_t at,
                                      std::span<const OpenElement> open) {
  if (at >= text.size()) {
    return {};
  }
  if (fault == SyntaxFault::tag_mismatch) {
    const Cause twice = closed_twice(text, at);
    return twice ? twice : opened_as_text(text, at, open);
  }
  if (fault == SyntaxFault::cut_off) {
    return unfinished_declaration(text, at);
  }
  if (fault != SyntaxFault::invalid_token) {
    return {};
  }
  for (const auto cause : {unclosed_value, broken_comment_start, broken_comment_end}) {
    if (const Cause found = cause(text, at)) {
      return found;
    }
  }
  return {};
}

}  // namespace scenefile
