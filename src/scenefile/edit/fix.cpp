#include "scenefile/edit/fix.h"

#include "scenefile/base/line_diff.h"
#include "scenefile/base/text.h"
#include "scenefile/edit/file_text.h"
#include "scenefile/format/codes.h"
#include "scenefile/format/json_parser.h"
#include "scenefile/format/write_scene.h"
#include "scenefile/format/write_text.h"
#include "scenefile/format/xml_scanner.h"
#include "scenefile/scene/check.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <span>
#include <string>
#include <tuple>
#include <utility>

namespace scenefile {

namespace {

using Changes = std::vector<TextChange>;

TextChange change_of(std::size_t at, std::size_t size, std::string text) {
  return {static_cast<std::uint32_t>(at), static_cast<std::uint32_t>(size), std::move(text)};
}

std::string as_xml_value(std::string_view value) {
  std::string text;
  append_xml(text, value);
  return text;
}

std::string as_json_string(std::string_view value) {
  std::string text;
  append_json(text, value);
  return text;
}

// Finds the word of a correction in XML.
class XmlFixer {
 public:
  XmlFixer(std::string_view text, std::size_t at, const Correction& correction)
      : text_(text), at_(at), written_(correction.written), instead_(correction.instead) {}

  Changes changes() const {
    if (text_[at_] == '&') {
      return written_ == "&" ? Changes{change_of(at_, 1, as_xml_value(instead_))} : Changes{};
    }
    const std::size_t open = text_.rfind('<', at_);
    XmlScanner scanner(text_.substr(std::min(open, text_.size())));
    XmlToken token;
    if (open == std::string_view::npos || !scanner.next(token)) {
      return {};
    }
    if (token.kind == XmlTokenKind::end) {
      return end_tag(token, open);
    }
    if (token.kind != XmlTokenKind::start && token.kind != XmlTokenKind::empty) {
      return {};
    }
    if (written_ == ">") {
      return {change_of(open + token.written.size() - 1, 1, instead_)};
    }
    if (at_ == open && token.name == written_) {
      return element(token, scanner);
    }
    for (const XmlAttribute& attribute : token.attributes) {
      if (attribute.value.data() == nullptr) {  // cut off
        continue;
      }
      const bool unquoted = token.unquoted && is_unquoted(attribute);
      const std::size_t start = value_start(attribute, unquoted);
      const bool here = at_ == open || attribute.name.data() == text_.data() + at_ || start == at_;
      // A tree may be named `name`: names that the format knows need no correction.
      const bool is_value =
          attribute.value == written_ || unescaped_xml(attribute.value) == written_;
      if (here && attribute.name == written_ && !is_value) {
        const std::size_t from = offset(attribute.name);
        const bool whole = instead_.find('"') != instead_.npos;  // attributes instead of this one
        const std::size_t end =
            whole ? offset(attribute.value) + attribute.value.size() + 1 : from + written_.size();
        return {change_of(from, end - from, instead_)};
      }
      if (here && is_value) {
        return value(attribute, unquoted);
      }
    }
    return {};
  }

 private:
  std::size_t offset(std::string_view part) const {
    return static_cast<std::size_t>(part.data() - text_.data());
  }

  // Where a value begins; if it is not in quotes, with what it has instead of them.
  std::size_t value_start(const XmlAttribute& attribute, bool unquoted) const {
    return offset(attribute.value) - (unquoted ? stray_marks(attribute).opening : 0);
  }

  Changes end_tag(const XmlToken& token, std::size_t open) const {
    if (token.name != written_) {
      return {};
    }
    return instead_.empty() ? Changes{change_of(open, token.written.size(), {})}
                            : Changes{change_of(offset(token.name), token.name.size(), instead_)};
  }

  // The name of an element and of its closing tag.
  Changes element(XmlToken& token, XmlScanner& scanner) const {
    Changes changes{change_of(offset(token.name), token.name.size(), instead_)};
    std::size_t depth = token.kind == XmlTokenKind::start ? 1 : 0;
    while (depth != 0 && scanner.next(token)) {
      depth += token.kind == XmlTokenKind::start ? 1 : 0;
      depth -= token.kind == XmlTokenKind::end ? 1 : 0;
    }
    if (token.kind == XmlTokenKind::end && token.name == written_) {
      changes.push_back(
          change_of(offset(token.name), token.name.size(), instead_.substr(0, instead_.find(' '))));
    }
    return changes;
  }

