#include "read_picture.h"

#include "scenefile/asset/image_file.h"
#include "scenefile/io/file.h"

namespace scenefile::conformance {

std::string read_picture(const std::string& path, Texture& picture) {
  std::string bytes;
  const Limits limits;
  if (IoError error = read_file(path, limits.file_bytes, bytes); !error.empty()) {
    return error.text;
  }
  std::uint64_t budget = limits.texture_bytes;
  std::string error;
  picture = decode_image(bytes, limits, budget, error);
  return error.empty() ? "" : path + ": " + error;
}

}  // namespace scenefile::conformance
