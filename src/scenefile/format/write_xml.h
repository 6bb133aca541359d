#pragma once
// Writes a scene as XML. Private to the room.

#include "scenefile/base/diagnostics.h"
#include "scenefile/base/limits.h"
#include "scenefile/scene/scene.h"

#include <string>

namespace scenefile {

/// `scene` must be a result of xml_form().
std::string print_xml(const Scene& scene, const Limits& limits, Diagnostics& diagnostics);

}  // namespace scenefile
