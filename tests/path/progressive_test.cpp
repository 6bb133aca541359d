// Pictures in progress: what windows show.

#include "scenefile/path/progressive.h"

#include "path/full_room.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace scenefile::path_test {
namespace {

struct Shown {
  std::vector<PathPass> passes;
  RenderStatus status = RenderStatus::complete;
  double rate = 0;
};

// Stops after `most` pictures.
Shown show(const Room& room, const RenderOptions& options, PathPasses passes,
           std::size_t most = 1000) {
  Shown shown;
  const TraceScene traced(room.scene, room.assets);
  passes.go_on = [&](bool first) {
    EXPECT_EQ(first, shown.passes.empty());
    return shown.passes.size() < most;
  };
  passes.show = [&](PathPass pass) { shown.passes.push_back(std::move(pass)); };
  shown.status = render_progressively(traced, room.scene, options, passes);
  shown.rate = passes.rate;
  return shown;
}

TEST(Progressive, PicturesAreThoseOfRenderPath) {
  const Room room = full_room(true, true);
  RenderOptions options = path_options(61, 35, 9);
  const Shown shown = show(room, options, {.rate = 1});  // a slow machine: coarse at first
  EXPECT_EQ(shown.status, RenderStatus::complete);
  ASSERT_GT(shown.passes.size(), 6u);
  EXPECT_EQ(shown.passes[0].image.width, 2) << "every 32nd pixel";
  EXPECT_EQ(shown.passes[0].image.height, 2);
  const Image one = draw(room, path_options(61, 35, 1)).image;
  std::uint32_t before = 0;
  int stride = 64;
  for (const PathPass& pass : shown.passes) {
    EXPECT_EQ(pass.complete, &pass == &shown.passes.back());
    if (pass.samples == 0) {
      stride /= 2;
      EXPECT_EQ(*pass.image.pixel(1, 1), *one.pixel(stride, stride));
      EXPECT_EQ(pass.noise, 0);
      continue;
    }
    EXPECT_EQ(stride, 2);
    EXPECT_GT(pass.samples, before);
    before = pass.samples;
    options.samples = static_cast<int>(pass.samples);
    EXPECT_EQ(pass.image.rgb, draw(room, options).image.rgb) << pass.samples;
    EXPECT_EQ(pass.noise > 0, pass.samples > 1);
  }
  EXPECT_EQ(before, 9u);
}

TEST(Progressive, AFastMachineStartsWithAllPixels) {
  const Shown shown = show(full_room(false, false), path_options(20, 20, 2), {.rate = 1e9});
  EXPECT_EQ(shown.passes.front().samples, 1u);
  EXPECT_GT(shown.rate, 0);
  EXPECT_LT(shown.rate, 1e9) << "measured";
}

TEST(Progressive, EndsAtTheNoise) {
  const Room room = full_room(false, false);
  const PathPass last = show(room, path_options(24, 24, 4096), {.noise = 0.08}).passes.back();
  EXPECT_TRUE(last.complete);
  EXPECT_LE(last.noise, 0.08);
  EXPECT_GE(last.samples, 16u);
  EXPECT_LT(last.samples, 4096u);
  // Halving the error takes about four times as many.
  const PathPass better = show(room, path_options(24, 24, 4096), {.noise = 0.03}).passes.back();
  EXPECT_LE(better.noise, 0.03);
  EXPECT_GT(better.samples, 2 * last.samples);
  EXPECT_TRUE(show(room, path_options(24, 24, 17), {.noise = 0.001}).passes.back().complete);
}

TEST(Progressive, BlackPicturesHaveNoNoise) {
  Room room;
  Model model;
  model.box({-1, -1, -1}, {1, 1, 1}, true, model.material(diffuse(glm::vec3(0.5f))));
  room.add(model);
  room.look({0, 0, 0.9}, {0, 0, 0}, 60);
  const PathPass last = show(room, path_options(8, 8, 100), {.noise = 0.01}).passes.back();
  EXPECT_TRUE(last.complete);
  EXPECT_EQ(last.noise, 0);
  EXPECT_LT(last.samples, 100u);
}

TEST(Progressive, Stops) {
  const Shown shown = show(full_room(false, false), path_options(64, 64, 100), {.rate = 1}, 2);
  EXPECT_EQ(shown.status, RenderStatus::cancelled);
  EXPECT_EQ(shown.passes.size(), 2u);
  EXPECT_FALSE(shown.passes.back().complete);
}

}  // namespace
}  // namespace scenefile::path_test
