#include "scenefile/edit/syntax.h"

#include "scenefile/base/text.h"
#include "scenefile/edit/file_text.h"
#include "scenefile/format/json_syntax.h"
#include "scenefile/format/scene_text.h"
#include "scenefile/format/text_places.h"
#include "scenefile/format/xml_reader.h"
#include "scenefile/format/xml_scanner.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

namespace scenefile {

namespace {

/// Collects the places of the elements.
class ElementPlaces final : public XmlHandler {
 public:
  explicit ElementPlaces(std::vector<Location>& places) : places_(places) {}
  bool start(const XmlTag& tag) override {
    places_.push_back(tag.location);
    return true;
  }
  void end() override {}
  void text(std::string_view /*characters*/, Location /*location*/) override {}

 private:
  std::vector<Location>& places_;
};

Error not_editable(const Diagnostics& found) {
  const auto& list = found.list();
  const auto error = std::find_if(list.begin(), list.end(), [](const Diagnostic& finding) {
    return finding.severity == Severity::error;
  });
  if (error == list.end()) {
    return input_error("the file cannot be parsed; correct it first");
  }
  return input_error(error->location.known()
                         ? fmt::format("line {}: {}; correct that in the text first",
                                       error->location.line, error->message)
                         : error->message);
}

/// The elements of a text that is well-formed, as far as the scanner's tokens go.
class ElementTree {
 public:
  explicit ElementTree(Syntax& syntax) : syntax_(syntax) {}

  /// Returns false if the tags do not match.
  bool build() {
    XmlScanner scanner(syntax_.text.substr(syntax_.start));
    for (XmlToken token; scanner.next(token);) {
      if (!take(token)) {
        return false;
      }
    }
    return open_.empty() && !syntax_.parts.empty();
  }

 private:
  bool take(const XmlToken& token) {
    const auto from = static_cast<std::uint32_t>(token.written.data() - syntax_.text.data());
    const auto to = static_cast<std::uint32_t>(from + token.written.size());
    if (token.kind == XmlTokenKind::end) {
      if (open_.empty() || syntax_.name(open_.back()) != token.name) {
        return false;
      }
      SyntaxPart& part = syntax_.parts[open_.back()];
      part.close = from;
      part.to = to;
      open_.pop_back();
    } else if (token.kind == XmlTokenKind::start || token.kind == XmlTokenKind::empty) {
      const auto id = static_cast<PartId>(syntax_.parts.size());
      SyntaxPart& part = syntax_.parts.emplace_back();
      part.empty = token.kind == XmlTokenKind::empty;
      part.from = from;
      part.to = part.body = part.close = to;
      part.key_size = static_cast<std::uint32_t>(token.name.size());
      if (!open_.empty()) {
        part.parent = open_.back();
        syntax_.parts[open_.back()].children.push_back(id);
      }
      if (!part.empty) {
        open_.push_back(id);
      }
    }
    return true;
  }

