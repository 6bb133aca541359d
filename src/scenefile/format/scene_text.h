#pragma once
// Opens the bytes of a scene file: converts them to UTF-8, the only encoding that the readers
// handle, and detects the syntax. Internal to format.

#include "scenefile/base/diagnostics.h"
#include "scenefile/format/write_scene.h"

#include <optional>
#include <string>
#include <string_view>

namespace scenefile {

struct SceneText {
  std::string_view text;  ///< UTF-8 without a byte order mark
  SceneFormat syntax = SceneFormat::xml;
};

/// The text of a file: a part of `bytes` if it is UTF-8 already, otherwise a copy in `storage`. The
/// first character that is not part of white space or a C comment decides the syntax: `<` is XML,
/// `{` or `[` is JSON. Returns nullopt, after an error that says what the file may be, for anything
/// else. If the text has no parts of a scene (has_scene_parts()), the error has no place and shows
/// nothing of the text.
std::optional<SceneText> open_text(std::string_view bytes, std::string& storage,
                                   Diagnostics& diagnostics);

/// Only the text, whatever its syntax. Supports UTF-8, UTF-16, ISO-8859-1 and windows-1252,
/// detected by a byte order mark, by the pattern of zero bytes, or by an XML declaration. Returns
/// nullopt, after an error, if the bytes are invalid in that encoding.
std::optional<std::string_view> decode_text(std::string_view bytes, std::string& storage,
                                            Diagnostics& diagnostics);

/// Appends a character as UTF-8.
void append_utf8(std::string& out, char32_t c);

/// A message about a character for which is_odd_blank() is true.
std::string odd_blank_text(char32_t blank);

}  // namespace scenefile
