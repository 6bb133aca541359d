#include "read_picture.h"

#include "scenefile/asset/image_file.h"
#include "scenefile/io/file.h"

namespace scenefile::conformance {

std::string read_picture(const std::string& path, Texture& picture) {
  const Limits limits;
  const Result<std::string> bytes = read_file(path, limits.file_bytes);
  if (!bytes) {
    return bytes.error().text;
  }
  std::uint64_t budget = limits.texture_bytes;
  std::string error;
  picture = decode_image(*bytes, limits, budget, error);
  return error.empty() ? "" : path + ": " + error;
}

}  // namespace scenefile::conformance
