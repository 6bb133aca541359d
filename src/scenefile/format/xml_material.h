#pragma once
// What stands in <object type="primitive">. Internal to the room.

#include "scenefile/format/xml_fields.h"
#include "scenefile/scene/scene.h"

namespace scenefile {

/// A primitive that is being read; it has its place in the scene already.
struct PrimitiveDraft {
  NodeId node = 0;  ///< whose last primitive it is
  SeenFields seen;
  bool texture_known = true;
};

/// A child of a primitive. False: to be left out with everything in it.
bool read_primitive_part(const XmlContext& context, const XmlTag& tag, PrimitiveDraft& draft,
                         Scene& scene);

/// At the end of a primitive.
void finish_primitive(const PrimitiveDraft& draft, Scene& scene);

}  // namespace scenefile
