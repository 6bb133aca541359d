// For builds without ISA-L. Compresses everything at the end, in a single call of zlib.

#include "scenefile/asset/png_packer.h"
#include "scenefile/asset/zlib_bytes.h"

namespace scenefile {

struct PngPacker::State {
  std::string bytes;
};

PngPacker::PngPacker() : state_(std::make_unique<State>()) {}
PngPacker::~PngPacker() = default;

void PngPacker::put(std::vector<std::uint8_t>& bytes, bool last, std::string& out) {
  constexpr int level = 3;
  state_->bytes.append(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  if (last) {
    out += deflated(state_->bytes, level);
  }
}

std::uint32_t crc_of(const char* bytes, std::size_t count) {
  return zlib_crc({bytes, count});
}

}  // namespace scenefile
