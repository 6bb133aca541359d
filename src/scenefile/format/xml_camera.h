#pragma once
// <globaldata> and <cameradata>. Internal to the room.

#include "scenefile/format/xml_fields.h"
#include "scenefile/scene/scene.h"

#include <glm/glm.hpp>

namespace scenefile {

/// Reads a child of <globaldata>. Returns false to skip it with its contents.
bool read_global(const XmlContext& context, const XmlTag& tag, SeenFields& seen, Scene& scene);

/// A camera while it is read.
struct CameraDraft {
  Camera camera;
  glm::vec3 focus{0};
  SeenFields seen;
};

/// Reads a child of <cameradata>. Returns false to skip it with its contents.
bool read_camera_part(const XmlContext& context, const XmlTag& tag, CameraDraft& draft);
/// Called at the end of <cameradata>: adds the camera to the scene.
void finish_camera(const XmlContext& context, CameraDraft& draft, Scene& scene);

}  // namespace scenefile
