// A PNG writer with the deflate and CRC of ISA-L (decision 18). Source of the
// format: W3C, "Portable Network Graphics (PNG) Specification (Second Edition)".

#include "scenefile/asset/codec.h"

#include <isa-l/crc.h>
#include <isa-l/igzip_lib.h>

#include <algorithm>
#include <memory>
#include <vector>

namespace scenefile {

namespace {

void append_big_endian(std::string& bytes, std::uint32_t value) {
  for (int shift = 24; shift >= 0; shift -= 8) {
    bytes.push_back(static_cast<char>(value >> shift & 255));
  }
}

std::uint32_t crc_of(const char* bytes, std::size_t count) {
  return crc32_gzip_refl(0, reinterpret_cast<const unsigned char*>(bytes), count);
}

// Appends a chunk whose data is appended by `append`; no chunk if there is no data.
template <typename Append>
void add_chunk(std::string& file, const char* name, const Append& append) {
  const std::size_t start = file.size();
  append_big_endian(file, 0);
  file += name;
  const std::size_t data = file.size();
  append();
  if (file.size() == data) {
    file.resize(start);
    return;
  }
  std::string length;
  append_big_endian(length, static_cast<std::uint32_t>(file.size() - data));
  file.replace(start, length.size(), length);
  append_big_endian(file, crc_of(file.data() + start + 4, file.size() - start - 4));
}

// A zlib stream, compressed piece by piece.
class Deflater {
 public:
  Deflater() : state_(std::make_unique<isal_zstream>()), buffer_(ISAL_DEF_LVL3_DEFAULT) {
    isal_deflate_init(state_.get());
    // Levels 1 and 2 give bytes that depend on memory addresses (decision 18).
    state_->level = 3;
    state_->level_buf = buffer_.data();
    state_->level_buf_size = static_cast<std::uint32_t>(buffer_.size());
    state_->gzip_flag = IGZIP_ZLIB;
  }

  // Appends the finished part of the stream to `out`.
  void put(std::vector<std::uint8_t>& bytes, bool last, std::string& out) {
    state_->next_in = bytes.data();
    state_->avail_in = static_cast<std::uint32_t>(bytes.size());
    state_->end_of_stream = last ? 1 : 0;
    do {
      state_->next_out = ready_;
      state_->avail_out = sizeof ready_;
      isal_deflate(state_.get());
      out.append(reinterpret_cast<const char*>(ready_), sizeof ready_ - state_->avail_out);
    } while (state_->avail_out == 0);
  }

 private:
  std::unique_ptr<isal_zstream> state_;
  std::vector<std::uint8_t> buffer_;
  std::uint8_t ready_[1 << 14];
};

void quantize_16_bit(const float* from, std::size_t count, Rounding rounding, std::uint8_t* to) {
  for (std::size_t i = 0; i < count; ++i) {
    const float clamped = from[i] > 0 ? std::min(from[i], 1.0f) : 0.0f;
    const double scaled = double{clamped} * 65535 + (rounding == Rounding::nearest ? 0.5 : 0);
    const auto value = static_cast<std::uint16_t>(scaled);
    to[2 * i] = static_cast<std::uint8_t>(value >> 8);
    to[2 * i + 1] = static_cast<std::uint8_t>(value & 255);
  }
}

// Applies the filter "Sub": each sample becomes the difference to the pixel on its left.
class Rows {
 public:
  Rows(const Image& image, int bits, Rounding rounding)
      : image_(image),
        bits_(bits),
        rounding_(rounding),
        samples_(std::size_t{3} * static_cast<std::size_t>(image.width)),
        row_(samples_ * static_cast<std::size_t>(bits) / 8) {}

  void append(int y, std::vector<std::uint8_t>& to) {
    constexpr std::uint8_t filter_sub = 1;
    if (bits_ == 8) {
      quantize(image_.pixel(0, y), samples_, rounding_, row_.data());
    } else {
      quantize_16_bit(image_.pixel(0, y), samples_, rounding_, row_.data());
    }
    const std::size_t start = to.size() + 1;
    const std::size_t pixel = static_cast<std::size_t>(bits_) / 8 * 3;
    to.push_back(filter_sub);
    to.insert(to.end(), row_.begin(), row_.end());
    for (std::size_t i = pixel; i < row_.size(); ++i) {
      to[start + i] = static_cast<std::uint8_t>(row_[i] - row_[i - pixel]);
    }
  }

 private:
  const Image& image_;
  int bits_;
  Rounding rounding_;
  std::size_t samples_;
  std::vector<std::uint8_t> row_;
};

void append_header(const Image& image, int bits, std::string& file) {
  constexpr char rgb = 2;
  append_big_endian(file, static_cast<std::uint32_t>(image.width));
  append_big_endian(file, static_cast<std::uint32_t>(image.height));
  file += {static_cast<char>(bits), rgb, 0, 0, 0};
}

}  // namespace

std::string encode_png(const Image& image, int bits, Rounding rounding) {
  constexpr std::size_t piece = 1 << 16;
  std::string file("\x89PNG\r\n\x1a\n", 8);
  add_chunk(file, "IHDR", [&] { append_header(image, bits, file); });
  Deflater deflater;
  Rows rows(image, bits, rounding);
  std::vector<std::uint8_t> ready;
  for (int y = 0; y < image.height; ++y) {
    rows.append(y, ready);
    const bool last = y + 1 == image.height;
    if (ready.size() >= piece || last) {
      add_chunk(file, "IDAT", [&] { deflater.put(ready, last, file); });
      ready.clear();
    }
  }
  file.append("\0\0\0\0IEND\xae\x42\x60\x82", 12);
  return file;
}

}  // namespace scenefile
