#include "scenefile/edit/layout.h"

#include "scenefile/base/ascii.h"
#include "scenefile/format/write_text.h"

#include <fmt/format.h>

#include <algorithm>

namespace scenefile {

namespace {

constexpr std::string_view comment_start = "<!--";
constexpr std::string_view comment_end = "-->";
constexpr std::size_t sample = 20'000;  // of a text that shows its style

TextChange insertion_at(std::size_t at, std::string text) {
  return {static_cast<std::uint32_t>(at), 0, std::move(text)};
}

TextChange replacing(std::size_t from, std::size_t to, std::string text = {}) {
  return {static_cast<std::uint32_t>(from), static_cast<std::uint32_t>(to - from), std::move(text)};
}

bool is_blank(std::string_view text) {
  return text.find_first_not_of(blanks) == std::string_view::npos;
}

// One step of indentation, from the first line that is indented deeper than the line before it.
std::string unit_of(std::string_view text) {
  text = text.substr(0, sample);
  std::size_t before = 0;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    const std::string_view line = text.substr(at, end - at);
    if (!is_blank(line)) {
      const std::size_t deep = line.find_first_not_of(" \t");
      if (deep > before) {
        return std::string(line.substr(before, deep - before));
      }
      before = deep;
    }
    at = end + 1;
  }
  return "  ";
}

bool is_minified(std::string_view text) {
  text = text.substr(0, sample);
  for (std::size_t i = 1; i < text.size(); ++i) {
    if ((text[i - 1] == ',' || text[i - 1] == ':') && blanks.find(text[i]) != blanks.npos) {
      return false;
    }
  }
  return true;
}

}  // namespace

std::string json_quoted(std::string_view text) {
  std::string out;
  append_json(out, text);
  return out;
}

Edit edit_of(std::vector<TextChange> changes, const TextChange* selected, std::size_t lead) {
  Edit edit;
  std::optional<TextChange> wanted;
  if (selected != nullptr) {
    wanted = *selected;
  }
  edit.changes = std::move(changes);
  sort_changes(edit.changes);
  if (wanted) {
    std::size_t grown = 0;
    for (const TextChange& change : edit.changes) {
      if (change == *wanted) {
        break;
      }
      grown += change.text.size() - change.size;
    }
    edit.select = static_cast<std::uint32_t>(wanted->at + grown + lead);
  }
  return edit;
}

Layout::Layout(const Syntax& syntax)
    : syntax_(syntax), text_(syntax.text), unit_(unit_of(text_)), minified_(is_minified(text_)) {
  const std::size_t newline = text_.find('\n');
  line_end_ = newline != text_.npos && newline > 0 && text_[newline - 1] == '\r' ? "\r\n" : "\n";
  const std::size_t last = text_.find_last_not_of(blanks);
  one_line_ = syntax.xml ? newline == text_.npos
                         : text_.substr(0, last + 1).find('\n', text_.find_first_not_of(blanks)) ==
                               text_.npos;
}

// Layout.

std::size_t Layout::line_start(std::size_t at) const {
  const std::size_t newline = at == 0 ? text_.npos : text_.rfind('\n', at - 1);
  return newline == text_.npos ? syntax_.start : newline + 1;
}

std::string_view Layout::indent_at(std::size_t at) const {
  const std::size_t from = line_start(at);
  return text_.substr(from, std::min(text_.find_first_not_of(" \t", from), text_.size()) - from);
}

bool Layout::starts_line(std::size_t at) const {
  const std::size_t from = line_start(at);
  return is_blank(text_.substr(from, at - from));
}

// The end of the line at `at` without white space if only comments follow, otherwise `at`.
std::size_t Layout::after_comments(std::size_t at) const {
  std::size_t end = at;
  for (;;) {
    const std::size_t next = std::min(text_.find_first_not_of(" \t", end), text_.size());
    const std::string_view rest = text_.substr(next);
    if (rest.empty() || rest[0] == '\n' || rest.starts_with("\r\n")) {
      return end;
    }
    const std::size_t close = rest.find(comment_end, comment_start.size());
    if (!rest.starts_with(comment_start) || close == rest.npos || rest.find('\n') < close) {
      return at;
    }
    end = next + close + comment_end.size();
  }
}

