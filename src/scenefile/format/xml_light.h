#pragma once
// <lightdata>. Internal to the room.

#include "scenefile/format/xml_fields.h"
#include "scenefile/scene/scene.h"

namespace scenefile {

/// A light while it is read.
struct LightDraft {
  Light light;
  SeenFields seen;
  bool type_known = true;  ///< false: misspelled, so missing values cannot be reported
};

/// Called at <lightdata>; `type` and `id` may be attributes.
LightDraft begin_light(const XmlContext& context, const XmlTag& tag);
/// Reads a child of <lightdata>. Returns false to skip it with its contents.
bool read_light_part(const XmlContext& context, const XmlTag& tag, LightDraft& draft);
/// Called at the end of <lightdata>: adds the light to the root.
void finish_light(const XmlContext& context, LightDraft& draft, Scene& scene);

}  // namespace scenefile
