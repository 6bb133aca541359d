#pragma once
// Which syntax a text is in. Internal to the room.

#include "scenefile/base/diagnostics.h"
#include "scenefile/format/write_scene.h"

#include <optional>
#include <string>
#include <string_view>

namespace scenefile {

/// By the first character that is neither white space nor in a comment as of C: `<` XML, `{` or `[`
/// JSON. Nothing, after an error that says what the file may be, for others. `text` is UTF-8
/// without a byte order mark.
std::optional<SceneFormat> syntax_of(std::string_view text, Diagnostics& diagnostics);

/// What to say of a character for which is_odd_blank() is true.
std::string odd_blank_text(char32_t blank);

}  // namespace scenefile