// Past white space at the end of a line, which belongs to what is before it.
std::size_t Layout::line_end_at(std::size_t at) const {
  const std::size_t next = std::min(text_.find_first_not_of(" \t", at), text_.size());
  const std::string_view rest = text_.substr(next);
  return rest.empty() || rest[0] == '\n' || rest.starts_with("\r\n") ? next : at;
}

TextRange Layout::with_comments(TextRange range, std::size_t limit) const {
  std::size_t start = range.from;
  for (;;) {
    std::string_view above = text_.substr(limit, start - limit);
    const auto trim = [&](std::string_view what) {
      above = above.substr(0, above.find_last_not_of(what) + 1);
    };
    trim(" \t");
    if (!above.ends_with('\n')) {
      break;
    }
    above.remove_suffix(above.ends_with("\r\n") ? 2 : 1);
    trim(" \t");
    if (!above.ends_with(comment_end) || above.size() < 7) {
      break;
    }
    // The comment starts at the first mark after the end of the one before.
    const std::size_t other = above.rfind(comment_end, above.size() - 4);
    const std::size_t open = above.find(comment_start, other == above.npos ? 0 : other);
    if (open == above.npos || open == 0 || !starts_line(limit + open)) {
      break;
    }
    start = limit + open;
  }
  // A comment after several on a line is about the line.
  const std::size_t end = starts_line(range.from) ? after_comments(range.to) : range.to;
  return {static_cast<std::uint32_t>(start), static_cast<std::uint32_t>(end)};
}

Piece Layout::piece_of(TextRange range) const {
  return {std::nullopt, std::string(syntax_.slice(range)), indent_at(range.from)};
}

std::string Layout::text_of(const Piece& piece, const std::string& indent, bool broad) const {
  std::string out;
  if (piece.fresh) {
    if (piece.fresh->type == Fresh::Type::element) {
      write_element(out, *piece.fresh, indent, broad);
    } else {
      write_json(out, *piece.fresh, indent, broad);
    }
    return out;
  }
  const std::string_view moved = piece.moved;
  for (std::size_t at = 0; at < moved.size();) {
    const std::size_t end = std::min(moved.find('\n', at), moved.size() - 1) + 1;
    std::string_view line = moved.substr(at, end - at);
    if (at > 0 && line.starts_with(piece.indent)) {
      line.remove_prefix(piece.indent.size());
      out += indent;
    }
    out += line;
    at = end;
  }
  return out;
}

void Layout::write_element(std::string& out, const Fresh& fresh, const std::string& indent,
                           bool broad) const {
  out += "<" + fresh.text;
  for (const auto& [name, value] : fresh.attributes) {
    fmt::format_to(std::back_inserter(out), " {}=\"{}\"", name, value);
  }
  if (fresh.children.empty()) {
    out += "/>";
    return;
  }
  out += ">";
  for (const Fresh& child : fresh.children) {
    out += broad ? line_end_ + indent + unit_ : "";
    write_element(out, child, indent + unit_, broad);
  }
  out += (broad ? line_end_ + indent : "") + "</" + fresh.text + ">";
}

void Layout::write_json(std::string& out, const Fresh& fresh, const std::string& indent,
                        bool broad) const {
  if (fresh.type == Fresh::Type::literal) {
    out += fresh.text;
    return;
  }
  const bool object = fresh.type == Fresh::Type::object;
  const bool lines =
      broad &&
      (object || std::any_of(fresh.children.begin(), fresh.children.end(),
                             [](const Fresh& child) { return child.type == Fresh::Type::object; }));
  out += object ? "{" : "[";
  for (std::size_t i = 0; i < fresh.children.size(); ++i) {
    const Fresh& child = fresh.children[i];
    out += i > 0 ? "," : "";
    out += lines ? line_end_ + indent + unit_ : i > 0 ? " " : "";
    out += object ? json_quoted(child.key) + ": " : "";
    write_json(out, child, indent + unit_, broad);
  }
  out += lines && !fresh.children.empty() ? line_end_ + indent : "";
  out += object ? "}" : "]";
}

