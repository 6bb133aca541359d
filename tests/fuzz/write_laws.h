#pragma once

#include "scenefile/scene/scene.h"

#include <string_view>

namespace scenefile::fuzz {

/// Writes a scene without errors, read from `source`, in both formats and reads it back: it must be
/// read without warnings and with the same meaning, unless the writer reported a loss, and writing
/// it again must give the same text. The writer's findings have places in `source`.
void require_rereadable(const Scene& scene, std::string_view source);

}  // namespace scenefile::fuzz
