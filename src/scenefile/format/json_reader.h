#pragma once
// The JSON dialect of the format. Private to the room; others use read_scene.h.

#include "scenefile/base/diagnostics.h"
#include "scenefile/format/read_scene.h"
#include "scenefile/scene/scene.h"

#include <string_view>

namespace scenefile {

/// Same as read_scene(), for JSON in UTF-8 without a byte order mark. Codes: json_codes.h.
Scene read_json(std::string_view text, const ReadOptions& options, Diagnostics& diagnostics);

}  // namespace scenefile
