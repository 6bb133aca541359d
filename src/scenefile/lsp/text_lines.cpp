#include "scenefile/lsp/text_lines.h"

#include "scenefile/base/text.h"

#include <algorithm>

namespace scenefile {

namespace {

// The size of the first character in bytes, at least 1.
std::size_t character_bytes(std::string_view text) {
  return std::max<std::size_t>(first_code_point(text).bytes, 1);
}

}  // namespace

Utf16Offsets::Utf16Offsets(std::string_view text) {
  if (std::all_of(text.begin(), text.end(), [](char c) { return (c & 0x80) == 0; })) {
    return;
  }
  before_.reserve(text.size() + 1);
  std::uint32_t units = 0;
  while (!text.empty()) {
    const std::size_t bytes = character_bytes(text);
    before_.insert(before_.end(), bytes, units);
    units += bytes == 4 ? 2 : 1;
    text.remove_prefix(bytes);
  }
  before_.push_back(units);
}

std::size_t Utf16Offsets::unit(std::size_t byte) const {
  return before_.empty() ? byte : before_[std::min(byte, before_.size() - 1)];
}

std::size_t Utf16Offsets::byte(std::size_t unit) const {
  const auto found = std::lower_bound(before_.begin(), before_.end(), unit);
  return before_.empty() ? unit : static_cast<std::size_t>(found - before_.begin());
}

TextLines::TextLines(std::string_view text) : text_(text), units_(text), starts_{0} {
  for (std::size_t at = 0; (at = text.find_first_of("\r\n", at)) != std::string_view::npos;) {
    at += text.substr(at).starts_with("\r\n") ? 2 : 1;
    starts_.push_back(at);
  }
}

std::string_view TextLines::line(std::size_t line) const {
  const std::string_view rest = text_.substr(starts_[line]);
  return rest.substr(0, rest.find_first_of("\r\n"));
}

std::size_t TextLines::offset(LspPosition position) const {
  if (position.line >= starts_.size()) {
    return text_.size();
  }
  const std::size_t start = starts_[position.line];
  const std::size_t end = start + line(position.line).size();
  return std::min(units_.byte(units_.unit(start) + position.character), end);
}

std::size_t TextLines::offset(Location location) const {
  if (location.line == 0 || location.line > starts_.size()) {
    return location.line == 0 ? 0 : text_.size();
  }
  std::string_view rest = line(location.line - 1);
  const std::size_t end = starts_[location.line - 1] + rest.size();
  for (std::uint32_t column = 1; column < location.column && !rest.empty(); ++column) {
    rest.remove_prefix(character_bytes(rest));
  }
  return end - rest.size();
}

LspPosition TextLines::position(std::size_t offset) const {
  offset = std::min(offset, text_.size());
  const auto next = std::upper_bound(starts_.begin(), starts_.end(), offset);
  const std::size_t units = units_.unit(offset) - units_.unit(*(next - 1));
  return {static_cast<std::uint32_t>(next - starts_.begin() - 1),
          static_cast<std::uint32_t>(units)};
}

}  // namespace scenefile
