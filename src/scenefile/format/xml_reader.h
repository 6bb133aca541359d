#pragma once
// Reads well-formed XML as a sequence of events. Independent of scenes. Internal to the room.

#include "scenefile/base/diagnostics.h"
#include "scenefile/base/limits.h"
#include "scenefile/format/xml_tag.h"

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

}  // namespace scenefile
