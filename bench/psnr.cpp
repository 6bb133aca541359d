// scenefile_bench_psnr A B: the similarity of two pictures in dB, measured by the library, and how
// much brighter A is on average (the channel with the largest difference, in units of 1/255).

#include "scenefile/asset/compare_images.h"
#include "scenefile/asset/image_file.h"

#include <cmath>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <string>

namespace {

using namespace scenefile;

Texture read_picture(const char* path) {
  std::ifstream file(path, std::ios::binary);
  const std::string bytes(std::istreambuf_iterator<char>(file), {});
  return *decode_image(bytes);
}

double difference_of_means(const Texture& a, const Texture& b) {
  double most = 0;
  for (std::size_t c = 0; c < 3; ++c) {
    double sum = 0;
    for (std::size_t i = c; i < a.rgb.size(); i += 3) {
      sum += int{a.rgb[i]} - int{b.rgb[i]};
    }
    const double mean = 3 * sum / double(a.rgb.size());
    most = std::abs(mean) > std::abs(most) ? mean : most;
  }
  return most;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fputs("scenefile_bench_psnr A B\n", stderr);
    return 2;
  }
  const Texture a = read_picture(argv[1]);
  const Texture b = read_picture(argv[2]);
  if (a.empty() || b.empty() || a.width != b.width || a.height != b.height) {
    std::fputs("the pictures cannot be read or differ in size\n", stderr);
    return 1;
  }
  std::printf("%.2f %+.3f\n", compare_images(a, b).psnr_db, difference_of_means(a, b));
}
