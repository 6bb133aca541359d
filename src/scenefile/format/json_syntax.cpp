#include "scenefile/format/json_syntax.h"

#include "scenefile/base/ascii.h"
#include "scenefile/base/number.h"
#include "scenefile/base/suggest.h"
#include "scenefile/base/text.h"
#include "scenefile/format/codes.h"
#include "scenefile/format/scene_text.h"
#include "scenefile/format/text_places.h"
#include "scenefile/format/xml_scanner.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>

namespace scenefile {

namespace {

bool is_bare_word(char c) {
  return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' ||
         c == '.' || c == '+' || c == '-';
}

// How to overwrite a fault so that reading can continue after it.
struct Repair {
  std::size_t offset = 0;
  std::string text;        // replaces as many bytes; empty: cannot continue
  bool is_number = false;  // replaces an unknown number
};

struct Finding {
  const Code* code = &"json.syntax"_code;
  std::size_t offset = 0;
  std::string message;
  Repair repair;
  std::optional<Correction> correction;
};

// An exponent such as e12 or E-3, possibly incomplete: e, e+.
bool is_exponent(std::string_view text) {
  text.remove_prefix(std::min<std::size_t>(text.size(), 1));
  text.remove_prefix(text.starts_with('+') || text.starts_with('-') ? 1 : 0);
  return std::all_of(text.begin(), text.end(), is_digit);
}

// The intended number, if it is clear. Keeps the author's spelling if only digits are missing.
std::string corrected_number(std::string_view word) {
  constexpr std::size_t longest = 40;
  const bool minus = word.starts_with('-');
  const std::string_view plain = word.substr(minus || word.starts_with('+') ? 1 : 0);
  const std::size_t mantissa_end = std::min(plain.find_first_of("eE"), plain.size());
  const std::string_view mantissa = plain.substr(0, mantissa_end);
  std::string_view exponent = plain.substr(mantissa_end);
  const std::size_t point = std::min(mantissa.find('.'), mantissa.size());
  std::string_view whole = mantissa.substr(0, point);
  const std::string_view fraction = mantissa.substr(std::min(point + 1, mantissa.size()));
  const auto only_digits = [](std::string_view s) {
    return std::all_of(s.begin(), s.end(), is_digit);
  };
  const bool digits =
      only_digits(whole) && only_digits(fraction) && !(whole.empty() && fraction.empty());
  if (!digits || !is_exponent(exponent) || word.size() > longest) {
    return nearest_number(word);
  }
  if (exponent.find_first_of("0123456789") == std::string_view::npos) {
    exponent = {};
  }
  whole.remove_prefix(std::min(whole.find_first_not_of('0'), whole.size()));
  return fmt::format("{}{}.{}{}", minus ? "-" : "", whole.empty() ? "0" : whole,
                     fraction.empty() ? "0" : fraction, exponent);
}

// Explains a fault by the first rule that applies.
class Explainer {
 public:
  Explainer(const JsonError& error, const RepairedJson& repaired, std::string_view text,
            const Limits& limits)
      : error_(error),
        repaired_(repaired),
        text_(repaired.text),
        limits_(limits),
        places_(text),
        at_(error.offset) {}

  Finding explain() {
    Finding finding;
    finding.offset = at_;
    (void)(by_limit(finding) || by_conflict(finding) || by_end(finding) || by_string(finding) ||
           by_comment(finding) || by_number(finding) || by_decimal_comma(finding) ||
           by_comma(finding) || by_quotes(finding) || by_bracket(finding) ||
           by_expectation(finding));
    return finding;
  }

  Location place(std::size_t offset) { return places_.at(repaired_.original_offset(offset)); }

 private:
  char found() const { return at_ < text_.size() ? text_[at_] : '\0'; }

  // The offset of the last character before the fault that is not white space; npos if there is
  // none.
  std::size_t before() const {
    return at_ == 0 ? at_ - 1 : text_.find_last_not_of(blanks, at_ - 1);
  }

  std::string_view word_around() const {
    std::size_t first = std::min(at_, text_.size());
    std::size_t last = first;
    while (first > 0 && is_bare_word(text_[first - 1])) {
      --first;
    }
    while (last < text_.size() && is_bare_word(text_[last])) {
      ++last;
    }
    return text_.substr(first, last - first);
  }

  std::string found_text() const {
    const bool inside = at_ < text_.size() && is_bare_word(text_[at_]);
    const std::string_view word = inside ? word_around() : std::string_view();
    return word.empty() ? quoted(text_.substr(at_, first_code_point(text_.substr(at_)).bytes))
                        : quoted(word);
  }