// Changes of XML.

Insertion Layout::insert_children(PartId id, PartId previous, std::span<const Piece> pieces) const {
  const SyntaxPart& element = syntax_[id];
  const std::string own(indent_at(element.from));
  const auto joined = [&](const std::string& indent, const std::string& before,
                          const std::string& after, bool broad) {
    std::string all;
    for (const Piece& piece : pieces) {
      all += before + text_of(piece, indent, broad) + after;
    }
    return all;
  };
  const bool lines = !one_line_;
  const bool broad = lines && starts_line(element.from);
  const std::string deeper = own + unit_;
  const std::string lead = broad ? line_end_ + deeper : "";
  if (element.empty) {
    std::size_t from = element.body - 2;
    while (blanks.find(text_[from - 1]) != blanks.npos) {
      --from;
    }
    std::string all = joined(deeper, lead, "", lines);
    all = ">" + all + (broad ? line_end_ + own : "") + "</" + std::string(syntax_.name(id)) + ">";
    return {replacing(from, element.body, std::move(all)), lead.size() + 1};
  }
  if (previous != no_part) {
    const TextRange place = syntax_[previous].range();
    const std::size_t end = line_end_at(after_comments(place.to));
    const bool ends_line = end == text_.size() || text_[end] == '\n' || text_[end] == '\r';
    if (starts_line(place.from) && ends_line) {
      const std::string indent(indent_at(place.from));
      return {insertion_at(end, joined(indent, line_end_ + indent, "", lines)),
              line_end_.size() + indent.size()};
    }
    const std::size_t index = syntax_.index(previous);
    const std::size_t before = index == 0 ? element.body : syntax_[element.children[index - 1]].to;
    const std::string_view gap = text_.substr(before, place.from - before);
    const bool narrow = gap.find_first_not_of(" \t") == gap.npos;
    const std::string space(narrow ? gap : std::string_view());
    return {insertion_at(place.to, joined(own, space, "", false)), space.size()};
  }
  if (!element.children.empty()) {
    const TextRange next = syntax_[element.children.front()].range();
    if (!starts_line(next.from)) {
      return {insertion_at(next.from, joined(own, "", "", false)), 0};
    }
    const std::string indent(indent_at(next.from));
    return {insertion_at(with_comments(next, element.body).from,
                         joined(indent, "", line_end_ + indent, lines)),
            0};
  }
  if (starts_line(element.close)) {
    return {insertion_at(line_start(element.close), joined(deeper, deeper, line_end_, lines)),
            deeper.size()};
  }
  return {
      insertion_at(element.close, joined(deeper, lead, "", lines) + (broad ? line_end_ + own : "")),
      lead.size()};
}

TextChange Layout::remove_element(TextRange range) const {
  const std::size_t next = std::min(text_.find_first_not_of(" \t", range.to), text_.size());
  const std::string_view rest = text_.substr(next);
  const std::size_t end = rest.empty() ? 0 : rest[0] == '\n' ? 1 : rest.starts_with("\r\n") ? 2 : 0;
  if (starts_line(range.from)) {
    return rest.empty() || end > 0 ? replacing(line_start(range.from), next + end)
                                   : replacing(range.from, range.to);
  }
  const std::string_view above = text_.substr(0, range.from);
  return replacing(above.find_last_not_of(" \t") + 1, range.to);
}

