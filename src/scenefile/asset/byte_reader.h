#pragma once
// Little-endian numbers out of bytes. Internal to asset.

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace scenefile {

/// Reads forward; past the end it returns zeros and records the overrun.
class ByteReader {
 public:
  explicit ByteReader(std::string_view bytes, std::size_t at = 0) : bytes_(bytes) { skip(at); }

  std::uint32_t u8() {
    if (at_ >= bytes_.size()) {
      ended_ = true;
      return 0;
    }
    return static_cast<std::uint8_t>(bytes_[at_++]);
  }
  std::uint32_t u16() {
    const std::uint32_t low = u8();
    return low | u8() << 8;
  }
  std::uint32_t u32() {
    const std::uint32_t low = u16();
    return low | u16() << 16;
  }
  void skip(std::size_t count) {
    ended_ = ended_ || count > left();
    at_ += count < left() ? count : left();
  }

  std::size_t at() const { return at_; }
  std::size_t left() const { return bytes_.size() - at_; }
  /// Whether a read went past the end.
  bool ended() const { return ended_; }

 private:
  std::string_view bytes_;
  std::size_t at_ = 0;
  bool ended_ = false;
};

}  // namespace scenefile