  bool by_limit(Finding& f) {
    if (error_.fault != JsonFault::too_deep) {
      return false;
    }
    f.code = &"json.limit"_code;
    f.message = fmt::format("arrays and objects are nested deeper than the limit of {} levels",
                            limits_.nesting);
    return true;
  }

  bool by_conflict(Finding& f) {
    const std::size_t end = at_ == 0 ? std::string_view::npos : text_.find_last_of("\r\n", at_ - 1);
    const std::size_t start = end == std::string_view::npos ? 0 : end + 1;
    const std::string_view line = text_.substr(start, text_.find_first_of("\r\n", start) - start);
    for (const std::string_view marker : {"<<<<<<<", "=======", ">>>>>>>", "|||||||"}) {
      if (line.starts_with(marker)) {
        f.code = &"json.conflict-marker"_code;
        f.offset = start;
        f.message = fmt::format(
            "git conflict marker {}: keep one of the two versions and remove "
            "the lines of <<<<<<<, ======= and >>>>>>>",
            escaped(line, 40));
        return true;
      }
    }
    return false;
  }

  bool by_end(Finding& f) {
    if (at_ < text_.size()) {
      return false;
    }
    f.code = &"json.truncated"_code;
    if (error_.open.empty()) {
      f.message = error_.fault == JsonFault::empty ? "there is no JSON value in the file"
                                                   : "the file ends in the middle of a value";
      return true;
    }
    const std::size_t open = error_.open.back();
    const bool object = text_[open] == '{';
    f.message = fmt::format(
        "the file ends inside the {} that begins at line {}, column {}; its "
        "closing {} is missing",
        object ? "object" : "array", place(open).line, place(open).column, object ? '}' : ']');
    return true;
  }

  bool by_string(Finding& f) {
    f.code = &"json.string"_code;
    switch (error_.fault) {
      case JsonFault::control_character:
        f.message = found() == '\n' || found() == '\r'
                        ? "the line ends inside a string: the closing quote is missing"
                        : fmt::format(
                              "the character {} inside a string must be written as an "
                              "escape such as \\t or \\u0009",
                              quoted(text_.substr(at_, 1)));
        return true;
      case JsonFault::escape:
        f.message = fmt::format("unknown escape {} in a string; a backslash itself is written \\\\",
                                quoted(text_.substr(at_, text_.substr(at_, 2) == "\\u" ? 6 : 2)));
        return true;
      case JsonFault::surrogate:
        f.message =
            "a string contains half of a surrogate pair (\\ud800 to \\udfff), which is not a "
            "character; write both halves, or the character itself";
        return true;
      case JsonFault::encoding:
        f.code = &"format.encoding"_code;
        f.message = fmt::format("the byte {} is not UTF-8; save the file as UTF-8",
                                quoted(text_.substr(at_, 1)));
        return true;
      default:
        f.code = &"json.syntax"_code;
        return false;
    }
  }

  bool by_comment(Finding& f) {
    const std::string_view two = text_.substr(at_, 2);
    if (two != "//" && two != "/*" && found() != '#') {
      return false;
    }
    f.code = &"json.comment"_code;
    f.message =
        fmt::format("JSON has no comments; remove what follows {}", found() == '#' ? "#" : two);
    const std::size_t end =
        two == "/*" ? text_.find("*/", at_ + 2) : text_.find_first_of("\r\n", at_);
    if (end != std::string_view::npos) {
      f.repair = {at_, std::string(end - at_ + (two == "/*" ? 2 : 0), ' ')};
    }
    return true;
  }

  bool by_comma(Finding& f) {
    const std::size_t previous = before();
    const bool after_comma = previous != std::string_view::npos && text_[previous] == ',';
    if (after_comma && (found() == '}' || found() == ']')) {
      f.code = &"json.trailing-comma"_code;
      f.offset = previous;
      f.message = fmt::format("comma before the closing {}; remove it, or write what should follow",
                              found());
      f.repair = {previous, " "};
      f.correction = Correction{",", ""};
      return true;
    }
    if (found() == ',' && (error_.fault == JsonFault::value || error_.fault == JsonFault::key)) {
      f.message = after_comma ? "two commas in a row; remove one, or write what is missing between"
                              : "a comma before the first member or element; remove it";
      f.repair = {at_, " "};
      f.correction = Correction{",", "", !after_comma};
      return true;
    }
    return false;
  }

