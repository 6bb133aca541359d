// Damages small valid files at random, with fixed seeds. Nothing may crash, and whatever is
// accepted must be complete. Most useful with sanitizers.

#include "asset/sample_files.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <random>

namespace scenefile {
namespace {

// For more rounds, set SCENEFILE_MUTATIONS=100000.
int rounds() {
  const char* wish = std::getenv("SCENEFILE_MUTATIONS");
  return wish != nullptr ? std::atoi(wish) : 300;
}

// Overwrites, inserts, removes, duplicates or truncates.
void mutate(std::string& bytes, std::mt19937& random) {
  if (bytes.empty()) {
    return;
  }
  const std::size_t at = random() % bytes.size();
  const std::size_t count = std::min<std::size_t>(1 + random() % 8, bytes.size() - at);
  constexpr unsigned char odd[] = {0x00, 0x01, 0x7f, 0x80, 0xff, 0xfe, 0x0a, '/', '-', '9'};
  switch (random() % 6) {
    case 0:
      bytes[at] = static_cast<char>(bytes[at] ^ 1 << random() % 8);
      break;
    case 1:
      bytes[at] = static_cast<char>(odd[random() % sizeof odd]);
      break;
    case 2:
      bytes.insert(at, count, static_cast<char>(odd[random() % sizeof odd]));
      break;
    case 3:
      bytes.erase(at, count);
      break;
    case 4:
      bytes.insert(at, bytes.substr(random() % bytes.size(), count));
      break;
    default:
      bytes.resize(at + 1);
  }
}

Limits small_limits() {
  Limits limits;
  limits.texture_bytes = 16 << 20;
  limits.mesh_bytes = 16 << 20;
  return limits;
}

void expect_whole(const Texture& texture) {
  EXPECT_EQ(texture.rgb.size(), std::size_t{3} * static_cast<std::size_t>(texture.width) *
                                    static_cast<std::size_t>(texture.height));
}

TEST(Mutation, Images) {
  std::mt19937 random(20);
  const Limits limits = small_limits();
  int refused = 0, accepted = 0;
  for (const std::string& name : test::image_fixtures()) {
    const std::string whole = test::fixture(name);
    for (int i = 0; i < rounds(); ++i) {
      std::string bytes = whole;
      for (auto n = 1 + random() % 4; n > 0; --n) {
        mutate(bytes, random);
      }
      const test::Decoded decoded = test::decode(bytes, limits);
      expect_whole(decoded.texture);
      ++(decoded.error.empty() ? accepted : refused);
    }
  }
  EXPECT_GT(refused, accepted / 4);
  EXPECT_GT(accepted, 0);
}

// PNG has a checksum for every chunk; repairing them lets damage reach the code after the check.
TEST(Mutation, PngWithValidChecksums) {
  std::mt19937 random(21);
  for (const char* name : {"rgb.png", "palette.png", "two.png", "gray16.png"}) {
    const std::string whole = test::fixture(name);
    for (int i = 0; i < rounds(); ++i) {
      std::string bytes = whole.substr(0, 8);
      for (std::size_t at = 8; at + 12 <= whole.size();) {
        const auto size = static_cast<std::size_t>(static_cast<std::uint8_t>(whole[at + 2]) << 8 |
                                                   static_cast<std::uint8_t>(whole[at + 3]));
        std::string data = whole.substr(at + 8, size);
        if (!data.empty() && random() % 3 == 0) {
          mutate(data, random);
        }
        bytes += test::png_chunk(whole.substr(at + 4, 4), data);
        at += 12 + size;
      }
      expect_whole(test::decode(bytes, small_limits()).texture);
    }
  }
}

TEST(Mutation, Meshes) {
  std::mt19937 random(22);
  const std::string whole =
      "# a square\nv 0 0 0\nv 1 0 0 1 0 0\nv 1 1 0\nv 0 1 -0.5e1\nvt 0 0\nvt 1 .5 0\n"
      "vn 0 0 1\nvn 1 0 0\ng x\nusemtl y\nf 1/1/1 2/2/2 3//1\nf -4 -3 \\\n -2 -1\ncurv 1 2\n";
  for (int i = 0; i < 20 * rounds(); ++i) {
    std::string text = whole;
    for (auto n = 1 + random() % 6; n > 0; --n) {
      mutate(text, random);
    }
    const test::ReadObj r = test::read(text, small_limits());
    const Mesh& mesh = r.mesh;
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
      const Surface s = surface_at(mesh, t, 0.25, 0.25, true);
      ASSERT_NEAR(glm::length(s.normal), 1, 1e-9) << text;
    }
  }
}

}  // namespace
}  // namespace scenefile
