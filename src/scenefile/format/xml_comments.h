#pragma once
// Comments that XML does not allow but that the parsers of the course's programs read. Internal to
// the room.

#include "scenefile/base/diagnostics.h"
#include "scenefile/format/read_scene.h"

#include <optional>
#include <string>
#include <string_view>

namespace scenefile {

/// What to say of `-- >`, which shall end a comment.
inline constexpr std::string_view broken_comment_end_text =
    "a comment ends with -->, without blanks in it; close the gap";

/// Reports comments with -- inside and comments that start with <--, and writes over what is wrong
/// with them, so that the result has the same length and what is not a comment is unchanged.
/// Nothing when there are none. A comment ends at the first -->.
std::optional<std::string> mend_comments(std::string_view text, const ReadOptions& options,
                                         Diagnostics& diagnostics);

}  // namespace scenefile
