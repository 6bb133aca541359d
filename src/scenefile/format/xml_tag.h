#pragma once
// A start tag of an XML text, as written. Internal to the room.

#include "scenefile/base/limits.h"
#include "scenefile/base/location.h"
#include "scenefile/format/text_places.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace scenefile {

/// `name` points into the text of the file, to find its place; `value` does too unless references
/// in it were replaced.
struct XmlAttribute {
  std::string_view name;
  std::string_view value;
};

/// Only valid during the call that receives it.
struct XmlTag {
  std::string_view name;  ///< points into the text of the file, directly after the `<`
  std::span<const XmlAttribute> attributes;
  Location location;  ///< of the `<`

  const XmlAttribute* find(std::string_view attribute) const;
};

/// Why a tag is rejected before it is interpreted.
enum class TagFault : std::uint8_t { none, name_too_long, too_many_attributes, value_too_long };

struct TagScan {
  std::string_view name;
  TagFault fault = TagFault::none;
  bool needs_decoding = false;  ///< a value contains a reference or a line break
  XmlAttribute culprit;         ///< for value_too_long
};

/// Finds the parts of the start tag at the beginning of `text`, which is well-formed but may be
/// truncated anywhere. Values are as written, with references unresolved.
TagScan scan_tag(std::string_view text, const Limits& limits, std::vector<XmlAttribute>& out);

}  // namespace scenefile
