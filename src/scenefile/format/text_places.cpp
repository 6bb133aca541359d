#include "scenefile/format/text_places.h"

#include "scenefile/base/text.h"

#include <algorithm>
#include <cstring>

namespace scenefile {

namespace {

constexpr std::size_t step = 4096;

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
  return advance(last_, offset);
}

void TextPlaces::go_near(std::size_t offset) {
  while (steps_.size() * step <= offset) {
    advance(last_step_, steps_.size() * step);
    steps_.push_back(last_step_.location);
  }
  last_ = {offset / step * step, steps_[offset / step]};
}

Location TextPlaces::advance(Mark& mark, std::size_t offset) const {
  const char* p = text_.data() + mark.offset;
  const char* const end = text_.data() + offset;
  Location location = mark.location;
  if (lone_cr_) {
    // The meaning of each CR depends on the next character.
    const char* const text_end = text_.data() + text_.size();
    for (; p != end; ++p) {
      const bool ends_line = *p == '\n' || (*p == '\r' && (p + 1 == text_end || p[1] != '\n'));
      location.line += ends_line;
      location.column = ends_line ? 1 : location.column + !continues_character(*p);
    }
  }
  while (p != end) {  // memchr() does not take the null pointer of an empty text
    const void* const newline = std::memchr(p, '\n', static_cast<std::size_t>(end - p));
    if (newline == nullptr) {
      break;
    }
    p = static_cast<const char*>(newline) + 1;
    ++location.line;
    location.column = 1;
  }
  for (; p != end; ++p) {
    location.column += !continues_character(*p);
  }
  mark = {offset, location};
  return location;
}

double TextPlaces::progress() const {
  return static_cast<double>(last_.offset) / static_cast<double>(text_.size());
}

}  // namespace scenefile
