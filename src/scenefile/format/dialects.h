#pragma once
// What read_scene(), write_scene() and lay_out() do in each dialect. Private to the room.

#include "scenefile/base/diagnostics.h"
#include "scenefile/base/limits.h"
#include "scenefile/format/read_scene.h"
#include "scenefile/scene/scene.h"

#include <optional>
#include <string>
#include <string_view>

namespace scenefile {

/// Same contract as read_scene(), for UTF-8 text without a byte order mark.
Scene read_xml(std::string_view text, const ReadOptions& options, Diagnostics& diagnostics);

/// Same as read_scene(), for JSON in UTF-8 without a byte order mark.
Scene read_json(std::string_view text, const ReadOptions& options, Diagnostics& diagnostics);

/// `scene` must be a result of xml_form().
std::string print_xml(const Scene& scene, const Limits& limits, Diagnostics& diagnostics);

/// `scene` must be a result of json_form().
std::string print_json(const Scene& scene, const Limits& limits, Diagnostics& diagnostics);

/// Returns whether `text`, UTF-8 without a byte order mark, is a well-formed XML <scenefile>;
/// reports an error otherwise.
bool check_xml_layout(std::string_view text, const Limits& limits, Diagnostics& diagnostics);

/// Formats `text`, which may be in any encoding that is a superset of ASCII.
std::string lay_out_xml(std::string_view text);

/// `text` is UTF-8 without a byte order mark. Returns nullopt, after an error, if it is not a JSON
/// object.
std::optional<std::string> lay_out_json(std::string_view text, const Limits& limits,
                                        Diagnostics& diagnostics);

}  // namespace scenefile
