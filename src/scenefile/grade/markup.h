#pragma once

#include <string>
#include <string_view>

namespace scenefile {

/// Text that may stand in XML and HTML, in attributes too. Characters that XML cannot hold become
/// '?'.
std::string markup(std::string_view text);

}  // namespace scenefile
