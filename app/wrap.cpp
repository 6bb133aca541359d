#include "app/wrap.h"

#include "app/output.h"

#include <algorithm>
#include <charconv>
#include <cstdlib>

namespace scenefile::app {

namespace {

constexpr std::size_t usual_width = 80;
constexpr std::size_t min_width = 40;
constexpr std::size_t max_width = 100;

// 0: unknown.
std::size_t given_width() {
  const char* const columns = std::getenv("COLUMNS");
  const std::string_view text = columns == nullptr ? "" : columns;
  std::size_t width = 0;
  const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), width);
  return error == std::errc() && rest == text.data() + text.size() ? width : 0;
}

}  // namespace

std::size_t help_width() {
  std::size_t width = given_width();
  width = width == 0 ? terminal_width(Stream::answer) : width;
  return width == 0 ? usual_width : std::clamp(width, min_width, max_width);
}

std::string wrapped(std::string_view text, std::size_t column, std::size_t indent,
                    std::size_t width, std::string_view joint) {
  std::string result;
  bool first = true;  // of its line
  while (!text.empty()) {
    const std::size_t space = std::min(text.find(' '), text.size());
    const std::string_view word = text.substr(0, space);
    text.remove_prefix(std::min(space + 1, text.size()));
    const std::size_t reserved = text.empty() ? 0 : joint.size();
    if (!first && column + 1 + word.size() + reserved > width) {
      result += joint;
      result += '\n';
      result.append(indent, ' ');
      column = indent;
      first = true;
    }
    if (!first) {
      result += ' ';
      ++column;
    }
    result += word;
    column += word.size();
    first = false;
  }
  return result;
}

}  // namespace scenefile::app
