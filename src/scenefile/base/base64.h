#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace scenefile {

/// Base64 as in RFC 4648, with padding.
std::string base64(std::string_view bytes);

/// Decodes base64; nullopt where it is malformed. Padding may be missing.
std::optional<std::string> base64_decoded(std::string_view text);

}  // namespace scenefile
