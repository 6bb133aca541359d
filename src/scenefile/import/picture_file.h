#pragma once
// Internal to import.

#include "scenefile/asset/image.h"
#include "scenefile/import/imported_scene.h"

#include <string>

namespace scenefile {

/// Adds the picture as a PNG file with the next number. Returns its name.
std::string add_picture(const Texture& texture, const ImportOptions& options,
                        std::vector<ImportedFile>& files);

}  // namespace scenefile
