#pragma once
// Scene files laid out afresh: the white space between the tokens of the text, and nothing else.

#include "scenefile/base/diagnostics.h"
#include "scenefile/base/limits.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace scenefile {

/// The text of a scene file with its elements or members one a line, indented by two blanks for
/// each level. Names, values, their order and spelling, comments, declarations, the encoding and
/// the kind of line ends stay as they are; of blank lines one stays where there were some. In XML,
/// a comment behind something stays in its line, and elements that hold text, CDATA or
/// xml:space="preserve" stay as they are. In JSON, a list of scalars stands in one line when it is
/// no longer than 80 bytes.
///
/// The text need not make sense as a scene, but must be a <scenefile> in well-formed XML or an
/// object in JSON; for others nothing, after an error. The result laid out again is the same, and
/// read_scene() finds the same in both. What write_scene() writes is laid out already.
std::optional<std::string> lay_out(std::string_view bytes, const Limits& limits,
                                   Diagnostics& diagnostics);

/// How many comments there are in the text of a scene file without errors.
std::size_t count_comments(std::string_view bytes);

}  // namespace scenefile
