#pragma once
// Laws of ready scenes.

#include "scenefile/base/limits.h"
#include "scenefile/scene/prepare.h"

namespace scenefile::fuzz {

/// All indices are in range and groups are in order: what any scene at all must give.
void require_safe(const Prepared& prepared, const Limits& limits);

/// Also all values are finite and usable: what a scene without errors must give.
void require_valid(const Prepared& prepared, const Limits& limits);

}  // namespace scenefile::fuzz