  Syntax& syntax_;
  std::vector<PartId> open_;
};

std::optional<Error> parse_xml(Syntax& syntax, std::string_view decoded,
                               const ReadOptions& options) {
  Diagnostics found(options.limits);
  TextPlaces places(decoded);
  ElementPlaces elements(syntax.places);
  const bool complete = read_events(decoded, options, places, elements, found).complete;
  if (!complete || found.has_errors()) {
    return not_editable(found);
  }
  if (!ElementTree(syntax).build() || syntax.parts.size() != syntax.places.size()) {
    return not_editable(found);
  }
  return std::nullopt;
}

std::optional<Error> parse_json_file(Syntax& syntax, const ReadOptions& options) {
  const std::string_view text = syntax.text.substr(syntax.start);
  const JsonError error = parse_json(text, options.limits.nesting, syntax.tape);
  if (error.fault != JsonFault::none) {
    Diagnostics found(options.limits);
    report_json_error(error, text, options.limits, found);
    return not_editable(found);
  }
  const JsonTape& tape = syntax.tape;
  struct Open {
    JsonIndex end;
    PartId id;
  };
  std::vector<Open> open;
  TextPlaces places(text);
  std::size_t read = 0;  // up to where brackets were matched
  const auto close = [&](JsonIndex next) {
    while (!open.empty() && open.back().end <= next) {
      SyntaxPart& part = syntax.parts[open.back().id];
      read = text.find(part.type == SyntaxPart::Type::object ? '}' : ']', read) + 1;
      part.to = syntax.start + static_cast<std::uint32_t>(read);
      open.pop_back();
    }
  };
  for (JsonIndex item = 0; item < tape.items.size(); ++item) {
    close(item);
    const bool keyed =
        !open.empty() && syntax.parts[open.back().id].type == SyntaxPart::Type::object;
    const auto id = static_cast<PartId>(syntax.parts.size());
    SyntaxPart& part = syntax.parts.emplace_back();
    part.from = syntax.start + tape.items[item].offset;
    syntax.places.push_back(places.at(tape.items[item].offset));
    if (keyed) {
      part.key_size = tape.items[item].extent;
      ++item;
    }
    part.item = item;
    part.body = syntax.start + tape.items[item].offset;
    part.parent = open.empty() ? no_part : open.back().id;
    if (part.parent != no_part) {
      syntax.parts[part.parent].children.push_back(id);
    }
    const bool contains = tape.is_object(item) || tape.is_array(item);
    read = tape.items[item].offset + (contains ? 1 : tape.items[item].extent);
    part.to = syntax.start + static_cast<std::uint32_t>(read);
    part.type = tape.is_object(item)   ? SyntaxPart::Type::object
                : tape.is_array(item)  ? SyntaxPart::Type::array
                : tape.is_string(item) ? SyntaxPart::Type::string
                : tape.is_number(item) ? SyntaxPart::Type::number
                                       : SyntaxPart::Type::word;
    if (contains) {
      open.push_back({tape.end(item), id});
    }
  }
  close(static_cast<JsonIndex>(tape.items.size()));
  return std::nullopt;
}

}  // namespace

std::string_view Syntax::name(PartId id) const {
  const SyntaxPart& part = parts[id];
  if (part.type == SyntaxPart::Type::element && xml) {
    return text.substr(part.from + 1, part.key_size);
  }
  return part.key_size == 0 ? std::string_view() : text.substr(part.from + 1, part.key_size - 2);
}

PartId Syntax::at(Location place) const {
  const auto before = [](const Location& a, const Location& b) {
    return a.line != b.line ? a.line < b.line : a.column < b.column;
  };
  const auto found = std::lower_bound(places.begin(), places.end(), place, before);
  return found == places.end() || *found != place ? no_part
                                                  : static_cast<PartId>(found - places.begin());
}

std::vector<WrittenAttribute> Syntax::attributes(PartId id) const {
  const SyntaxPart& part = parts[id];
  XmlScanner scanner(text.substr(part.from, part.body - part.from));
  XmlToken token;
  scanner.next(token);
  std::vector<WrittenAttribute> found;
  const auto offset = [&](const char* byte) {
    return static_cast<std::uint32_t>(byte - text.data());
  };
  for (const XmlAttribute& attribute : token.attributes) {
    const std::uint32_t value = offset(attribute.value.data());
    const auto end = static_cast<std::uint32_t>(value + attribute.value.size());
    found.push_back({attribute.name, {offset(attribute.name.data()), end + 1}, {value, end}});
  }
  return found;
}

std::size_t Syntax::index(PartId id) const {
  const std::vector<PartId>& all = parts[parts[id].parent].children;
  return static_cast<std::size_t>(std::lower_bound(all.begin(), all.end(), id) - all.begin());
}

Result<Syntax> parse_syntax(std::string_view bytes, const ReadOptions& options) {
  if (bytes.size() > std::numeric_limits<std::uint32_t>::max() / 2) {
    return Error{"the file is larger than 2 GiB, too large to edit", ErrorKind::limit};
  }
  if (bytes.find('\0') != std::string_view::npos) {
    return input_error(std::string(utf16_refusal));
  }
  Diagnostics found(options.limits);
  std::string storage;
  const std::optional<SceneText> file = open_text(bytes, storage, found);
  if (!file) {
    return not_editable(found);
  }
  Syntax syntax;
  syntax.text = bytes;
  syntax.xml = file->syntax == SceneFormat::xml;
  syntax.start = static_cast<std::uint32_t>(bytes.size() - without_byte_order_mark(bytes).size());
  const std::optional<Error> error =
      syntax.xml ? parse_xml(syntax, file->text, options) : parse_json_file(syntax, options);
  return error ? Result<Syntax>(*error) : Result<Syntax>(std::move(syntax));
}

}  // namespace scenefile
