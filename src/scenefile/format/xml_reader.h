#pragma once
// Well-formed XML as a series of events. Knows nothing of scenes. Internal to the room.

#include "scenefile/base/diagnostics.h"
#include "scenefile/base/limits.h"
#include "scenefile/format/xml_tag.h"

#include <string_view>

namespace scenefile {

/// Told what stands in the text, in its order.
class XmlHandler {
 public:
  /// False: what follows is of no interest, reading ends without an error.
  virtual bool start(const XmlTag& tag) = 0;
  /// The innermost element that is open ends.
  virtual void end() = 0;
  /// Characters in or between elements, without the blanks around them; possibly a part of them.
  virtual void text(std::string_view characters, Location location) = 0;

 protected:
  ~XmlHandler() = default;
};

/// Reads all of `text`, UTF-8 without a byte order mark, and tells `handler`. Stops at the first
/// place that is not well-formed, declares or uses an entity, or breaks a limit, with an error.
/// `places` must be fresh; inside XmlHandler::start it may be asked about the tag. Memory does not
/// depend on the length of the text. False: it was not read to its end.
bool read_events(std::string_view text, const Limits& limits, TextCursor& places,
                 XmlHandler& handler, Diagnostics& diagnostics);

}  // namespace scenefile
