#include "scenefile/format/xml_context.h"

#include "scenefile/base/text.h"

#include <fmt/format.h>

#include <algorithm>

namespace scenefile {

namespace {

char lower(char c) {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

}  // namespace

std::string element_text(std::string_view name) {
  return fmt::format("<{}>", escaped(name, 40));
}

std::string did_you_mean(std::string_view name, std::string_view mark) {
  if (name.empty()) {
    return {};
  }
  const bool marked = mark.size() == 2;
  return fmt::format("; did you mean {}{}{}?", mark.substr(0, marked), name,
                     mark.substr(marked ? 1 : 0));
}

bool equal_ignoring_case(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](char x, char y) { return lower(x) == lower(y); });
}

}  // namespace scenefile