  bool by_number(Finding& f) {
    const std::string_view word = word_around();
    if (error_.fault == JsonFault::number_too_large) {
      f.code = &"json.number-range"_code;
      f.message = fmt::format("the number {} is too large", quoted(word));
      return true;
    }
    if (!is_about_number(word)) {
      return false;
    }
    f.code = &"json.number"_code;
    f.offset = static_cast<std::size_t>(word.data() - text_.data());
    if (is_special(word)) {
      f.message = fmt::format("JSON has no {}; write a number", quoted(word));
    } else {
      explain_number(word, f);
    }
    f.repair = {f.offset, fmt::format("{:<{}}", 0, word.size()), true};
    return true;
  }

  static void explain_number(std::string_view word, Finding& f) {
    const std::string meant = corrected_number(word);
    f.message = fmt::format("{} is not a JSON number{}", quoted(word),
                            meant.empty() ? meant : fmt::format("; write {}", meant));
    f.correction = number_correction(word, meant);
  }

  // Whether the fault is inside a word that was meant as a number.
  bool is_about_number(std::string_view word) const {
    if (word.empty() || error_.fault == JsonFault::number) {
      return error_.fault == JsonFault::number;
    }
    const auto first = static_cast<std::size_t>(word.data() - text_.data());
    const bool at_word_end = at_ == first + word.size() && word != "-";
    const bool comma =
        error_.fault == JsonFault::array_comma || error_.fault == JsonFault::object_comma;
    if (at_word_end || !(error_.fault == JsonFault::value || (comma && at_ != first))) {
      return false;
    }
    const bool digits = std::any_of(word.begin(), word.end(), is_digit);
    return is_special(word) || word == "-" ||
           (digits && (is_digit(word[0]) || word.find_first_of("+-.") == 0));
  }

  static bool is_special(std::string_view word) {
    const std::string lower = lower_case(word.substr(word.find_first_of("+-") == 0 ? 1 : 0));
    return lower == "nan" || lower == "inf" || lower == "infinity";
  }

  // "angle": 1,5
  bool by_decimal_comma(Finding& f) {
    const std::string_view word = word_around();
    const std::size_t comma = at_ - 1;
    const bool digits = !word.empty() && std::all_of(word.begin(), word.end(), is_digit);
    if (error_.fault != JsonFault::key || !digits || at_ < 2 || text_[comma] != ',' ||
        !is_digit(text_[comma - 1])) {
      return false;
    }
    const std::size_t before = text_.find_last_not_of("+-.0123456789", comma - 1) + 1;
    const std::string_view number = text_.substr(before, at_ + word.size() - before);
    f.code = &"json.number"_code;
    f.offset = before;
    explain_number(number, f);
    f.repair = {before, fmt::format("{:<{}}", 0, number.size()), true};
    return true;
  }

  bool by_quotes(Finding& f) {
    const std::string_view word = word_around();
    if (found() == '\'') {
      f.message = "strings and keys must be in double quotes, not in single quotes";
      f.repair = {at_, in_double_quotes()};
      if (const std::size_t size = f.repair.text.size(); size > 1) {
        const std::string_view string = text_.substr(at_ + 1, size - 2);
        f.correction = correction(string, string);
      }
    } else if (!word.empty() && error_.fault == JsonFault::key) {
      const std::size_t before = text_.find_last_not_of(" \t\r\n", at_ == 0 ? 0 : at_ - 1);
      const bool is_list = before != std::string_view::npos && text_[before] == '{' &&
                           parse_number(word).error == NumberError::none;
      f.message = is_list ? std::string("numbers in { }; a list of numbers is written in [ ]")
                          : fmt::format("the key {} must be in double quotes", quoted(word));
      if (!is_list && word.data() == text_.data() + at_) {
        f.correction = correction(word, word);
      }
    } else if (!word.empty() && error_.fault == JsonFault::value) {
      f.offset = static_cast<std::size_t>(word.data() - text_.data());
      explain_word(word, f);
    } else {
      return false;
    }
    return true;
  }

  // The contents of single quotes at the fault, if they can be a string.
  std::string in_double_quotes() const {
    const std::size_t end = text_.find_first_of("'\"\\\r\n", at_ + 1);
    if (end == std::string_view::npos || text_[end] != '\'') {
      return {};
    }
    return fmt::format("\"{}\"", text_.substr(at_ + 1, end - at_ - 1));
  }

  static void explain_word(std::string_view word, Finding& f) {
    constexpr std::pair<std::string_view, std::string_view> spellings[] = {
        {"True", "true"}, {"TRUE", "true"}, {"False", "false"}, {"FALSE", "false"},
        {"None", "null"}, {"NULL", "null"}, {"Null", "null"},   {"nil", "null"}};
    for (const auto& [wrong, right] : spellings) {
      if (word == wrong) {
        f.message = fmt::format("{} is written {} in JSON", wrong, right);
        f.correction = correction(word, right);
        return;
      }
    }
    f.message = fmt::format("{} is not a value; strings must be in double quotes", quoted(word));
    f.correction = correction(word, word);
  }

