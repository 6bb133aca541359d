#pragma once
// Compares the fast reader of simple XML with Expat, which it replaces.

#include "scenefile/base/limits.h"
#include "scenefile/format/xml_reader.h"

#include <string>
#include <string_view>

namespace scenefile::testing {

/// The events of read_plain_events(), one per line, and how it ended.
struct Told {
  PlainEnd end = PlainEnd::complete;
  std::string said;
};
Told plain_events(std::string_view text, const Limits& limits);

/// Whether the fast reader gives the same events and places as Expat, or gives up.
bool agrees_with_expat(std::string_view text, const Limits& limits);

}  // namespace scenefile::testing