  Changes value(const XmlAttribute& attribute, bool unquoted) const {
    const std::size_t start = value_start(attribute, unquoted);
    if (unquoted) {
      const std::size_t end =
          offset(attribute.value) + attribute.value.size() + stray_marks(attribute).closing;
      return {change_of(start, end - start, '"' + as_xml_value(instead_) + '"')};
    }
    std::string text = as_xml_value(instead_);
    for (std::size_t i = 0; (i = text.find('\'', i)) != text.npos;) {
      text.replace(i, 1, "&apos;");
    }
    return {change_of(start, attribute.value.size(), std::move(text))};
  }

  std::string_view text_;
  std::size_t at_;
  const std::string& written_;
  const std::string& instead_;
};

// The string, with its quotes, that begins at the offset; empty if it does not end.
std::string_view json_string_at(std::string_view text, std::size_t at) {
  std::size_t end = at + 1;
  while (end < text.size() && text[end] != '"') {
    end += text[end] == '\\' ? 2 : 1;
  }
  return end < text.size() ? text.substr(at, end + 1 - at) : std::string_view();
}

// Where the value of a key begins; npos if there is none.
std::size_t value_of_key(std::string_view text, std::size_t at, std::string_view key) {
  return text.find_first_not_of(" \t\r\n:", at + key.size());
}

bool json_string_is(std::string_view string, std::string_view value) {
  JsonTape tape;
  return parse_json(string, 1, tape).fault == JsonFault::none && tape.string(0) == value;
}

// Finds the word of a correction in JSON: at the place, or in the value of the key there.
Changes json_changes(std::string_view text, std::size_t at, const Diagnostic& finding) {
  const std::string& written = finding.correction->written;
  const std::string& instead = finding.correction->instead;
  const std::string_view rest = text.substr(at);
  if (rest.starts_with(written)) {
    return {change_of(at, written.size(), written == instead ? as_json_string(instead) : instead)};
  }
  if (rest.starts_with('\'') && rest.substr(1).starts_with(written)) {
    return {change_of(at, written.size() + 2, as_json_string(instead))};
  }
  const auto replaced = [&](std::string_view string) {
    const bool number = finding.code == &"json.wrong-type"_code;
    return Changes{change_of(static_cast<std::size_t>(string.data() - text.data()), string.size(),
                             number ? instead : as_json_string(instead))};
  };
  const std::string_view key = rest.starts_with('"') ? json_string_at(text, at) : "";
  if (key.empty()) {
    return {};
  }
  const std::size_t value = value_of_key(text, at, key);
  const std::string_view string = value != std::string_view::npos && text[value] == '"'
                                      ? json_string_at(text, value)
                                      : std::string_view();
  if (!string.empty() && json_string_is(string, written)) {
    return replaced(string);
  }
  return json_string_is(key, written) ? replaced(key) : Changes{};
}

std::optional<Edit> edit_of(const FileText& file, const Diagnostic& finding) {
  if (!finding.correction || !finding.file.empty()) {
    return std::nullopt;
  }
  const Location place = finding.correction->place;
  const std::optional<std::size_t> at = file.offset(place.known() ? place : finding.location);
  if (!at || *at >= file.text().size()) {
    return std::nullopt;
  }
  Edit edit{file.is_xml() ? XmlFixer(file.text(), *at, *finding.correction).changes()
                          : json_changes(file.text(), *at, finding),
            std::nullopt};
  if (edit.changes.empty() || !file.to_bytes(edit)) {
    return std::nullopt;
  }
  sort_changes(edit.changes);
  return edit;
}

struct Reading {
  Scene scene;
  Diagnostics findings;
};

Reading read_and_check(std::string_view text, ReadOptions options) {
  // Findings that are not kept would look new when others are fixed.
  options.limits.messages_per_code = 100'000;
  options.limits.message_bytes = 64'000'000;
  Reading reading{{}, Diagnostics(options.limits)};
  reading.scene = read_scene(text, options, reading.findings);
  check(reading.scene, options.limits, reading.findings);
  return reading;
}

// Mistakes at which reading may stop.
bool is_syntax(const Diagnostic& finding) {
  constexpr const Code* codes[] = {
      &"xml.syntax"_code,   &"xml.comment"_code, &"xml.entity"_code,
      &"json.syntax"_code,  &"json.string"_code, &"json.trailing-comma"_code,
      &"json.comment"_code, &"json.number"_code, &"json.truncated"_code};
  return finding.severity == Severity::error &&
         std::find(std::begin(codes), std::end(codes), finding.code) != std::end(codes);
}

int rank_of(const Diagnostic& finding) {
  return is_syntax(finding) ? 0 : finding.severity == Severity::error ? 1 : 2;
}

using Place = std::pair<std::uint32_t, std::uint32_t>;  // line, column

Place place_of(const Diagnostic& finding) {
  return {finding.location.line, finding.location.column};
}

struct Candidate {
  const Diagnostic* finding;
  Edit edit;
};

// A mistake that is found only because an earlier one, at `stop`, was fixed.
bool is_later_mistake(const Diagnostic& finding, Place stop) {
  return stop != Place() && is_syntax(finding) && place_of(finding) > stop;
}

// Counts findings by what stays when other words of their line change.
class Tally {
 public:
  explicit Tally(const Reading& reading, Place stop = {}) {
    for (const Diagnostic& d : reading.findings.list()) {
      if (!is_later_mistake(d, stop)) {
        ++lines_[{d.code, d.location.line}];
        ++messages_[{d.code, d.location.line, d.message}];
      }
    }
  }
  std::size_t on_line(const Diagnostic& d) const {
    const auto found = lines_.find({d.code, d.location.line});
    return found == lines_.end() ? 0 : found->second;
  }
  std::size_t of_message(const Diagnostic& d) const {
    const auto found = messages_.find({d.code, d.location.line, d.message});
    return found == messages_.end() ? 0 : found->second;
  }