  bool by_bracket(Finding& f) {
    if (error_.open.empty()) {
      return false;
    }
    const std::size_t open = error_.open.back();
    const bool object = text_[open] == '{';
    const Location at_open = place(open);
    if (found() == (object ? ']' : '}')) {
      f.message = fmt::format(
          "the {} that begins at line {}, column {} is closed by {}; {} is "
          "missing or one of them is too many",
          object ? "object" : "array", at_open.line, at_open.column, found(), object ? '}' : ']');
      return true;
    }
    if (!object && found() == ':') {
      f.message = fmt::format(
          "a key inside the array that begins at line {}, column {}; the {{ in "
          "front of it is missing",
          at_open.line, at_open.column);
      return true;
    }
    return false;
  }

  bool by_expectation(Finding& f) {
    f.message = fmt::format("expected {}, found {}", expected(), found_text());
    if (found() == '\0') {
      f.message = "a NUL byte; the file is damaged";
    } else if (error_.fault == JsonFault::after_end) {
      f.code = &"json.after-end"_code;
      f.message = fmt::format("{} follows the end of the scene", found_text());
    } else if (error_.fault == JsonFault::colon && found() == '=') {
      f.message = "a key is followed by a colon, not by =";
      f.repair = {at_, ":"};
      f.correction = Correction{"=", ":"};
    } else if (found() == ';') {
      f.message = "members and elements are separated by commas, not by semicolons";
      f.repair = {at_, ","};
      f.correction = Correction{";", ","};
    } else if (std::string_view("+-*/^").find(found()) != std::string_view::npos) {
      f.message = "JSON does not calculate; write the result";
    } else if (const std::size_t mark = typographic_quote(text_.substr(at_)); mark != 0) {
      f.message = "a typographic quotation mark, as word processors insert it; use \"";
      straighten(mark, f);
    } else if (const std::string hint = bracket_hint(); !hint.empty()) {
      f.message = hint;
    } else if (lacks_comma()) {
      f.offset = before();
      f.message = "expected a comma after this";
      f.repair = {at_ - 1, ","};
      const std::string last(1, text_[f.offset]);
      f.correction = Correction{last, last + ","};
    }
    return true;
  }

  std::string bracket_hint() const {
    const std::size_t previous = before();
    const bool behind_quote = previous != std::string_view::npos && text_[previous] == '"';
    if (found() == '(') {
      return "an array is written in square brackets, [ ]";
    }
    if (found() == '{' && error_.fault == JsonFault::key) {
      return "an object inside an object needs a key; a list of objects is written in [ ]";
    }
    if (behind_quote && is_bare_word(found()) && error_.fault == JsonFault::object_comma) {
      return fmt::format(
          "{} right after a quotation mark: an earlier string is missing its closing one",
          found_text());
    }
    const CodePoint c = first_code_point(text_.substr(at_));
    if (is_odd_blank(c.value)) {
      return odd_blank_text(c.value);
    }
    return {};
  }

  // Corrects what is in typographic marks, if a string could be in their place.
  void straighten(std::size_t mark, Finding& f) const {
    const std::size_t first = at_ + mark;
    std::size_t end = first;
    while (end < text_.size() && static_cast<unsigned char>(text_[end]) >= ' ' &&
           text_[end] != '"' && text_[end] != '\\' && typographic_quote(text_.substr(end)) == 0) {
      ++end;
    }
    const std::size_t after = end + typographic_quote(text_.substr(end));
    const bool closed = after != end && text_.find_first_of(" \t\r\n:,]}", after) == after;
    const bool expected = error_.fault == JsonFault::key || error_.fault == JsonFault::value;
    if (closed && expected && end != first) {
      const std::string string = fmt::format("\"{}\"", text_.substr(first, end - first));
      f.repair = {at_, fmt::format("{}{:{}}", string, "", after - at_ - string.size())};
      f.correction = Correction{std::string(text_.substr(at_, after - at_)), string};
    }
  }

  // Whether more follows after white space, as if a comma were missing.
  bool lacks_comma() const {
    const bool in_object = error_.fault == JsonFault::object_comma;
    const bool in_array = error_.fault == JsonFault::array_comma;
    const std::string_view starts = in_object ? "\"" : "\"[{-0123456789";
    return (in_object || in_array) && starts.find(found()) != std::string_view::npos && at_ > 0 &&
           blanks.find(text_[at_ - 1]) != std::string_view::npos;
  }

