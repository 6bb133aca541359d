#pragma once

#include "scenefile/scene/scene.h"

#include <string_view>

namespace scenefile::fuzz {

/// Writes a scene without errors, read from `source`, in both formats and reads it back: it must
/// come back without a word and with the same meaning, unless the writer said otherwise, and be
/// written alike again. What the writer says is about places in `source`.
void require_rereadable(const Scene& scene, std::string_view source);

}  // namespace scenefile::fuzz
