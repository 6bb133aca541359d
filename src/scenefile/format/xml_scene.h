#pragma once
// Builds a Scene from the elements of an XML scene file. Internal to the room.

#include "scenefile/base/diagnostics.h"
#include "scenefile/format/read_scene.h"
#include "scenefile/scene/scene.h"

#include <string_view>

namespace scenefile {

/// Same contract as read_scene(), for UTF-8 text without a byte order mark.
Scene read_xml(std::string_view text, const ReadOptions& options, Diagnostics& diagnostics);

}  // namespace scenefile
