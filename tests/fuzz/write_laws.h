#pragma once

#include "scenefile/scene/scene.h"

namespace scenefile::fuzz {

/// Writes a scene without errors in both formats and reads it back: it must come back without a
/// word and with the same meaning, unless the writer said otherwise, and be written alike again.
void require_rereadable(const Scene& scene);

}  // namespace scenefile::fuzz
