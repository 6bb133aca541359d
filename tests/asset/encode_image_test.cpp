#include "asset/sample_files.h"
#include "scenefile/asset/exr_rows.h"
#include "scenefile/asset/image_stream.h"

#include <gtest/gtest.h>
#include <png.h>
#include <rapidcheck/gtest.h>
#include <tinyexr.h>

#include <cstdlib>
#include <cstring>
#include <limits>
#include <memory>
#include <optional>
#include <utility>

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

TEST(EncodeImage, ATextOfAPngCanBeChangedInPlace) {
  const auto with_text = [](const std::string& text) {
    return *encode_image(gradient(3, 2), ImageFormat::png8, Rounding::nearest, {text});
  };
  std::string changed = with_text("sum=0000");
  changed.replace(changed.find("0000"), 4, "1f2e");
  EXPECT_NE(changed, with_text("sum=1f2e"));
  renew_png_text(changed);
  EXPECT_EQ(changed, with_text("sum=1f2e"));
  for (std::string other : {with_text(""), std::string("\x89PNG"), std::string()}) {
    const std::string before = other;
    renew_png_text(other);
    EXPECT_EQ(other, before);
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
    ASSERT_TRUE(std::equal(rgba + 4 * p, rgba + 4 * p + 3, image.rgb.data() + 3 * p)) << p;
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

// Other readers find the pixels, and the text where their format has it.
TEST(EncodeImage, ATextDoesNotChangeThePixels) {
  const Image image = gradient(20, 40);
  for (const ImageFormat format :
       {ImageFormat::png8, ImageFormat::png16, ImageFormat::pfm, ImageFormat::exr}) {
    const Result<std::string> bytes =
        encode_image(image, format, Rounding::nearest, {.text = "the text"});
    ASSERT_EQ(error_text(bytes), "");
    EXPECT_NE(bytes->find("the text"), std::string::npos);
    if (format == ImageFormat::exr && !SCENEFILE_OPENEXR) {
      continue;
    }
    const Result<DecodedPicture> with = decode_picture(*bytes);
    const Result<DecodedPicture> without = decode_picture(encode(image, format));
    ASSERT_EQ(error_text(with), "");
    EXPECT_EQ(with->texture.rgb, without->texture.rgb);
    EXPECT_EQ(with->linear.rgb, without->linear.rgb);
  }
}

#if SCENEFILE_OPENEXR
std::vector<ImageLayer> rows_of_layers(int width, int first, int end) {
  std::vector<ImageLayer> layers{{"", {"R", "G", "B"}, false, {}},
                                 {"normal", {"X", "Y", "Z"}, false, {}},
                                 {"object-id", {"ID"}, true, {}},
                                 {"depth", {"Z"}, false, {}}};
  for (ImageLayer& layer : layers) {
    for (int i = first * width; i < end * width; ++i) {
      for (std::size_t c = 0; c < layer.channels.size(); ++c) {
        const float value = static_cast<float>(i * 31 % 1009) + static_cast<float>(c);
        layer.values.push_back(layer.whole   ? value
                               : i % 97 == 3 ? std::numeric_limits<float>::infinity()
                                             : value / 7 - 3);
      }
    }
  }
  return layers;
}

TEST(ExrRows, BandsHaveTheirRowsAndMakeTheWholeFile) {
  constexpr int width = 37;
  constexpr int height = 100;
  const std::vector<ImageLayer> whole = rows_of_layers(width, 0, height);
  std::vector<ExrRows> bands;
  for (const auto& [first, end] : {std::pair{0, 48}, std::pair{48, 64}, std::pair{64, 100}}) {
    const std::vector<ImageLayer> rows = rows_of_layers(width, first, end);
    const Result<std::string> bytes =
        encode_layers(width, end - first, rows, {"the text", first, height});
    ASSERT_EQ(error_text(bytes), "");
    Result<ExrRows> band = ExrRows::open(*bytes);
    ASSERT_EQ(error_text(band), "");
    EXPECT_EQ(band->width(), width);
    EXPECT_EQ(band->picture_height(), height);
    EXPECT_EQ(band->first(), first);
    EXPECT_EQ(band->end(), end);
    std::vector<ImageLayer> read = rows;
    for (ImageLayer& layer : read) {
      layer.values.clear();
    }
    ASSERT_EQ(error_text(band->read(read)), "");
    for (std::size_t i = 0; i < rows.size(); ++i) {
      EXPECT_EQ(read[i].values, rows[i].values) << rows[i].name;
    }
    std::vector<ImageLayer> other{{"albedo", {"R"}, false, {}}};
    EXPECT_EQ(error_text(band->read(other)), "it has no channel \"albedo.R\"");
    bands.push_back(*std::move(band));
  }
  std::string made;
  const auto block_at = [&](int y, int) -> std::optional<std::string> {
    const ExrRows& band = bands[y < 48 ? 0 : y < 64 ? 1 : 2];
    return *band.block(y);
  };
  ASSERT_EQ(error_text(stream_blocks(width, height, whole, block_at, sink_to(made))), "");
  EXPECT_TRUE(made == *encode_layers(width, height, whole));
}

TEST(ExrRows, RefusesWhatIsNoBand) {
  const std::vector<ImageLayer> rows = rows_of_layers(5, 0, 20);
  const std::string good = *encode_layers(5, 20, rows, {"", 16, 40});
  EXPECT_EQ(error_text(ExrRows::open(good)), "");
  for (std::size_t i = 0; i < 300; i += 3) {
    EXPECT_NE(error_text(ExrRows::open(good.substr(0, i))), "") << i;
  }
  EXPECT_NE(error_text(ExrRows::open(*encode_layers(5, 20, rows, {"", 30, 40}))), "")
      << "below the picture";
  EXPECT_NE(error_text(ExrRows::open(*encode_layers(5, 20, rows, {"", -16, 40}))), "");
  EXPECT_NE(error_text(ExrRows::open(encode(gradient(4, 4), ImageFormat::png8))), "");
}
#endif

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
