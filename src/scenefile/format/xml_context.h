#pragma once
// What every part of the XML reader is handed. Internal to the room.

#include "scenefile/base/diagnostics.h"
#include "scenefile/format/read_scene.h"
#include "scenefile/format/xml_tag.h"

#include <string>
#include <string_view>
#include <utility>

namespace scenefile {

struct XmlContext {
  const ReadOptions& options;
  Diagnostics& diagnostics;
  TextCursor& places;

  void report(const Code& code, const XmlTag& tag, std::string message) const {
    diagnostics.report(code, tag.location, std::move(message));
  }
  void report(const Code& code, const XmlAttribute& attribute, std::string message) const {
    diagnostics.report(code, places.inside_tag(attribute.name.data()), std::move(message));
  }
};

/// The name of an element as messages show it, with its brackets.
std::string element_text(std::string_view name);

/// "; did you mean X?", or nothing when X is empty. `mark` surrounds X: "<>" or "".
std::string did_you_mean(std::string_view name, std::string_view mark = "");

}  // namespace scenefile
