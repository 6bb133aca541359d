#pragma once
// Prints a scene in its XML form. Private to the room.

#include "scenefile/base/diagnostics.h"
#include "scenefile/base/limits.h"
#include "scenefile/scene/scene.h"

#include <string>

namespace scenefile {

/// `scene` is as xml_form() makes it.
std::string print_xml(const Scene& scene, const Limits& limits, Diagnostics& diagnostics);

}  // namespace scenefile
