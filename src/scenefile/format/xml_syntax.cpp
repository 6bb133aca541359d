#include "scenefile/format/xml_syntax.h"

#include "scenefile/base/ascii.h"
#include "scenefile/base/suggest.h"
#include "scenefile/base/text.h"
#include "scenefile/format/codes.h"
#include "scenefile/format/scene_text.h"
#include "scenefile/format/text_places.h"
#include "scenefile/format/xml_scanner.h"
#include "scenefile/scene/vocabulary.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace scenefile {

namespace {

// The message about `-- >` as the end of a comment.
constexpr std::string_view broken_comment_end_text =
    "a comment ends with -->, without spaces in it; remove them";

constexpr std::string_view typographic_text =
    "a typographic quotation mark, as word processors insert it";

// Mistakes that begin before the place where the parser notices them.

// What is wrong, and where.
struct SyntaxCause {
  const Code* code;
  std::size_t at;  //< offset in the text
  std::string message;
  std::optional<Correction> correction = std::nullopt;
};

// The name at the start of the text; empty if there is none.
std::string_view name_at(std::string_view text) {
  return text.substr(0, text.find_first_of(" \t\r\n=/>&;\"'<"));
}

using Cause = std::optional<SyntaxCause>;

std::uint32_t line_of(std::string_view text, std::size_t at) {
  return TextPlaces(text).at(at).line;
}

// The offset of the < of the tag that is open at the offset, or npos.
std::size_t open_tag(std::string_view text, std::size_t at) {
  const std::size_t open = at == 0 ? std::string_view::npos : text.rfind('<', at - 1);
  return open == std::string_view::npos || open + 1 == at ? std::string_view::npos : open;
}

// A < inside a value whose closing quote is missing.
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
  return SyntaxCause{
      &"xml.syntax"_code, value,
      fmt::format("the value that begins here, in <{}>, is missing its closing quotation "
                  "mark",
                  escaped(name_at(text.substr(open + 1)), 40))};
}

// The offset is after a <! that does not begin a comment.
Cause broken_comment_start(std::string_view text, std::size_t at) {
  const std::size_t open = open_tag(text, at);
  if (open == std::string_view::npos || at - open > 3 || text[open + 1] != '!') {
    return {};
  }
  return SyntaxCause{&"xml.syntax"_code, open, "a comment starts with <!-- and ends with -->"};
}

// Dashes in a comment that is not closed properly.
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
  return SyntaxCause{&"xml.comment"_code, at - 2, std::string(broken_comment_end_text)};
}

Cause unfinished_declaration(std::string_view text, std::size_t at) {
  if (!text.substr(at).starts_with("<?")) {
    return {};
  }
  const std::string name = escaped(name_at(text.substr(at + 2)), 40);
  return SyntaxCause{&"xml.syntax"_code, at,
                     fmt::format("<?{} is missing its end ?>: write ? in front of the >", name)};
}

// A closing tag for an element that was already closed by />.
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
  return SyntaxCause{
      &"xml.syntax"_code, at,
      fmt::format("</{0}> has no opening tag: <{0}> is already closed by its />; remove it", shown),
      Correction{std::string(name), ""}};
}

// A closing tag whose opening tag lacks its <, and so was read as text.
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
  const std::size_t after_name = text.find_first_not_of(blanks, written + name.size());
  const std::size_t before = text.find_last_not_of(blanks, written - 1);
  if (text[after_name] != '>' || before == std::string_view::npos || text[before] != '>') {
    return {};
  }
  return SyntaxCause{
      &"xml.syntax"_code, written,
      fmt::format("the tag {}> is missing its <; </{}> of line {} has nothing to close",
                  escaped(name, 40), escaped(name, 40), line_of(text, at))};
}

// All other elements of the format are empty tags.
bool holds_elements(std::string_view name) {
  const std::string word = lower_case(name);
  return word == transform_word<Matrix> ||
         std::find(structure_elements.begin(), structure_elements.end(), word) !=
             structure_elements.end();
}

