#pragma once
// Laws for every scene file, tested on those of a folder.

#include "scenefile/format/read_scene.h"

#include <string>
#include <string_view>
#include <vector>

namespace scenefile::laws {

/// Descriptions of the laws that a file breaks.
using Breaches = std::vector<std::string>;

/// Formatting is idempotent and keeps the scene; a truncated file is rejected.
void try_text_laws(std::string_view text, Breaches& breaches);

/// Checking twice gives the same findings; writing and reading keeps the meaning, in each format
/// and when converting between them; writing is idempotent; the pictures before and after are
/// identical. Returns false if the file is not a scene without errors, so the laws do not apply.
bool try_scene_laws(const std::string& path, std::string_view text, const ReadOptions& options,
                    Breaches& breaches);

}  // namespace scenefile::laws
