#pragma once
// One start tag of an XML text as the author wrote it. Internal to the room.

#include "scenefile/base/limits.h"
#include "scenefile/base/location.h"
#include "scenefile/format/text_places.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace scenefile {

/// `name` lies in the text of the file, so that its place can be told; `value` only where no
/// character of it had to be replaced.
struct XmlAttribute {
  std::string_view name;
  std::string_view value;
};

/// Valid during the call that hands it out.
struct XmlTag {
  std::string_view name;  ///< lies in the text of the file, just behind the `<`
  std::span<const XmlAttribute> attributes;
  Location location;  ///< of the `<`

  const XmlAttribute* find(std::string_view attribute) const;
};

/// Why a tag is refused before its meaning is looked at.
enum class TagFault : std::uint8_t { none, name_too_long, too_many_attributes, value_too_long };

struct TagScan {
  std::string_view name;
  TagFault fault = TagFault::none;
  bool needs_decoding = false;  ///< a value holds a reference or a line break
  XmlAttribute culprit;         ///< under value_too_long
};

/// Finds the parts of the start tag at the front of `text`, which is well-formed but may be cut off
/// anywhere. Values are as written, with their references.
TagScan scan_tag(std::string_view text, const Limits& limits, std::vector<XmlAttribute>& out);

}  // namespace scenefile
