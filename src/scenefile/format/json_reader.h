#pragma once
// The JSON variant of the format. Private to the room: read_scene.h is for others.

#include "scenefile/base/diagnostics.h"
#include "scenefile/format/read_scene.h"
#include "scenefile/scene/scene.h"

#include <string_view>

namespace scenefile {

/// Reads a JSON scene; as read_scene(), for text that is UTF-8 without a byte order mark.
/// Codes: json_codes.h.
Scene read_json(std::string_view text, const ReadOptions& options, Diagnostics& diagnostics);

}  // namespace scenefile
