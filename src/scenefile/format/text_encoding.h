#pragma once
// Converts the bytes of a scene file to UTF-8, the only encoding that the readers handle. Internal
// to the room.

#include "scenefile/base/diagnostics.h"

#include <optional>
#include <string>
#include <string_view>

namespace scenefile {

/// The text as UTF-8 without a byte order mark: a part of `bytes` if it is UTF-8 already, otherwise
/// a copy in `storage`. Supports UTF-8, UTF-16, ISO-8859-1 and windows-1252, detected by a byte
/// order mark, by the pattern of zero bytes, or by an XML declaration. Returns nullopt, after an
/// error, if the bytes are invalid in that encoding.
std::optional<std::string_view> decode_text(std::string_view bytes, std::string& storage,
                                            Diagnostics& diagnostics);

/// Appends a character as UTF-8.
void append_utf8(std::string& out, char32_t c);

}  // namespace scenefile
