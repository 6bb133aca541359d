#pragma once
// The start tag of <object>. Internal to the room.

#include "scenefile/base/shape.h"
#include "scenefile/format/xml_context.h"

#include <cstdint>
#include <optional>
#include <string_view>

namespace scenefile {

enum class ObjectType : std::uint8_t { tree, master, primitive };

struct ObjectTag {
  ObjectType type = ObjectType::tree;
  bool has_name = false;
  std::string_view name;      ///< may be empty
  std::string_view filename;  ///< of a mesh
  Location name_place;        ///< of the attribute, or of the tag if there is none
  Location filename_place;
};

/// Reads the attributes. Returns nullopt to skip the object: after an error, or a warning about a
/// type that the format does not have.
std::optional<ObjectTag> read_object_tag(const XmlContext& context, const XmlTag& tag);

/// The shape that a primitive names. Returns nullopt to skip it: after an error, or a warning about
/// a shape that the format does not have.
std::optional<Shape> read_shape(const XmlContext& context, const XmlTag& tag,
                                const ObjectTag& object);

}  // namespace scenefile
