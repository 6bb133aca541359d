#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace scenefile {

/// RFC 4648, with padding.
std::string base64(std::string_view bytes);

/// The bytes of such a text; nothing where it is malformed. Padding may be missing.
std::optional<std::string> base64_decoded(std::string_view text);

}  // namespace scenefile
