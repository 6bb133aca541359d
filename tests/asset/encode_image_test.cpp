#include "asset/sample_files.h"

#include <gtest/gtest.h>
#include <png.h>
#include <rapidcheck/gtest.h>
#include <tinyexr.h>

#include <cstdlib>
#include <cstring>
#include <limits>
#include <memory>

namespace scenefile {
namespace {

std::string encode(const Image& image, ImageFormat format, Rounding rounding = Rounding::nearest) {
  const Result<std::string> bytes = encode_image(image, format, rounding);
  EXPECT_EQ(error_text(bytes), "");
  EXPECT_EQ(*encode_image(image, format, rounding), *bytes) << "same image, same bytes";
  return *bytes;
}

Image gradient(int width, int height) {
  Image image(width, height);
  for (std::size_t i = 0; i < image.rgb.size(); ++i) {
    image.rgb[i] = static_cast<float>(i * 7919 % 1000) / 900 - 0.05f;  // some below 0, some over 1
  }
  return image;
}

TEST(EncodeImage, Png8ContainsTheQuantizedPixels) {
  for (const Rounding rounding : {Rounding::truncate, Rounding::nearest}) {
    const Image image = gradient(31, 17);
    const test::Decoded d = test::decode(encode(image, ImageFormat::png8, rounding));
    ASSERT_EQ(d.error, "");
    EXPECT_EQ(d.texture.width, 31);
    EXPECT_EQ(d.texture.height, 17);
    EXPECT_EQ(d.texture.rgb, quantize(image, rounding).rgb);
  }
}

// Each allocation that is kept moves the addresses of the next call; with ISA-L's lower levels,
// that changed the bytes of one picture in a thousand.
TEST(EncodeImage, PngDoesNotDependOnMemoryAddresses) {
  std::string error;
  const Image image(40, 30);
  const std::string first = encode(image, ImageFormat::png8);
  std::vector<std::unique_ptr<char[]>> kept;
  for (int i = 0; i < 10000; ++i) {
    kept.emplace_back(new char[std::size_t{1} << 16]);
    ASSERT_TRUE(*encode_image(image, ImageFormat::png8, Rounding::nearest) == first);
  }
}

// Reads 16-bit values with libpng's simplified API.
std::vector<std::uint16_t> read_png16(const std::string& bytes) {
  png_image header{};
  header.version = PNG_IMAGE_VERSION;
  EXPECT_NE(png_image_begin_read_from_memory(&header, bytes.data(), bytes.size()), 0);
  EXPECT_NE(header.format & PNG_FORMAT_FLAG_LINEAR, 0u) << "16 bits a channel";
  header.format = PNG_FORMAT_LINEAR_RGB;
  std::vector<std::uint16_t> values(std::size_t{3} * header.width * header.height);
  EXPECT_NE(png_image_finish_read(&header, nullptr, values.data(), 0, nullptr), 0);
  return values;
}

TEST(EncodeImage, Png16KeepsSixteenBits) {
  Image image(3, 2);
  const float values[] = {0, 1, 0.5f, 0.25f, 2, -1, 1e-4f, std::nanf(""), 1.0f / 65535};
  std::copy(std::begin(values), std::end(values), image.rgb.begin());
  const std::string rounded = encode(image, ImageFormat::png16, Rounding::nearest);
  EXPECT_EQ(static_cast<int>(rounded[24]), 16) << "bit depth";
  const auto read = read_png16(rounded);
  const std::uint16_t expected[] = {0, 65535, 32768, 16384, 65535, 0, 7, 0, 1};
  EXPECT_TRUE(std::equal(std::begin(expected), std::end(expected), read.begin()));
  const auto cut = read_png16(encode(image, ImageFormat::png16, Rounding::truncate));
  EXPECT_EQ(cut[2], 32767);
  EXPECT_EQ(cut[6], 6);
}

TEST(EncodeImage, ExrKeepsEveryFloat) {
  Image image = gradient(29, 40);
  image.pixel(3, 5)[0] = 1e30f;
  image.pixel(3, 5)[1] = -7.25f;
  image.pixel(3, 5)[2] = std::numeric_limits<float>::infinity();
  const std::string bytes = encode(image, ImageFormat::exr);
  float* rgba = nullptr;
  int width = 0, height = 0;
  ASSERT_EQ(LoadEXRFromMemory(&rgba, &width, &height,
                              reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size(),
                              nullptr),
            TINYEXR_SUCCESS);
  ASSERT_EQ(width, 29);
  ASSERT_EQ(height, 40);
  for (std::size_t p = 0; p < image.rgb.size() / 3; ++p) {
    ASSERT_EQ(std::memcmp(rgba + 4 * p, image.rgb.data() + 3 * p, 3 * sizeof(float)), 0) << p;
  }
  std::free(rgba);
}

// All channels of an EXR file, by name.
struct ExrFile {
  EXRVersion version{};
  EXRHeader header{};
  EXRImage image{};

