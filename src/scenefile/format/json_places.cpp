#include "scenefile/format/json_places.h"

#include <algorithm>

namespace scenefile {

namespace {

constexpr std::size_t step = 4096;

}  // namespace

JsonPlaces::JsonPlaces(std::string_view text) : text_(text) {
  steps_.reserve(text.size() / step + 1);
  Mark mark;
  for (std::size_t offset = 0; offset <= text.size(); offset += step) {
    advance(mark, offset);
    steps_.push_back(mark.location);
  }
}

Location JsonPlaces::at(std::size_t offset) {
  offset = std::min(offset, text_.size());
  if (offset < last_.offset || offset - last_.offset > step) {
    last_ = {offset / step * step, steps_[offset / step]};
  }
  advance(last_, offset);
  return last_.location;
}

void JsonPlaces::advance(Mark& mark, std::size_t offset) const {
  std::uint32_t line = mark.location.line;
  std::uint32_t column = mark.location.column;
  for (std::size_t i = mark.offset; i < offset; ++i) {
    const char c = text_[i];
    const bool line_end =
        c == '\n' || (c == '\r' && (i + 1 == text_.size() || text_[i + 1] != '\n'));
    const bool continues = (static_cast<unsigned char>(c) & 0xc0u) == 0x80u;
    line += line_end ? 1 : 0;
    column = line_end ? 1 : column + (continues ? 0 : 1);
  }
  mark = {offset, {line, column}};
}

}  // namespace scenefile
