#include "sample_files.h"
#include "scenefile/asset/compare_images.h"
#include "scenefile/asset/image_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <png.h>

#include <cmath>
#include <limits>

namespace scenefile {
namespace {

using testing::HasSubstr;

DecodedPicture picture(const std::string& name, std::string_view layer = {}) {
  Result<DecodedPicture> decoded = decode_picture(test::fixture("../pictures/" + name), layer);
  EXPECT_TRUE(decoded) << name << ": " << (decoded ? "" : decoded.error().text);
  return decoded ? *std::move(decoded) : DecodedPicture();
}

std::string error(std::string_view bytes, std::string_view layer = {}) {
  const Result<DecodedPicture> decoded = decode_picture(bytes, layer);
  return decoded ? "" : decoded.error().text;
}

std::string error_of(const std::string& name, std::string_view layer = {}) {
  return error(test::fixture("../pictures/" + name), layer);
}

// As in make_exr.cpp.
constexpr int width = 9;
constexpr int height = 7;

float value(int channel, int x, int y) {
  return channel == 0   ? static_cast<float>(x) / 8
         : channel == 1 ? static_cast<float>(y) / 4
                        : static_cast<float>(x ^ y) / 16;
}

// Compares the pixels from x0, y0 up to and including x1, y1; those outside must be black.
void expect_values(const std::string& name, const Image& image, float scale = 1,
                   float tolerance = 0, float most = 100, int x0 = 0, int y0 = 0,
                   int x1 = width - 1, int y1 = height - 1) {
  ASSERT_EQ(image.width, width) << name;
  ASSERT_EQ(image.height, height) << name;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      for (int c = 0; c < 3; ++c) {
        const bool inside = x >= x0 && x <= x1 && y >= y0 && y <= y1;
        const float expected = inside ? std::min(scale * value(c, x, y), most) : 0;
        ASSERT_NEAR(image.pixel(x, y)[c], expected, tolerance)
            << name << " at " << x << "," << y << " channel " << c;
      }
    }
  }
}

void expect_same_bytes(const Texture& a, const Texture& b, const std::string& name) {
  EXPECT_EQ(a.width, b.width) << name;
  EXPECT_EQ(a.height, b.height) << name;
  EXPECT_EQ(a.rgb, b.rgb) << name;
}

#if SCENEFILE_OPENEXR
TEST(DecodePicture, ExrOfOtherPrograms) {
  for (const char* name :
       {"none_float.exr", "rle_half.exr", "zip_half.exr", "piz_half.exr", "pxr24_float.exr",
        "piz_tiles.exr", "zip_float_tiles.exr", "mip_map.exr", "decreasing.exr",
        "decreasing_tiles.exr", "beyond.exr", "origin.exr", "rgba.exr", "exrmaketiled.exr",
        "one_layer.exr", "plain_and_layer.exr", "parts.exr"}) {
    const DecodedPicture decoded = picture(name);
    ASSERT_TRUE(decoded.is_linear()) << name;
    EXPECT_EQ(decoded.not_finite, 0u) << name;
    expect_values(name, decoded.linear);
    expect_same_bytes(decoded.texture, quantize(decoded.linear, Rounding::nearest), name);
  }
  expect_values("magick.exr", picture("magick.exr").linear, 1, 0, 1);  // ImageMagick clamps
  expect_values("zips_uint.exr", picture("zips_uint.exr").linear, 16);
  expect_values("inside.exr", picture("inside.exr").linear, 1, 0, 100, 2, 1, 5, 4);
  for (const char* name : {"gray.exr", "depth.exr"}) {
    for (const float v : picture(name).linear.rgb) {
      ASSERT_EQ(v, 0.5f) << name;
    }
  }
}

TEST(DecodePicture, LayersOfExr) {
  EXPECT_THAT(error_of("layers.exr"),
              HasSubstr("it has several layers (beauty, depth, diffuse); choose one with --layer"));
  expect_values("beauty", picture("layers.exr", "beauty").linear);
  EXPECT_EQ(picture("layers.exr", "depth").linear.rgb, std::vector<float>(3 * 9 * 7, 0.5f));
  EXPECT_THAT(error_of("layers.exr", "glossy"),
              HasSubstr("it has no layer \"glossy\"; it has beauty, depth, diffuse"));
  expect_values("no layers", picture("zip_half.exr", "beauty").linear);
  EXPECT_EQ(picture("plain_and_layer.exr", "depth").linear.rgb,
            std::vector<float>(3 * 9 * 7, 0.5f));
  expect_values("right", picture("parts.exr", "right").linear, 0.5f);
}

