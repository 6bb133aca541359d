#pragma once
// Formats scene files: changes only the white space between tokens.

#include "scenefile/base/diagnostics.h"
#include "scenefile/base/limits.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace scenefile {

/// Formats a scene file with one element or member per line, indented by two spaces per level.
/// Names, values, their order and spelling, comments, declarations, the encoding and line ends are
/// unchanged; several blank lines become one. In XML, a comment after other text stays on its line,
/// and elements that contain text, CDATA or xml:space="preserve" are unchanged. In JSON, a list of
/// scalars is on one line if it is at most 80 bytes long.
///
/// The text need not be a valid scene, but must be a well-formed XML <scenefile> or a JSON object;
/// otherwise reports an error and returns nullopt. Idempotent, and read_scene() gives equal scenes
/// for both texts. The output of write_scene() is already formatted.
std::optional<std::string> lay_out(std::string_view bytes, const Limits& limits,
                                   Diagnostics& diagnostics);

/// The number of comments in a scene file without errors.
std::size_t count_comments(std::string_view bytes);

}  // namespace scenefile
