#pragma once

#include <string>
#include <string_view>

namespace scenefile {

/// Escapes text for XML and HTML, including attributes. Characters that XML cannot represent become
/// '?'.
std::string markup(std::string_view text);

}  // namespace scenefile
