// Explains random pixels of every scene below a folder, in both profiles, and checks that the sums
// equal the pixels of the picture exactly.
//
//     scenefile_explained FOLDER [PIXELS]
//
// PIXELS (default 50) per picture. Scenes that cannot be drawn are listed but not counted.

#include "scenefile/trace/explain.h"
#include "support/load_scene.h"
#include "trace/add_up.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <filesystem>
#include <random>
#include <string_view>
#include <vector>

namespace scenefile::conformance {

namespace {

namespace fs = std::filesystem;

constexpr int width = 96;
constexpr int height = 72;

struct Way {
  const char* name;
  Profile profile;
  Mode mode;
};
constexpr Way ways[] = {{"course", Profile::course, Mode::ray},
                        {"course, ray caster", Profile::course, Mode::intersect},
                        {"course, normals", Profile::course, Mode::normals},
                        {"fine", Profile::fine, Mode::ray}};

struct Count {
  long scenes = 0;
  long pixels = 0;
  long rays = 0;
  long wrong = 0;
};

std::vector<std::string> scenes_below(const std::string& folder) {
  std::vector<std::string> paths;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
    const fs::path extension = entry.path().extension();
    if (entry.is_regular_file() && (extension == ".xml" || extension == ".json")) {
      paths.push_back(entry.path());
    }
  }
  std::sort(paths.begin(), paths.end());
  return paths;
}

RenderOptions options_of(const Way& way) {
  RenderOptions options = default_options(way.profile);
  options.mode = way.mode;
  options.features.super_sample = true;
  options.width = width;
  options.height = height;
  return options;
}

std::string wrong_with(const RenderScene& scene, const PixelRecord& pixel, const Image& image) {
  std::string wrong = trace_test::what_differs(pixel, image);
  return wrong.empty() ? trace_test::what_does_not_add_up(scene, pixel) : wrong;
}

void try_pixels(const testing_support::LoadedScene& loaded, const std::string& path, const Way& way,
                int pixels, Count& count) {
  const RenderScene& scene = loaded.ready.scene;
  const RenderOptions options = options_of(way);
  const Image image = render(scene, loaded.assets, options).image;
  const Explainer explainer(scene, loaded.assets, options);
  if (explainer.status() != RenderStatus::complete) {
    fmt::print("not drawn: {}\n", path);
    return;
  }
  std::mt19937 random(1);
  for (int i = 0; i < pixels; ++i) {
    const int x = static_cast<int>(random() % width);
    const int y = static_cast<int>(random() % height);
    const auto sample = static_cast<std::uint32_t>(random() % 8);
    const PixelRecord pixel = explainer.explain(x, y, sample);
    ++count.pixels;
    count.rays += static_cast<long>(pixel.rays.size());
    if (const std::string wrong = wrong_with(scene, pixel, image); !wrong.empty()) {
      ++count.wrong;
      fmt::print("WRONG {} ({}), pixel {},{}, sample {}: {}\n", path, way.name, x, y, pixel.shown,
                 wrong);
    }
  }
}

int run(const std::string& folder, int pixels) {
  Count count;
  for (const std::string& path : scenes_below(folder)) {
    const testing_support::LoadedScene loaded = testing_support::load_scene(path, true);
    if (!loaded.error.empty()) {
      fmt::print("not a scene that can be drawn: {}\n", path);
      continue;
    }
    ++count.scenes;
    for (const Way& way : ways) {
      try_pixels(loaded, path, way, pixels, count);
    }
  }
  fmt::print("{} scenes, {} pixels, {} rays, {} wrong\n", count.scenes, count.pixels, count.rays,
             count.wrong);
  return count.wrong == 0 && count.pixels != 0 ? 0 : 1;
}

}  // namespace

}  // namespace scenefile::conformance

int main(int argc, char** argv) {
  int pixels = 50;
  const std::string_view number = argc == 3 ? argv[2] : "50";
  const auto read = std::from_chars(number.data(), number.data() + number.size(), pixels);
  if (argc < 2 || argc > 3 || read.ec != std::errc() || pixels < 1) {
    fmt::print(stderr, "usage: scenefile_explained FOLDER [PIXELS]\n");
    return 2;
  }
  return scenefile::conformance::run(argv[1], pixels);
}
