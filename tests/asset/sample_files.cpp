#include "asset/sample_files.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <png.h>
#include <zlib.h>

#include <filesystem>
#include <fstream>
#include <iterator>

namespace scenefile::test {

namespace {

const std::filesystem::path folder = std::filesystem::path(SCENEFILE_FIXTURES) / "asset";

void append(png_structp png, png_bytep from, png_size_t count) {
  static_cast<std::string*>(png_get_io_ptr(png))->append(reinterpret_cast<char*>(from), count);
}

void flush(png_structp) {}

}  // namespace

std::string fixture(const std::string& name) {
  std::ifstream file(folder / name, std::ios::binary);
  EXPECT_TRUE(file) << name;
  return {std::istreambuf_iterator<char>(file), {}};
}

std::vector<std::string> image_fixtures() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::string end = entry.path().extension().string();
    if (end == ".png" || end == ".jpg" || end == ".gif" || end == ".tga" || end == ".bmp") {
      names.push_back(entry.path().filename().string());
    }
  }
  std::sort(names.begin(), names.end());
  return names;
}

Color sharp(int x, int y) {
  return {15 * x, 23 * y, 255 * ((x + y) % 2)};
}

Color smooth(int x, int y) {
  return {15 * x, 23 * y, 128};
}

Color gray(int x, int y) {
  return {x * y, x * y, x * y};
}

Color two(int x, int y) {
  const int value = 255 * ((x + y) % 2);
  return {value, value, value};
}

Decoded decode(std::string_view bytes, const Limits& limits) {
  Decoded result;
  std::uint64_t budget = limits.texture_bytes;
  if (Result<Texture> texture = decode_image(bytes, limits, budget)) {
    result.texture = *std::move(texture);
  } else {
    result.error = texture.error().text;
    result.over_limit = texture.error().kind == ErrorKind::limit;
  }
  EXPECT_EQ(budget, limits.texture_bytes - result.texture.rgb.size());
  EXPECT_EQ(result.texture.empty(), !result.error.empty());
  return result;
}

Color color_at(const Texture& texture, int x, int y) {
  const std::uint8_t* texel = texture.texel(x, y);
  return {texel[0], texel[1], texel[2]};
}

std::string make_png(int width, int height, int depth, int color_type, bool interlaced,
                     const std::vector<std::string>& rows,
                     const std::vector<std::array<std::uint8_t, 3>>& palette) {
  std::string bytes;
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  png_set_write_fn(png, &bytes, append, flush);
  png_set_IHDR(png, info, static_cast<png_uint_32>(width), static_cast<png_uint_32>(height), depth,
               color_type, interlaced ? PNG_INTERLACE_ADAM7 : PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  if (!palette.empty()) {
    png_set_PLTE(png, info, reinterpret_cast<png_const_colorp>(palette.data()),
                 static_cast<int>(palette.size()));
  }
  png_set_check_for_invalid_index(png, -1);
  png_write_info(png, info);
  std::vector<png_bytep> pointers;
  for (const std::string& row : rows) {
    pointers.push_back(reinterpret_cast<png_bytep>(const_cast<char*>(row.data())));
  }
  png_write_image(png, pointers.data());
  png_write_end(png, info);
  png_destroy_write_struct(&png, &info);
  return bytes;
}

std::string png_chunk(std::string_view type, std::string_view data) {
  const auto big = [](std::uint32_t v) {
    return std::string{static_cast<char>(v >> 24), static_cast<char>(v >> 16),
                       static_cast<char>(v >> 8), static_cast<char>(v)};
  };
  const std::string body = std::string(type) + std::string(data);
  const uLong sum =
      crc32(0, reinterpret_cast<const Bytef*>(body.data()), static_cast<uInt>(body.size()));
  return big(static_cast<std::uint32_t>(data.size())) + body + big(static_cast<std::uint32_t>(sum));
}

std::string u16(unsigned value) {
  return {static_cast<char>(value), static_cast<char>(value >> 8)};
}

std::string u32(unsigned value) {
  return u16(value & 0xffff) + u16(value >> 16);
}

ReadObj read(std::string_view text, const Limits& limits) {
  ReadObj result{{}, Diagnostics(limits)};
  std::uint64_t triangles = limits.mesh_triangles;
  std::uint64_t bytes = limits.mesh_bytes;
  result.mesh = read_obj(text, "test.obj", limits, triangles, bytes, result.diagnostics);
  EXPECT_EQ(limits.mesh_triangles - triangles, result.mesh.triangles.size());
  if (result.diagnostics.has_errors()) {
    EXPECT_TRUE(result.mesh.triangles.empty() && result.mesh.positions.empty());
    EXPECT_EQ(bytes, limits.mesh_bytes);
  }
  for (const Diagnostic& finding : result.diagnostics.list()) {
    EXPECT_EQ(finding.file, "test.obj");
  }
  return result;
}

std::string findings(const Diagnostics& diagnostics) {
  std::string text;
  for (const Diagnostic& finding : diagnostics.list()) {
    text += fmt::format("{}:{} {} {}\n", finding.location.line, finding.location.column,
                        finding.code->name, finding.message);
  }
  return text;
}

}  // namespace scenefile::test
