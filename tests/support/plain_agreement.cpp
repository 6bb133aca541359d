#include "support/plain_agreement.h"

#include "scenefile/format/codes.h"

#include <expat.h>
#include <fmt/format.h>

#include <algorithm>
#include <string>

namespace scenefile::testing {

namespace {

// Records all events.
class Log : public XmlHandler {
 public:
  bool start(const XmlTag& tag) override {
    said += fmt::format("{}:{} <{}", tag.location.line, tag.location.column, tag.name);
    for (const XmlAttribute& attribute : tag.attributes) {
      said += fmt::format(" {}=[{}]", attribute.name, attribute.value);
    }
    said += ">\n";
    return tag.name != "stop";
  }
  void end() override { said += "end\n"; }
  void text(std::string_view, Location location) override {
    said += fmt::format("{}:{} text\n", location.line, location.column);
  }

  std::string said;
};

// The same record, made by Expat.
class ExpatLog {
 public:
  explicit ExpatLog(std::string_view text) : places_(text) {
    parser_ = XML_ParserCreate("UTF-8");
    XML_SetUserData(parser_, this);
    XML_SetElementHandler(
        parser_,
        [](void* self, const XML_Char* name, const XML_Char** attributes) {
          static_cast<ExpatLog*>(self)->start(name, attributes);
        },
        [](void* self, const XML_Char*) {
          static_cast<ExpatLog*>(self)->in_text_ = false;
          static_cast<ExpatLog*>(self)->said += "end\n";
        });
    XML_SetCharacterDataHandler(parser_, [](void* self, const XML_Char* characters, int length) {
      static_cast<ExpatLog*>(self)->text({characters, static_cast<std::size_t>(length)});
    });
    XML_SetCommentHandler(parser_, [](void* self, const XML_Char*) {
      static_cast<ExpatLog*>(self)->in_text_ = false;
    });
    const auto border = [](void* self) { static_cast<ExpatLog*>(self)->in_text_ = false; };
    XML_SetCdataSectionHandler(parser_, border, border);
    XML_SetProcessingInstructionHandler(parser_, [](void* self, const XML_Char*, const XML_Char*) {
      static_cast<ExpatLog*>(self)->in_text_ = false;
    });
    failed = XML_Parse(parser_, text.data(), static_cast<int>(text.size()), 1) != XML_STATUS_OK &&
             !stopped_;
  }
  ExpatLog(const ExpatLog&) = delete;
  ExpatLog& operator=(const ExpatLog&) = delete;
  ~ExpatLog() { XML_ParserFree(parser_); }

  std::string said;
  bool failed = false;

 private:
  Location place(std::size_t offset) {
    return places_.at(static_cast<std::size_t>(XML_GetCurrentByteIndex(parser_)) + offset);
  }

  void start(std::string_view name, const XML_Char** attributes) {
    if (stopped_) {
      return;
    }
    in_text_ = false;
    said += fmt::format("{}:{} <{}", place(0).line, place(0).column, name);
    for (; *attributes != nullptr; attributes += 2) {
      said += fmt::format(" {}=[{}]", attributes[0], attributes[1]);
    }
    said += ">\n";
    if (name == "stop") {
      stopped_ = true;
      XML_SetElementHandler(parser_, nullptr, nullptr);
      XML_StopParser(parser_, XML_FALSE);
    }
  }

  // Only the first part that is not blank.
  void text(std::string_view part) {
    const std::size_t first = part.find_first_not_of(" \t\r\n");
    if (!in_text_ && !stopped_ && first != std::string_view::npos) {
      in_text_ = true;
      said += fmt::format("{}:{} text\n", place(first).line, place(first).column);
    }
  }

  TextPlaces places_;
  XML_Parser parser_ = nullptr;
  bool in_text_ = false;
  bool stopped_ = false;
};

// Whether there was a mistake after which our reader goes on where Expat stops.
bool has_repair(const Diagnostics& diagnostics) {
  return std::any_of(diagnostics.list().begin(), diagnostics.list().end(), [](const Diagnostic& d) {
    return d.code == &"xml.syntax"_code &&
           (d.message.find("; write ") != std::string::npos ||
            d.message.find("; did you mean </") != std::string::npos);
  });
}

}  // namespace

Told events_of(std::string_view text, const Limits& limits) {
  TextPlaces places(text);
  Log log;
  Diagnostics diagnostics;
  const ReadOptions options{false, limits};
  const XmlReading reading = read_events(text, options, places, log, diagnostics);
  return {reading, log.said, diagnostics};
}

bool agrees_with_expat(std::string_view text, const Limits& limits) {
  using namespace std::string_view_literals;
  const Told told = events_of(text, limits);
  if (text.starts_with("<\0"sv)) {
    return !told.reading.complete;  // Expat takes it for UTF-16, which decode_text() converts first
  }
  const ExpatLog expat(text);
  if (told.diagnostics.list().empty()) {
    return !expat.failed && told.said == expat.said;
  }
  if (has_repair(told.diagnostics)) {
    return expat.failed && told.said.starts_with(expat.said);
  }
  const Code* const code = told.diagnostics.list().front().code;
  if (code == &"xml.syntax"_code || code == &"xml.conflict-marker"_code) {
    return expat.failed && told.said == expat.said && !told.reading.complete;
  }
  return code == &"xml.comment"_code || expat.said.starts_with(told.said);
}

}  // namespace scenefile::testing
