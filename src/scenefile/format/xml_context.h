#pragma once
// The context passed to every part of the XML reader. Internal to format.

#include "scenefile/base/diagnostics.h"
#include "scenefile/format/read_scene.h"
#include "scenefile/format/text_places.h"
#include "scenefile/format/xml_scanner.h"

#include <string>
#include <string_view>
#include <utility>

namespace scenefile {

struct XmlContext {
  const ReadOptions& options;
  Diagnostics& diagnostics;
  TextPlaces& places;

  void report(const Code& code, const XmlTag& tag, std::string message) const {
    diagnostics.report(code, tag.location, std::move(message));
  }
  void report(const Code& code, const XmlAttribute& attribute, std::string message) const {
    diagnostics.report(code, place(attribute), std::move(message));
  }
  Location place(const XmlAttribute& attribute) const { return places.at(attribute.name.data()); }
};

/// The name of an element for messages, in angle brackets.
std::string element_text(std::string_view name);

/// "; did you mean X?", or empty if X is empty. `mark` surrounds X: "<>" or "".
std::string did_you_mean(std::string_view name, std::string_view mark = "");

}  // namespace scenefile
