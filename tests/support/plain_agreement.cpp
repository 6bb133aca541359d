#include "support/plain_agreement.h"

#include "scenefile/format/xml_reader.h"

#include <fmt/format.h>

namespace scenefile::testing {

namespace {

// Records all events.
class Log : public XmlHandler {
 public:
  explicit Log(const TextCursor& places) : places_(places) {}

  bool start(const XmlTag& tag) override {
    said += fmt::format("{}:{} {:.6f} <{}", tag.location.line, tag.location.column,
                        places_.progress(), tag.name);
    for (const XmlAttribute& attribute : tag.attributes) {
      said += fmt::format(" {}=[{}]", attribute.name, attribute.value);
    }
    said += ">\n";
    return tag.name != "stop";
  }
  void end() override { said += "end\n"; }
  void text(std::string_view characters, Location) override {
    said += fmt::format("text {}\n", characters);
  }

  std::string said;

 private:
  const TextCursor& places_;
};

}  // namespace

Told plain_events(std::string_view text, const Limits& limits) {
  TextCursor places(text);
  Log log(places);
  const PlainEnd end = read_plain_events(text, limits, places, log);
  return {end, log.said};
}

bool agrees_with_expat(std::string_view text, const Limits& limits) {
  const Told told = plain_events(text, limits);
  if (told.end == PlainEnd::not_plain) {
    return true;
  }
  TextCursor places(text);
  Log log(places);
  Diagnostics diagnostics;
  const bool whole = read_events(text, limits, places, log, diagnostics);
  return whole == (told.end == PlainEnd::complete) && log.said == told.said &&
         diagnostics.list().empty();
}

}  // namespace scenefile::testing
