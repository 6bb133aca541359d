#pragma once
// Prints a scene in its JSON form. Private to the room.

#include "scenefile/base/diagnostics.h"
#include "scenefile/base/limits.h"
#include "scenefile/scene/scene.h"

#include <string>

namespace scenefile {

/// `scene` is as json_form() makes it.
std::string print_json(const Scene& scene, const Limits& limits, Diagnostics& diagnostics);

}  // namespace scenefile
