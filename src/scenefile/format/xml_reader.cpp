#include "scenefile/format/xml_reader.h"

#include "scenefile/base/text.h"
#include "scenefile/format/codes.h"
#include "scenefile/format/xml_syntax_error.h"

#include <expat.h>
#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <memory>
#include <new>
#include <vector>

namespace scenefile {

namespace {

constexpr std::size_t chunk_bytes = std::size_t{64} << 10;
// For comments and declarations; tags have lower limits.
constexpr std::size_t max_markup_bytes = std::size_t{16} << 20;

struct ParserFree {
  void operator()(XML_Parser parser) const { XML_ParserFree(parser); }
};

std::string_view without_blanks(std::string_view text) {
  while (!text.empty() && is(text.front(), blank)) {
    text.remove_prefix(1);
  }
  while (!text.empty() && is(text.back(), blank)) {
    text.remove_suffix(1);
  }
  return text;
}

// Connects Expat to the handler.
class EventReader {
 public:
  EventReader(std::string_view text, const Limits& limits, TextCursor& places, XmlHandler& handler,
              Diagnostics& diagnostics);
  bool run();

 private:
  static EventReader& of(void* self) { return *static_cast<EventReader*>(self); }
  static void XMLCALL on_start(void* self, const XML_Char* name, const XML_Char** attributes);
  static void XMLCALL on_end(void* self, const XML_Char* name);
  static void XMLCALL on_text(void* self, const XML_Char* characters, int length);
  static void XMLCALL on_doctype(void* self, const XML_Char* name, const XML_Char* system_id,
                                 const XML_Char* public_id, int has_internal_subset);
  static void XMLCALL on_entity(void* self, const XML_Char* name, int, const XML_Char*, int,
                                const XML_Char*, const XML_Char*, const XML_Char*, const XML_Char*);
  static void XMLCALL on_attribute_list(void* self, const XML_Char* element, const XML_Char*,
                                        const XML_Char*, const XML_Char*, int);
  static void XMLCALL on_skipped_entity(void* self, const XML_Char* name, int);

  template <typename Action>
  void guarded(Action action);
  void start(const XML_Char** attributes);
  void decode_values(const XML_Char** attributes);
  bool accept(std::string_view name, const char* tag);
  bool check_unfinished(std::size_t fed);
  bool feed(std::size_t from, std::size_t size, bool last);
  void report_syntax_error();
  void stop();
  void refuse_entity(const char* at, std::string message);
  const char* opening(std::string_view keyword) const;
  const char* current() const;
  Location place_of(const char* at) const;