TEST(DecodePicture, ExrThatCannotBeShown) {
  EXPECT_THAT(error_of("deep.exr"), HasSubstr("deep samples"));
  EXPECT_THAT(error_of("chroma.exr"), HasSubstr("luminance and chroma"));
  EXPECT_THAT(error_of("b44.exr"), HasSubstr("save it with ZIP or PIZ"));
  EXPECT_THAT(error_of("dwaa.exr"), HasSubstr("save it with ZIP or PIZ"));
}

TEST(DecodePicture, OurOwnExrIsReadBack) {
  Image image(17, 40);
  for (std::size_t i = 0; i < image.rgb.size(); ++i) {
    image.rgb[i] = std::sin(static_cast<float>(i)) * 3;
  }
  const std::string bytes = *encode_image(image, ImageFormat::exr, Rounding::nearest);
  EXPECT_EQ(decode_picture(bytes)->linear.rgb, image.rgb);
}

TEST(DecodePicture, ValuesThatAreNotFiniteAreCounted) {
  const DecodedPicture decoded = picture("not_finite.exr");
  EXPECT_EQ(decoded.not_finite, 2u);
  EXPECT_EQ(decoded.texture.rgb,
            (std::vector<std::uint8_t>{0, 0, 0, 255, 255, 255, 0, 0, 0, 255, 255, 255}));
  EXPECT_TRUE(std::isnan(decoded.linear.rgb[0]));
  EXPECT_EQ(decoded.linear.rgb[9], 2.5f);
}

TEST(DecodePicture, PngsThatAreTransparentEverywhereAreTold) {
  const auto is_transparent = [](int type, const std::string& row, bool interlaced = false) {
    const auto decoded = decode_picture(test::make_png(2, 2, 8, type, interlaced, {row, row}));
    return decoded->transparent;
  };
  const std::string none("\x0a\x14\x1e\x00\x28\x32\x3c\x00", 8);
  EXPECT_TRUE(is_transparent(PNG_COLOR_TYPE_RGB_ALPHA, none));
  EXPECT_TRUE(is_transparent(PNG_COLOR_TYPE_GRAY_ALPHA, std::string(4, '\0')));
  EXPECT_FALSE(is_transparent(PNG_COLOR_TYPE_RGB_ALPHA, none.substr(0, 7) + "\x01"));
  EXPECT_FALSE(is_transparent(PNG_COLOR_TYPE_RGB, std::string(6, '\0')));
}

TEST(DecodePicture, DamagedExrIsRejected) {
  const std::string whole = test::fixture("../pictures/piz_tiles.exr");
  for (std::size_t size = 0; size < whole.size(); size += 7) {
    EXPECT_NE(error(whole.substr(0, size)), "") << size;
  }
  const std::string big = *encode_image(Image(300, 200), ImageFormat::exr, Rounding::nearest);
  Limits limits;
  limits.texture_bytes = 100'000;
  const Result<DecodedPicture> over = decode_picture(big, {}, limits);
  ASSERT_FALSE(over);
  EXPECT_EQ(over.error().kind, ErrorKind::limit);
}
#endif

TEST(DecodePicture, PfmOfOtherPrograms) {
  // ImageMagick rounds to 16 bits, and clamps to 1.
  for (const char* name : {"color.pfm", "big_endian.pfm"}) {
    const DecodedPicture decoded = picture(name);
    ASSERT_TRUE(decoded.is_linear()) << name;
    expect_values(name, decoded.linear, 1, 2e-5f, 1);
  }
  for (const float v : picture("gray.pfm").linear.rgb) {
    ASSERT_NEAR(v, 0.5f, 2e-5f);
  }
}

TEST(DecodePicture, OurOwnPfmIsReadBack) {
  Image image(5, 3);
  for (std::size_t i = 0; i < image.rgb.size(); ++i) {
    image.rgb[i] = static_cast<float>(i) - 7.25f;
  }
  const std::string bytes = *encode_image(image, ImageFormat::pfm, Rounding::nearest);
  EXPECT_EQ(decode_picture(bytes)->linear.rgb, image.rgb);
  EXPECT_THAT(error(bytes.substr(0, bytes.size() - 1)), HasSubstr("truncated"));
  for (const char* const header : {"PF\n2 x\n-1\n", "PF\n1 1\n0\n", "PF\n1 1\nabc\n"}) {
    EXPECT_THAT(error(header), HasSubstr("expected the width"));
  }
}

TEST(DecodePicture, PpmAndPgmOfOtherPrograms) {
  const Texture rgb = *decode_image(test::fixture("rgb.png"));
  const Texture gray = *decode_image(test::fixture("gray.png"));
  const auto part = [](const Texture& of) {
    Texture cut{6, 5, {}};
    for (int y = 0; y < 5; ++y) {
      cut.rgb.insert(cut.rgb.end(), of.texel(0, y), of.texel(6, y));
    }
    return cut;
  };
  for (const char* name : {"rgb.ppm", "rgb16.ppm"}) {
    EXPECT_FALSE(picture(name).is_linear());
    expect_same_bytes(picture(name).texture, rgb, name);
  }
  expect_same_bytes(picture("gray.pgm").texture, gray, "gray.pgm");
  expect_same_bytes(picture("text.ppm").texture, part(rgb), "text.ppm");
  expect_same_bytes(picture("text16.pgm").texture, part(gray), "text16.pgm");
}

