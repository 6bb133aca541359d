#pragma once
// <globaldata> and <cameradata>. Internal to the room.

#include "scenefile/format/xml_fields.h"
#include "scenefile/scene/scene.h"

#include <glm/glm.hpp>

namespace scenefile {

/// A child of <globaldata>. False: to be left out with everything in it.
bool read_global(const XmlContext& context, const XmlTag& tag, SeenFields& seen, Scene& scene);

/// A camera that is being read.
struct CameraDraft {
  Camera camera;
  glm::vec3 focus{0};
  SeenFields seen;
};

/// A child of <cameradata>. False: to be left out with everything in it.
bool read_camera_part(const XmlContext& context, const XmlTag& tag, CameraDraft& draft);
/// At the end of <cameradata>: the scene gets its camera.
void finish_camera(const XmlContext& context, CameraDraft& draft, Scene& scene);

}  // namespace scenefile
