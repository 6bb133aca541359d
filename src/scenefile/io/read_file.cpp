#include "scenefile/io/descriptor.h"

#include <unistd.h>

namespace scenefile {

IoError read_file(const std::string& path, std::uint64_t max_bytes, std::string& bytes) {
  bytes.clear();
  if (const int own = own_descriptor(path, STDIN_FILENO); own >= 0) {
    return read_all(own, own == STDIN_FILENO ? "standard input" : path, 1 << 16, max_bytes, bytes);
  }
  std::uint64_t size = 0;
  IoError error;
  const Descriptor file = open_regular(path, true, max_bytes, size, error);
  if (!file.open()) {
    return error;
  }
  return read_all(file.get(), path, size, max_bytes, bytes);
}

}  // namespace scenefile
