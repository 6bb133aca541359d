#pragma once
// Compares the scanner of plain XML with Expat, which it stands in for.

#include "scenefile/base/limits.h"
#include "scenefile/format/xml_reader.h"

#include <string>
#include <string_view>

namespace scenefile::testing {

/// What read_plain_events() told of a text, one line an event, and how it ended.
struct Told {
  PlainEnd end = PlainEnd::complete;
  std::string said;
};
Told plain_events(std::string_view text, const Limits& limits);

/// Whether Expat says the same of the text, with the same places, or has to be asked.
bool agrees_with_expat(std::string_view text, const Limits& limits);

}  // namespace scenefile::testing
