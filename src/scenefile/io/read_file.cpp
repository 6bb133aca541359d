#include "scenefile/io/descriptor.h"

#include <unistd.h>

namespace scenefile {

Result<std::string> read_file(const std::string& path, std::uint64_t max_bytes) {
  if (const int own = own_descriptor(path, STDIN_FILENO); own >= 0) {
    return read_all(own, own == STDIN_FILENO ? "standard input" : path, 1 << 16, max_bytes);
  }
  const Result<OpenFile> file = open_regular(path, true, max_bytes);
  if (!file) {
    return file.error();
  }
  return read_all(file->descriptor.get(), path, file->size, max_bytes);
}

}  // namespace scenefile
