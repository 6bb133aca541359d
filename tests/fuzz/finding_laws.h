#pragma once
// Laws of what is said about an input.

#include "scenefile/base/diagnostics.h"
#include "scenefile/base/limits.h"

#include <string_view>

namespace scenefile::fuzz {

/// Limits so narrow that small inputs meet them.
Limits narrow_limits();

/// The list is bounded, each message is one short line of UTF-8 and points into the text, and the
/// report shows nothing that could act on a terminal.
void require_sound(const Diagnostics& diagnostics, const Limits& limits, std::string_view text);

}  // namespace scenefile::fuzz
