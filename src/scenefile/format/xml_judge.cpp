#include "scenefile/format/xml_judge.h"

#include "scenefile/base/text.h"
#include "scenefile/format/codes.h"
#include "scenefile/format/text_places.h"

#include <expat.h>
#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <memory>
#include <new>
#include <utility>

namespace scenefile {

namespace {

constexpr std::size_t chunk_bytes = std::size_t{64} << 10;
constexpr std::size_t max_markup_bytes = std::size_t{16} << 20;

std::string too_long() {
  return fmt::format("a tag, comment or declaration is longer than the limit of {} bytes",
                     max_markup_bytes);
}

struct ParserFree {
  void operator()(XML_Parser parser) const { XML_ParserFree(parser); }
};

SyntaxFault fault_of(XML_Error error) {
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
}

class Judge {
 public:
  Judge(std::string_view text, const Limits& limits, Diagnostics& diagnostics)
      : text_(text),
        limits_(limits),
        diagnostics_(diagnostics),
        parser_(XML_ParserCreate("UTF-8")) {
    if (!parser_) {
      throw std::bad_alloc();
    }
    XML_SetUserData(parser_.get(), this);
    XML_SetStartDoctypeDeclHandler(parser_.get(), on_doctype);
    XML_SetEntityDeclHandler(parser_.get(), on_entity);
    XML_SetAttlistDeclHandler(parser_.get(), on_attribute_list);
  }

  XmlFault run() {
    std::size_t fed = 0;
    std::size_t size = std::min(chunk_bytes, text_.size());
    while (feed(fed, size)) {
      fed += size;
      if (fed == text_.size()) {
        return {SyntaxFault::none, fed, {}};
      }
      // Expat scans incomplete markup again with the next chunk: at least as much as is incomplete,
      // so that the total cost is linear.
      const std::size_t unfinished = fed - current();
      if (unfinished >= chunk_bytes && is_over_limit(text_.substr(current(), unfinished))) {
        return {SyntaxFault::over_limit, current(), too_long()};
      }
      size = std::min(std::max(chunk_bytes, unfinished), text_.size() - fed);
    }
    return std::move(fault_);
  }

 private:
  static void XMLCALL on_doctype(void* self, const XML_Char*, const XML_Char* system_id,
                                 const XML_Char* public_id, int) {
    if (system_id != nullptr || public_id != nullptr) {
      static_cast<Judge*>(self)->guarded([&](Judge& judge) {
        judge.diagnostics_.report(
            "xml.external-dtd"_code, TextPlaces(judge.text_).at(judge.opening("<!DOCTYPE")),
            fmt::format("the DOCTYPE names the external file {}; it was not opened",
                        quoted(system_id != nullptr ? system_id : public_id)));
      });
    }
  }

  static void XMLCALL on_entity(void* self, const XML_Char* name, int, const XML_Char*, int,
                                const XML_Char*, const XML_Char*, const XML_Char*,
                                const XML_Char*) {
    static_cast<Judge*>(self)->guarded([&](Judge& judge) {
      judge.refuse(
          "<!ENTITY",
          fmt::format("the DOCTYPE declares the entity {}; scene files may not declare entities",
                      quoted(name)));
    });
  }

  static void XMLCALL on_attribute_list(void* self, const XML_Char* element, const XML_Char*,
                                        const XML_Char*, const XML_Char*, int) {
    static_cast<Judge*>(self)->guarded([&](Judge& judge) {
      judge.refuse(
          "<!ATTLIST",
          fmt::format("the DOCTYPE declares attributes of <{}>; write them where they are used",
                      escaped(element, 40)));
    });
  }

  // Exceptions must not propagate through the C library.
  template <typename Action>
  void guarded(Action action) {
    try {
      if (!failure_ && fault_.kind == SyntaxFault::none) {
        action(*this);
      }
    } catch (...) {
      failure_ = std::current_exception();
      XML_StopParser(parser_.get(), XML_FALSE);
    }
  }

  void refuse(std::string_view keyword, std::string message) {
    fault_ = {SyntaxFault::declaration, opening(keyword), std::move(message)};
    XML_StopParser(parser_.get(), XML_FALSE);
  }

  // The start of the current declaration, which Expat only reports at its end.
  std::size_t opening(std::string_view keyword) const {
    const std::size_t start = text_.rfind(keyword, current());
    return start == std::string_view::npos ? current() : start;
  }

  // Returns false after a fault.
  bool feed(std::size_t from, std::size_t size) {
    const bool last = from + size == text_.size();
    const XML_Status status =
        XML_Parse(parser_.get(), text_.data() + from, static_cast<int>(size), last);
    if (failure_) {
      std::rethrow_exception(failure_);
    }
    if (status == XML_STATUS_OK || fault_.kind != SyntaxFault::none) {
      return fault_.kind == SyntaxFault::none;
    }
    const XML_Error error = XML_GetErrorCode(parser_.get());
    if (error == XML_ERROR_NO_MEMORY) {
      throw std::bad_alloc();
    }
    fault_ = {fault_of(error), current(), XML_ErrorString(error)};
    return false;
  }

  bool is_over_limit(std::string_view unfinished) const {
    XmlToken token;
    return unfinished.size() >= max_markup_bytes ||
           (XmlScanner(unfinished).next(token) && limit_fault(token, limits_));
  }

  std::size_t current() const {
    // Expat returns -1 before the first event.
    return static_cast<std::size_t>(std::max<XML_Index>(XML_GetCurrentByteIndex(parser_.get()), 0));
  }

  std::string_view text_;
  const Limits& limits_;
  Diagnostics& diagnostics_;
  std::unique_ptr<XML_ParserStruct, ParserFree> parser_;
  XmlFault fault_;
  std::exception_ptr failure_;
};

}  // namespace

XmlFault find_fault(std::string_view text, const Limits& limits, Diagnostics& diagnostics) {
  return Judge(text, limits, diagnostics).run();
}

std::optional<LimitFault> limit_fault(const XmlToken& token, const Limits& limits) {
  if (token.kind == XmlTokenKind::text || token.kind == XmlTokenKind::cdata) {
    return std::nullopt;
  }
  if (token.attributes.size() <= limits.attributes &&
      token.written.size() <=
          std::min<std::size_t>({limits.name_bytes, limits.value_bytes, max_markup_bytes - 1})) {
    return std::nullopt;  // the usual case
  }
  const auto name_too_long = [&] {
    return LimitFault{&"xml.length-limit"_code,
                      fmt::format("a name in <{}> is longer than the limit of {} bytes",
                                  escaped(token.name, 40), limits.name_bytes)};
  };
  if (token.name.size() > limits.name_bytes) {
    return name_too_long();
  }
  for (std::size_t i = 0; i < token.attributes.size(); ++i) {
    const XmlAttribute& attribute = token.attributes[i];
    if (i >= limits.attributes) {
      return LimitFault{&"xml.attribute-limit"_code,
                        fmt::format("<{}> has more attributes than the limit of {}",
                                    escaped(token.name, 40), limits.attributes)};
    }
    if (attribute.name.size() > limits.name_bytes) {
      return name_too_long();
    }
    if (attribute.value.size() > limits.value_bytes) {
      return LimitFault{
          &"xml.length-limit"_code,
          fmt::format("attribute {} of <{}> is longer than the limit of {} bytes",
                      escaped(attribute.name, 40), escaped(token.name, 40), limits.value_bytes)};
    }
  }
  if (token.written.size() >= max_markup_bytes) {
    return LimitFault{&"xml.length-limit"_code, too_long()};
  }
  return std::nullopt;
}

}  // namespace scenefile
