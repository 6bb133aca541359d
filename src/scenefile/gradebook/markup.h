#pragma once

#include <string>
#include <string_view>

namespace scenefile {

/// Escapes text for XML and HTML, including attributes. Characters that XML cannot represent become
/// '?'.
std::string markup(std::string_view text);

/// A relative path as an attribute that is a link: all but plain characters are percent-encoded.
std::string link_to(std::string_view path);

}  // namespace scenefile
