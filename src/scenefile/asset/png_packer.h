#pragma once
// Compression of PNG files with ISA-L (isal_packer.cpp), or with zlib in builds without ISA-L
// (zlib_packer.cpp). The bytes of files differ between the two, the pixels do not.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace scenefile {

/// A zlib stream, compressed piece by piece.
class PngPacker {
 public:
  PngPacker();
  ~PngPacker();
  PngPacker(const PngPacker&) = delete;
  PngPacker& operator=(const PngPacker&) = delete;

  /// Appends the finished part of the stream to `out`.
  void put(std::vector<std::uint8_t>& bytes, bool last, std::string& out);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// The CRC of PNG chunks.
std::uint32_t crc_of(const char* bytes, std::size_t count);

}  // namespace scenefile
