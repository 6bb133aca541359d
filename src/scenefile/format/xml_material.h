#pragma once
// The contents of <object type="primitive">. Internal to the room.

#include "scenefile/format/xml_fields.h"
#include "scenefile/scene/scene.h"

namespace scenefile {

/// A primitive while it is read; it is already in the scene.
struct PrimitiveDraft {
  NodeId node = 0;  ///< the primitive is the last one of this node
  SeenFields seen;
  bool texture_known = true;
};

/// Reads a child of a primitive. Returns false to skip it with its contents.
bool read_primitive_part(const XmlContext& context, const XmlTag& tag, PrimitiveDraft& draft,
                         Scene& scene);

/// Called at the end of a primitive.
void finish_primitive(const PrimitiveDraft& draft, Scene& scene);

}  // namespace scenefile