// The name of the closing tag at the offset.
std::string_view closing_name(std::string_view text, std::size_t at) {
  const std::string_view rest = text.substr(at);
  return name_at(rest.substr(rest.starts_with("</") ? 2 : 0));
}

// A closing tag of an element whose opening tag is misspelled, within another of that name.
Cause misspelled_start(std::string_view text, std::size_t at, std::span<const OpenElement> open) {
  const std::string_view closing = closing_name(text, at);
  const bool is_open = std::any_of(open.begin(), open.end(),
                                   [&](const OpenElement& e) { return e.name == closing; });
  if (!is_open || holds_elements(open.back().name) ||
      nearest_name(open.back().name, std::span(&closing, 1)).empty()) {
    return {};
  }
  const OpenElement& inner = open.back();
  return SyntaxCause{&"xml.syntax"_code, inner.at,
                     fmt::format("<{0}> is closed by </{1}> of line {2}; did you mean <{1}>?",
                                 escaped(inner.name, 40), escaped(closing, 40), line_of(text, at)),
                     correction(inner.name, closing)};
}

// A closing tag after a value that is not closed, because the / of its tag is missing.
Cause unclosed_element(std::string_view text, std::size_t at, std::span<const OpenElement> open) {
  auto outer = open.rbegin();
  while (outer != open.rend() && !holds_elements(outer->name)) {
    ++outer;
  }
  if (outer == open.rbegin() || outer == open.rend() || outer->name != closing_name(text, at)) {
    return {};
  }
  const OpenElement& value = *std::prev(outer);
  XmlScanner scanner(text.substr(value.at));
  XmlToken token;
  scanner.next(token);
  const std::size_t next = text.find_first_not_of(blanks, value.at + token.written.size());
  if (!token.written.ends_with('>') || next == std::string_view::npos || text[next] != '<') {
    return {};
  }
  return SyntaxCause{&"xml.syntax"_code, value.at,
                     fmt::format("<{}> is not closed before </{}>; a tag without contents ends "
                                 "with />",
                                 escaped(value.name, 40), escaped(outer->name, 40)),
                     Correction{">", "/>"}};
}

