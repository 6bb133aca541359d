#pragma once

#include <string_view>

namespace scenefile {

/// Whether the bytes begin like an OpenEXR file.
inline bool has_exr_signature(std::string_view bytes) {
  return bytes.starts_with("\x76\x2f\x31\x01");
}

}  // namespace scenefile