  std::string_view expected() const {
    switch (error_.fault) {
      case JsonFault::key:
        return "a key in double quotes";
      case JsonFault::colon:
        return "a colon after the key";
      case JsonFault::object_comma:
        return "a comma or } after the member";
      case JsonFault::array_comma:
        return "a comma or ] after the element";
      default:
        return "a value";
    }
  }

  const JsonError& error_;
  const RepairedJson& repaired_;
  std::string_view text_;
  const Limits& limits_;
  TextPlaces places_;
  std::size_t at_;
};

void write_over(const Repair& repair, RepairedJson& repaired) {
  repaired.text.replace(repair.offset, repair.text.size(), repair.text);
  if (repair.is_number) {
    const auto at =
        std::lower_bound(repaired.unknown.begin(), repaired.unknown.end(), repair.offset);
    repaired.unknown.insert(at, repair.offset);
  }
}

// Writes numbers without a digit next to their point as JSON.
class NumberRepair {
 public:
  NumberRepair(std::string_view text, Diagnostics& diagnostics)
      : text_(text), diagnostics_(diagnostics), places_(text) {}

  RepairedJson run() {
    bool in_string = false;
    for (std::size_t at = 0; at < text_.size(); ++at) {
      const char c = text_[at];
      if (c == '.' && !in_string) {
        copy_point(at);
        continue;
      }
      result_.text += c;
      if (in_string && c == '\\' && at + 1 < text_.size()) {
        result_.text += text_[++at];
      } else if (c == '"') {
        in_string = !in_string;
      }
    }
    return std::move(result_);
  }

 private:
  // A decimal point needs a digit on each side; adds the missing one.
  void copy_point(std::size_t at) {
    const bool before = at > 0 && is_digit(text_[at - 1]);
    const bool after = at + 1 < text_.size() && is_digit(text_[at + 1]);
    if (!before && after) {
      insert_zero();
    }
    result_.text += '.';
    if (before && !after) {
      insert_zero();
    }
    if (before != after) {
      const std::string_view part = text_.substr(before ? at - 1 : at, 2);
      diagnostics_.add({&"json.number"_code,
                        Severity::warning,
                        places_.at(at),
                        {},
                        fmt::format("a number with {} is not JSON; it is read with a zero {} the "
                                    "point, as by the course's programs",
                                    quoted(part), before ? "after" : "before"),
                        {},
                        Correction{".", before ? ".0" : "0."}});
    }
  }

  void insert_zero() {
    result_.inserted.push_back(result_.text.size());
    result_.text += '0';
  }

  std::string_view text_;
  Diagnostics& diagnostics_;
  TextPlaces places_;
  RepairedJson result_;
};

}  // namespace

std::size_t RepairedJson::original_offset(std::size_t offset) const {
  const auto first_after = std::lower_bound(inserted.begin(), inserted.end(), offset);
  return offset - static_cast<std::size_t>(first_after - inserted.begin());
}

RepairedJson repair_json_numbers(std::string_view text, Diagnostics& diagnostics) {
  return NumberRepair(text, diagnostics).run();
}

void report_json_error(const JsonError& error, std::string_view text, const Limits& limits,
                       Diagnostics& diagnostics) {
  const RepairedJson as_written{std::string(text), {}, {}};
  Explainer explainer(error, as_written, text, limits);
  Finding finding = explainer.explain();
  diagnostics.report(*finding.code, explainer.place(finding.offset), std::move(finding.message),
                     std::move(finding.correction));
}

bool recover_json(JsonError error, std::string_view text, const Limits& limits,
                  RepairedJson& repaired, JsonTape& tape, Diagnostics& diagnostics) {
  constexpr int max_faults = 50;
  if (repaired.text.empty()) {
    repaired.text = text;
  }
  struct {
    std::uint32_t line = 0;
    std::string message;
  } last;
  for (int fault = 0; error.fault != JsonFault::none; ++fault) {
    Explainer explainer(error, repaired, text, limits);
    Finding finding = explainer.explain();
    const Location place = explainer.place(finding.offset);
    if (place.line != last.line || finding.message != last.message || finding.correction) {
      diagnostics.report(*finding.code, place, finding.message, std::move(finding.correction));
    }
    last = {place.line, std::move(finding.message)};
    if (finding.repair.text.empty() || fault == max_faults) {
      return false;
    }
    write_over(finding.repair, repaired);
    error = parse_json(repaired.text, limits.nesting, tape);
  }
  return true;
}

}  // namespace scenefile
