#pragma once
// <lightdata>. Internal to the room.

#include "scenefile/format/xml_fields.h"
#include "scenefile/scene/scene.h"

namespace scenefile {

/// A light that is being read.
struct LightDraft {
  Light light;
  SeenFields seen;
  bool type_known = true;  ///< false: it is misspelled, so what the light lacks cannot be told
};

/// At <lightdata>; `type` and `id` may be attributes.
LightDraft begin_light(const XmlContext& context, const XmlTag& tag);
/// A child of <lightdata>. False: to be left out with everything in it.
bool read_light_part(const XmlContext& context, const XmlTag& tag, LightDraft& draft);
/// At the end of <lightdata>: the root gets the light.
void finish_light(const XmlContext& context, LightDraft& draft, Scene& scene);

}  // namespace scenefile
