#pragma once

#include <string>
#include <string_view>

namespace scenefile {

/// Text that may stand in XML and HTML, in attributes too. Characters that XML cannot hold become
/// '?'.
std::string markup(std::string_view text);

/// RFC 4648, with padding.
std::string base64(std::string_view bytes);

}  // namespace scenefile
