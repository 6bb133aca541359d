#pragma once
// The elements of an XML scene file, and the Scene they mean. Internal to the room.

#include "scenefile/base/diagnostics.h"
#include "scenefile/format/read_scene.h"
#include "scenefile/scene/scene.h"

#include <string_view>

namespace scenefile {

/// Reads UTF-8 text without a byte order mark. Contract as read_scene().
Scene read_xml(std::string_view text, const ReadOptions& options, Diagnostics& diagnostics);

}  // namespace scenefile
