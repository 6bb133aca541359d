#include "asset/sample_files.h"

#include <gtest/gtest.h>
#include <png.h>

#include <cstdlib>
#include <functional>

namespace scenefile {
namespace {

using test::Color;
using test::color_at;
using test::decode;
using test::Decoded;
using test::fixture;
using test::u16;
using test::u32;

void expect_picture(const std::string& name, const std::function<Color(int, int)>& expected,
                    int tolerance) {
  const Decoded decoded = decode(fixture(name));
  ASSERT_EQ(decoded.error, "") << name;
  ASSERT_EQ(decoded.texture.width, test::fixture_width) << name;
  ASSERT_EQ(decoded.texture.height, test::fixture_height) << name;
  for (int y = 0; y < decoded.texture.height; ++y) {
    for (int x = 0; x < decoded.texture.width; ++x) {
      const Color color = color_at(decoded.texture, x, y);
      for (int i = 0; i < 3; ++i) {
        ASSERT_LE(std::abs(color[i] - expected(x, y)[i]), tolerance)
            << name << " at " << x << " " << y << " channel " << i;
      }
    }
  }
}

TEST(DecodeImage, FilesOfAnotherEncoder) {
  for (const char* name :
       {"rgb.png", "rgba.png", "palette.png", "palette.gif", "rgb.tga", "rgb_rle.tga", "rgba.tga",
        "palette_rle.tga", "rgb.bmp", "palette.bmp"}) {
    expect_picture(name, test::sharp, 0);
  }
  for (const char* name : {"gray.png", "gray16.png", "gray.tga"}) {
    expect_picture(name, test::gray, 0);
  }
  for (const char* name : {"two.png", "two.gif", "two.bmp"}) {
    expect_picture(name, test::two, 0);
  }
  for (const char* name : {"rgb.jpg", "progressive.jpg"}) {
    expect_picture(name, test::smooth, 5);
  }
  expect_picture("cmyk.jpg", test::smooth, 6);
  expect_picture("gray.jpg", test::gray, 4);
  const Decoded noise = decode(fixture("noise.gif"));
  ASSERT_EQ(noise.error, "");
  ASSERT_EQ(noise.texture.width, 72);
  for (int y = 0; y < 72; ++y) {
    for (int x = 0; x < 72; ++x) {
      ASSERT_EQ(color_at(noise.texture, x, y)[0], (x * x * 7 + y * 131 + x * y * 29) % 251);
    }
  }
  EXPECT_EQ(test::image_fixtures().size(), 21u) << "name a new one above";
}

TEST(DecodeImage, TellsImagesFromScenes) {
  for (const char* name : {"rgb.png", "rgb.jpg", "palette.gif", "rgb.tga", "rgb.bmp"}) {
    EXPECT_TRUE(is_image(fixture(name))) << name;
  }
  for (const char* text : {"", "<scenefile>", "{\"globalData\": {}}", "  <!-- a scene -->"}) {
    EXPECT_FALSE(is_image(text)) << text;
  }
}

TEST(DecodeImage, PngWithSixteenBitsIsRounded) {
  // 0x10f0 is 16.87 of 255, 0xf010 is 239.13.
  const std::string row("\x10\xf0\xf0\x10\xff\xff\x00\x00\x01\x01\x00\x80", 12);
  for (const bool interlaced : {false, true}) {
    const Decoded d = decode(test::make_png(2, 1, 16, PNG_COLOR_TYPE_RGB, interlaced, {row}));
    ASSERT_EQ(d.error, "");
    EXPECT_EQ(color_at(d.texture, 0, 0), (Color{17, 239, 255}));
    EXPECT_EQ(color_at(d.texture, 1, 0), (Color{0, 1, 0}));
  }
}

TEST(DecodeImage, InterlacedPngOfManySizes) {
  for (int width = 1; width <= 9; ++width) {
    for (int height = 1; height <= 9; ++height) {
      std::vector<std::string> rows;
      for (int y = 0; y < height; ++y) {
        std::string row;
        for (int x = 0; x < width; ++x) {
          row += {static_cast<char>(20 * x), static_cast<char>(20 * y), static_cast<char>(x ^ y)};
        }
        rows.push_back(row);
      }
      const Decoded d = decode(test::make_png(width, height, 8, PNG_COLOR_TYPE_RGB, true, rows));
      ASSERT_EQ(d.error, "");
      EXPECT_EQ(color_at(d.texture, width - 1, height - 1),
                (Color{20 * (width - 1), 20 * (height - 1), (width - 1) ^ (height - 1)}));
      EXPECT_EQ(color_at(d.texture, width / 2, height / 2)[0], 20 * (width / 2));
    }
  }
}

TEST(DecodeImage, GrayOfFewBitsIsStretched) {
  EXPECT_EQ(
      color_at(decode(test::make_png(4, 1, 2, PNG_COLOR_TYPE_GRAY, false, {"\x1b"})).texture, 2, 0),
      (Color{170, 170, 170}));
  EXPECT_EQ(
      color_at(decode(test::make_png(2, 1, 4, PNG_COLOR_TYPE_GRAY, false, {"\x5f"})).texture, 0, 0),
      (Color{85, 85, 85}));
}

// Alpha does not darken: fully transparent pixels keep their color.
TEST(DecodeImage, AlphaIsDropped) {
  const std::string row("\x0a\x14\x1e\x00\x28\x32\x3c\x80", 8);
  const Decoded d = decode(test::make_png(2, 1, 8, PNG_COLOR_TYPE_RGB_ALPHA, false, {row}));
  EXPECT_EQ(color_at(d.texture, 0, 0), (Color{10, 20, 30}));
  EXPECT_EQ(color_at(d.texture, 1, 0), (Color{40, 50, 60}));
}

std::string tga(int type, int width, int height, int bits, int descriptor,
                const std::string& data) {
  return std::string{0, 0, static_cast<char>(type)} + std::string(9, '\0') +
         u16(static_cast<unsigned>(width)) + u16(static_cast<unsigned>(height)) +
         std::string{static_cast<char>(bits), static_cast<char>(descriptor)} + data;
}

TEST(DecodeImage, TgaCornersAndSixteenBits) {
  const std::string data = u16(31 << 10) + u16(31 << 5) + u16(31) + u16(0x7fff);
  const Color red{255, 0, 0}, green{0, 255, 0}, blue{0, 0, 255}, white{255, 255, 255};
  const struct {
    int descriptor;
    Color corners[4];  // top left, top right, bottom left, bottom right
  } cases[] = {{0x00, {blue, white, red, green}},
               {0x20, {red, green, blue, white}},
               {0x10, {white, blue, green, red}},
               {0x30, {green, red, white, blue}}};
  for (const auto& c : cases) {
    const Decoded d = decode(tga(2, 2, 2, 16, c.descriptor, data));
    ASSERT_EQ(d.error, "");
    for (int i = 0; i < 4; ++i) {
      EXPECT_EQ(color_at(d.texture, i % 2, i / 2), c.corners[i]) << c.descriptor << " " << i;
    }
  }
}

TEST(DecodeImage, TgaPaletteThatBeginsLater) {
  std::string bytes = tga(1, 2, 1, 8, 0x20, "");
  bytes[1] = 1;
  bytes[3] = 100;  // the first index
  bytes[5] = 2;    // the number of them
  bytes[7] = 24;
  bytes += std::string("\x01\x02\x03\x04\x05\x06", 6);
  EXPECT_EQ(color_at(decode(bytes + "\x65\x64").texture, 0, 0), (Color{6, 5, 4}));
  EXPECT_EQ(color_at(decode(bytes + "\x65\x64").texture, 1, 0), (Color{3, 2, 1}));
  EXPECT_NE(decode(bytes + "\x65\x66").error.find("beyond the end of the palette"),
            std::string::npos);
  EXPECT_NE(decode(bytes + "\x65\x01").error.find("beyond the end of the palette"),
            std::string::npos);
}

std::string bmp(unsigned width, unsigned height, unsigned bits, unsigned compression,
                const std::string& extra, const std::string& data) {
  const auto at = static_cast<unsigned>(54 + extra.size());
  return std::string("BM") + u32(0) + u32(0) + u32(at) + u32(40) + u32(width) + u32(height) +
         u16(1) + u16(bits) + u32(compression) + std::string(20, '\0') + extra + data;
}

TEST(DecodeImage, BmpTopDownMasksAndHalfBytes) {
  const std::string two_rows = std::string("\x01\x02\x03\0\x04\x05\x06\0", 8);
  EXPECT_EQ(color_at(decode(bmp(1, 2, 24, 0, "", two_rows)).texture, 0, 0), (Color{6, 5, 4}));
  EXPECT_EQ(color_at(decode(bmp(1, 0u - 2, 24, 0, "", two_rows)).texture, 0, 0), (Color{3, 2, 1}));
  // 565 color masks, and masks of 10 bits each in 32.
  const std::string masks = u32(0xf800) + u32(0x07e0) + u32(0x001f);
  EXPECT_EQ(color_at(decode(bmp(1, 1, 16, 3, masks, u16(0xf800 | 32 << 5) + u16(0))).texture, 0, 0),
            (Color{255, 130, 0}));
  const std::string deep = u32(0x3ffu << 20) + u32(0x3ff << 10) + u32(0x3ff);
  EXPECT_EQ(color_at(decode(bmp(1, 1, 32, 3, deep, u32(1023u << 20 | 512 << 10))).texture, 0, 0),
            (Color{255, 128, 0}));
  EXPECT_EQ(color_at(decode(bmp(1, 1, 16, 0, "", u16(31 << 10) + u16(0))).texture, 0, 0),
            (Color{255, 0, 0}));
  std::string palette;
  for (unsigned i = 0; i < 16; ++i) {
    palette += u32(i << 16 | i << 8 | 2 * i);
  }
  EXPECT_EQ(
      color_at(decode(bmp(2, 1, 4, 0, palette, std::string("\x3a") + std::string(3, '\0'))).texture,
               1, 0),
      (Color{10, 10, 20}));
}

TEST(DecodeImage, TheBytesDecideNotTheName) {
  const std::string bytes = fixture("rgb.jpg");
  EXPECT_EQ(decode(bytes).error, "");  // the file name does not matter
  EXPECT_EQ(decode("\n" + bytes).error, "this is not a PNG, JPEG, GIF, TGA or BMP image");
  EXPECT_EQ(decode("").error, "the file is empty");
}

TEST(DecodeImage, BudgetShrinksOverSeveralImages) {
  const std::string bytes = fixture("rgb.png");
  const std::uint64_t size = 3 * test::fixture_width * test::fixture_height;
  Limits limits;
  std::uint64_t budget = 2 * size + 1;
  EXPECT_TRUE(decode_image(bytes, limits, budget));
  EXPECT_TRUE(decode_image(bytes, limits, budget));
  EXPECT_EQ(budget, 1u);
  const Result<Texture> third = decode_image(bytes, limits, budget);
  ASSERT_FALSE(third);
  EXPECT_EQ(third.error().kind, ErrorKind::limit);
  EXPECT_EQ(budget, 1u);
  EXPECT_NE(third.error().text.find("PNG of 17 x 11 pixels: that takes 1 MB, and 0 MB are left"),
            std::string::npos)
      << third.error().text;
}

}  // namespace
}  // namespace scenefile
