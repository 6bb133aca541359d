#pragma once
// Reads XML as a sequence of events. Independent of scenes. Internal to format.

#include "scenefile/base/diagnostics.h"
#include "scenefile/format/read_scene.h"
#include "scenefile/format/text_places.h"
#include "scenefile/format/xml_scanner.h"

#include <string>
#include <string_view>

namespace scenefile {

/// Receives the contents of the text in order.
class XmlHandler {
 public:
  /// Returns false to stop reading without an error.
  virtual bool start(const XmlTag& tag) = 0;
  /// The end of the innermost open element.
  virtual void end() = 0;
  /// The first line of text between two pieces of markup, trimmed; up to the first reference in it.
  virtual void text(std::string_view characters, Location location) = 0;

 protected:
  ~XmlHandler() = default;
};

struct XmlReading {
  bool complete = false;     ///< everything was read
  bool asked_expat = false;  ///< the text is not plain (XmlToken::plain)
};

/// Reads all of `text`, UTF-8 without a byte order mark, and calls `handler`. Stops with an error
/// at the first place that is not well-formed, declares or uses an entity, or exceeds a limit.
/// After malformed comments, values without quotation marks and end tags in the wrong case, which
/// are errors too, it goes on. XmlHandler may query `places`, of the same
/// text. Memory does not depend on the length of the text if it is plain.
XmlReading read_events(std::string_view text, const ReadOptions& options, TextPlaces& places,
                       XmlHandler& handler, Diagnostics& diagnostics);

/// An attribute's value as XML demands: references resolved, line breaks replaced. The text must be
/// well-formed.
std::string decoded_value(std::string_view written);

}  // namespace scenefile
