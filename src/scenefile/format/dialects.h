#pragma once
// The implementations of read_scene() and write_scene() for XML and JSON. Internal to format.

#include "scenefile/base/diagnostics.h"
#include "scenefile/base/limits.h"
#include "scenefile/format/read_scene.h"
#include "scenefile/format/write_scene.h"
#include "scenefile/scene/scene.h"

#include <string>
#include <string_view>

namespace scenefile {

/// Same contract as read_scene(), for UTF-8 text without a byte order mark.
Scene read_xml(std::string_view text, const ReadOptions& options, Diagnostics& diagnostics);

/// Same as read_scene(), for JSON in UTF-8 without a byte order mark.
Scene read_json(std::string_view text, const ReadOptions& options, Diagnostics& diagnostics);

/// Same contract as write_scene().
std::string write_xml(const Scene& scene, const Limits& limits, Diagnostics& diagnostics);
std::string write_json(const Scene& scene, const Limits& limits, Diagnostics& diagnostics);

/// The lines of list_scene().
SceneListing list_xml(const Scene& scene);
SceneListing list_json(const Scene& scene);

}  // namespace scenefile