std::optional<SyntaxCause> find_cause(SyntaxFault fault, std::string_view text, std::size_t at,
                                      std::span<const OpenElement> open) {
  if (at >= text.size()) {
    return {};
  }
  if (fault == SyntaxFault::tag_mismatch) {
    for (const Cause& cause : {closed_twice(text, at), misspelled_start(text, at, open),
                               unclosed_element(text, at, open)}) {
      if (cause) {
        return cause;
      }
    }
    return opened_as_text(text, at, open);
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

// What to report about a fault, and where.

// The line that contains the offset, from its start.
std::string_view line_at(std::string_view text, std::size_t at) {
  const std::size_t before = at == 0 ? std::string_view::npos : text.find_last_of("\r\n", at - 1);
  const std::size_t start = before == std::string_view::npos ? 0 : before + 1;
  const std::string_view rest = text.substr(start);
  return rest.substr(0, rest.find_first_of("\r\n"));
}

bool is_conflict_marker(std::string_view line) {
  return line.starts_with("<<<<<<<") || line.starts_with("=======") || line.starts_with(">>>>>>>");
}

std::string opened_at(const OpenElement& element) {
  return fmt::format("<{}>, opened at line {}", escaped(element.name, 40), element.location.line);
}

std::string misspelled_end(std::string_view closing, const OpenElement& inner) {
  return fmt::format("</{}> cannot close {}; did you mean </{}>?", escaped(closing, 40),
                     opened_at(inner), escaped(inner.name, 40));
}

std::string cut_off_message(std::string_view text, std::size_t at,
                            std::span<const OpenElement> open) {
  const bool in_markup = at < text.size() && text[at] == '<';
  if (in_markup && text.substr(at).starts_with("<!--")) {
    return "the file ends inside a comment; --> is missing";
  }
  if (open.empty()) {
    return in_markup ? "the file ends inside a tag" : "the file ends before its first element";
  }
  return fmt::format("the file ends inside {}{}", in_markup ? "a tag inside " : "",
                     opened_at(open.back()));
}

// Whether the closing tag was probably meant to close the innermost element.
bool closes_inner(std::string_view closing, std::span<const OpenElement> open) {
  return !open.empty() && !nearest_name(closing, std::span(&open.back().name, 1)).empty() &&
         std::none_of(open.begin(), open.end(),
                      [&](const OpenElement& e) { return e.name == closing; });
}

std::string mismatch_message(std::string_view text, std::size_t at,
                             std::span<const OpenElement> open) {
  const std::string_view name = closing_name(text, at);
  const std::string closing = escaped(name, 40);
  if (closes_inner(name, open)) {
    return misspelled_end(name, open.back());
  }
  const bool is_open = std::any_of(open.begin(), open.end(), [&](const OpenElement& e) {
    return e.name == name || !nearest_name(name, std::span(&e.name, 1)).empty();
  });
  if (!is_open) {
    return fmt::format("</{0}> has no opening tag <{0}>", closing);
  }
  const OpenElement& inner = open.back();
  const std::string_view slash =
      holds_elements(inner.name) ? "" : ", or a / in front of the > that ends its tag";
  return fmt::format("</{}> cannot close {}; </{}> is missing before it{}", closing,
                     opened_at(inner), escaped(inner.name, 40), slash);
}

// Whether the offset is inside a comment.
bool in_comment(std::string_view text, std::size_t at) {
  const std::size_t open = text.rfind("<!--", at);
  return open != std::string_view::npos &&
         text.substr(open, at - open).find("-->") == std::string_view::npos;
}

// Whether the offset is inside a tag, but not inside a value.
bool in_tag(std::string_view text, std::size_t at) {
  std::size_t i = at == 0 ? std::string_view::npos : text.rfind('<', at - 1);
  char quote = '\0';
  for (; i < at && (quote != '\0' || text[i] != '>'); ++i) {
    const char c = text[i];
    if (quote != '\0' ? c == quote : c == '"' || c == '\'') {
      quote = quote == '\0' ? c : '\0';
    }
  }
  return i == at && quote == '\0';
}

// The offset is a `<`; if it is inside a tag, but not inside a value: a hint about that tag.
std::string unclosed_tag(std::string_view text, std::size_t at) {
  if (!in_tag(text, at)) {
    return {};
  }
  const std::size_t open = text.rfind('<', at - 1);
  const std::string_view tag = text.substr(open, at - open);
  if (tag.size() == 1) {
    return "two < in a row; one is enough";
  }
  const bool closing = tag.starts_with("</");
  return fmt::format("the tag <{}{}> of line {} is missing its >{}", closing ? "/" : "",
                     escaped(name_at(tag.substr(closing ? 2 : 1)), 40), line_of(text, open),
                     closing ? "" : " or />");
}

// A hint from the characters before the offset; empty if there is none.
std::string hint_before(std::string_view text, std::size_t at) {
  const std::string found = quoted(name_at(text.substr(at)), 20);
  const char before = at == 0 ? ' ' : text[at - 1];
  if (before == '<') {
    return text.substr(at).starts_with("--") ? "a comment starts with <!--"
                                             : "a name must directly follow <";
  }
  if (before == '/') {
    return "the / that ends a tag must be directly followed by >";
  }
  if (text[at] == '\\') {
    return "a tag ends with >, or with /> where nothing is inside; no \\ belongs there";
  }
  if ((before == '"' || before == '\'') && (text[at] == ',' || text[at] == ';')) {
    return fmt::format("attributes are separated by spaces, not by {}",
                       text[at] == ',' ? "commas" : "semicolons");
  }
  if (before == '"' || before == '\'') {
    return fmt::format(
        "{} right after a quotation mark: a space is missing, or an earlier value is missing its "
        "closing quotation mark",
        found);
  }
  if (text[at] == '"' || text[at] == '\'') {
    return "a quotation mark that does not open a value; a value is written name=\"value\"";
  }
  std::size_t sign = at;
  while (sign > 0 && blanks.find(text[sign - 1]) != blanks.npos) {
    --sign;
  }
  return sign > 0 && text[sign - 1] == '=' ? fmt::format("{} must be in quotation marks", found)
                                           : std::string();
}

// Why the characters at the offset are not allowed there.
std::string token_message(std::string_view text, std::size_t at) {
  const std::string_view rest = text.substr(at);
  if (typographic_quote(rest) != 0) {
    return fmt::format("{}; use \" or '", typographic_text);
  }
  if (rest.empty()) {
    return "the file ends too early";
  }
  const CodePoint c = first_code_point(rest);
  if (c.bytes == 0) {
    return fmt::format(
        "the byte {} is not valid UTF-8; save the file as UTF-8 or declare its encoding",
        quoted(rest.substr(0, 1)));
  }
  if (c.value < ' ' && c.value != '\t' && c.value != '\n' && c.value != '\r') {
    return fmt::format("the character {} is not allowed in XML", quoted(rest.substr(0, 1)));
  }
  if (is_odd_blank(c.value)) {
    return odd_blank_text(c.value);
  }
  if (rest[0] == '&' && !in_tag(text, at)) {
    return "a bare & is not allowed; write &amp;";
  }
  if (rest.starts_with("<!--") && in_tag(text, at)) {
    return "a comment cannot be inside a tag; write it before or after the tag";
  }
  if (in_comment(text, at)) {
    return "-- is not allowed inside a comment; write - or == instead";
  }
  if (const std::string tag = unclosed_tag(text, at); rest[0] == '<' && !tag.empty()) {
    return tag;
  }
  if (rest[0] == '<') {
    return "< is not allowed here; inside a value write &lt;";
  }
  if (const std::string hint = hint_before(text, at); !hint.empty()) {
    return hint;
  }
  const std::string_view found =
      rest.substr(0, std::max<std::size_t>(name_at(rest).size(), c.bytes));
  return fmt::format("{} is not expected here", quoted(found, 20));
}

std::string message_of(const XmlFault& fault, std::string_view text, std::size_t at,
                       std::span<const OpenElement> open) {
  const std::string_view rest = text.substr(at);
  switch (fault.kind) {
    case SyntaxFault::tag_mismatch:
      return mismatch_message(text, at, open);
    case SyntaxFault::cut_off:
      return cut_off_message(text, at, open);
    case SyntaxFault::duplicate_attribute:
      return fmt::format("attribute {} is given twice", quoted(name_at(rest)));
    case SyntaxFault::undefined_entity:
      return fmt::format("the entity {} is not defined; for a bare & write &amp;",
                         quoted(name_at(rest.substr(rest.starts_with('&')))));
    case SyntaxFault::bad_character_reference:
      return fmt::format("{} is not a valid character reference",
                         quoted(rest.substr(0, rest.find(';') + 1), 20));
    case SyntaxFault::junk_after_document:
      return fmt::format("nothing may follow the closing tag of the scene; found {}",
                         quoted(rest.substr(0, rest.find_first_of("\r\n")), 20));
    case SyntaxFault::late_declaration:
      return "<?xml ...?> must be the very first thing in the file; remove everything before it";
    case SyntaxFault::invalid_token:
      return token_message(text, at);
    case SyntaxFault::none:
    case SyntaxFault::declaration:
    case SyntaxFault::over_limit:
    case SyntaxFault::other:
      break;
  }
  return fmt::format("{} ({})", token_message(text, at), fault.message);
}

// The correction that the message of the fault states.
std::optional<Correction> correction_of(const XmlFault& fault, std::string_view text,
                                        std::size_t at, std::span<const OpenElement> open) {
  if (fault.kind == SyntaxFault::tag_mismatch && closes_inner(closing_name(text, at), open)) {
    return correction(closing_name(text, at), open.back().name);
  }
  if (fault.kind == SyntaxFault::invalid_token && text.substr(at).starts_with('&') &&
      !in_tag(text, at)) {
    return Correction{"&", "&"};
  }
  return std::nullopt;
}

// Whether Expat accepts the character in the name of an entity.
bool is_entity_character(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.' ||
         c == '-' || c == '_' || c == ':' || static_cast<unsigned char>(c) >= 0x80;
}

// The & of a reference without a semicolon before the offset; otherwise the offset.
std::size_t bare_ampersand(std::string_view text, std::size_t at) {
  constexpr std::size_t longest_name = 40;
  std::size_t start = at;
  while (start > 0 && at - start < longest_name && is_entity_character(text[start - 1])) {
    --start;
  }
  return start > 0 && text[start - 1] == '&' ? start - 1 : at;
}

// Where the author has to look; Expat may report the tag around it or the next character.
std::size_t exact_place(SyntaxFault fault, std::string_view text, std::size_t at) {
  switch (fault) {
    case SyntaxFault::tag_mismatch:
      return at >= 2 && text.substr(at - 2, 2) == "</" ? at - 2 : at;
    case SyntaxFault::undefined_entity: {
      const std::size_t use = find_entity_use(text.substr(at));
      return use == std::string_view::npos ? at : at + use;
    }
    case SyntaxFault::invalid_token:
      return bare_ampersand(text, at);
    case SyntaxFault::cut_off:
    case SyntaxFault::duplicate_attribute:
    case SyntaxFault::bad_character_reference:
    case SyntaxFault::junk_after_document:
    case SyntaxFault::late_declaration:
    case SyntaxFault::none:
    case SyntaxFault::declaration:
    case SyntaxFault::over_limit:
    case SyntaxFault::other:
      break;
  }
  return at;
}

class Mender {
 public:
  Mender(std::string_view text, const ReadOptions& options, Diagnostics& diagnostics)
      : text_(text), options_(options), diagnostics_(diagnostics), places_(text) {}

  std::optional<std::string> run() {
    XmlScanner scanner(text_);
    for (XmlToken token; scanner.next(token);) {
      const std::size_t begin = offset(token.written.data());
      if (token.kind == XmlTokenKind::comment && !token.plain) {
        token.written.starts_with("<!--") ? repair_comment(begin, token.written.size())
                                          : repair_false_comment(begin, token.written.size());
      } else if (in_order_) {
        repair_tag(token);
      }
    }
    return std::move(repaired_);
  }

 private:
  std::size_t offset(const char* p) const { return static_cast<std::size_t>(p - text_.data()); }

  void repair_tag(const XmlToken& token) {
    if (token.unquoted) {
      const std::size_t end = token.kind == XmlTokenKind::empty ? 2 : 1;
      blank(offset(token.name.data() + token.name.size()),
            offset(token.written.data() + token.written.size()) - end);
    }
    if (token.kind == XmlTokenKind::start) {
      in_order_ = open_.size() < options_.limits.nesting;
      open_.push_back(token.name);
    } else if (token.kind == XmlTokenKind::end) {
      in_order_ = !open_.empty() && equal_ignoring_case(open_.back(), token.name);
      if (in_order_ && open_.back() != token.name) {
        writable().replace(offset(token.name.data()), token.name.size(), open_.back());
      }
      open_.resize(open_.size() - (in_order_ ? 1 : 0));
    }
  }

  void repair_comment(std::size_t begin, std::size_t size) {
    const std::size_t end = begin + size - 3;
    if (size < 7 || text_.substr(end, 3) != "-->") {
      return;
    }
    bool reported = false;
    for (std::size_t at = begin + 4; at < end; ++at) {
      // A dash before another one, which may be the first of the comment's end.
      if (text_[at] != '-' || text_[at + 1] != '-') {
        continue;
      }
      if (!std::exchange(reported, true)) {
        const std::size_t next = text_.find_first_not_of(blanks, at + 2);
        report(at,
               next > at + 2 && text_[next] == '>'
                   ? broken_comment_end_text
                   : "-- is not allowed inside a comment; write - or == instead",
               "-- inside a comment, which XML does not allow, was taken as a part of it");
      }
      blank(at, at + 1);
    }
  }

  void repair_false_comment(std::size_t begin, std::size_t size) {
    report(begin, "a comment starts with <!--, not with <--",
           "<-- was taken as the start of a comment, which is <!--");
    blank(begin, begin + size);
  }

  void report(std::size_t at, std::string_view refused, std::string_view accepted) {
    const Severity severity = options_.compat_course ? Severity::warning : Severity::error;
    diagnostics_.report("xml.comment"_code, severity, places_.at(at),
                        std::string(options_.compat_course ? accepted : refused));
  }

  std::string& writable() { return repaired_ ? *repaired_ : repaired_.emplace(text_); }

  // Keeps line ends.
  void blank(std::size_t from, std::size_t to) {
    std::string& text = writable();
    for (std::size_t at = from; at < to; ++at) {
      char& c = text[at];
      c = c == '\n' || c == '\r' ? c : ' ';
    }
  }

  std::string_view text_;
  const ReadOptions& options_;
  Diagnostics& diagnostics_;
  TextPlaces places_;
  std::optional<std::string> repaired_;
  std::vector<std::string_view> open_;  // the names of the open elements
  bool in_order_ = true;                // up to here, elements end where they should
};

}  // namespace

std::size_t find_entity_use(std::string_view markup) {
  std::size_t at = markup.find('&');
  for (; at != std::string_view::npos; at = markup.find('&', at + 1)) {
    const std::string_view rest = markup.substr(at + 1);
    const bool predefined = rest.starts_with('#') || rest.starts_with("lt;") ||
                            rest.starts_with("gt;") || rest.starts_with("amp;") ||
                            rest.starts_with("apos;") || rest.starts_with("quot;");
    if (!predefined) {
      break;
    }
  }
  return at;
}

void report_syntax(const XmlFault& fault, std::string_view text, std::span<const OpenElement> open,
                   TextPlaces& places, Diagnostics& diagnostics) {
  if (fault.kind == SyntaxFault::declaration) {
    diagnostics.report("xml.entity"_code, places.at(fault.at), fault.message);
    return;
  }
  const std::string_view line = line_at(text, fault.at);
  if (is_conflict_marker(line)) {
    diagnostics.report("xml.conflict-marker"_code,
                       places.at(static_cast<std::size_t>(line.data() - text.data())),
                       fmt::format("an unresolved git conflict: {}", quoted(line, 40)));
    return;
  }
  const std::size_t at = exact_place(fault.kind, text, fault.at);
  if (const std::optional<SyntaxCause> cause = find_cause(fault.kind, text, at, open)) {
    diagnostics.report(*cause->code, places.at(cause->at), cause->message, cause->correction);
    return;
  }
  diagnostics.report("xml.syntax"_code, places.at(at), message_of(fault, text, at, open),
                     correction_of(fault, text, at, open));
}

void report_unquoted(const XmlToken& token, TextPlaces& places, Diagnostics& diagnostics) {
  for (const XmlAttribute& attribute : token.attributes) {
    if (!is_unquoted(attribute)) {
      continue;
    }
    const StrayMarks marks = stray_marks(attribute);
    std::string what;
    if (marks.opening > 1) {
      what = typographic_text;
    } else {
      what = fmt::format("{} {}", quoted(attribute.value, 20),
                         marks.opening != 0   ? "is missing its closing quotation mark"
                         : marks.closing != 0 ? "is missing its opening quotation mark"
                                              : "must be in quotation marks");
    }
    diagnostics.report("xml.syntax"_code, places.at(attribute.value.data() - marks.opening),
                       fmt::format("{}; write {}=\"{}\"", what, escaped(attribute.name, 40),
                                   escaped(attribute.value, 60)),
                       correction(attribute.value, attribute.value));
  }
}

void report_end_case(const XmlToken& end, std::string_view open, TextPlaces& places,
                     Diagnostics& diagnostics) {
  diagnostics.report("xml.syntax"_code, places.at(end.written.data()),
                     misspelled_end(end.name, {open, places.at(open.data() - 1)}),
                     correction(end.name, open));
}

std::optional<std::string> repair(std::string_view text, const ReadOptions& options,
                                  Diagnostics& diagnostics) {
  return Mender(text, options, diagnostics).run();
}

}  // namespace scenefile
