// scenefile_bench_psnr A B: the similarity of two pictures in dB, measured by the library.

#include "scenefile/asset/compare_images.h"
#include "scenefile/asset/image_file.h"

#include <cstdio>
#include <fstream>
#include <iterator>
#include <string>

namespace {

using namespace scenefile;

Texture read_picture(const char* path) {
  std::ifstream file(path, std::ios::binary);
  const std::string bytes(std::istreambuf_iterator<char>(file), {});
  const Limits limits;
  std::uint64_t budget = limits.texture_bytes;
  std::string error;
  return decode_image(bytes, limits, budget, error);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fputs("scenefile_bench_psnr A B\n", stderr);
    return 2;
  }
  const Texture a = read_picture(argv[1]);
  const Texture b = read_picture(argv[2]);
  if (a.empty() || b.empty()) {
    std::fputs("one of the pictures cannot be read\n", stderr);
    return 1;
  }
  std::printf("%.2f\n", compare_images(a, b).psnr_db);
}
