#pragma once
// Detects the syntax of a text. Internal to the room.

#include "scenefile/base/diagnostics.h"
#include "scenefile/format/write_scene.h"

#include <optional>
#include <string>
#include <string_view>

namespace scenefile {

/// Decides by the first character that is not part of white space or a C comment: `<` is XML, `{`
/// or `[` is JSON. Otherwise reports an error that says what the file may be, and returns nullopt.
/// `text` is UTF-8 without a byte order mark.
std::optional<SceneFormat> syntax_of(std::string_view text, Diagnostics& diagnostics);

/// A message about a character for which is_odd_blank() is true.
std::string odd_blank_text(char32_t blank);

}  // namespace scenefile
