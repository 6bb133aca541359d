#include "scenefile/format/xml_context.h"

#include "scenefile/base/text.h"

#include <fmt/format.h>

namespace scenefile {

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

}  // namespace scenefile