TextChange Layout::set_attribute(PartId element, std::string_view name, std::string_view value,
                                 std::span<const std::string_view> after) const {
  std::size_t at = syntax_[element].from + 1 + syntax_[element].key_size;
  std::optional<std::size_t> known;
  for (const WrittenAttribute& attribute : syntax_.attributes(element)) {
    if (attribute.name == name) {
      return replacing(attribute.value.from, attribute.value.to, std::string(value));
    }
    at = attribute.range.to;
    if (std::find(after.begin(), after.end(), attribute.name) != after.end()) {
      known = at;
    }
  }
  return insertion_at(known.value_or(at), fmt::format(" {}=\"{}\"", name, value));
}

// Changes of JSON.

// What is between an entry and the comma or bracket before it.
std::string_view Layout::gap_before(PartId list, std::size_t index) const {
  const SyntaxPart& all = syntax_[list];
  const std::size_t before =
      index == 0 ? all.body + 1 : text_.find(',', syntax_[all.children[index - 1]].to) + 1;
  return text_.substr(before, syntax_[all.children[index]].from - before);
}

std::string Layout::colon_of(PartId object) const {
  if (syntax_[object].children.empty()) {
    return minified_ ? ":" : ": ";
  }
  const SyntaxPart& first = syntax_[syntax_[object].children.front()];
  const std::size_t key_end = first.from + first.key_size;
  return std::string(text_.substr(key_end, first.body - key_end));
}

Insertion Layout::insert_entry(PartId id, std::size_t index, const Piece& piece,
                               std::string_view key) const {
  const SyntaxPart& list = syntax_[id];
  const std::string own(indent_at(list.body));
  const std::string name = key.empty() ? "" : json_quoted(key) + colon_of(id);
  if (list.children.empty()) {
    const bool broad = !one_line_ && (piece.fresh ? piece.fresh->type == Fresh::Type::object
                                                  : piece.moved.find('\n') != std::string::npos);
    const std::string indent = broad ? own + unit_ : own;
    const std::string lead = broad ? line_end_ + indent : "";
    return {replacing(
                list.body + 1, list.to - 1,
                lead + name + text_of(piece, indent, !one_line_) + (broad ? line_end_ + own : "")),
            lead.size()};
  }
  const std::size_t near = index > 0 ? index - 1 : 0;
  const bool second = near == 0 && list.children.size() > 1 && index > 0;
  const std::string_view gap = gap_before(id, second ? 1 : near);
  const bool broad_gap = gap.find('\n') != gap.npos;
  const SyntaxPart& neighbor = syntax_[list.children[near]];
  const std::string indent(broad_gap ? indent_at(neighbor.from) : std::string_view(own));
  const std::string_view written = syntax_.slice(neighbor.range());
  const bool broad = !one_line_ && broad_gap &&
                     (!key.empty() || written.find('\n') != written.npos || written.size() < 3);
  std::string text = name + text_of(piece, indent, broad);
  if (index > 0) {
    const std::string lead = "," + (broad_gap                   ? line_end_ + indent
                                    : gap.empty() && !minified_ ? std::string(" ")
                                                                : std::string(gap));
    return {insertion_at(neighbor.to, lead + text), lead.size()};
  }
  text += "," + (broad_gap ? line_end_ + indent : minified_ ? "" : " ");
  return {insertion_at(neighbor.from, std::move(text)), 0};
}

std::vector<TextChange> Layout::remove_entries(PartId id, std::span<const std::size_t> gone) const {
  const SyntaxPart& list = syntax_[id];
  std::vector<TextChange> changes;
  if (gone.size() == list.children.size()) {
    return {replacing(list.body + 1, list.to - 1)};
  }
  std::size_t first = 0;  // that stays
  while (first < gone.size() && gone[first] == first) {
    ++first;
  }
  for (const std::size_t index : gone) {
    const SyntaxPart& entry = syntax_[list.children[index]];
    changes.push_back(index < first ? replacing(entry.from, syntax_[list.children[index + 1]].from)
                                    : replacing(syntax_[list.children[index - 1]].to, entry.to));
  }
  return changes;
}

}  // namespace scenefile
