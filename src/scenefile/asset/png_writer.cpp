// A PNG writer around a deflate and a CRC (decision 18). Source of the format: W3C,
// "Portable Network Graphics (PNG) Specification (Second Edition)".

#include "scenefile/asset/codec.h"
#include "scenefile/asset/image_stream.h"
#include "scenefile/asset/png_packer.h"

#include <algorithm>
#include <vector>

namespace scenefile {

namespace {

void append_big_endian(std::string& bytes, std::uint32_t value) {
  for (int shift = 24; shift >= 0; shift -= 8) {
    bytes.push_back(static_cast<char>(value >> shift & 255));
  }
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
  Rows(int width, int bits, Rounding rounding)
      : bits_(bits),
        rounding_(rounding),
        samples_(std::size_t{3} * static_cast<std::size_t>(width)),
        row_(samples_ * static_cast<std::size_t>(bits) / 8) {}

  void append(const float* values, std::vector<std::uint8_t>& to) {
    constexpr std::uint8_t filter_sub = 1;
    if (bits_ == 8) {
      quantize(values, samples_, rounding_, row_.data());
    } else {
      quantize_16_bit(values, samples_, rounding_, row_.data());
    }
    const std::size_t start = to.size() + 1;
    const std::size_t pixel = static_cast<std::size_t>(bits_) / 8 * 3;
    to.push_back(filter_sub);
    to.insert(to.end(), row_.begin(), row_.end());
    // Local copies, because bytes may alias the vectors themselves, which prevents vectorization.
    const std::uint8_t* const from = row_.data();
    std::uint8_t* const difference = to.data() + start;
    const std::size_t size = row_.size();
    for (std::size_t i = pixel; i < size; ++i) {
      difference[i] = static_cast<std::uint8_t>(from[i] - from[i - pixel]);
    }
  }

 private:
  int bits_;
  Rounding rounding_;
  std::size_t samples_;
  std::vector<std::uint8_t> row_;
};

void append_header(int width, int height, int bits, std::string& file) {
  constexpr char rgb = 2;
  append_big_endian(file, static_cast<std::uint32_t>(width));
  append_big_endian(file, static_cast<std::uint32_t>(height));
  file += {static_cast<char>(bits), rgb, 0, 0, 0};
}

constexpr std::string_view file_start("\x89PNG\r\n\x1a\n", 8);
constexpr std::size_t text_chunk = file_start.size() + 12 + 13;  // after IHDR

}  // namespace

void renew_png_text(std::string& file) {
  if (!file.starts_with(file_start) || file.find("tEXt") != text_chunk + 4) {
    return;
  }
  std::size_t count = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    count = count << 8 | static_cast<unsigned char>(file[text_chunk + i]);
  }
  std::string crc;
  append_big_endian(crc, crc_of(file.data() + text_chunk + 4, count + 4));
  file.replace(text_chunk + 8 + count, crc.size(), crc);
}

bool stream_png(int width, int height, int bits, Rounding rounding, const RowSource& rows,
                const ByteSink& sink, std::string_view text) {
  constexpr std::size_t piece = 1 << 16;
  std::string file(file_start);
  add_chunk(file, "IHDR", [&] { append_header(width, height, bits, file); });
  if (!text.empty()) {
    add_chunk(file, "tEXt", [&] { file.append("scenefile").append(1, '\0').append(text); });
  }
  PngPacker packer;
  Rows filtered(width, bits, rounding);
  std::vector<std::uint8_t> ready;
  for (int y = 0; y < height; ++y) {
    const float* const row = rows(y);
    if (row == nullptr) {
      return false;
    }
    filtered.append(row, ready);
    const bool last = y + 1 == height;
    if (ready.size() >= piece || last) {
      add_chunk(file, "IDAT", [&] { packer.put(ready, last, file); });
      ready.clear();
      if (!sink.append(file)) {
        return false;
      }
      file.clear();
    }
  }
  return sink.append(std::string_view("\0\0\0\0IEND\xae\x42\x60\x82", 12));
}

std::string encode_png(const Image& image, int bits, Rounding rounding, std::string_view text) {
  std::string file;
  stream_png(
      image.width, image.height, bits, rounding, [&](int y) { return image.pixel(0, y); },
      sink_to(file), text);
  return file;
}

}  // namespace scenefile
