// Programs whose light grows from bounce to bounce.

#include "scenefile/noise/growing_light.h"

#include "path/full_room.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace scenefile {

namespace {

using namespace path_test;

PathTruth truth_of_a_room() {
  Room room;
  Model model;
  model.box({-1, 0, -1}, {1, 2, 1}, true, model.material(diffuse({0.7f, 0.6f, 0.5f})));
  model.quad({-0.3f, 1.98f, -0.3f}, {0.6f, 0, 0}, {0, 0, 0.6f},
             model.material(diffuse(glm::vec3(0), {12, 10, 8})));
  room.add(model);
  room.look({0, 1, 0.95}, {0, 0.9, 0}, 80);
  const RenderOptions options = path_options(64, 64, 16);
  const TraceScene traced(room.scene, room.assets);
  PathTruth truth;
  EXPECT_EQ(draw_truth(traced, room.scene, options, 0, 32, {}, truth), RenderStatus::complete);
  draw_pools(traced, room.scene, options, truth);
  return truth;
}

// By a program that goes on with probability 0.6 and draws 256 samples.
LinearPicture drawn(const PathTruth& truth, double scattered, double brightness) {
  LinearPicture picture;
  picture.pixels.resize(truth.pixels.size());
  picture.rounding.resize(truth.pixels.size());
  picture.usable.resize(truth.pixels.size(), 1);
  std::mt19937 random(1);
  std::uniform_real_distribution<> uniform;
  for (const PathPool& pool : truth.pools) {
    const auto& paths = pool.paths[1];
    for_each_pixel(truth, pool.block, [&](int, int, std::size_t at) {
      double sum = 0;
      for (int i = 0; i < 256; ++i) {
        const auto& path = paths[random() % paths.size()];
        double weight = 1;
        for (const PathStep& step : path) {
          sum += step.direct * weight * std::pow(scattered, step.rough);
          if (uniform(random) >= 0.6) {
            break;
          }
          weight /= 0.6;
        }
      }
      picture.pixels[at] = Color(brightness * sum / 256);
    });
  }
  return picture;
}

TEST(GrowingLight, IsFoundByTheDistributionOfPixels) {
  const PathTruth truth = truth_of_a_room();
  const TruthBlocks back(truth);
  const std::vector<GrowthMatch> matches = match_growth(back, drawn(truth, std::numbers::pi, 1));
  std::vector<std::string> names;
  for (const GrowthMatch& match : matches) {
    names.push_back(match.meaning.name);
  }
  EXPECT_THAT(names, ::testing::Contains("pi"));
  // Brighter, but as noisy as a right one.
  EXPECT_TRUE(match_growth(back, drawn(truth, 1, 3)).empty());
}

}  // namespace

}  // namespace scenefile
