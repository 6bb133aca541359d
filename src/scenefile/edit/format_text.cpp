#include "scenefile/edit/format_text.h"

#include "scenefile/base/text.h"
#include "scenefile/format/codes.h"
#include "scenefile/format/json_fields.h"
#include "scenefile/format/json_parser.h"
#include "scenefile/format/json_syntax.h"
#include "scenefile/format/scene_text.h"
#include "scenefile/format/text_places.h"
#include "scenefile/format/xml_reader.h"
#include "scenefile/format/xml_scanner.h"
#include "scenefile/format/xml_values.h"

#include <fmt/format.h>

#include <utility>
#include <vector>

namespace scenefile {

namespace {

// The line end of a text: that of its first line; LF if there is only one line.
std::string_view line_end_of(std::string_view text) {
  const std::size_t end = text.find_first_of("\r\n");
  if (end == std::string_view::npos || text[end] == '\n') {
    return "\n";
  }
  return text.substr(end).starts_with("\r\n") ? "\r\n" : "\r";
}

// The number of line ends in the white space between two tokens.
std::size_t count_line_ends(std::string_view between) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < between.size(); ++i) {
    const bool half = between[i] == '\r' && i + 1 < between.size() && between[i + 1] == '\n';
    count += (between[i] == '\n' || between[i] == '\r') && !half;
  }
  return count;
}

// Builds a text line by line.
class LinePrinter {
 public:
  explicit LinePrinter(std::string_view line_end) : line_end_(line_end) {}

  // Ends the current line, if any, and indents the next. `blank`: adds an empty line before it.
  void start_line(std::size_t depth, bool blank) {
    if (!out_.empty()) {
      out_ += line_end_;
      out_ += blank ? line_end_ : std::string_view();
    }
    out_.append(2 * depth, ' ');
  }
  void add(std::string_view text) { out_ += text; }
  std::string finish() {
    out_ += line_end_;
    return std::move(out_);
  }

 private:
  std::string_view line_end_;
  std::string out_;
};

// Checks only the outermost element.
class RootCheck : public XmlHandler {
 public:
  explicit RootCheck(Diagnostics& diagnostics) : diagnostics_(diagnostics) {}