 private:
  std::map<std::pair<const Code*, std::uint32_t>, std::size_t> lines_;
  std::map<std::tuple<const Code*, std::uint32_t, std::string_view>, std::size_t> messages_;
};

// Where an edit has written: an error there is the edit's own.
class WrittenPlaces {
 public:
  WrittenPlaces(std::string_view text, const Edit& back) : file_(text), back_(back) {}

  // Whether the edit has written at the place of the error, or in the value of the JSON key there.
  bool have(const Diagnostic& d) const {
    const std::optional<std::size_t> at = file_.offset(d.location);
    if (d.severity != Severity::error || !at || *at >= file_.text().size()) {
      return false;
    }
    const std::string_view key = file_.text()[*at] == '"' && !file_.is_xml()
                                     ? json_string_at(file_.text(), *at)
                                     : std::string_view();
    return wrote(*at) || (!key.empty() && wrote(value_of_key(file_.text(), *at, key)));
  }

  // The place of a byte that was at `offset` before the edit; what the edit wrote there follows it.
  Place place(std::uint32_t offset, Edit edit) const {
    std::erase_if(edit.changes, [&](const TextChange& change) { return change.at >= offset; });
    const Location location = file_.location(moved(offset, edit));
    return {location.line, location.column};
  }

 private:
  bool wrote(std::size_t offset) const {
    return offset < file_.text().size() &&
           std::any_of(back_.changes.begin(), back_.changes.end(),
                       [at = file_.in_bytes(offset)](const TextChange& change) {
                         return at >= change.at && at <= change.at + change.size;
                       });
  }

  FileText file_;
  Edit back_;
};

// How many objects and lights differ; one that was added counts as one with all that it contains.
std::size_t count_changed_parts(const Scene& before, const Scene& after, SceneFormat format) {
  const SceneListing a = list_scene(before, format);
  const SceneListing b = list_scene(after, format);
  std::set<std::pair<std::uint32_t, std::string_view>> parts;
  for (const LineChange& change :
       line_changes(a.lines.size(), b.lines.size(),
                    [&](std::size_t i, std::size_t j) { return a.line(i) == b.line(j); })) {
    const ListedLine& line = change.removed != 0 ? a.lines[change.a] : b.lines[change.b];
    parts.insert({line.place.line, line.what});
  }
  return parts.size();
}

// Searches for the fixes of one text that can be made together.
class Round {
 public:
  Round(std::string_view text, const FileText& file, const Reading& reading,
        const ReadOptions& options)
      : text_(text), file_(file), reading_(reading), options_(options), before_(reading) {}

  // Adds all of the candidates that are right.
  void take(std::span<const Candidate> candidates) {
    if (candidates.empty() || reads_left_ == 0) {
      return;
    }
    --reads_left_;
    std::vector<Candidate> all = taken_;
    all.insert(all.end(), candidates.begin(), candidates.end());
    if (is_right(all)) {
      taken_ = std::move(all);
    } else if (candidates.size() > 1) {
      const std::size_t half = candidates.size() / 2;
      take(candidates.first(half));
      take(candidates.subspan(half));
    }
  }

  const std::vector<Candidate>& taken() const { return taken_; }

  static Edit together(std::span<const Candidate> candidates) {
    Edit edit;
    for (const Candidate& candidate : candidates) {
      edit.changes.insert(edit.changes.end(), candidate.edit.changes.begin(),
                          candidate.edit.changes.end());
    }
    sort_changes(edit.changes);
    edit.changes.erase(std::unique(edit.changes.begin(), edit.changes.end()), edit.changes.end());
    return edit;
  }

