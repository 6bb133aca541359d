// The only file that includes zlib.

#include "scenefile/asset/zlib_bytes.h"

#include <zlib.h>

#include <new>

namespace scenefile {

std::string deflated(std::string_view bytes, int level) {
  uLongf size = compressBound(static_cast<uLong>(bytes.size()));
  std::string packed(size, '\0');
  const int status = compress2(reinterpret_cast<Bytef*>(packed.data()), &size,
                               reinterpret_cast<const Bytef*>(bytes.data()),
                               static_cast<uLong>(bytes.size()), level);
  if (status != Z_OK) {
    throw std::bad_alloc();  // the only possible reason: the buffer has the size that zlib requires
  }
  packed.resize(size);
  return packed;
}

std::uint32_t zlib_crc(std::string_view bytes) {
  return static_cast<std::uint32_t>(
      crc32_z(0, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

}  // namespace scenefile
