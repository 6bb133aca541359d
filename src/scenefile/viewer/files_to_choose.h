#pragma once
// The files that an object can name.

#include <cstdint>
#include <string>
#include <vector>

namespace scenefile::viewer {

enum class FileUse : std::uint8_t { mesh, image };

/// Meshes or images in the scene's folder and the folders in it, as the scene would name them, in
/// natural order; at most a few hundred.
std::vector<std::string> files_to_choose(const std::string& scene, FileUse use);

}  // namespace scenefile::viewer
