#pragma once
// XML as nearly all scene files are, read in a fifth of the time. Internal to the room.

#include "scenefile/base/limits.h"
#include "scenefile/format/xml_reader.h"
#include "scenefile/format/xml_tag.h"

#include <cstdint>
#include <string_view>

namespace scenefile {

/// How reading plain text ended.
enum class PlainEnd : std::uint8_t {
  complete,   ///< all was read, and is well-formed
  stopped,    ///< the handler wanted no more
  not_plain,  ///< something is unusual or wrong: only read_events() can tell
};

/// Tells `handler` the very same as read_events() does, of text that is plain: elements with names
/// in ASCII, values without references and line breaks, comments; no text, no DOCTYPE, no
/// processing instructions, no CDATA sections, and within the limits. Of other text, handler has
/// been told a beginning, and must forget it.
PlainEnd read_plain_events(std::string_view text, const Limits& limits, TextCursor& places,
                           XmlHandler& handler);

}  // namespace scenefile
