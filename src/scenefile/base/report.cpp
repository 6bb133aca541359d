#include "scenefile/base/report.h"

#include "scenefile/base/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <set>
#include <tuple>
#include <vector>

namespace scenefile {

namespace {

constexpr std::size_t excerpt_width = 80;
constexpr std::string_view bold = "\033[1m";
constexpr std::string_view plain = "\033[0m";

std::string_view name_of(Severity severity) {
  switch (severity) {
    case Severity::note:
      return "note";
    case Severity::warning:
      return "warning";
    case Severity::error:
      return "error";
  }
  return {};
}

std::string_view color_of(Severity severity) {
  switch (severity) {
    case Severity::note:
      return "\033[1;36m";
    case Severity::warning:
      return "\033[1;35m";
    case Severity::error:
      return "\033[1;31m";
  }
  return {};
}

// Offsets of line starts, found in a single pass over the text for any number of findings.
class LineFinder {
 public:
  explicit LineFinder(std::string_view text) : text_(text) {}

  // Must be called with ascending lines.
  std::string_view line(std::uint32_t number) {
    while (current_ < number && at_ < text_.size()) {
      at_ = next_start(at_);
      ++current_;
    }
    if (current_ != number || at_ >= text_.size()) {
      return {};
    }
    const std::size_t end = text_.find_first_of("\r\n", at_);
    return text_.substr(at_, end == std::string_view::npos ? end : end - at_);
  }

 private:
  std::size_t next_start(std::size_t from) const {
    const std::size_t end = text_.find_first_of("\r\n", from);
    if (end == std::string_view::npos) {
      return text_.size();
    }
    const bool crlf = text_[end] == '\r' && end + 1 < text_.size() && text_[end + 1] == '\n';
    return end + (crlf ? 2 : 1);
  }

  std::string_view text_;
  std::size_t at_ = 0;
  std::uint32_t current_ = 1;
};

std::size_t character_length(std::string_view text) {
  return std::max<std::size_t>(first_code_point(text).bytes, 1);
}

// The shown part of a line: up to excerpt_width characters around the column, and the position of
// the caret in it. Tabs become spaces so that the caret stays under its character.
struct Excerpt {
  std::string text;
  std::size_t caret = 0;
};

Excerpt excerpt_of(std::string_view line, std::uint32_t column) {
  const std::size_t target = column == 0 ? 0 : column - 1;
  const std::size_t first = target < excerpt_width - 10 ? 0 : target - excerpt_width / 2;
  Excerpt result;
  if (first != 0) {
    result.text = "...";
  }
  std::size_t at = 0;
  while (!line.empty() && at < first + excerpt_width) {
    if (at == target) {
      result.caret = count_code_points(result.text);
    }
    const std::size_t bytes = character_length(line);
    if (at >= first) {
      result.text += line[0] == '\t' ? " " : escaped(line.substr(0, bytes));
    }
    line.remove_prefix(bytes);
    ++at;
  }
  if (at <= target) {
    result.caret = count_code_points(result.text);
  }
  if (!line.empty()) {
    result.text += "...";
  }
  return result;
}

void append_excerpt(std::string& out, std::string_view line, const Location& location,
                    const ReportStyle& style) {
  const Excerpt excerpt = excerpt_of(line, location.column);
  const std::string number = fmt::format("{:5}", location.line);
  fmt::format_to(std::back_inserter(out), "{} | {}\n{} | {}{}^{}\n", number, excerpt.text,
                 std::string(number.size(), ' '), std::string(excerpt.caret, ' '),
                 style.color ? "\033[1;32m" : "", style.color ? plain : "");
}

void append_heading(std::string& out, const Diagnostic& d, std::string_view file,
                    const ReportStyle& style) {
  std::string place = escaped(!d.path.empty() ? d.path : d.file.empty() ? file : d.file);
  if (d.location.known()) {
    place += fmt::format(":{}", d.location.line);
    if (d.location.column != 0) {
      place += fmt::format(":{}", d.location.column);
    }
  }
  const auto on = [&](std::string_view code) { return style.color ? code : std::string_view(); };
  fmt::format_to(std::back_inserter(out), "{}{}: {}{}{}:{} {} [{}]\n", on(bold), place, on(plain),
                 on(color_of(d.severity)), name_of(d.severity), on(plain), escaped(d.message, 4000),
                 d.code->name);
  for (const std::string& note : d.notes) {
    fmt::format_to(std::back_inserter(out), "    {}\n", escaped(note, 4000));
  }
}

void append_dropped(std::string& out, const Diagnostics& diagnostics) {
  std::set<std::string_view> seen;
  for (const Diagnostic& d : diagnostics.list()) {
    const std::size_t dropped = diagnostics.dropped(*d.code);
    if (dropped != 0 && seen.insert(d.code->name).second) {
      fmt::format_to(std::back_inserter(out), "and {} more of the kind [{}]\n", dropped,
                     d.code->name);
    }
  }
}

}  // namespace

std::vector<const Diagnostic*> by_place(const Diagnostics& diagnostics) {
  std::vector<const Diagnostic*> order;
  for (const Diagnostic& d : diagnostics.list()) {
    order.push_back(&d);
  }
  std::stable_sort(order.begin(), order.end(), [](const Diagnostic* a, const Diagnostic* b) {
    const auto key = [](const Diagnostic& d) {
      const bool here = d.file.empty() && d.location.known();
      return std::tuple(!here, here ? d.location.line : 0, here ? d.location.column : 0);
    };
    return key(*a) < key(*b);
  });
  return order;
}

std::string report_text(const Diagnostics& diagnostics, std::string_view file,
                        std::string_view text, const ReportStyle& style) {
  std::string out;
  LineFinder lines(text);
  for (const Diagnostic* d : by_place(diagnostics)) {
    if (d->severity == Severity::note && !style.notes) {
      continue;
    }
    append_heading(out, *d, file, style);
    if (style.excerpt && d->file.empty() && d->location.known() && !text.empty()) {
      append_excerpt(out, lines.line(d->location.line), d->location, style);
    }
  }
  append_dropped(out, diagnostics);
  return out;
}

std::string verdict_text(const Diagnostics& diagnostics, std::string_view file) {
  const std::size_t errors = diagnostics.count(Severity::error);
  const std::size_t warnings = diagnostics.count(Severity::warning);
  std::string verdict = errors != 0 ? counted(errors, "error") : "";
  if (warnings != 0) {
    verdict += (verdict.empty() ? "" : ", ") + counted(warnings, "warning");
  }
  return escaped(file) + ": " + (verdict.empty() ? "fine" : verdict);
}

}  // namespace scenefile