  std::string_view text_;
  const Limits& limits_;
  TextCursor& places_;
  XmlHandler& handler_;
  Diagnostics& diagnostics_;
  std::unique_ptr<XML_ParserStruct, ParserFree> parser_;
  std::vector<XmlAttribute> attributes_;
  std::vector<OpenElement> open_;
  bool has_external_subset_ = false;
  bool stopped_ = false;
  std::exception_ptr failure_;
};

EventReader::EventReader(std::string_view text, const Limits& limits, TextCursor& places,
                         XmlHandler& handler, Diagnostics& diagnostics)
    : text_(text),
      limits_(limits),
      places_(places),
      handler_(handler),
      diagnostics_(diagnostics),
      parser_(XML_ParserCreate("UTF-8")) {
  if (!parser_) {
    throw std::bad_alloc();
  }
  XML_Parser parser = parser_.get();
  XML_SetUserData(parser, this);
  XML_SetElementHandler(parser, on_start, on_end);
  XML_SetCharacterDataHandler(parser, on_text);
  XML_SetStartDoctypeDeclHandler(parser, on_doctype);
  XML_SetEntityDeclHandler(parser, on_entity);
  XML_SetAttlistDeclHandler(parser, on_attribute_list);
  XML_SetSkippedEntityHandler(parser, on_skipped_entity);
}

// Exceptions must not propagate through the C library.
template <typename Action>
void EventReader::guarded(Action action) {
  if (stopped_) {
    return;
  }
  try {
    action();
  } catch (...) {
    failure_ = std::current_exception();
    stop();
  }
}

void EventReader::on_start(void* self, const XML_Char*, const XML_Char** attributes) {
  of(self).guarded([&] { of(self).start(attributes); });
}

void EventReader::on_end(void* self, const XML_Char*) {
  of(self).guarded([&] {
    of(self).open_.pop_back();
    of(self).handler_.end();
  });
}

void EventReader::on_text(void* self, const XML_Char* characters, int length) {
  const std::string_view all(characters, static_cast<std::size_t>(length));
  const std::string_view text = without_blanks(all);
  if (text.empty()) {
    return;
  }
  EventReader& reader = of(self);
  reader.guarded([&] {
    const char* const at = reader.current() + (text.data() - all.data());
    reader.handler_.text(text, reader.places_.advance_to(at));
  });
}

void EventReader::on_doctype(void* self, const XML_Char*, const XML_Char* system_id,
                             const XML_Char* public_id, int) {
  EventReader& reader = of(self);
  reader.guarded([&] {
    if (system_id == nullptr && public_id == nullptr) {
      return;
    }
    reader.has_external_subset_ = true;
    reader.diagnostics_.report(
        xml_external_dtd, reader.place_of(reader.opening("<!DOCTYPE")),
        fmt::format("the DOCTYPE names the external file {}; it was not opened",
                    quoted(system_id != nullptr ? system_id : public_id)));
  });
}

void EventReader::on_entity(void* self, const XML_Char* name, int, const XML_Char*, int,
                            const XML_Char*, const XML_Char*, const XML_Char*, const XML_Char*) {
  of(self).guarded([&] {
    of(self).refuse_entity(
        of(self).opening("<!ENTITY"),
        fmt::format("the DOCTYPE declares the entity {}; scene files may not declare entities",
                    quoted(name)));
  });
}

void EventReader::on_attribute_list(void* self, const XML_Char* element, const XML_Char*,
                                    const XML_Char*, const XML_Char*, int) {
  of(self).guarded([&] {
    of(self).refuse_entity(
        of(self).opening("<!ATTLIST"),
        fmt::format("the DOCTYPE declares attributes of <{}>; write them where they are used",
                    escaped(element, 40)));
  });
}

void EventReader::on_skipped_entity(void* self, const XML_Char* name, int) {
  of(self).guarded([&] {
    of(self).refuse_entity(
        of(self).current(),
        fmt::format("the entity {} is not defined; only &lt; &gt; &amp; &quot; and &apos; are",
                    quoted(name)));
  });
}

void EventReader::start(const XML_Char** attributes) {
  const char* const at = current();
  const auto size = static_cast<std::size_t>(XML_GetCurrentByteCount(parser_.get()));
  const TagScan scan = scan_tag({at, size}, attributes_);
  if (!accept(scan.name, at)) {
    return;
  }
  if (has_external_subset_ && scan.needs_decoding) {
    // Expat silently drops such an entity from a value.
    const std::size_t use = find_entity_use({at, size});
    if (use != std::string_view::npos) {
      refuse_entity(at + use,
                    fmt::format("<{}> uses an entity that is not defined", escaped(scan.name, 40)));
      return;
    }
  }
  if (scan.needs_decoding) {
    decode_values(attributes);
  }
  const XmlTag tag{scan.name, attributes_, places_.advance_to(at)};
  if (open_.size() == limits_.nesting) {
    diagnostics_.report(xml_nesting_limit, tag.location,
                        fmt::format("<{}> is nested deeper than the limit of {} elements",
                                    escaped(tag.name, 40), limits_.nesting));
    stop();
    return;
  }
  open_.push_back({tag.name, tag.location});
  if (!handler_.start(tag)) {
    stop();
  }
}

// Takes the values from Expat, which has resolved references and line breaks.
void EventReader::decode_values(const XML_Char** attributes) {
  for (std::size_t i = 0; i < attributes_.size(); ++i) {
    attributes_[i].value = attributes[2 * i + 1];
  }
}

// Whether the tag is within the limits.
bool EventReader::accept(std::string_view tag_name, const char* tag) {
  const TagVerdict verdict = check_tag(tag_name, attributes_, limits_);
  if (verdict.fault == TagFault::none) {
    return true;
  }
  const Location place = place_of(tag);
  const std::string name = escaped(tag_name, 40);
  switch (verdict.fault) {
    case TagFault::none:
      break;
    case TagFault::name_too_long:
      diagnostics_.report(xml_length_limit, place,
                          fmt::format("a name in <{}> is longer than the limit of {} bytes", name,
                                      limits_.name_bytes));
      break;
    case TagFault::too_many_attributes:
      diagnostics_.report(
          xml_attribute_limit, place,
          fmt::format("<{}> has more attributes than the limit of {}", name, limits_.attributes));
      break;
    case TagFault::value_too_long:
      diagnostics_.report(xml_length_limit, place,
                          fmt::format("attribute {} of <{}> is longer than the limit of {} bytes",
                                      escaped(verdict.culprit, 40), name, limits_.value_bytes));
      break;
  }
  stop();
  return false;
}

// Expat keeps incomplete markup and scans it again with the next chunk. Stops early if it already
// exceeds a limit. `fed`: bytes passed to Expat so far.
bool EventReader::check_unfinished(std::size_t fed) {
  const char* const at = current();
  const std::string_view unfinished(at, static_cast<std::size_t>(text_.data() + fed - at));
  if (unfinished.size() < chunk_bytes) {
    return true;
  }
  const bool is_tag = unfinished[0] == '<' && unfinished[1] != '!' && unfinished[1] != '?';
  if (is_tag) {
    return accept(scan_tag(unfinished, attributes_).name, at);
  }
  if (unfinished.size() < max_markup_bytes) {
    return true;
  }
  diagnostics_.report(xml_length_limit, place_of(at),
                      fmt::format("a comment or declaration is longer than the limit of {} bytes",
                                  max_markup_bytes));
  return false;
}

bool EventReader::feed(std::size_t from, std::size_t size, bool last) {
  const XML_Status status =
      XML_Parse(parser_.get(), text_.data() + from, static_cast<int>(size), last);
  if (failure_) {
    std::rethrow_exception(failure_);
  }
  if (status == XML_STATUS_OK || stopped_) {
    return !stopped_;
  }
  report_syntax_error();
  return false;
}

bool EventReader::run() {
  std::size_t fed = 0;
  std::size_t size = std::min(chunk_bytes, text_.size());
  while (feed(fed, size, fed + size == text_.size())) {
    fed += size;
    if (fed == text_.size()) {
      return true;
    }
    if (!check_unfinished(fed)) {
      return false;
    }
    // At least as much as is incomplete, so that the total cost of scanning again is linear.
    const auto unfinished = static_cast<std::size_t>(text_.data() + fed - current());
    size = std::min(std::max(chunk_bytes, unfinished), text_.size() - fed);
  }
  return false;
}

void EventReader::report_syntax_error() {
  const XML_Error error = XML_GetErrorCode(parser_.get());
  if (error == XML_ERROR_NO_MEMORY) {
    throw std::bad_alloc();
  }
  const auto at = static_cast<std::size_t>(current() - text_.data());
  const SyntaxFault fault = [error] {
    switch (error) {
      case XML_ERROR_INVALID_TOKEN:
        return SyntaxFault::invalid_token;
      case XML_ERROR_TAG_MISMATCH:
        return SyntaxFault::tag_mismatch;
      case XML_ERROR_NO_ELEMENTS:
      case XML_ERROR_UNCLOSED_TOKEN:
      case XML_ERROR_UNCLOSED_CDATA_SECTION:
      case XML_ERROR_PARTIAL_CHAR:
        return SyntaxFault::cut_off;
      case XML_ERROR_DUPLICATE_ATTRIBUTE:
        return SyntaxFault::duplicate_attribute;
      case XML_ERROR_UNDEFINED_ENTITY:
        return SyntaxFault::undefined_entity;
      case XML_ERROR_BAD_CHAR_REF:
        return SyntaxFault::bad_character_reference;
      case XML_ERROR_JUNK_AFTER_DOC_ELEMENT:
        return SyntaxFault::junk_after_document;
      case XML_ERROR_MISPLACED_XML_PI:
        return SyntaxFault::late_declaration;
      default:
        return SyntaxFault::other;
    }
  }();
  report_syntax(fault, XML_ErrorString(error), text_, at, open_, diagnostics_);
}

void EventReader::stop() {
  stopped_ = true;
  XML_StopParser(parser_.get(), XML_FALSE);
}

void EventReader::refuse_entity(const char* at, std::string message) {
  diagnostics_.report(xml_entity, place_of(at), std::move(message));
  stop();
}

// The start of the current declaration, which Expat only reports at its end.
const char* EventReader::opening(std::string_view keyword) const {
  const auto end = static_cast<std::size_t>(current() - text_.data());
  const std::size_t start = text_.rfind(keyword, end);
  return text_.data() + (start == std::string_view::npos ? end : start);
}

const char* EventReader::current() const {
  // Expat returns -1 before the first event.
  return text_.data() + std::max<XML_Index>(XML_GetCurrentByteIndex(parser_.get()), 0);
}

// For places out of order; scans the text from the start.
Location EventReader::place_of(const char* at) const {
  return TextCursor(text_).advance_to(at);
}

}  // namespace

bool read_events(std::string_view text, const Limits& limits, TextCursor& places,
                 XmlHandler& handler, Diagnostics& diagnostics) {
  return EventReader(text, limits, places, handler, diagnostics).run();
}

}  // namespace scenefile
