#pragma once
// Laws about the findings for any input.

#include "scenefile/base/diagnostics.h"
#include "scenefile/base/limits.h"

#include <string_view>

namespace scenefile::fuzz {

/// Limits so low that small inputs exceed them.
Limits narrow_limits();

/// The list is bounded, each message is one short line of UTF-8 with a place in the text, and the
/// report contains no terminal control characters.
void require_sound(const Diagnostics& diagnostics, const Limits& limits, std::string_view text);

}  // namespace scenefile::fuzz
