#pragma once
// Comments that are invalid in XML, but that the parsers of the course's programs accept. Internal
// to the room.

#include "scenefile/base/diagnostics.h"
#include "scenefile/format/read_scene.h"

#include <optional>
#include <string>
#include <string_view>

namespace scenefile {

/// The message about `-- >` as the end of a comment.
inline constexpr std::string_view broken_comment_end_text =
    "a comment ends with -->, without spaces in it; remove them";

/// Reports comments that contain -- and comments that start with <--, and overwrites what is wrong
/// with them. The result has the same length, and text outside of comments is unchanged. Returns
/// nullopt if there are none. A comment ends at the first -->.
std::optional<std::string> mend_comments(std::string_view text, const ReadOptions& options,
                                         Diagnostics& diagnostics);

}  // namespace scenefile
