// PPM, PGM and PFM: a text header, then numbers. Sources: netpbm, "ppm" and "pgm"; Debevec, "PFM
// Portable FloatMap Image Format".

#include "scenefile/asset/codec.h"
#include "scenefile/base/number.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <charconv>

namespace scenefile {

namespace {

bool is_space(char c) {
  return c == ' ' || (c >= '\t' && c <= '\r');
}

// Reads words separated by white space and comments, which reach from # to the end of the line.
class Words {
 public:
  explicit Words(std::string_view bytes, std::size_t at = 0) : bytes_(bytes), at_(at) {}

  std::string_view next() {
    while (at_ < bytes_.size() && (is_space(bytes_[at_]) || bytes_[at_] == '#')) {
      at_ = bytes_[at_] == '#' ? std::min(bytes_.find('\n', at_), bytes_.size()) : at_ + 1;
    }
    const std::size_t start = at_;
    while (at_ < bytes_.size() && !is_space(bytes_[at_]) && bytes_[at_] != '#') {
      ++at_;
    }
    return bytes_.substr(start, at_ - start);
  }
  /// A number without a sign; nullopt if the next word is something else, or too large.
  std::optional<std::uint32_t> number() {
    const std::string_view word = next();
    std::uint32_t value = 0;
    const auto [end, wrong] = std::from_chars(word.data(), word.data() + word.size(), value);
    return wrong == std::errc() && end == word.data() + word.size() ? std::optional(value)
                                                                    : std::nullopt;
  }
  std::size_t at() const { return at_; }

 private:
  std::string_view bytes_;
  std::size_t at_;
};

bool begins_with_p(std::string_view bytes, std::string_view kinds) {
  return bytes.size() > 2 && bytes[0] == 'P' && kinds.find(bytes[1]) != std::string_view::npos &&
         (is_space(bytes[2]) || bytes[2] == '#');
}

bool recognizes_pnm(std::string_view bytes) {
  return begins_with_p(bytes, "2356");
}

bool recognizes_pfm(std::string_view bytes) {
  return begins_with_p(bytes, "Ff");
}

struct PnmHeader {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::uint32_t max = 0;  // the value of full intensity
  bool color = false;
  bool text = false;
  std::size_t pixels_at = 0;

  std::size_t values() const { return color ? 3 : 1; }
  std::size_t value_bytes() const { return max > 255 ? 2 : 1; }
};

Result<PnmHeader> pnm_header(std::string_view bytes) {
  Words words(bytes, 2);
  const auto width = words.number();
  const auto height = words.number();
  const auto max = words.number();
  if (!width || !height || !max || *max == 0 || *max > 65535) {
    return input_error("expected the width, the height and the largest value, 1 to 65535");
  }
  const bool text = bytes[1] == '2' || bytes[1] == '3';
  // One character of white space ends the header.
  const std::size_t pixels_at = words.at() + (text ? 0 : 1);
  return PnmHeader{*width, *height, *max, bytes[1] == '3' || bytes[1] == '6', text, pixels_at};
}

Result<ImageHeader> read_pnm_header(std::string_view bytes) {
  const Result<PnmHeader> h = pnm_header(bytes);
  if (!h) {
    return h.error();
  }
  // May wrap around for sizes that are rejected before it is used. A number as text takes at least
  // a digit and a space.
  const std::uint64_t value_bytes = h->text ? 2 : h->value_bytes();
  const std::uint64_t data = h->values() * value_bytes * h->width * h->height;
  return ImageHeader{
      .width = h->width, .height = h->height, .min_bytes = h->pixels_at + data - (h->text ? 1 : 0)};
}

Result<void> decode_pnm(std::string_view bytes, DecodedPicture& picture) {
  Texture& texture = picture.texture;
  const Result<PnmHeader> h = pnm_header(bytes);
  if (!h) {
    return h.error();
  }
  Words words(bytes, h->pixels_at);
  std::size_t at = h->pixels_at;
  const std::size_t count = h->values() * h->width * h->height;
  for (std::size_t i = 0; i < count; ++i) {
    std::optional<std::uint32_t> value;
    if (h->text) {
      value = words.number();
    } else {
      value = 0;
      for (std::size_t k = 0; k < h->value_bytes(); ++k, ++at) {
        value = *value << 8 | static_cast<std::uint8_t>(bytes[at]);
      }
    }
    if (!value || *value > h->max) {
      return input_error(value ? fmt::format("the value {} exceeds the maximum {}", *value, h->max)
                               : "a value is missing or not a number");
    }
    const auto byte = static_cast<std::uint8_t>((*value * 255 + h->max / 2) / h->max);
    texture.rgb.insert(texture.rgb.end(), h->color ? 1 : 3, byte);
  }
  return {};
}

struct PfmHeader {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  bool color = false;
  bool little_endian = false;
  std::size_t pixels_at = 0;

  std::size_t values() const { return color ? 3 : 1; }
};

Result<PfmHeader> pfm_header(std::string_view bytes) {
  Words words(bytes, 2);
  const auto width = words.number();
  const auto height = words.number();
  const std::string_view scale = words.next();
  const ParsedNumber number = parse_number(scale);
  if (!width || !height || number.error != NumberError::none || number.value == 0) {
    return input_error("expected the width, the height and a scale other than 0");
  }
  return PfmHeader{*width, *height, bytes[1] == 'F', number.value < 0, words.at() + 1};
}

Result<ImageHeader> read_pfm_header(std::string_view bytes) {
  const Result<PfmHeader> h = pfm_header(bytes);
  if (!h) {
    return h.error();
  }
  return ImageHeader{
      .width = h->width,
      .height = h->height,
      .min_bytes = h->pixels_at + std::uint64_t{4} * h->values() * h->width * h->height};
}

Result<void> decode_pfm(std::string_view bytes, std::string_view, Image& image) {
  const Result<PfmHeader> h = pfm_header(bytes);
  if (!h) {
    return h.error();
  }
  const auto* from = reinterpret_cast<const std::uint8_t*>(bytes.data()) + h->pixels_at;
  const auto next = [&] {
    std::uint32_t bits = 0;
    for (int k = 0; k < 4; ++k) {
      const int shift = h->little_endian ? 8 * k : 24 - 8 * k;
      bits |= std::uint32_t{*from++} << shift;
    }
    return std::bit_cast<float>(bits);
  };
  for (int y = image.height - 1; y >= 0; --y) {
    float* const row = image.pixel(0, y);
    for (int i = 0; i < 3 * image.width; ++i) {
      row[i] = i % 3 == 0 || h->color ? next() : row[i - 1];
    }
  }
  return {};
}

}  // namespace

const Codec pnm_codec{{"PPM", ".ppm .pgm .pnm"}, recognizes_pnm, read_pnm_header, decode_pnm};
const Codec pfm_codec{{"PFM", ".pfm"}, recognizes_pfm, read_pfm_header, nullptr, decode_pfm};

}  // namespace scenefile