TEST(DecodePicture, PpmWithCommentsAndOtherMaximum) {
  const auto bytes = [](std::string_view text) {
    Result<DecodedPicture> decoded = decode_picture(text);
    return decoded ? decoded->texture.rgb : std::vector<std::uint8_t>();
  };
  EXPECT_THAT(bytes("P3#first\n2 # width\n1\n# largest\n15\n0 7#seven\n15 1\t2\r\n3"),
              testing::ElementsAre(0, 119, 255, 17, 34, 51));
  EXPECT_THAT(bytes("P2 1 1 1 1"), testing::ElementsAre(255, 255, 255));
  EXPECT_THAT(bytes("P5\n2 1\n100\n\x32\x64"), testing::ElementsAre(128, 128, 128, 255, 255, 255));
  // White space that is a value.
  EXPECT_THAT(bytes("P5 1 1 255\n\n"), testing::ElementsAre(10, 10, 10));
  EXPECT_THAT(bytes(std::string_view("P5 1 1 65535\n\x80\x80", 15)),
              testing::ElementsAre(128, 128, 128));
  EXPECT_THAT(error("P2 1 1 9 10"), HasSubstr("the value 10 exceeds the maximum 9"));
  EXPECT_THAT(error("P2 2 1 9 1 x"), HasSubstr("missing or not a number"));
  EXPECT_THAT(error("P2 2 1 0 1 1"), HasSubstr("1 to 65535"));
  EXPECT_THAT(error("P6 2 1 255\n12345"), HasSubstr("truncated"));
  EXPECT_THAT(error("P6 99999999 99999999 255\n1"), HasSubstr("the limit is"));
  EXPECT_THAT(error("P6 0 1 255\n"), HasSubstr("at least one pixel"));
}

TEST(DecodePicture, NamesTheFormatsForOtherFiles) {
  EXPECT_EQ(error("root:x:0:0"),
            "not a picture that scenefile reads (PNG, JPEG, GIF, BMP, PPM, PFM, EXR, TGA)");
  EXPECT_TRUE(is_picture_name("a.b/C.JPEG"));
  EXPECT_TRUE(is_picture_name("x.pgm"));
  EXPECT_TRUE(is_picture_name("x.exr"));
  EXPECT_TRUE(is_texture_name("a.b/C.JPEG"));
  EXPECT_FALSE(is_texture_name("x.exr")) << "textures do not have it";
  for (const char* name : {"png", "x.", "x.p", "x.xml", "x.png ", "x.jpg .jp", ""}) {
    EXPECT_FALSE(is_picture_name(name)) << name;
  }
}

TEST(DecodePicture, TexturesHaveFewerFormats) {
  EXPECT_FALSE(decode_image("P2 1 1 1 1"));
  EXPECT_TRUE(is_image("P2 1 1 1 1"));
}

TEST(CompareImages, FloatsAreNeitherClampedNorRounded) {
  Image a(2, 1);
  Image b(2, 1);
  a.rgb = {0, 0, 0, 2, 2, 2};
  b.rgb = {0, 0, 0.1f, 2, 2, 4};
  const ImageDifference difference = compare_images(a, b);
  EXPECT_NEAR(difference.max, 510, 1e-9);
  EXPECT_NEAR(difference.mean, (25.5 + 510) / 6, 1e-5);
  EXPECT_EQ(difference.share_over, 1);
  EXPECT_NEAR(difference.psnr_db, -10 * std::log10((0.01 + 4) / 6), 1e-6);
  EXPECT_EQ(compare_images(a, a).max, 0);
  EXPECT_EQ(compare_images(a, a).psnr_db, 99);
}

TEST(CompareImages, ValuesThatAreNotFiniteAreFullyOff) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float inf = std::numeric_limits<float>::infinity();
  Image a(3, 1);
  Image b(3, 1);
  a.rgb = {nan, inf, 1, 1, 1, 1, -inf, 0, 0};
  EXPECT_EQ(compare_images(a, a).max, 0);
  b.rgb = {nan, inf, 1, 1, 1, 1, inf, 0, 0};
  EXPECT_EQ(compare_images(a, b).max, 255);
  EXPECT_NEAR(compare_images(a, b).mean, 255.0 / 9, 1e-9);
  b.rgb = a.rgb;
  b.rgb[0] = 7;
  EXPECT_EQ(compare_images(a, b).max, 255);
}

}  // namespace
}  // namespace scenefile
