#pragma once
// Compares our reader of XML with Expat's events.

#include "scenefile/base/diagnostics.h"
#include "scenefile/base/limits.h"
#include "scenefile/format/xml_reader.h"

#include <string>
#include <string_view>

namespace scenefile::testing {

/// The events of read_events(), one per line, and how it ended.
struct Told {
  XmlReading reading;
  std::string said;
  Diagnostics diagnostics;
};
Told events_of(std::string_view text, const Limits& limits);

/// Whether our reader gives the same events at the same places as Expat and finds an error where
/// Expat does; up to the first mistake that our reader repairs, limit, malformed comment or
/// declaration of an entity, which only our reader reports. An element called "stop" stops both.
bool agrees_with_expat(std::string_view text, const Limits& limits);

}  // namespace scenefile::testing
