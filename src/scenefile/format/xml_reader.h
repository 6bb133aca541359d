#pragma once
// Reads well-formed XML as a sequence of events. Independent of scenes. Internal to the room.

#include "scenefile/base/diagnostics.h"
#include "scenefile/base/limits.h"
#include "scenefile/format/xml_tag.h"

#include <cstdint>
#include <string_view>

namespace scenefile {

/// Receives the contents of the text in order.
class XmlHandler {
 public:
  /// Returns false to stop reading without an error.
  virtual bool start(const XmlTag& tag) = 0;
  /// The end of the innermost open element.
  virtual void end() = 0;
  /// Text in or between elements, trimmed; may be delivered in several parts.
  virtual void text(std::string_view characters, Location location) = 0;

 protected:
  ~XmlHandler() = default;
};

/// Reads all of `text`, UTF-8 without a byte order mark, and calls `handler`. Stops with an error
/// at the first place that is not well-formed, declares or uses an entity, or exceeds a limit.
/// `places` must be new; XmlHandler::start may query it about the current tag. Memory does not
/// depend on the length of the text. Returns false unless everything was read.
bool read_events(std::string_view text, const Limits& limits, TextCursor& places,
                 XmlHandler& handler, Diagnostics& diagnostics);

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