  explicit ExrFile(const std::string& bytes) {
    const auto* data = reinterpret_cast<const unsigned char*>(bytes.data());
    InitEXRHeader(&header);
    InitEXRImage(&image);
    EXPECT_EQ(ParseEXRVersionFromMemory(&version, data, bytes.size()), TINYEXR_SUCCESS);
    EXPECT_EQ(ParseEXRHeaderFromMemory(&header, &version, data, bytes.size(), nullptr),
              TINYEXR_SUCCESS);
    EXPECT_EQ(LoadEXRImageFromMemory(&image, &header, data, bytes.size(), nullptr),
              TINYEXR_SUCCESS);
  }
  ~ExrFile() {
    FreeEXRImage(&image);
    FreeEXRHeader(&header);
  }
  ExrFile(const ExrFile&) = delete;
  ExrFile& operator=(const ExrFile&) = delete;

  std::vector<std::string> names() const {
    std::vector<std::string> names;
    for (int i = 0; i < header.num_channels; ++i) {
      names.emplace_back(header.channels[i].name);
    }
    return names;
  }
};

TEST(EncodeLayers, ChannelsAreNamedByTheirLayerAndSorted) {
  const std::vector<ImageLayer> layers{{"", {"R", "G", "B"}, false, {1, 2, 3, 4, 5, 6}},
                                       {"normal", {"X", "Y", "Z"}, false, {7, 8, 9, 10, 11, -12}},
                                       {"object-id", {"ID"}, true, {0, 16777215}}};
  const Result<std::string> bytes = encode_layers(2, 1, layers);
  ASSERT_EQ(error_text(bytes), "");
  EXPECT_EQ(*encode_layers(2, 1, layers), *bytes);
  const ExrFile file(*bytes);
  EXPECT_EQ(file.names(), (std::vector<std::string>{"B", "G", "R", "normal.X", "normal.Y",
                                                    "normal.Z", "object-id.ID"}));
  const auto floats = [&](int channel) {
    return reinterpret_cast<const float*>(file.image.images[channel]);
  };
  EXPECT_EQ(floats(0)[1], 6);
  EXPECT_EQ(floats(2)[0], 1);
  EXPECT_EQ(floats(5)[1], -12);
  EXPECT_EQ(file.header.pixel_types[6], TINYEXR_PIXELTYPE_UINT);
  EXPECT_EQ(reinterpret_cast<const unsigned*>(file.image.images[6])[1], 16777215u);
}

TEST(EncodeLayers, NamesHaveALimit) {
  const ImageLayer layer{std::string(300, 'n'), {"Y"}, false, {0}};
  EXPECT_NE(error_text(encode_layers(1, 1, {&layer, 1})), "");
}

TEST(EncodeImage, PfmByHand) {
  Image image(1, 2);
  image.rgb = {1, 2, 3, -0.5f, 0, 1e10f};
  const std::string expected = std::string("PF\n1 2\n-1.0\n") +
                               std::string("\x00\x00\x00\xbf\x00\x00\x00\x00\xf9\x02\x15\x50", 12) +
                               std::string("\x00\x00\x80\x3f\x00\x00\x00\x40\x00\x00\x40\x40", 12);
  EXPECT_EQ(encode(image, ImageFormat::pfm), expected);
}

TEST(EncodeImage, WithoutPixelsIsAnError) {
  for (const ImageFormat format :
       {ImageFormat::png8, ImageFormat::png16, ImageFormat::exr, ImageFormat::pfm}) {
    EXPECT_NE(error_text(encode_image({}, format, Rounding::nearest)), "");
  }
}

TEST(EncodeImage, FormatFollowsTheExtension) {
  const struct {
    const char* name;
    std::optional<ImageFormat> format;
  } cases[] = {{"a.png", ImageFormat::png8}, {"b/c.PNG", ImageFormat::png8},
               {"a.exr", ImageFormat::exr},  {"a.Pfm", ImageFormat::pfm},
               {"a.jpg", std::nullopt},      {"png", std::nullopt},
               {"a.png.bak", std::nullopt},  {"", std::nullopt}};
  for (const auto& c : cases) {
    EXPECT_EQ(image_format_of(c.name), c.format) << c.name;
  }
}

RC_GTEST_PROP(EncodeImageLaw, EightBitsSurviveAPng, ()) {
  Texture texture;
  texture.width = *rc::gen::inRange(1, 20);
  texture.height = *rc::gen::inRange(1, 20);
  texture.rgb = *rc::gen::container<std::vector<std::uint8_t>>(
      std::size_t{3} * texture.width * texture.height, rc::gen::arbitrary<std::uint8_t>());
  const std::string bytes = encode(to_float(texture), ImageFormat::png8, Rounding::truncate);
  RC_ASSERT(test::decode(bytes).texture.rgb == texture.rgb);
}

}  // namespace
}  // namespace scenefile
