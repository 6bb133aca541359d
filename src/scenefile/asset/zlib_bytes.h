#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace scenefile {

/// Compresses bytes to a zlib stream; levels 1 to 9, where 9 gives the smallest result. Throws
/// std::bad_alloc.
std::string deflated(std::string_view bytes, int level);

/// The CRC-32 of gzip and PNG.
std::uint32_t zlib_crc(std::string_view bytes);

}  // namespace scenefile
