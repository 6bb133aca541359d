// Files that are truncated, damaged, or lie about their size.

#include "asset/sample_files.h"
#include "support/cpu_time.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <png.h>
#include <zlib.h>

namespace scenefile {
namespace {

using test::decode;
using test::Decoded;
using test::fixture;
using test::u16;
using test::u32;
using ::testing::AnyOf;
using ::testing::HasSubstr;

// Every prefix of every fixture is rejected, or decoded completely if only a trailer is missing.
TEST(HostileImage, CutAtEveryByte) {
  for (const std::string& name : test::image_fixtures()) {
    const std::string whole = fixture(name);
    const Texture expected = decode(whole).texture;
    std::size_t accepted = 0;
    for (std::size_t size = 0; size < whole.size(); ++size) {
      const Decoded d = decode(std::string_view(whole).substr(0, size));
      if (d.error.empty()) {
        ++accepted;
        ASSERT_EQ(d.texture.rgb, expected.rgb) << name << " cut to " << size;
      }
    }
    // The GIF trailer and the end code; padding of the last BMP row; the footer of TGA.
    EXPECT_LE(accepted, 30u) << name;
  }
}

// The checksum of the empty last chunk protects nothing, and libpng 1.6.48 does not compare it.
TEST(HostileImage, EveryFlippedByteOfAPngIsNoticed) {
  const std::string whole = fixture("rgb.png");
  const Texture expected = decode(whole).texture;
  for (std::size_t at = 0; at < whole.size(); ++at) {
    std::string bytes = whole;
    bytes[at] = static_cast<char>(bytes[at] ^ 0x20);
    const Decoded d = decode(bytes);
    if (at + 4 < whole.size() || !d.error.empty()) {
      EXPECT_NE(d.error, "") << at;
    } else {
      EXPECT_EQ(d.texture.rgb, expected.rgb) << at;
    }
  }
}

std::string png_header(unsigned width, unsigned height, int depth, int color_type) {
  const auto big = [](unsigned v) {
    return std::string{static_cast<char>(v >> 24), static_cast<char>(v >> 16),
                       static_cast<char>(v >> 8), static_cast<char>(v)};
  };
  return std::string("\x89PNG\r\n\x1a\n") +
         test::png_chunk("IHDR", big(width) + big(height) +
                                     std::string{static_cast<char>(depth),
                                                 static_cast<char>(color_type), 0, 0, 0});
}

TEST(HostileImage, PngWithAWrongSize) {
  const std::string end = test::png_chunk("IDAT", "\x78\x9c\x63\x60") + test::png_chunk("IEND", "");
  const struct {
    unsigned width, height;
    const char* error;
    bool over_limit;
  } cases[] = {
      {0, 4, "PNG of 0 x 4 pixels: an image needs at least one pixel", false},
      {4, 0, "PNG of 4 x 0 pixels: an image needs at least one pixel", false},
      {0x7fffffff, 0x7fffffff, "the limit is 16384 pixels on a side", true},
      {0xffffffff, 0xffffffff, "the limit is 16384 pixels on a side", true},
      {16385, 1, "the limit is 16384 pixels on a side", true},
      {16384, 16384, "that many cannot be in ", false},
  };
  for (const auto& c : cases) {
    const Decoded d = decode(png_header(c.width, c.height, 8, 2) + end);
    EXPECT_THAT(d.error, HasSubstr(c.error));
    EXPECT_EQ(d.over_limit, c.over_limit) << d.error;
  }
  Limits tight;
  tight.texture_bytes = 1000;
  EXPECT_THAT(decode(png_header(19, 19, 8, 2) + end, tight).error, HasSubstr("that takes 1 MB"));
  EXPECT_TRUE(decode(png_header(19, 19, 8, 2) + end, tight).over_limit);
  EXPECT_FALSE(decode(png_header(18, 18, 8, 2) + end, tight).over_limit) << "972 bytes fit";
}

TEST(HostileImage, PngWithoutItsPaletteOrBeyondIt) {
  const std::string end = test::png_chunk("IEND", "");
  const std::string no_palette =
      png_header(8, 1, 1, 3) +
      test::png_chunk("IDAT", std::string("\x78\x9c\x63\x58\x05\x00\x00\xac\x00\xab", 10)) + end;
  EXPECT_THAT(decode(no_palette).error, HasSubstr("PLTE"));
  const std::vector<std::array<std::uint8_t, 3>> palette = {{{1, 2, 3}}, {{4, 5, 6}}};
  const std::string row("\x00\x01\x01\x02", 4);
  EXPECT_THAT(decode(test::make_png(4, 1, 8, PNG_COLOR_TYPE_PALETTE, false, {row}, palette)).error,
              HasSubstr("beyond the end of the palette"));
  const std::string fine("\x00\x01\x01\x00", 4);
  EXPECT_EQ(decode(test::make_png(4, 1, 8, PNG_COLOR_TYPE_PALETTE, false, {fine}, palette)).error,
            "");
}

// Chunks that decompress to large data, or contain nonsense, are skipped.
TEST(HostileImage, PngAncillaryChunksAreSkipped) {
  const std::string whole = fixture("rgb.png");
  const std::string before = whole.substr(0, 33);
  for (const char* type : {"zTXt", "iCCP", "gAMA", "tRNS", "tEXt", "eXIf", "sPLT", "abCd"}) {
    const std::string bytes =
        before + test::png_chunk(type, std::string("x\0\0junk", 7)) + whole.substr(33);
    EXPECT_EQ(decode(bytes).error, "") << type;
    EXPECT_EQ(decode(bytes).texture.rgb, decode(whole).texture.rgb) << type;
  }
  EXPECT_NE(decode(before + test::png_chunk("ABCD", "") + whole.substr(33)).error, "")
      << "an unknown critical chunk";
}

TEST(HostileImage, PngTextsAreNotUnpacked) {
  const std::string zeros(7'900'000, '\0');
  uLongf size = compressBound(zeros.size());
  std::string packed(size, '\0');
  ASSERT_EQ(compress(reinterpret_cast<Bytef*>(packed.data()), &size,
                     reinterpret_cast<const Bytef*>(zeros.data()), zeros.size()),
            Z_OK);
  const std::string text =
      test::png_chunk("zTXt", std::string("x\0\0", 3) + packed.substr(0, size));
  const std::string whole = fixture("rgb.png");
  std::string bytes = whole.substr(0, 33);
  for (int i = 0; i < 60; ++i) {
    bytes += text;
  }
  const double start = cpu_seconds();
  EXPECT_EQ(decode(bytes + whole.substr(33)).error, "");
  EXPECT_LT(cpu_seconds() - start, 1);
}

// A PNG of 4 x 4 gray pixels, followed by surplus bytes in the compressed data.
std::string png_with_surplus(std::size_t surplus) {
  const std::string pixels(4 * 5 + surplus, '\0');
  uLongf size = compressBound(pixels.size());
  std::string packed(size, '\0');
  EXPECT_EQ(compress2(reinterpret_cast<Bytef*>(packed.data()), &size,
                      reinterpret_cast<const Bytef*>(pixels.data()), pixels.size(), 0),
            Z_OK);
  return png_header(4, 4, 8, 0) + test::png_chunk("IDAT", packed.substr(0, size)) +
         test::png_chunk("IEND", "");
}

TEST(HostileImage, PngDataAfterTheLastPixelIsNotDecompressed) {
  EXPECT_EQ(decode(png_with_surplus(1000)).error, "");
  EXPECT_THAT(decode(png_with_surplus(200'000)).error, HasSubstr("far more data than pixels"));
}

TEST(HostileImage, JpegWithAWrongSize) {
  std::string bytes = fixture("rgb.jpg");
  const std::size_t frame = bytes.find("\xff\xc0");
  ASSERT_NE(frame, std::string::npos);
  const auto sized = [&](unsigned width, unsigned height) {
    std::string changed = bytes;
    changed[frame + 5] = static_cast<char>(height >> 8);
    changed[frame + 6] = static_cast<char>(height);
    changed[frame + 7] = static_cast<char>(width >> 8);
    changed[frame + 8] = static_cast<char>(width);
    return changed;
  };
  EXPECT_THAT(decode(sized(65535, 65535)).error, HasSubstr("65500"));
  EXPECT_THAT(decode(sized(20000, 8)).error, HasSubstr("16384 pixels on a side"));
  EXPECT_NE(decode(sized(0, 8)).error, "");
  EXPECT_NE(decode(sized(8, 0)).error, "");
  EXPECT_NE(decode(sized(9000, 9000)).error, "");
  EXPECT_NE(decode(sized(17, 40)).error, "") << "rows are missing";
}

// A progressive JPEG needs all its coefficients at once.
TEST(HostileImage, JpegWorkingMemoryIsBounded) {
  Limits tight;
  tight.texture_bytes = 3 * 17 * 11 + 2000;
  EXPECT_THAT(decode(fixture("progressive.jpg"), tight).error, HasSubstr("decoding that takes"));
  EXPECT_TRUE(decode(fixture("progressive.jpg"), tight).over_limit);
}

TEST(HostileImage, JpegOfEndlessPasses) {
  const std::string whole = fixture("progressive.jpg");
  // Repeats the first scan many times.
  const std::size_t begin = whole.find("\xff\xda");
  const std::size_t end = whole.find("\xff\xc4", begin);
  std::string bytes = whole.substr(0, end);
  for (int i = 0; i < 200; ++i) {
    bytes += whole.substr(begin, end - begin);
  }
  EXPECT_THAT(decode(bytes + whole.substr(end)).error, HasSubstr("100 passes"));
}

// A table that declares more codes than there are symbols.
TEST(HostileImage, JpegWithAnImpossibleHuffmanTable) {
  std::string bytes = fixture("rgb.jpg");
  const std::size_t table = bytes.find("\xff\xc4");
  ASSERT_NE(table, std::string::npos);
  for (std::size_t i = 0; i < 16; ++i) {
    bytes[table + 5 + i] = '\xff';
  }
  EXPECT_THAT(decode(bytes).error, HasSubstr("Huffman"));
}

std::string gif(unsigned width, unsigned height, const std::string& rest) {
  return std::string("GIF89a") + u16(width) + u16(height) + std::string("\x80\0\0", 3) +
         std::string("\x0a\x14\x1e\xff\xff\xff", 6) + rest;
}

std::string frame(unsigned left, unsigned top, unsigned width, unsigned height,
                  const std::string& data) {
  return std::string(",") + u16(left) + u16(top) + u16(width) + u16(height) + std::string(1, '\0') +
         data;
}

TEST(HostileImage, GifByHand) {
  // Codes: clear, 1, 0, 1 in 3 bits, 1 and end in 4.
  const std::string pixels("\x02\x03\x0c\x12\x05\x00", 6);
  const Decoded whole = decode(gif(2, 2, frame(0, 0, 2, 2, pixels)));
  ASSERT_EQ(whole.error, "");
  EXPECT_EQ(whole.texture.rgb,
            (std::vector<std::uint8_t>{255, 255, 255, 10, 20, 30, 255, 255, 255, 255, 255, 255}));
  // A frame smaller than the image leaves the rest as background.
  const std::string one("\x02\x02\x4c\x01\x00", 5);
  const Decoded part = decode(gif(2, 2, frame(1, 0, 1, 1, one)));
  ASSERT_EQ(part.error, "");
  EXPECT_EQ(test::color_at(part.texture, 1, 0), (test::Color{255, 255, 255}));
  EXPECT_EQ(test::color_at(part.texture, 0, 1), (test::Color{10, 20, 30}));
}

TEST(HostileImage, GifThatMakesNoSense) {
  const std::string pixels("\x02\x03\x0c\x12\x05\x00", 6);
  const std::pair<std::string, const char*> cases[] = {
      {gif(2, 2, ";"), "it contains no image"},
      {gif(2, 2, ""), "it contains no image"},
      {gif(2, 2,
           std::string("!\xfe\x03"
                       "abc\0",
                       7)),
       "it contains no image"},
      {gif(2, 2, frame(1, 0, 2, 2, pixels)), "reaches beyond the image"},
      {gif(2, 2, frame(0, 0, 0, 2, pixels)), "empty or reaches"},
      {gif(2, 2, frame(0, 0, 2, 2, std::string("\x0c") + pixels.substr(1))),
       "impossible number of bits"},
      {gif(2, 2, frame(0, 0, 2, 2, std::string("\x02\x01\xfc\x00", 4))), "invalid code"},
      {gif(2, 2, frame(0, 0, 2, 2, std::string("\x02\x01\x1c\x00", 4))), "palette"},
      {gif(2, 2, frame(0, 0, 2, 2, std::string("\x02\x01\x0c\x00", 4))), "ends early"},
      {gif(2, 2, frame(0, 0, 2, 2, std::string("\x02\x01\x2c\x00", 4))), "ends early"},
      {gif(0, 2, frame(0, 0, 2, 2, pixels)), "at least one pixel"},
      {gif(16000, 16000, frame(0, 0, 2, 2, pixels)), "that many cannot be in"},
      {gif(65535, 65535, ";"), "16384 pixels on a side"},
  };
  for (const auto& [bytes, error] : cases) {
    EXPECT_THAT(decode(bytes).error, HasSubstr(error));
  }
}

TEST(HostileImage, BmpThatMakesNoSense) {
  const auto bmp = [](unsigned at, unsigned header, unsigned width, unsigned height, unsigned bits,
                      unsigned compression, unsigned colors) {
    return std::string("BM") + u32(0) + u32(0) + u32(at) + u32(header) + u32(width) + u32(height) +
           u16(1) + u16(bits) + u32(compression) + std::string(12, '\0') + u32(colors) + u32(0) +
           std::string(64, '\1');
  };
  EXPECT_EQ(decode(bmp(54, 40, 2, 2, 24, 0, 0)).error, "");
  const std::pair<std::string, const char*> cases[] = {
      {bmp(54, 40, 2, 2, 8, 1, 0), "run-length"},
      {bmp(54, 40, 2, 2, 24, 3, 0), "unknown compression 3"},
      {bmp(54, 40, 2, 2, 32, 9, 0), "unknown compression 9"},
      {bmp(54, 40, 2, 2, 7, 0, 0), "unknown depth of 7 bits"},
      {bmp(54, 39, 2, 2, 24, 0, 0), "unknown header of 39 bytes"},
      {bmp(10, 40, 2, 2, 24, 0, 0), "begin inside its header"},
      {bmp(54, 40, 2, 2, 8, 0, 300), "a palette of 300 colors"},
      {bmp(58, 40, 2, 2, 8, 0, 1), "beyond the end of the palette"},
      {bmp(4000000000u, 40, 2, 2, 24, 0, 0), "that many cannot be in"},
      {bmp(54, 40, 2, 30, 24, 0, 0), "that many cannot be in"},
      {bmp(54, 40, 0x80000000u, 2, 24, 0, 0), "at least one pixel"},
      {bmp(54, 40, 2, 0x80000000u, 24, 0, 0), "pixels on a side"},
      {bmp(54, 40, 0x7fffffff, 0x7fffffff, 32, 0, 0), "pixels on a side"},
  };
  for (const auto& [bytes, error] : cases) {
    EXPECT_THAT(decode(bytes).error, HasSubstr(error));
  }
}

TEST(HostileImage, TgaIsKnownOnlyWhenItMakesSense) {
  const std::string unknown = "this is not a PNG, JPEG, GIF, TGA or BMP image";
  const std::string whole = fixture("rgb.tga");
  const auto with = [&](std::size_t at, int value) {
    std::string bytes = whole;
    bytes[at] = static_cast<char>(value);
    return decode(bytes).error;
  };
  EXPECT_EQ(with(1, 2), unknown);      // palette type
  EXPECT_EQ(with(2, 4), unknown);      // image type
  EXPECT_EQ(with(5, 1), unknown);      // a palette length without a palette
  EXPECT_EQ(with(16, 23), unknown);    // bits
  EXPECT_EQ(with(17, 0x40), unknown);  // interleaving
  EXPECT_THAT(with(12, 100), HasSubstr("TGA of 100 x 11 pixels: that many cannot be in"));
  EXPECT_EQ(decode("this is not an image\n").error, unknown);
  EXPECT_EQ(decode("<svg xmlns=\"http://www.w3.org/2000/svg\"/>").error, unknown);
  EXPECT_EQ(decode(std::string(64, '\0')).error, unknown);
}

TEST(HostileImage, TgaPacketsThatEndEarly) {
  const std::string head = std::string("\0\0\x0a", 3) + std::string(9, '\0') + u16(200) + u16(2) +
                           std::string("\x18\x20", 2);
  const std::string run = "\xff\7\7\7";
  const std::string run_of_16 = "\x8f\7\7\7";
  EXPECT_EQ(decode(head + run + run + run + run_of_16).error, "");
  EXPECT_THAT(decode(head + run + run + run).error, HasSubstr("ends early"));
  EXPECT_THAT(decode(head + run).error, HasSubstr("that many cannot be in"));
}

// In TGA 1, packets may continue in the next row, but not past the end of the picture.
TEST(HostileImage, TgaPacketsThatRunTooFar) {
  const std::string head = std::string("\0\0\x0a", 3) + std::string(9, '\0') + u16(3) + u16(2) +
                           std::string("\x18\x20", 2);
  const std::string four = "\x83\7\7\7";
  const std::string two = "\x81\x9\x9\x9";
  const Decoded whole = decode(head + four + two);
  EXPECT_EQ(whole.error, "");
  EXPECT_THAT(decode(head + four + four).error, HasSubstr("continues past the last pixel"));
  const std::string three_raw = "\2\1\1\1\2\2\2\3\3\3";
  EXPECT_THAT(decode(head + four + three_raw).error, HasSubstr("continues past the last pixel"));
}

}  // namespace
}  // namespace scenefile
