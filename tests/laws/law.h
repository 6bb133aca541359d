#pragma once
// Laws that hold for every scene file, tried on those of a folder.

#include "scenefile/format/read_scene.h"

#include <string>
#include <string_view>
#include <vector>

namespace scenefile::laws {

/// What a file breaks, in words; it may break several.
using Breaches = std::vector<std::string>;

/// Laying out twice is laying out once and keeps the scene; a file that is cut off is refused.
void try_text_laws(std::string_view text, Breaches& breaches);

/// Checking twice finds the same; writing and reading keeps the meaning, in each format and from
/// one to the other and back; writing twice is writing once; the pictures before and after are the
/// same to the byte. False: the file is no scene without errors, so the laws do not speak of it.
bool try_scene_laws(const std::string& path, std::string_view text, const ReadOptions& options,
                    Breaches& breaches);

}  // namespace scenefile::laws