 private:
  bool is_right(std::span<const Candidate> candidates) const {
    const Edit edit = together(candidates);
    if (!fits(edit, text_.size())) {
      return false;
    }
    const std::string text = applied(text_, edit);
    const Reading after = read_and_check(text, options_);
    const WrittenPlaces written(text, inverse(text_, edit));
    return findings_are_right(candidates, after, written, last_stop(candidates, edit, written)) &&
           scene_is_right(candidates, after);
  }

  // Where reading last stopped, if it did, in the text after the edit.
  Place last_stop(std::span<const Candidate> candidates, const Edit& edit,
                  const WrittenPlaces& written) const {
    Location stop;
    for (const Candidate& candidate : candidates) {
      const Diagnostic& d = *candidate.finding;
      stop = is_syntax(d) && place_of(d) > Place(stop.line, stop.column) ? d.location : stop;
    }
    const std::optional<std::size_t> offset = file_.offset(stop);
    return offset ? written.place(file_.in_bytes(*offset), edit) : Place();
  }

  bool findings_are_right(std::span<const Candidate> candidates, const Reading& after,
                          const WrittenPlaces& written, Place stop) const {
    const Tally now(after, stop);
    std::map<std::tuple<const Code*, std::uint32_t, std::string_view>, std::size_t> fixed;
    for (const Candidate& candidate : candidates) {
      const Diagnostic& d = *candidate.finding;
      ++fixed[{d.code, d.location.line, d.message}];
    }
    const bool all_gone =
        std::all_of(candidates.begin(), candidates.end(), [&](const Candidate& candidate) {
          const Diagnostic& d = *candidate.finding;
          return now.of_message(d) + fixed[{d.code, d.location.line, d.message}] <=
                 before_.of_message(d);
        });
    const auto& list = after.findings.list();
    return all_gone && std::all_of(list.begin(), list.end(), [&](const Diagnostic& d) {
             if (written.have(d)) {
               return now.of_message(d) <= before_.of_message(d);
             }
             const bool revealed = d.code->kind == CodeKind::absence ||
                                   (stop != Place() && !is_syntax(d)) || is_later_mistake(d, stop);
             return revealed || now.on_line(d) <= before_.on_line(d);
           });
  }

  bool scene_is_right(std::span<const Candidate> candidates, const Reading& after) const {
    std::size_t errors = 0;
    for (const Candidate& candidate : candidates) {
      if (is_syntax(*candidate.finding)) {
        return true;  // the rest of the scene may not have been read
      }
      errors += candidate.finding->severity == Severity::error ? 1 : 0;
    }
    if (errors == 0) {
      return reading_.scene == after.scene;
    }
    const SceneFormat format = file_.is_xml() ? SceneFormat::xml : SceneFormat::json;
    return count_changed_parts(reading_.scene, after.scene, format) <= errors;
  }

