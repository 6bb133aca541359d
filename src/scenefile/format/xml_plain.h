#pragma once
// A fast path for the simple XML of nearly all scene files; takes a fifth of the time of Expat.
// Internal to the room.

#include "scenefile/base/limits.h"
#include "scenefile/format/xml_reader.h"
#include "scenefile/format/xml_tag.h"

#include <cstdint>
#include <string_view>

namespace scenefile {

/// How reading ended.
enum class PlainEnd : std::uint8_t {
  complete,   ///< everything was read, and is well-formed
  stopped,    ///< the handler stopped it
  not_plain,  ///< unusual or invalid; use read_events()
};

/// Calls `handler` exactly as read_events() does, for simple text: elements with ASCII names,
/// values without references or line breaks, and comments; no text, DOCTYPE, processing
/// instructions or CDATA sections, and within the limits. If it returns not_plain, the handler has
/// seen only a part and must be reset.
PlainEnd read_plain_events(std::string_view text, const Limits& limits, TextCursor& places,
                           XmlHandler& handler);

}  // namespace scenefile