  bool start(const XmlTag& tag) override {
    if (!seen_ && !equal_ignoring_case(tag.name, "scenefile")) {
      diagnostics_.report("xml.root-element"_code, tag.location,
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
      : text_(text), scanner_(text), lines_(line_end_of(text)) {}

  std::string make() {
    while (scanner_.next(token_)) {
      place();
    }
    return lines_.finish();
  }

 private:
  std::size_t begin() const {
    return static_cast<std::size_t>(token_.written.data() - text_.data());
  }
  std::size_t end() const { return begin() + token_.written.size(); }

  // Prints the token; with its contents, if the element is unchanged.
  void place() {
    const bool is_first = end_ == 0;
    depth_ -= token_.kind == XmlTokenKind::end ? 1 : 0;
    if (!is_first) {
      separate();
    }
    after_start_ = false;
    switch (token_.kind) {
      case XmlTokenKind::start:
        print_tag();
        if (is_verbatim()) {
          copy_contents();
        } else {
          ++depth_;
          after_start_ = true;
        }
        break;
      case XmlTokenKind::empty:
      case XmlTokenKind::end:
        print_tag();
        break;
      case XmlTokenKind::text:
      case XmlTokenKind::comment:
      case XmlTokenKind::cdata:
      case XmlTokenKind::other:
        lines_.add(token_.written);
        break;
    }
    end_ = end();
  }

  // Prints the white space before the token.
  void separate() {
    const std::size_t line_ends = count_line_ends(text_.substr(end_, begin() - end_));
    const bool is_end = token_.kind == XmlTokenKind::end;
    if (after_start_ && is_end) {
      return;
    }
    if (token_.kind == XmlTokenKind::comment && line_ends == 0) {
      lines_.add(" ");
      return;
    }
    lines_.start_line(depth_, line_ends > 1 && !after_start_ && !is_end);
  }

  void print_tag() {
    lines_.add(token_.kind == XmlTokenKind::end ? "</" : "<");
    lines_.add(token_.name);
    for (const XmlAttribute& attribute : token_.attributes) {
      lines_.add(" ");
      lines_.add(attribute.name);
      lines_.add("=");
      lines_.add({attribute.value.data() - 1, attribute.value.size() + 2});  // with its quotes
    }
    lines_.add(token_.kind == XmlTokenKind::empty ? "/>" : ">");
  }

  // Whether the element whose start tag was just read only contains text, or keeps its white space.
  bool is_verbatim() {
    for (const XmlAttribute& attribute : token_.attributes) {
      if (attribute.name == "xml:space" &&
          attribute.value.find("preserve") != std::string_view::npos) {
        return true;
      }
    }
    bool has_text = false;
    for (XmlScanner ahead = scanner_; ahead.next(ahead_);) {
      switch (ahead_.kind) {
        case XmlTokenKind::start:
        case XmlTokenKind::empty:
          return false;
        case XmlTokenKind::end:
          return has_text;
        case XmlTokenKind::text:
        case XmlTokenKind::cdata:
          has_text = true;
          break;
        case XmlTokenKind::comment:
        case XmlTokenKind::other:
          break;
      }
    }
    return false;
  }

  // Up to and including the end tag.
  void copy_contents() {
    const std::size_t from = end();
    for (std::size_t open = 1; open != 0 && scanner_.next(token_);) {
      open += token_.kind == XmlTokenKind::start ? 1 : 0;
      open -= token_.kind == XmlTokenKind::end ? 1 : 0;
    }
    lines_.add(text_.substr(from, end() - from));
  }

  std::string_view text_;
  XmlScanner scanner_;
  XmlToken token_;
  XmlToken ahead_;
  LinePrinter lines_;
  std::size_t depth_ = 0;
  std::size_t end_ = 0;       // offset after the last printed token
  bool after_start_ = false;  // it was the start tag of an element that is not verbatim
};

// Whether the text is a well-formed <scenefile>; reports an error otherwise.
bool check_xml(std::string_view text, const Limits& limits, Diagnostics& diagnostics) {
  TextPlaces places(text);
  RootCheck root(diagnostics);
  const ReadOptions options{false, limits};
  return read_events(text, options, places, root, diagnostics).complete &&
         !diagnostics.has_errors();
}

constexpr std::size_t max_list_bytes = 80;

class JsonLayout {
 public:
  explicit JsonLayout(const JsonTape& tape) : tape_(tape), lines_(line_end_of(tape.text)) {}

  std::string make() {
    place(0);
    while (!open_.empty()) {
      const Container top = open_.back();
      if (next_ == tape_.end(top.item)) {
        open_.pop_back();
        close(top);
      } else {
        place_inside(top);
      }
    }
    return lines_.finish();
  }

 private:
  struct Container {
    JsonIndex item;
    bool is_object;
    bool in_line;
  };

  bool is_container(JsonIndex item) const { return tape_.is_object(item) || tape_.is_array(item); }

  std::string_view raw(JsonIndex item) const {
    const JsonItem& it = tape_.items[item];
    return tape_.text.substr(it.offset, it.extent);
  }

  // Prints a scalar, or the opening bracket of a container.
  void place(JsonIndex item) {
    next_ = item + 1;
    if (!is_container(item)) {
      lines_.add(raw(item));
      end_ = tape_.items[item].offset + tape_.items[item].extent;
      return;
    }
    const bool is_object = tape_.is_object(item);
    end_ = tape_.items[item].offset + 1;
    lines_.add(is_object ? "{" : "[");
    open_.push_back({item, is_object, fits_line(item)});
  }

  void place_inside(const Container& top) {
    const bool first = next_ == top.item + 1;
    lines_.add(first ? "" : ",");
    if (!top.in_line) {
      lines_.start_line(open_.size(), !first && blank_line_before(next_));
    } else if (!first) {
      lines_.add(" ");
    }
    if (top.is_object) {
      lines_.add(raw(next_));
      lines_.add(": ");
      ++next_;
    }
    place(next_);
  }

  void close(const Container& container) {
    if (!container.in_line && next_ != container.item + 1) {
      lines_.start_line(open_.size(), false);
    }
    lines_.add(container.is_object ? "}" : "]");
    end_ = tape_.text.find(container.is_object ? '}' : ']', end_) + 1;
  }

  // Whether the item is a short list of scalars, at any depth.
  bool fits_line(JsonIndex item) const {
    if (tape_.is_object(item)) {
      return false;
    }
    std::size_t bytes = 0;
    for (JsonIndex i = item + 1; i < tape_.end(item); ++i) {
      if (is_container(i)) {
        return false;
      }
      bytes += raw(i).size() + 2;
    }
    return bytes <= max_list_bytes;
  }

  // Whether the author left an empty line before the item, possibly with a comma in between.
  bool blank_line_before(JsonIndex item) const {
    return count_line_ends(tape_.text.substr(end_, tape_.items[item].offset - end_)) > 1;
  }

  const JsonTape& tape_;
  LinePrinter lines_;
  std::vector<Container> open_;
  JsonIndex next_ = 0;
  std::size_t end_ = 0;  // offset after the last printed token
};

// `text` is UTF-8 without a byte order mark. Returns nullopt, after an error, if it is not a JSON
// object.
std::optional<std::string> lay_out_json(std::string_view text, const Limits& limits,
                                        Diagnostics& diagnostics) {
  JsonTape tape;
  const JsonError error = parse_json(text, limits.nesting, tape);
  if (error.fault != JsonFault::none) {
    report_json_error(error, text, limits, diagnostics);
    return std::nullopt;
  }
  if (!tape.is_object(0)) {
    diagnostics.report("json.wrong-type"_code, TextPlaces(text).at(tape.items[0].offset),
                       "a scene must be an object, found " + describe_json(tape, 0));
    return std::nullopt;
  }
  return JsonLayout(tape).make();
}

std::string_view byte_order_mark(std::string_view bytes) {
  for (const std::string_view mark :
       {utf8_mark, std::string_view("\xFF\xFE"), std::string_view("\xFE\xFF")}) {
    if (bytes.starts_with(mark)) {
      return bytes.substr(0, mark.size());
    }
  }
  return {};
}

// Neither syntax allows zero bytes, and every second byte of ASCII in UTF-16 is zero.
bool is_utf16(std::string_view bytes) {
  return bytes.find('\0') != std::string_view::npos;
}

void append_unit(std::string& out, char32_t unit, bool little_endian) {
  const char high = static_cast<char>(unit >> 8);
  const char low = static_cast<char>(unit & 0xFF);
  out += little_endian ? low : high;
  out += little_endian ? high : low;
}

std::string utf16(std::string_view text, bool little_endian) {
  std::string out;
  out.reserve(2 * text.size());
  while (!text.empty()) {
    const CodePoint c = first_code_point(text);
    if (c.value < 0x10000) {
      append_unit(out, c.value, little_endian);
    } else {
      append_unit(out, 0xD800 + ((c.value - 0x10000) >> 10), little_endian);
      append_unit(out, 0xDC00 + ((c.value - 0x10000) & 0x3FF), little_endian);
    }
    text.remove_prefix(c.bytes);
  }
  return out;
}

}  // namespace

std::optional<std::string> lay_out(std::string_view bytes, const Limits& limits,
                                   Diagnostics& diagnostics) {
  std::string storage;
  const std::optional<SceneText> file = open_text(bytes, storage, diagnostics);
  if (!file) {
    return std::nullopt;
  }
  const std::string_view mark = byte_order_mark(bytes);
  const bool wide = is_utf16(bytes);
  std::optional<std::string> text;
  if (file->syntax == SceneFormat::json) {
    text = lay_out_json(file->text, limits, diagnostics);
  } else if (check_xml(file->text, limits, diagnostics)) {
    // Formats the original bytes if possible, which works in every superset of ASCII.
    text = XmlLayout(wide ? file->text : bytes.substr(mark.size())).make();
  }
  if (text) {
    const bool little_endian = wide && bytes[mark.size() + 1] == '\0';
    if (wide) {
      *text = utf16(*text, little_endian);
    }
    text->insert(0, mark);
  }
  return text;
}

std::size_t count_comments(std::string_view bytes) {
  std::string storage;
  Diagnostics ignored;
  const std::optional<SceneText> file = open_text(bytes, storage, ignored);
  if (!file || file->syntax != SceneFormat::xml) {
    return 0;
  }
  std::size_t count = 0;
  XmlScanner scanner(file->text);
  for (XmlToken token; scanner.next(token);) {
    count += token.kind == XmlTokenKind::comment ? 1 : 0;
  }
  return count;
}

}  // namespace scenefile