  std::string_view text_;
  const FileText& file_;
  const Reading& reading_;
  const ReadOptions& options_;
  Tally before_;
  std::vector<Candidate> taken_;
  std::size_t reads_left_ = 200;
};

// Whether the edit changes the number of lines.
bool joins_lines(std::string_view text, const Edit& edit) {
  return std::any_of(edit.changes.begin(), edit.changes.end(), [&](const TextChange& change) {
    return text.substr(change.at, change.size).find_first_of("\r\n") != text.npos;
  });
}

bool has_certain_correction(const Diagnostic& d, const std::vector<std::string>& ignored) {
  return d.severity != Severity::note && d.correction && d.correction->certain &&
         std::find(ignored.begin(), ignored.end(), d.code->name) == ignored.end();
}

// The certain corrections of a text.
std::vector<Candidate> candidates_of(std::string_view text, const FileText& file,
                                     const Reading& reading,
                                     const std::vector<std::string>& ignored) {
  std::vector<Candidate> candidates;
  for (const Diagnostic& d : reading.findings.list()) {
    std::optional<Edit> edit = has_certain_correction(d, ignored) ? edit_of(file, d) : std::nullopt;
    if (edit && !joins_lines(text, *edit)) {
      candidates.push_back({&d, *std::move(edit)});
    }
  }
  return candidates;
}

// The place in the original text; `backs`: the inverses of the edits since then.
Location original_place(const FileText& original, const FileText& file, Location location,
                        const std::vector<Edit>& backs) {
  const std::optional<std::size_t> offset = file.offset(location);
  if (!offset) {
    return location;
  }
  std::uint32_t at = file.in_bytes(*offset);
  for (auto back = backs.rbegin(); back != backs.rend(); ++back) {
    at = moved(at, *back);
  }
  return original.location(at);
}

}  // namespace

std::optional<Edit> fix(std::string_view bytes, const Diagnostic& finding) {
  return edit_of(FileText(bytes), finding);
}

std::vector<std::vector<Replacement>> replacements(std::string_view bytes,
                                                   const std::vector<const Diagnostic*>& findings) {
  std::vector<std::vector<Replacement>> result(findings.size());
  std::optional<FileText> file;
  for (std::size_t i = 0; i < findings.size(); ++i) {
    if (!findings[i]->correction) {
      continue;
    }
    if (!file) {
      file.emplace(bytes);
    }
    if (std::optional<Edit> edit = edit_of(*file, *findings[i])) {
      for (TextChange& change : edit->changes) {
        result[i].push_back({file->location(change.at), file->location(change.at + change.size),
                             std::move(change.text)});
      }
    }
  }
  return result;
}

FixedText fix_text(std::string text, const ReadOptions& options,
                   const std::vector<std::string>& ignored) {
  constexpr int most_rounds = 100;
  const std::string before = text;
  const FileText original(before);
  FixedText fixed{std::move(text), {}, {}};
  std::vector<Edit> backs;
  for (int i = 0; i < most_rounds; ++i) {
    const FileText file(fixed.text);
    const Reading reading = read_and_check(fixed.text, options);
    const auto& list = reading.findings.list();
    if (file.text().empty() && std::any_of(list.begin(), list.end(), [&](const Diagnostic& d) {
          return has_certain_correction(d, ignored);
        })) {
      fixed.refused = utf16_refusal;
      break;
    }
    const std::vector<Candidate> candidates = candidates_of(fixed.text, file, reading, ignored);
    Round round(fixed.text, file, reading, options);
    // Mistakes at which reading may have stopped, other errors, which may change values, and
    // warnings, which may not, are not fixed together.
    for (const int rank : {0, 1, 2}) {
      std::vector<Candidate> some;
      std::copy_if(candidates.begin(), candidates.end(), std::back_inserter(some),
                   [&](const Candidate& c) { return rank_of(*c.finding) == rank; });
      round.take(some);
      if (!round.taken().empty()) {
        break;
      }
    }
    if (round.taken().empty()) {
      break;
    }
    for (const Candidate& candidate : round.taken()) {
      fixed.made.push_back(*candidate.finding);
      fixed.made.back().location =
          original_place(original, file, candidate.finding->location, backs);
    }
    const Edit edit = Round::together(round.taken());
    backs.push_back(inverse(fixed.text, edit));
    fixed.text = applied(fixed.text, edit);
  }
  std::stable_sort(
      fixed.made.begin(), fixed.made.end(),
      [](const Diagnostic& a, const Diagnostic& b) { return place_of(a) < place_of(b); });
  return fixed;
}

namespace {

std::vector<std::string_view> lines_of(std::string_view text) {
  std::vector<std::string_view> lines;
  while (!text.empty()) {
    const std::size_t size = std::min(text.find('\n'), text.size() - 1) + 1;
    lines.push_back(text.substr(0, size));
    text.remove_prefix(size);
  }
  return lines;
}

void add_line(std::string& diff, char mark, std::string_view line) {
  diff += mark;
  diff += line;
  if (!line.ends_with('\n')) {
    diff += "\n\\ No newline at end of file\n";
  }
}

}  // namespace

std::string unified_diff(std::string_view before, std::string_view after, std::string_view name) {
  constexpr std::size_t context = 3;
  const std::vector<std::string_view> a = lines_of(before);
  const std::vector<std::string_view> b = lines_of(after);
  const std::vector<LineChange> changes =
      line_changes(a.size(), b.size(), [&](std::size_t i, std::size_t j) { return a[i] == b[j]; });
  std::string diff = changes.empty() ? std::string() : fmt::format("--- {0}\n+++ {0}\n", name);
  for (const std::span<const LineChange> hunk : hunks_of(changes, context)) {
    std::string lines;
    std::size_t first = a.size();
    std::size_t count = 0;
    visit_hunk(hunk, context, a.size(), [&](char mark, std::size_t i, std::size_t j) {
      first = std::min(first, i);
      count += mark == '+' ? 0 : 1;
      add_line(lines, mark, mark == '+' ? b[j] : a[i]);
    });
    diff += fmt::format("@@ -{0},{1} +{0},{1} @@\n", first + 1, count) + lines;
  }
  return diff;
}

}  // namespace scenefile
