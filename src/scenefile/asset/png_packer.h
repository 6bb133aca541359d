#pragma once
// What packs the pixels of PNG files: ISA-L (isal_packer.cpp), or zlib where the build has no ISA-L
// (zlib_packer.cpp). The bytes of files differ between the two, their pixels do not.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace scenefile {

/// A zlib stream that is made piece by piece.
class PngPacker {
 public:
  PngPacker();
  ~PngPacker();
  PngPacker(const PngPacker&) = delete;
  PngPacker& operator=(const PngPacker&) = delete;

  /// Appends what is ready of the stream to `out`.
  void put(std::vector<std::uint8_t>& bytes, bool last, std::string& out);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// The CRC of PNG's chunks.
std::uint32_t crc_of(const char* bytes, std::size_t count);

}  // namespace scenefile
