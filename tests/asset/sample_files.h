#pragma once
// Small files to read, and helpers to read them.

#include "scenefile/asset/image_file.h"
#include "scenefile/asset/read_obj.h"

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace scenefile::test {

using Color = std::array<int, 3>;

/// The contents of a file in tests/fixtures/asset.
std::string fixture(const std::string& name);
/// The names of the images there.
std::vector<std::string> image_fixtures();

/// The size of the fixtures' pictures; make_images.py uses the same formulas.
inline constexpr int fixture_width = 17;
inline constexpr int fixture_height = 11;
Color sharp(int x, int y);
Color smooth(int x, int y);
Color gray(int x, int y);
Color two(int x, int y);

/// decode_image() under default limits.
struct Decoded {
  Texture texture;
  std::string error;
  bool over_limit = false;
};
Decoded decode(std::string_view bytes, const Limits& limits = {});
Color color_at(const Texture& texture, int x, int y);

/// A PNG written by libpng: `depth` and `color_type` as there, rows of packed samples.
std::string make_png(int width, int height, int depth, int color_type, bool interlaced,
                     const std::vector<std::string>& rows,
                     const std::vector<std::array<std::uint8_t, 3>>& palette = {});
/// A chunk with its checksum, so that tests can forge valid chunks.
std::string png_chunk(std::string_view type, std::string_view data);

/// Little-endian bytes.
std::string u16(unsigned value);
std::string u32(unsigned value);

/// read_obj() under default limits.
struct ReadObj {
  Mesh mesh;
  Diagnostics diagnostics;
};
ReadObj read(std::string_view text, const Limits& limits = {});
/// All findings as "line:column code message", one per line.
std::string findings(const Diagnostics& diagnostics);

}  // namespace scenefile::test
