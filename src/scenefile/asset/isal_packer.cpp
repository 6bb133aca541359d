// The only file that includes ISA-L.

#include "scenefile/asset/png_packer.h"

#include <isa-l/crc.h>
#include <isa-l/igzip_lib.h>

namespace scenefile {

struct PngPacker::State {
  isal_zstream stream;
  std::vector<std::uint8_t> buffer = std::vector<std::uint8_t>(ISAL_DEF_LVL3_DEFAULT);
  std::uint8_t ready[1 << 14];
};

PngPacker::PngPacker() : state_(std::make_unique<State>()) {
  isal_zstream& stream = state_->stream;
  isal_deflate_init(&stream);
  // Levels 1 and 2 give bytes that depend on memory addresses (decision 18).
  stream.level = 3;
  stream.level_buf = state_->buffer.data();
  stream.level_buf_size = static_cast<std::uint32_t>(state_->buffer.size());
  stream.gzip_flag = IGZIP_ZLIB;
}

PngPacker::~PngPacker() = default;

void PngPacker::put(std::vector<std::uint8_t>& bytes, bool last, std::string& out) {
  isal_zstream& stream = state_->stream;
  auto& ready = state_->ready;
  stream.next_in = bytes.data();
  stream.avail_in = static_cast<std::uint32_t>(bytes.size());
  stream.end_of_stream = last ? 1 : 0;
  do {
    stream.next_out = ready;
    stream.avail_out = sizeof ready;
    isal_deflate(&stream);
    out.append(reinterpret_cast<const char*>(ready), sizeof ready - stream.avail_out);
  } while (stream.avail_out == 0);
}

std::uint32_t crc_of(const char* bytes, std::size_t count) {
  return crc32_gzip_refl(0, reinterpret_cast<const unsigned char*>(bytes), count);
}

}  // namespace scenefile
