#pragma once

#include "scenefile/asset/image.h"

#include <string>

namespace scenefile::conformance {

/// Reads and decodes a picture. Returns an error text; empty on success.
std::string read_picture(const std::string& path, Texture& picture);

}  // namespace scenefile::conformance
