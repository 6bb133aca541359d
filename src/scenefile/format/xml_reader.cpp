#include "scenefile/format/xml_reader.h"

#include "scenefile/base/ascii.h"
#include "scenefile/base/text.h"
#include "scenefile/format/codes.h"
#include "scenefile/format/write_text.h"
#include "scenefile/format/xml_judge.h"
#include "scenefile/format/xml_syntax.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace scenefile {

namespace {

constexpr std::string_view cdata_start = "<![CDATA[";
constexpr std::string_view cdata_end = "]]>";

std::string_view reference_at(std::string_view text, std::size_t at) {
  return text.substr(at, text.find(';', at) + 1 - at);
}

class EventReader {
 public:
  EventReader(std::string_view text, const ReadOptions& options, TextPlaces& places,
              XmlHandler& handler, Diagnostics& diagnostics)
      : text_(text),
        options_(options),
        places_(places),
        handler_(handler),
        diagnostics_(diagnostics) {}

  XmlReading run();

 private:
  bool is_plain() const;
  void ask_expat();
  bool fail();
  bool refuse(const Code& code, const char* at, std::string message);
  bool read_token();
  bool read_start();
  bool read_text(std::string_view written);
  bool decode_values();
  void close();

  std::string_view text_;
  const ReadOptions& options_;
  TextPlaces& places_;
  XmlHandler& handler_;
  Diagnostics& diagnostics_;
  XmlToken token_;
  std::vector<std::string_view> open_;  // the names of the open elements
  std::vector<std::string> decoded_;    // values of the current tag
  bool has_root_ = false;
  std::optional<XmlFault> fault_;        // what Expat found, once it was asked
  std::optional<std::string> repaired_;  // the text that Expat was given, if it is another
};

XmlReading EventReader::run() {
  XmlScanner scanner(text_);
  while (scanner.next(token_)) {
    if (!read_token()) {
      return {false, fault_.has_value()};
    }
  }
  if (!has_root_ || !open_.empty()) {
    ask_expat();
  }
  return {!fault_ || fault_->kind == SyntaxFault::none || fail(), fault_.has_value()};
}

// Whether the current token is well-formed at its place without a doubt.
bool EventReader::is_plain() const {
  switch (token_.kind) {
    case XmlTokenKind::start:
    case XmlTokenKind::empty:
      return token_.plain && !(open_.empty() && has_root_);
    case XmlTokenKind::end:
      return token_.plain && !open_.empty() && same_name(open_.back(), token_.name);
    case XmlTokenKind::text:
    case XmlTokenKind::comment:
    case XmlTokenKind::cdata:
    case XmlTokenKind::other:
      break;
  }
  return token_.plain;
}

void EventReader::ask_expat() {
  if (!fault_) {
    repaired_ = repair(text_, options_, diagnostics_);
    fault_ = find_fault(repaired_ ? *repaired_ : text_, options_.limits, diagnostics_);
  }
}

bool EventReader::fail() {
  if (fault_->kind == SyntaxFault::over_limit) {
    return refuse("xml.length-limit"_code, text_.data() + fault_->at, fault_->message);
  }
  std::vector<OpenElement> open;
  for (const std::string_view name : open_) {
    const auto at = static_cast<std::size_t>(name.data() - 1 - text_.data());
    open.push_back({name, places_.at(at), at});
  }
  report_syntax(*fault_, repaired_ ? *repaired_ : text_, open, places_, diagnostics_);
  return false;
}

bool EventReader::refuse(const Code& code, const char* at, std::string message) {
  diagnostics_.report(code, places_.at(at), std::move(message));
  return false;
}

// Returns false to stop.
bool EventReader::read_token() {
  if (!is_plain()) {
    ask_expat();
  }
  const std::string_view written = token_.written;
  const auto begin = static_cast<std::size_t>(written.data() - text_.data());
  const bool faulty = fault_ && begin + written.size() > fault_->at;
  if (token_.kind == XmlTokenKind::text || token_.kind == XmlTokenKind::cdata) {
    if (open_.empty()) {
      return fail();
    }
    if (!faulty) {
      return read_text(written);
    }
    std::string_view sound = written.substr(0, fault_->at - begin);
    if (sound.ends_with("]]") && written[sound.size()] == '>') {
      // Expat rejects ]]> with its whole line, or with the rest of it after a reference.
      sound = sound.substr(0, sound.find_last_of("\r\n;") + 1);
    }
    return read_text(sound) && fail();
  }
  if (faulty && fault_->kind != SyntaxFault::over_limit) {
    return fail();
  }
  if (const std::optional<LimitFault> limit = limit_fault(token_, options_.limits)) {
    return refuse(*limit->code, written.data(), limit->message);
  }
  if (faulty) {
    return fail();
  }
  switch (token_.kind) {
    case XmlTokenKind::start:
    case XmlTokenKind::empty:
      return read_start();
    case XmlTokenKind::end:
      if (!same_name(open_.back(), token_.name)) {
        report_end_case(token_, open_.back(), places_, diagnostics_);
      }
      close();
      break;
    case XmlTokenKind::text:
    case XmlTokenKind::comment:
    case XmlTokenKind::cdata:
    case XmlTokenKind::other:
      break;
  }
  return true;
}

bool EventReader::read_start() {
  if (token_.needs_decoding && !decode_values()) {
    return false;
  }
  const XmlTag tag{token_.name, token_.attributes, places_.at(token_.written.data())};
  if (open_.size() == options_.limits.nesting) {
    return refuse("xml.nesting-limit"_code, token_.written.data(),
                  fmt::format("<{}> is nested deeper than the limit of {} elements",
                              escaped(tag.name, 40), options_.limits.nesting));
  }
  if (token_.unquoted) {
    report_unquoted(token_, places_, diagnostics_);
  }
  has_root_ = true;
  open_.push_back(token_.name);
  if (!handler_.start(tag)) {
    return false;
  }
  if (token_.kind == XmlTokenKind::empty) {
    close();
  }
  return true;
}

// `written` may end within the current token.
bool EventReader::read_text(std::string_view written) {
  const bool has_references = token_.kind == XmlTokenKind::text;
  std::string_view text = written;
  if (!has_references) {
    text.remove_prefix(std::min(cdata_start.size(), text.size()));
    text.remove_suffix(text.ends_with(cdata_end) ? cdata_end.size() : 0);
  }
  const std::string_view line_border = has_references ? "\r\n&" : "\r\n";
  // Expat passes over undefined entities if the DOCTYPE names another file.
  const std::size_t entity = has_references ? find_entity_use(text) : std::string_view::npos;
  std::string_view rest = text.substr(0, entity);
  std::string line;
  const char* at = nullptr;
  while (line.empty() && !rest.empty()) {
    rest.remove_prefix(std::min(rest.find_first_not_of(blanks), rest.size()));
    at = rest.data();
    const bool is_reference = has_references && rest.starts_with('&');
    const std::string_view part =
        is_reference ? reference_at(rest, 0) : rest.substr(0, rest.find_first_of(line_border));
    line = is_reference && !part.empty() ? unescaped_xml(part) : part;
    line.resize(line.find_last_not_of(blanks) + 1);
    rest.remove_prefix(part.empty() ? rest.size() : part.size());
  }
  if (!line.empty()) {
    handler_.text(line, places_.at(at));
  }
  if (entity == std::string_view::npos) {
    return true;
  }
  const std::string_view name = text.substr(entity + 1);
  return refuse(
      "xml.entity"_code, text.data() + entity,
      fmt::format("the entity {} is not defined; only &lt; &gt; &amp; &quot; and &apos; are",
                  quoted(name.substr(0, name.find(';')))));
}

// Returns false after an error.
bool EventReader::decode_values() {
  if (const std::size_t entity = find_entity_use(token_.written); entity != token_.written.npos) {
    return refuse("xml.entity"_code, token_.written.data() + entity,
                  fmt::format("<{}> uses an entity that is not defined", escaped(token_.name, 40)));
  }
  decoded_.clear();
  for (const XmlAttribute& attribute : token_.attributes) {
    decoded_.push_back(decoded_value(attribute.value));
  }
  for (std::size_t i = 0; i < decoded_.size(); ++i) {
    token_.attributes[i].value = decoded_[i];
  }
  return true;
}

void EventReader::close() {
  open_.pop_back();
  handler_.end();
}

}  // namespace

std::string decoded_value(std::string_view value) {
  std::string text;
  for (std::size_t at = 0; at < value.size(); ++at) {
    const char c = value[at];
    if (c == '&') {
      const std::string_view reference = reference_at(value, at);
      text += unescaped_xml(reference);
      at += reference.size() - 1;
    } else if (c != '\r' || !value.substr(at).starts_with("\r\n")) {
      text += blanks.find(c) == std::string_view::npos ? c : ' ';
    }
  }
  return text;
}

XmlReading read_events(std::string_view text, const ReadOptions& options, TextPlaces& places,
                       XmlHandler& handler, Diagnostics& diagnostics) {
  return EventReader(text, options, places, handler, diagnostics).run();
}

}  // namespace scenefile
