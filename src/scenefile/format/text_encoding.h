#pragma once
// Bytes of a scene file to UTF-8, the one encoding that the readers behind it know. Internal to the
// room.

#include "scenefile/base/diagnostics.h"

#include <optional>
#include <string>
#include <string_view>

namespace scenefile {

/// The text as UTF-8 without a byte order mark: a part of `bytes` where it is UTF-8 already, else a
/// copy in `storage`. Knows UTF-8, UTF-16, ISO-8859-1 and windows-1252, by byte order mark, by the
/// pattern of zero bytes, or by an XML declaration. Nothing, after an error, when the bytes are not
/// what they claim to be.
std::optional<std::string_view> decode_text(std::string_view bytes, std::string& storage,
                                            Diagnostics& diagnostics);

}  // namespace scenefile
