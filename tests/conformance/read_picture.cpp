#include "read_picture.h"

#include "scenefile/asset/image_file.h"
#include "scenefile/io/file.h"

#include <utility>

namespace scenefile::conformance {

std::string read_picture(const std::string& path, Texture& picture) {
  const Limits limits;
  const Result<std::string> bytes = read_file(path, limits.file_bytes);
  if (!bytes) {
    return bytes.error().text;
  }
  Result<Texture> decoded = decode_image(*bytes);
  if (!decoded) {
    return path + ": " + decoded.error().text;
  }
  picture = *std::move(decoded);
  return {};
}

}  // namespace scenefile::conformance
