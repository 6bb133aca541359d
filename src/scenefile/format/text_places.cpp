#include "scenefile/format/text_places.h"

#include <algorithm>
#include <cstring>

namespace scenefile {

namespace {

constexpr std::size_t step = 4096;

bool starts_character(char c) {
  return (static_cast<unsigned char>(c) & 0xC0) != 0x80;
}

// Counts in short runs whose sum fits a byte, which compilers vectorize.
template <typename Test>
std::uint32_t count_bytes(std::string_view text, Test test) {
  std::uint32_t sum = 0;
  while (!text.empty()) {
    const std::string_view run = text.substr(0, 255);
    std::uint8_t count = 0;
    for (const char c : run) {
      count = static_cast<std::uint8_t>(count + (test(c) ? 1 : 0));
    }
    sum += count;
    text.remove_prefix(run.size());
  }
  return sum;
}

// In UTF-8; counts the bytes that are not continuation bytes.
std::uint32_t count_characters(std::string_view text) {
  return count_bytes(text, starts_character);
}

// Whether a CR that is not part of CR LF ends a line.
bool has_lone_cr(std::string_view text) {
  for (std::size_t at = text.find('\r'); at != std::string_view::npos;
       at = text.find('\r', at + 1)) {
    if (at + 1 == text.size() || text[at + 1] != '\n') {
      return true;
    }
  }
  return false;
}

}  // namespace

TextPlaces::TextPlaces(std::string_view text) : text_(text), lone_cr_(has_lone_cr(text)) {}

Location TextPlaces::at(std::size_t offset) {
  offset = std::min(offset, text_.size());
  if (offset < last_.offset || offset - last_.offset > step) {
    go_near(offset);
  }
  advance(last_, offset);
  return last_.location;
}

void TextPlaces::go_near(std::size_t offset) {
  while (steps_.size() * step <= offset) {
    advance(last_step_, steps_.size() * step);
    steps_.push_back(last_step_.location);
  }
  last_ = {offset / step * step, steps_[offset / step]};
}

void TextPlaces::advance(Mark& mark, std::size_t offset) const {
  const std::string_view passed = text_.substr(mark.offset, offset - mark.offset);
  if (lone_cr_) {
    advance_by_character(mark, offset);
    return;
  }
  const std::uint32_t lines = count_bytes(passed, [](char c) { return c == '\n'; });
  const std::size_t line_start = lines == 0 ? 0 : passed.rfind('\n') + 1;
  mark.offset = offset;
  mark.location.line += lines;
  mark.location.column =
      (lines == 0 ? mark.location.column : 1) + count_characters(passed.substr(line_start));
}

// If a lone CR ends lines, the meaning of each CR depends on the next character.
void TextPlaces::advance_by_character(Mark& mark, std::size_t offset) const {
  for (; mark.offset < offset; ++mark.offset) {
    const char c = text_[mark.offset];
    const char next = mark.offset + 1 < text_.size() ? text_[mark.offset + 1] : '\0';
    if (c == '\n' || (c == '\r' && next != '\n')) {
      mark.location = {mark.location.line + 1, 1};
    } else {
      mark.location.column += count_characters(text_.substr(mark.offset, 1));
    }
  }
}

TextCursor::TextCursor(std::string_view text)
    : begin_(text.data()),
      end_(text.data() + text.size()),
      lone_cr_(has_lone_cr(text)),
      tag_{text.data()},
      inside_{text.data()} {}

Location TextCursor::advance_to(const char* at) {
  move(tag_, at);
  inside_ = tag_;
  return tag_.location;
}

Location TextCursor::inside_tag(const char* at) {
  if (at < inside_.at) {
    inside_ = tag_;
  }
  move(inside_, at);
  return inside_.location;
}

double TextCursor::progress() const {
  return static_cast<double>(tag_.at - begin_) / static_cast<double>(end_ - begin_);
}

void TextCursor::move(Point& point, const char* to) const {
  const char* p = point.at;
  Location location = point.location;
  if (lone_cr_) {
    for (; p != to; ++p) {
      const bool ends_line = *p == '\n' || (*p == '\r' && p + 1 != end_ && p[1] != '\n');
      location.line += ends_line;
      location.column = ends_line ? 1 : location.column + starts_character(*p);
    }
    point = {to, location};
    return;
  }
  while (const void* newline = std::memchr(p, '\n', static_cast<std::size_t>(to - p))) {
    p = static_cast<const char*>(newline) + 1;
    ++location.line;
    location.column = 1;
  }
  for (; p != to; ++p) {
    location.column += starts_character(*p);
  }
  point = {to, location};
}

}  // namespace scenefile
