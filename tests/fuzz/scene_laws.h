#pragma once
// Laws of render scenes.

#include "scenefile/base/limits.h"
#include "scenefile/scene/prepare.h"

namespace scenefile::fuzz {

/// All indices are in range and groups are in order: must hold for any scene.
void require_safe(const Prepared& prepared, const Limits& limits);

/// Also all values are finite and in range: must hold for scenes without errors.
void require_valid(const Prepared& prepared, const Limits& limits);

}  // namespace scenefile::fuzz
